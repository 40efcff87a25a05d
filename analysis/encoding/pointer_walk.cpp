// Successors of a tuple are the models of the next-state functions, one after the other.
#include "analysis/encoding/pointer_walk.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/bit_cnf.hpp"
#include "analysis/graph/evaluate.hpp"

namespace rungproof {

namespace {

constexpr std::size_t companionLimit = 12;  ///< cells that are tried
constexpr std::size_t tupleLimit = 1024;
constexpr std::size_t firstTuples = 64;   ///< in the first turn; twice as many in each that follows
constexpr std::size_t coneLimit = 20000;  ///< nodes of the next-state functions
constexpr int solverLimit = 4000;         ///< calls of the solver, so that the answer does not depend on the machine
constexpr double walkSeconds = 10;

using Tuple = std::vector<std::uint64_t>;

class PointerWalk {
 public:
  PointerWalk(const TransitionSystem& system, Node pointer, const std::vector<Node>& firstScans, std::size_t limit,
              const std::function<void()>& interruption)
      : graph_(*system.graph), pointer_(pointer), firstScans_(firstScans), limit_(limit), interruption_(interruption) {
    for (const StateVariable& s : system.states) states_.emplace(s.node, s);
  }

  std::optional<Walk> run() {
    const std::vector<Node> near = companions();
    std::vector<std::vector<Node>> attempts{{}};
    for (const Node n : near) attempts.push_back({n});
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (std::size_t j = i + 1; j < near.size(); ++j) attempts.push_back({near[i], near[j]});
    }
    for (std::vector<Node>& others : attempts) others.insert(others.begin(), pointer_);
    const Budget budget = Budget::seconds(walkSeconds);
    // Those that do not end need not be followed far before the others have had their turn.
    for (std::size_t most = firstTuples; !attempts.empty(); most *= 2) {
      most_ = std::min(most, tupleLimit);
      std::vector<std::vector<Node>> longer;
      for (const std::vector<Node>& cells : attempts) {
        isCut_ = false;
        if (auto walk = follow(cells, budget)) return walk;
        if (budget.isExhausted() || calls_ > solverLimit) return std::nullopt;
        if (isCut_) longer.push_back(cells);
      }
      attempts = std::move(longer);
    }
    return std::nullopt;
  }

 private:
  /// Memory words that the next value of the pointer depends on, without the registers of timers and counters.
  std::vector<Node> companions() const {
    std::vector<Node> result;
    const Node roots[] = {states_.at(pointer_).next};
    for (const Node n : coneOf(graph_, roots)) {
      const auto state = states_.find(n);
      if (state == states_.end() || n == pointer_ || graph_[n].width < 8 || graph_[n].width > 32) continue;
      const std::string& name = graph_.variables()[graph_[n].value].name;
      if (name[0] == 'T' || name.rfind("time.", 0) == 0 || result.size() == companionLimit) continue;
      result.push_back(n);
    }
    return result;
  }

  /// Closes the initial tuple under all steps; nothing if the tuples become too many.
  std::optional<Walk> follow(const std::vector<Node>& cells, const Budget& budget) {
    TransitionSystem step;  // variables are inputs of one step
    step.graph = &graph_;
    std::vector<Node> roots = cells;
    roots.insert(roots.end(), firstScans_.begin(), firstScans_.end());
    Tuple first;
    std::vector<bool> isFree;  // at the start of the first scan
    for (const Node n : cells) {
      const StateVariable& state = states_.at(n);
      isFree.push_back(state.init == noNode || graph_[state.init].op != Op::Constant);
      first.push_back(isFree.back() ? 0 : graph_[state.init].value);
      roots.push_back(state.next);
    }
    if (coneOf(graph_, roots).size() > coneLimit) return std::nullopt;
    BitBlast blast(step, {}, roots);
    Sat sat(Sat::Use::Many);
    BitCnf cnf(blast.bits(), sat);
    const auto literals = [&](Node n) {
      std::vector<int> result;
      for (const Lit l : blast.of(n)) result.push_back(cnf.literal(l));
      return result;
    };
    std::vector<std::vector<int>> from, to;
    for (const Node n : cells) {
      from.push_back(literals(n));
      to.push_back(literals(states_.at(n).next));
    }
    std::vector<int> inFirst;
    for (const Node n : firstScans_) inFirst.push_back(literals(n)[0]);
    std::set<Tuple> seen;  // at the start of scans that are not the first one
    std::vector<Tuple> open{first};
    std::set<std::uint64_t> values;
    for (bool isFirst = true; !open.empty(); isFirst = false) {
      const Tuple tuple = std::move(open.back());
      open.pop_back();
      const int round = sat.newVariable();
      std::vector<int> assumptions{round};
      for (const int l : inFirst) assumptions.push_back(isFirst ? l : -l);
      for (std::size_t c = 0; c < cells.size(); ++c) {
        if (isFirst && isFree[c]) continue;
        for (std::size_t bit = 0; bit < from[c].size(); ++bit)
          assumptions.push_back((tuple[c] >> bit & 1U) != 0 ? from[c][bit] : -from[c][bit]);
      }
      for (;;) {
        if (++calls_ > solverLimit) return std::nullopt;
        if (interruption_) interruption_();
        const Sat::Outcome outcome = sat.solve(assumptions, budget);
        if (outcome == Sat::Outcome::Unknown) return std::nullopt;
        if (outcome == Sat::Outcome::Unsatisfiable) break;
        Tuple next;
        std::vector<int> differs{-round};
        for (const std::vector<int>& cell : to) {
          next.push_back(0);
          for (std::size_t bit = 0; bit < cell.size(); ++bit) {
            const bool isSet = sat.value(cell[bit]);
            next.back() |= static_cast<std::uint64_t>(isSet) << bit;
            differs.push_back(isSet ? -cell[bit] : cell[bit]);
          }
        }
        sat.add(differs);
        values.insert(next[0]);
        if (seen.insert(next).second) open.push_back(std::move(next));
        isCut_ = seen.size() > most_ && most_ < tupleLimit;
        if (seen.size() > most_ || values.size() > limit_) return std::nullopt;
      }
      sat.add({-round});
    }
    return Walk{{values.begin(), values.end()}, cells, std::move(seen)};
  }

  Graph& graph_;
  const Node pointer_;
  const std::vector<Node>& firstScans_;
  const std::size_t limit_;
  const std::function<void()>& interruption_;
  std::map<Node, StateVariable> states_;
  std::size_t most_ = tupleLimit;  ///< tuples in this turn
  bool isCut_ = false;             ///< the last attempt ended for that
  int calls_ = 0;                  ///< of the solver, in all attempts
};

}  // namespace

std::optional<Walk> walkOf(const TransitionSystem& system, Node pointer, const std::vector<Node>& firstScans,
                           std::size_t limit, const std::function<void()>& interruption) {
  return PointerWalk(system, pointer, firstScans, limit, interruption).run();
}

}  // namespace rungproof
