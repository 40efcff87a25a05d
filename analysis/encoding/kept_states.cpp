// Proofs are by SAT over one run of each routine, with the rules as assumptions: the failed ones tell what a rule rests
// on.
#include "analysis/encoding/kept_states.hpp"

#include <algorithm>
#include <chrono>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/bit_cnf.hpp"
#include "analysis/graph/evaluate.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostValues = 12;     ///< that a cell was seen with
constexpr std::size_t mostBoundsEach = 3;  ///< constants of one kind of bound: the nearest to what was seen
constexpr std::size_t mostPairs = 200;
constexpr std::size_t mostConditions = 16;  ///< bits that may imply something
constexpr std::size_t mostRules = 160, mostSets = 24;
constexpr std::size_t mostNodesBlasted = 40'000;
constexpr double proofSeconds = 20;  ///< of the processor: far more than such proofs take

using SeenState = std::map<Place, std::uint64_t>;

/// Proposals.
class RuleGuess {
 public:
  RuleGuess(Graph& graph, const std::vector<RunBounds::Cell>& cells, const RuleHints& hints)
      : graph_(graph), cells_(cells), hints_(hints) {
    for (const RunBounds::Cell& cell : cells) now_.emplace(cell.place, cell.now);
    for (const auto& [width, constants] : hints.constants) {
      for (const std::uint64_t c : constants) {
        for (const std::uint64_t near : {c - 1, c, c + 1}) pool_[width].insert(near & Graph::maskOf(width));
      }
    }
  }

  StateRules rules() {
    for (const auto& said : hints_.said) {
      const bool isOfCells = std::ranges::all_of(said->places(), [&](const Place& p) { return now_.contains(p); });
      if (isOfCells) propose({.kind = StateRule::Kind::Said, .said = said});
    }
    for (const RunBounds::Cell& cell : cells_) ofOne(cell.place, {});
    ofPairs();
    ofConditions();
    return std::move(rules_);
  }

 private:
  using Kind = StateRule::Kind;

  std::vector<std::uint64_t> seenOf(const Place& place, const std::optional<StateRule::Condition>& where) const {
    std::set<std::uint64_t> values;
    for (const SeenState& state : hints_.seen) {
      if (!where || (state.at(where->bit) != 0) == where->isOn) values.insert(state.at(place));
    }
    return {values.begin(), values.end()};
  }

  void ofOne(const Place& place, const std::optional<StateRule::Condition>& where) {
    const std::vector<std::uint64_t> seen = seenOf(place, where);
    if (seen.empty()) return;
    const auto add = [&](Kind kind, std::vector<std::uint64_t> constants) {
      propose({.kind = kind, .place = place, .constants = std::move(constants), .where = where});
    };
    if (place.width == 1) {
      if (seen.size() == 1) add(Kind::OneOf, seen);
      return;
    }
    if (seen.size() <= (where ? 3 : mostValues)) add(Kind::OneOf, seen);
    const std::set<std::uint64_t>& pool = pool_[place.width];
    const std::uint64_t flip = 1ULL << (place.width - 1);
    const bool isSigned = place.width > 8;  // as programs compare them
    const auto rank = [&](std::uint64_t v) { return isSigned ? v ^ flip : v; };
    std::vector<std::uint64_t> ranked, ends;
    for (const std::uint64_t c : pool) ranked.push_back(rank(c));
    for (const std::uint64_t v : seen) ends.push_back(rank(v));
    std::ranges::sort(ranked);
    const std::uint64_t low = std::ranges::min(ends), high = std::ranges::max(ends);
    std::size_t count = 0;
    for (auto c = std::ranges::lower_bound(ranked, high); c != ranked.end() && count < mostBoundsEach; ++c, ++count)
      add(isSigned ? Kind::SignedAtMost : Kind::AtMost, {rank(*c)});
    count = 0;
    for (auto c = std::ranges::upper_bound(ranked, low); c != ranked.begin() && count < mostBoundsEach; ++count)
      add(isSigned ? Kind::SignedAtLeast : Kind::AtLeast, {rank(*--c)});
  }

  void ofPairs() {
    std::size_t pairs = 0;
    for (const RunBounds::Cell& a : cells_) {
      for (const RunBounds::Cell& b : cells_) {
        if (!(a.place < b.place) || a.place.width != b.place.width || (!a.isWritten && !b.isWritten)) continue;
        if (a.isBehindPointer || b.isBehindPointer) continue;
        if (++pairs > mostPairs) return;
        propose({.kind = Kind::Same, .place = a.place, .other = b.place});
        if (a.place.width == 1) continue;
        const Kind kind = a.place.width > 8 ? Kind::SignedNotAbove : Kind::NotAbove;  // as programs compare them
        propose({.kind = kind, .place = a.place, .other = b.place});
        propose({.kind = kind, .place = b.place, .other = a.place});
      }
    }
  }

