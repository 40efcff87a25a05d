// Hints: a comparison of an input, also behind a sum with a constant or as a part of a wider value, with a constant
// says which values of the input decide it.
#include "analysis/portfolio/word_runs.hpp"

#include <algorithm>
#include <random>
#include <unordered_map>
#include <unordered_set>

#include "analysis/graph/evaluate.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

/// Values for some inputs, by index in TransitionSystem::inputs.
using Hint = std::vector<std::pair<std::size_t, std::uint64_t>>;

bool isLongArithmetic(const Graph& graph, Node n) {
  const NodeData& node = graph[n];
  const bool isProduct = node.op == Op::Mul || node.op == Op::Udiv || node.op == Op::Urem || node.op == Op::Sdiv ||
                         node.op == Op::Srem || node.op == Op::RealMul || node.op == Op::RealDiv;
  return isProduct && node.width >= schedule::wordRunBits && graph[node.child[0]].op != Op::Constant &&
         graph[node.child[1]].op != Op::Constant;
}

class WordRuns {
 public:
  WordRuns(const TransitionSystem& system, const Questions& open, std::uint64_t seed)
      : system_(system), graph_(*system.graph), open_(open), random_(seed) {
    for (std::size_t i = 0; i < system.inputs.size(); ++i) inputAt_.emplace(indexOf(system.inputs[i]), i);
  }

  std::vector<std::optional<WordTrace>> run(const Budget& budget) {
    std::vector<std::optional<WordTrace>> found(open_.size());
    std::vector<Node> roots = system_.constraints;
    for (const std::size_t q : open_) roots.push_back(system_.questions[q].bad);
    for (const StateVariable& state : system_.states) roots.push_back(state.next);
    const std::vector<Node> cone = coneOf(graph_, roots);
    const bool isLong = std::ranges::any_of(cone, [&](Node n) { return isLongArithmetic(graph_, n); });
    if (!isLong || cone.size() > schedule::wordRunNodes) return found;
    for (const Node n : cone) addHints(n);
    for (const Node n : coneOf(graph_, system_.constraints)) {
      if (const auto input = inputAt_.find(indexOf(n)); input != inputAt_.end()) constrained_.push_back(input->second);
    }
    LaneEvaluator values(graph_, roots);
    for (int round = 0; round < schedule::wordRunRounds && !budget.isExhausted(); ++round) {
      if (oneRound(values, round, found)) break;
    }
    return found;
  }

 private:
  static constexpr int lanes = LaneEvaluator::lanes;

  /// Whether all questions are answered.
  bool oneRound(LaneEvaluator& values, int round, std::vector<std::optional<WordTrace>>& found) {
    std::vector<std::vector<std::uint64_t>> initial(system_.states.size(), std::vector<std::uint64_t>(lanes, 0));
    for (std::size_t s = 0; s < system_.states.size(); ++s) {
      const Node init = system_.states[s].init;
      const std::uint64_t mask = Graph::maskOf(graph_[system_.states[s].node].width);
      for (int lane = 0; lane < lanes; ++lane) {
        const bool isKnown = init != noNode && graph_[init].op == Op::Constant;
        initial[s][static_cast<std::size_t>(lane)] = isKnown ? graph_[init].value : lane == 0 ? 0 : random_() & mask;
        values.set(system_.states[s].node, lane, initial[s][static_cast<std::size_t>(lane)]);
      }
    }
    std::uint64_t live = ~0ULL;
    std::vector<std::vector<std::vector<std::uint64_t>>> scans;  // by scan and lane: inputs
    for (int scan = 0; scan < schedule::wordRunScans && live != 0; ++scan) {
      scans.push_back(chooseInputs(round + scan));
      std::uint64_t legal = compute(values, scans.back());
      for (int attempt = 0; attempt < schedule::wordRunRedraws && (~legal & live) != 0; ++attempt) {
        redraw(scans.back(), ~legal & live);
        legal = compute(values, scans.back());
      }
      live &= legal;
      if (takeBad(values, live, initial, scans, found)) return true;
      advance(values);
    }
    return false;
  }

  /// The lanes in which these inputs meet the constraints.
  std::uint64_t compute(LaneEvaluator& values, const std::vector<std::vector<std::uint64_t>>& inputs) const {
    for (std::size_t lane = 0; lane < inputs.size(); ++lane) {
      for (std::size_t i = 0; i < inputs[lane].size(); ++i)
        values.set(system_.inputs[i], static_cast<int>(lane), inputs[lane][i]);
    }
    values.run();
    std::uint64_t ok = ~0ULL;
    for (const Node constraint : system_.constraints) ok &= values.bits(constraint);
    return ok;
  }

