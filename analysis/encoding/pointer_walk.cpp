// Successors of a tuple are the models of the next-state functions, one after the other.
#include "analysis/encoding/pointer_walk.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/bit_cnf.hpp"
#include "analysis/graph/evaluate.hpp"

namespace rungproof {

namespace {

constexpr std::size_t companionLimit = 12;  ///< cells that are tried
constexpr std::size_t tupleLimit = 1024;
constexpr std::size_t firstTuples = 64;    ///< in the first turn; twice as many in each that follows
constexpr std::size_t triedSteps = 12;     ///< that are looked at first
constexpr std::size_t mostOfOneStep = 64;  ///< values of the pointer after one of them
constexpr std::size_t coneLimit = 20000;   ///< nodes of the next-state functions
constexpr int solverLimit = 4000;          ///< calls of the solver, so that the answer does not depend on the machine
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
    const Budget budget = Budget::seconds(walkSeconds);
    if (isBoundless(near, budget)) return std::nullopt;
    std::vector<std::vector<Node>> attempts{{}};
    for (const Node n : near) attempts.push_back({n});
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (std::size_t j = i + 1; j < near.size(); ++j) attempts.push_back({near[i], near[j]});
    }
    for (std::vector<Node>& others : attempts) others.insert(others.begin(), pointer_);
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

  /// The next-state functions of some cells, with a solver that gives their values one after the other.
  class Step {
   public:
    Step(const PointerWalk& walk, const std::vector<Node>& cells) : walk_(walk), cells_(cells) {
      system_.graph = &walk.graph_;
      std::vector<Node> roots = cells;
      roots.insert(roots.end(), walk.firstScans_.begin(), walk.firstScans_.end());
      for (const Node n : cells) {
        const StateVariable& state = walk.states_.at(n);
        isFree_.push_back(state.init == noNode || walk.graph_[state.init].op != Op::Constant);
        first_.push_back(isFree_.back() ? 0 : walk.graph_[state.init].value);
        roots.push_back(state.next);
      }
      if (coneOf(walk.graph_, roots).size() > coneLimit) return;
      blast_.emplace(system_, std::vector<std::size_t>{}, roots);
      cnf_.emplace(blast_->bits(), sat_);
      for (const Node n : cells) {
        from_.push_back(literals(n));
        to_.push_back(literals(walk.states_.at(n).next));
      }
      for (const Node n : walk.firstScans_) inFirst_.push_back(literals(n)[0]);
    }
    bool isTooLarge() const { return !blast_; }
    /// What the cells start with; any value of those without a start.
    const Tuple& first() const { return first_; }

    /// Hands each tuple that may follow to `take`, which gives whether it wants more. They differ in the first
    /// `compared` cells. False if that was cut off.
    template <class Take>
    bool successors(const Tuple& tuple, bool isFirst, std::size_t compared, int& calls, const Budget& budget,
                    const Take& take) {
      const int round = sat_.newVariable();
      std::vector<int> assumptions{round};
      for (const int l : inFirst_) assumptions.push_back(isFirst ? l : -l);
      for (std::size_t c = 0; c < cells_.size(); ++c) {
        if (isFirst && isFree_[c]) continue;
        for (std::size_t bit = 0; bit < from_[c].size(); ++bit)
          assumptions.push_back((tuple[c] >> bit & 1U) != 0 ? from_[c][bit] : -from_[c][bit]);
      }
      for (;;) {
        if (++calls > solverLimit) return false;
        if (walk_.interruption_) walk_.interruption_();
        const Sat::Outcome outcome = sat_.solve(assumptions, budget);
        if (outcome == Sat::Outcome::Unknown) return false;
        if (outcome == Sat::Outcome::Unsatisfiable) break;
        Tuple next;
        std::vector<int> differs{-round};
        for (const std::vector<int>& cell : to_) {
          const bool isCompared = next.size() < compared;
          next.push_back(0);
          for (std::size_t bit = 0; bit < cell.size(); ++bit) {
            const bool isSet = sat_.value(cell[bit]);
            next.back() |= static_cast<std::uint64_t>(isSet) << bit;
            if (isCompared) differs.push_back(isSet ? -cell[bit] : cell[bit]);
          }
        }
        sat_.add(differs);
        if (!take(std::move(next))) return false;
      }
      sat_.add({-round});
      return true;
    }

   private:
    std::vector<int> literals(Node n) {
      std::vector<int> result;
      for (const Lit l : blast_->of(n)) result.push_back(cnf_->literal(l));
      return result;
    }

    const PointerWalk& walk_;
    const std::vector<Node>& cells_;
    TransitionSystem system_;  ///< in which variables are inputs of one step
    Tuple first_;
    std::vector<bool> isFree_;  ///< at the start of the first scan
    std::optional<BitBlast> blast_;
    Sat sat_{Sat::Use::Many};
    std::optional<BitCnf> cnf_;
    std::vector<std::vector<int>> from_, to_;
    std::vector<int> inFirst_;
  };

  /// Whether the pointer may go too far in one step although all that might limit it is known: nothing limits it then.
  bool isBoundless(const std::vector<Node>& near, const Budget& budget) {
    std::vector<Node> all{pointer_};
    all.insert(all.end(), near.begin(), near.end());
    Step step(*this, all);
    if (step.isTooLarge()) return false;
    std::vector<Tuple> tried{step.first()};
    for (std::size_t i = 0; i < tried.size() && i < triedSteps; ++i) {
      std::size_t count = 0;
      step.successors(Tuple(tried[i]), i == 0, 1, calls_, budget, [&](Tuple next) {
        if (tried.size() < triedSteps && std::ranges::find(tried, next) == tried.end())
          tried.push_back(std::move(next));
        return ++count <= mostOfOneStep;
      });
      if (count > mostOfOneStep) return true;
    }
    return false;
  }

  /// Closes the initial tuple under all steps; nothing if the tuples become too many.
  std::optional<Walk> follow(const std::vector<Node>& cells, const Budget& budget) {
    Step step(*this, cells);
    if (step.isTooLarge()) return std::nullopt;
    std::set<Tuple> seen;  // at the start of scans that are not the first one
    std::vector<Tuple> open{step.first()};
    std::set<std::uint64_t> values;
    for (bool isFirst = true; !open.empty(); isFirst = false) {
      const Tuple tuple = std::move(open.back());
      open.pop_back();
      const bool isWhole = step.successors(tuple, isFirst, cells.size(), calls_, budget, [&](Tuple next) {
        values.insert(next[0]);
        if (seen.insert(next).second) open.push_back(std::move(next));
        isCut_ = seen.size() > most_ && most_ < tupleLimit;
        return seen.size() <= most_ && values.size() <= limit_;
      });
      if (!isWhole) return std::nullopt;
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