  void ofConditions() {
    std::size_t conditions = 0;
    for (const RunBounds::Cell& bit : cells_) {
      if (bit.place.width != 1 || bit.place.isRegister || ++conditions > mostConditions) continue;
      for (const RunBounds::Cell& cell : cells_) {
        if (cell.place == bit.place || !cell.isWritten || cell.place.isRegister) continue;
        const std::size_t all = seenOf(cell.place, {}).size();
        for (const bool isOn : {false, true}) {
          const StateRule::Condition where{bit.place, isOn};
          if (seenOf(cell.place, where).size() < all) ofOne(cell.place, where);
        }
      }
    }
  }

  void propose(StateRule rule) {
    if (rules_.size() >= mostRules) return;
    for (const SeenState& state : hints_.seen) {
      const Node holds =
          rule.holds(graph_, [&](const Place& place) { return graph_.constantNode(state.at(place), place.width); });
      if (graph_[holds].value == 0) return;
    }
    const Node always = rule.holds(graph_, [&](const Place& place) { return now_.at(place); });
    if (graph_.truth({always}) == true) return;
    rules_.push_back(std::move(rule));
  }

  Graph& graph_;
  const std::vector<RunBounds::Cell>& cells_;
  const RuleHints& hints_;
  std::map<Place, Node> now_;
  std::map<int, std::set<std::uint64_t>> pool_;
  StateRules rules_;
};

/// Which of the rules one run keeps, and with which others.
class RuleProof {
 public:
  RuleProof(Graph& graph, const std::vector<RunBounds::Cell>& cells, const std::vector<RunBounds::Run>& runs,
            const StateRules& rules)
      : rules_(rules) {
    std::map<Place, Node> now;
    for (const RunBounds::Cell& cell : cells) now.emplace(cell.place, cell.now);
    system_.graph = &graph;
    for (const StateRule& rule : rules)
      before_.push_back(rule.holds(graph, [&](const Place& place) { return now.at(place); }));
    for (const RunBounds::Run& run : runs) {
      std::map<Place, Node> left = now;
      std::set<Place> written;
      for (const auto& [index, after] : run) {
        left[cells[index].place] = after;
        written.insert(cells[index].place);
      }
      for (std::size_t i = 0; i < rules.size(); ++i) {
        const bool isTouched =
            std::ranges::any_of(rules[i].places(), [&](const Place& p) { return written.contains(p); });
        if (!isTouched) continue;
        after_.push_back({i, rules[i].holds(graph, [&](const Place& place) { return left.at(place); })});
      }
    }
  }

  std::vector<StateRules> sets() {
    std::vector<Node> roots = before_;
    for (const After& a : after_) roots.push_back(a.holds);
    const std::vector<Node> cone = coneOf(*system_.graph, roots);
    if (cone.size() > mostNodesBlasted) return {};
    for (const Node n : cone) {
      if ((*system_.graph)[n].op == Op::Variable) system_.inputs.push_back(n);
    }
    for (const Node n : roots) system_.questions.push_back({"", n});
    const Budget budget = Budget::ofThread(proofSeconds, Budget::seconds(schedule::mostWait * proofSeconds));
    try {
      const BitBlast blast(system_, allQuestions(system_), {}, &budget);
      Sat sat(Sat::Use::Many);
      BitCnf cnf(blast.bits(), sat);
      for (const Node n : before_) beforeLiterals_.push_back(cnf.literal(blast.of(n)[0]));
      for (After& a : after_) a.literal = cnf.literal(blast.of(a.holds)[0]);
      if (!findKept(sat, budget) || !findSupports(sat, budget)) return {};
    } catch (const OutOfBudget&) {
      return {};
    }
    return closures();
  }

 private:
  struct After {
    std::size_t rule;
    Node holds;
    int literal = 0;
  };

  std::vector<int> assumed(const std::set<std::size_t>& rules) const {
    std::vector<int> literals;
    for (const std::size_t i : rules) literals.push_back(beforeLiterals_[i]);
    return literals;
  }