  bool takeBad(const LaneEvaluator& values, std::uint64_t live, const std::vector<std::vector<std::uint64_t>>& initial,
               const std::vector<std::vector<std::vector<std::uint64_t>>>& scans,
               std::vector<std::optional<WordTrace>>& found) const {
    bool isDone = true;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const std::uint64_t bad = found[i] ? 0 : values.bits(system_.questions[open_[i]].bad) & live;
      if (bad != 0) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bad));
        WordTrace& trace = found[i].emplace();
        for (const std::vector<std::uint64_t>& state : initial) trace.initial.push_back(state[lane]);
        for (const auto& scan : scans) trace.inputs.push_back(scan[lane]);
      }
      isDone = isDone && found[i].has_value();
    }
    return isDone;
  }

  void advance(LaneEvaluator& values) const {
    std::vector<std::uint64_t> next(system_.states.size() * lanes);
    for (std::size_t s = 0; s < system_.states.size(); ++s) {
      for (int lane = 0; lane < lanes; ++lane)
        next[s * lanes + static_cast<std::size_t>(lane)] = values.at(system_.states[s].next, lane);
    }
    for (std::size_t s = 0; s < system_.states.size(); ++s) {
      for (int lane = 0; lane < lanes; ++lane)
        values.set(system_.states[s].node, lane, next[s * lanes + static_cast<std::size_t>(lane)]);
    }
  }

  std::uint64_t maskOf(std::size_t input) const { return Graph::maskOf(graph_[system_.inputs[input]].width); }

  /// The first lane has 0, the second all ones; the others begin with 0 or random values and follow some hints.
  std::vector<std::vector<std::uint64_t>> chooseInputs(int turn) {
    std::vector<std::vector<std::uint64_t>> chosen(lanes, std::vector<std::uint64_t>(system_.inputs.size(), 0));
    for (std::size_t lane = 1; lane < chosen.size(); ++lane) {
      const bool isRandom = lane % 4 == 3;
      for (std::size_t i = 0; i < system_.inputs.size(); ++i)
        chosen[lane][i] = lane == 1 ? maskOf(i) : isRandom ? random_() & maskOf(i) : 0;
      if (lane == 1 || hints_.empty()) continue;
      // Each hint alone first, then several together.
      const std::size_t one = (static_cast<std::size_t>(turn) * lanes + lane) % hints_.size();
      apply(hints_[one], chosen[lane]);
      for (std::size_t more = random_() % 4; more > 0; --more) apply(hints_[random_() % hints_.size()], chosen[lane]);
    }
    return chosen;
  }
  static void apply(const Hint& hint, std::vector<std::uint64_t>& inputs) {
    for (const auto& [input, value] : hint) inputs[input] = value;
  }
  void redraw(std::vector<std::vector<std::uint64_t>>& inputs, std::uint64_t wrong) {
    for (std::size_t lane = 0; lane < inputs.size(); ++lane) {
      if ((wrong >> lane & 1U) == 0) continue;
      for (const std::size_t i : constrained_) inputs[lane][i] = random_() & maskOf(i);
    }
  }

  void addHints(Node n) {
    const NodeData& node = graph_[n];
    const bool isCompare = node.op == Op::Equal || node.op == Op::Ult || node.op == Op::Ule || node.op == Op::Slt ||
                           node.op == Op::Sle || node.op == Op::RealEqual || node.op == Op::RealLess;
    if (!isCompare || hints_.size() > schedule::wordRunHints) return;
    const bool isFirst = graph_[node.child[0]].op == Op::Constant;
    const Node constant = node.child[isFirst ? 0 : 1], other = node.child[isFirst ? 1 : 0];
    if (graph_[constant].op != Op::Constant) return;
    const int width = graph_[other].width;
    for (const std::uint64_t distance : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
      Hint hint;
      meet(other, (graph_[constant].value + distance) & Graph::maskOf(width), hint);
      if (!hint.empty()) hints_.push_back(std::move(hint));
    }
  }

  /// Values of inputs with which the node has that value, as far as its form tells.
  void meet(Node n, std::uint64_t value, Hint& hint) const {
    const NodeData& node = graph_[n];
    switch (node.op) {
      case Op::Variable:
        if (const auto input = inputAt_.find(indexOf(n)); input != inputAt_.end())
          hint.emplace_back(input->second, value & Graph::maskOf(node.width));
        return;
      case Op::Concat: {
        const int low = graph_[node.child[1]].width;
        meet(node.child[0], value >> static_cast<unsigned>(low), hint);
        return meet(node.child[1], value & Graph::maskOf(low), hint);
      }
      case Op::Zext:
      case Op::Sext: return meet(node.child[0], value & Graph::maskOf(graph_[node.child[0]].width), hint);
      case Op::Add:
      case Op::Sub:
        if (graph_[node.child[1]].op != Op::Constant) return;
        return meet(node.child[0],
                    (node.op == Op::Add ? value - graph_[node.child[1]].value : value + graph_[node.child[1]].value) &
                        Graph::maskOf(node.width),
                    hint);
      default: return;
    }
  }

  const TransitionSystem& system_;
  const Graph& graph_;
  const Questions& open_;
  std::mt19937_64 random_;
  std::unordered_map<std::uint32_t, std::size_t> inputAt_;
  std::vector<Hint> hints_;
  std::vector<std::size_t> constrained_;  ///< inputs that constraints speak of
};

}  // namespace

std::vector<std::optional<WordTrace>> wordRuns(const TransitionSystem& system, const Questions& open,
                                               std::uint64_t seed, const Budget& budget) {
  return WordRuns(system, open, seed).run(budget);
}

}  // namespace rungproof