  /// A state in which one run breaks some of them takes these out.
  bool findKept(Sat& sat, const Budget& budget) {
    for (std::size_t i = 0; i < rules_.size(); ++i) kept_.insert(i);
    while (true) {
      std::vector<int> broken;
      for (const After& a : after_) {
        if (kept_.contains(a.rule)) broken.push_back(-a.literal);
      }
      if (broken.empty()) return true;
      const Sat::Outcome outcome = sat.solve(assumed(kept_), budget, broken);
      if (outcome == Sat::Outcome::Unsatisfiable) return true;
      if (outcome == Sat::Outcome::Unknown) return false;
      for (const After& a : after_) {
        if (!sat.value(a.literal)) kept_.erase(a.rule);
      }
    }
  }

  /// What each rests on: as little as can be.
  bool findSupports(Sat& sat, const Budget& budget) {
    supports_.resize(rules_.size());
    for (const After& a : after_) {
      if (!kept_.contains(a.rule)) continue;
      const auto isEnough = [&](const std::set<std::size_t>& rules) {
        std::vector<int> assumptions = assumed(rules);
        assumptions.push_back(-a.literal);
        return sat.solve(assumptions, budget);
      };
      std::set<std::size_t> needed{a.rule};
      if (isEnough(needed) == Sat::Outcome::Satisfiable) {
        if (isEnough(kept_) != Sat::Outcome::Unsatisfiable) return false;
        std::set<std::size_t> core;
        for (const std::size_t i : kept_) {
          if (sat.failed(beforeLiterals_[i])) core.insert(i);
        }
        needed = core;
        for (auto i = core.rbegin(); i != core.rend(); ++i) {  // what was seen by chance stands last
          std::set<std::size_t> fewer = needed;
          fewer.erase(*i);
          if (isEnough(fewer) == Sat::Outcome::Unsatisfiable) needed = std::move(fewer);
        }
      }
      supports_[a.rule].insert(needed.begin(), needed.end());
    }
    return !budget.isExhausted();
  }

  /// Whether a rule that is kept as well says more of the same cell.
  bool isWeaker(std::size_t i) const {
    using Kind = StateRule::Kind;
    const StateRule& rule = rules_[i];
    if (rule.kind > Kind::SignedAtMost) return false;
    return std::ranges::any_of(kept_, [&](std::size_t j) {
      const StateRule& other = rules_[j];
      const bool isOfSame = other.place == rule.place && other.where == rule.where;
      if (j == i || !isOfSame) return false;
      if (other.kind == Kind::OneOf) return true;
      if (other.kind != rule.kind) return false;
      const std::uint64_t flip = rule.kind >= Kind::SignedAtLeast ? 1ULL << (rule.place.width - 1) : 0;
      const std::uint64_t its = other.constants[0] ^ flip, own = rule.constants[0] ^ flip;
      return rule.kind == Kind::AtLeast || rule.kind == Kind::SignedAtLeast ? its > own : its < own;
    });
  }

  /// Each rule with all that it rests on, what these rest on, and so on.
  std::vector<StateRules> closures() const {
    std::set<std::size_t> touched;
    for (const After& a : after_) {
      if (kept_.contains(a.rule)) touched.insert(a.rule);
    }
    std::vector<std::set<std::size_t>> found;
    for (const std::size_t first : touched) {
      if (isWeaker(first)) continue;
      std::set<std::size_t> all{first};
      std::vector<std::size_t> open{first};
      while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        for (const std::size_t j : supports_[i]) {
          if (all.insert(j).second) open.push_back(j);
        }
      }
      if (std::ranges::find(found, all) == found.end()) found.push_back(std::move(all));
    }
    if (found.size() > mostSets) found.resize(mostSets);
    std::vector<StateRules> sets;
    for (const std::set<std::size_t>& all : found) {
      StateRules& set = sets.emplace_back();
      for (const std::size_t i : all) set.push_back(rules_[i]);
    }
    return sets;
  }

  const StateRules& rules_;
  TransitionSystem system_;
  std::vector<Node> before_;
  std::vector<After> after_;
  std::vector<int> beforeLiterals_;
  std::set<std::size_t> kept_;
  std::vector<std::set<std::size_t>> supports_;
};

}  // namespace

std::vector<StateRules> keptStates(Graph& graph, const std::vector<RunBounds::Cell>& cells,
                                   const std::vector<RunBounds::Run>& runs, const RuleHints& hints) {
  const StateRules rules = RuleGuess(graph, cells, hints).rules();
  return rules.empty() ? std::vector<StateRules>{} : RuleProof(graph, cells, runs, rules).sets();
}

}  // namespace rungproof
