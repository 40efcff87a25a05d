// Samples word values on some of the 64 random runs, finds pairs with equal growth, and writes the bounds seen.
#include "analysis/portfolio/invariants_words.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <unordered_map>

#include "analysis/bits/simulation_runs.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

struct Word {
  std::size_t state = 0;  ///< index in TransitionSystem::states
  int width = 0;
  std::vector<Lit> bits;             ///< lowest first
  std::vector<std::int64_t> values;  ///< by lane, then scan
  std::vector<std::uint64_t> caps;   ///< constants its next value is chosen from or compared with
};

class DifferenceGuess {
 public:
  DifferenceGuess(const TransitionSystem& system, const BitBlast& blast, std::uint64_t seed, const Budget& budget)
      : system_(system), graph_(*system.graph), blast_(blast), budget_(budget), runs_(blast.bits(), seed) {}

  std::vector<NodeClause> run() {
    collect();
    sample();
    std::erase_if(words_, [&](const Word& w) { return !counts(w); });
    if (words_.size() > schedule::countingWords) words_.resize(schedule::countingWords);
    for (Word& word : words_) collectCaps(word);
    for (std::size_t i = 0; i < words_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (growTogether(words_[i], words_[j])) {
          bound(words_[i], words_[j]);
          bound(words_[j], words_[i]);
        }
      }
    }
    return std::move(clauses_);
  }

 private:
  void collect() {
    std::unordered_map<std::uint32_t, std::size_t> index;
    for (std::uint32_t latch = 0; latch < blast_.bits().latches.size(); ++latch) {
      const auto [state, bit] = blast_.stateBit(latch);
      const int width = graph_[system_.states[state].node].width;
      if (width < 4 || width > 32) continue;
      const auto [at, isNew] = index.emplace(state, words_.size());
      if (isNew) words_.push_back({state, width, std::vector<Lit>(static_cast<std::size_t>(width), falseLit), {}, {}});
      words_[at->second].bits[bit] = positive(blast_.bits().latches[latch].variable);
    }
  }

  void sample() {
    int taken = 0;
    for (; taken < schedule::wordScans && !budget_.isExhausted() && runs_.choose() && runs_.live() == ~0ULL; ++taken) {
      for (Word& word : words_) {
        std::size_t base = word.values.size();
        word.values.resize(base + schedule::wordLanes, 0);
        for (std::size_t bit = 0; bit < word.bits.size(); ++bit) {
          const std::uint64_t value = runs_.simulator().value(word.bits[bit]);
          for (std::size_t lane = 0; lane < schedule::wordLanes; ++lane) {
            word.values[base + lane] |= static_cast<std::int64_t>(value >> laneOf(lane) & 1U) << bit;
          }
        }
      }
      runs_.step();
    }
  }

  /// Sampled lanes, four of each pace of input changes.
  static std::size_t laneOf(std::size_t i) { return i * schedule::wordLaneStep + i / schedule::wordLaneStep; }

  static bool counts(const Word& word) {
    std::set<std::int64_t> different(word.values.begin(), word.values.end());
    return different.size() >= 4;
  }

  /// Mostly the same positive growth wherever both are on their way, and never far apart.
  static bool growTogether(const Word& x, const Word& y) {
    int same = 0, other = 0;
    std::int64_t low = 0, high = 0, most = 0;
    const std::int64_t capX = x.caps.empty() ? 0 : static_cast<std::int64_t>(x.caps.front());
    const std::int64_t capY = y.caps.empty() ? 0 : static_cast<std::int64_t>(y.caps.front());
    for (std::size_t i = schedule::wordLanes; i < x.values.size(); ++i) {
      const std::int64_t vx = x.values[i], vy = y.values[i];
      const std::int64_t dx = vx - x.values[i - schedule::wordLanes], dy = vy - y.values[i - schedule::wordLanes];
      if (dx > 0 || dy > 0) (dx == dy ? same : other) += 1;
      if (3 * other > same + 48) return false;
      most = std::max(most, std::min(vx, vy));
      if ((capX != 0 && vx >= capX) || (capY != 0 && vy >= capY)) continue;
      low = std::min(low, vx - vy);
      high = std::max(high, vx - vy);
    }
    return same >= 16 && same > 3 * other && high - low <= most / 3;
  }

  /// Clauses "x - y <= hi or y >= cap" for no cap and each cap of y.
  void bound(const Word& x, const Word& y) {
    std::vector<std::uint64_t> caps = y.caps;
    caps.push_back(0);  // none
    for (const std::uint64_t cap : caps) {
      std::int64_t high = std::numeric_limits<std::int64_t>::min();
      for (std::size_t i = 0; i < x.values.size(); ++i) {
        if (cap == 0 || y.values[i] < static_cast<std::int64_t>(cap)) high = std::max(high, x.values[i] - y.values[i]);
      }
      if (high > schedule::widestDifference || high < -schedule::widestDifference) continue;
      NodeClause clause{atMost(x, y, high)};
      if (cap != 0)
        clause.push_back(graph_.make(Op::Ule, 1, graph_.constantNode(cap, y.width), system_.states[y.state].node));
      clauses_.push_back(std::move(clause));
    }
  }

  /// x - y <= high, in enough bits.
  Node atMost(const Word& x, const Word& y, std::int64_t high) {
    const Node a = system_.states[x.state].node, b = system_.states[y.state].node;
    if (high == 0 && x.width == y.width) return graph_.make(Op::Ule, 1, a, b);
    const int width = std::max({x.width, y.width, 21}) + 2;
    const auto wide = [&](Node n) { return graph_[n].width == width ? n : graph_.make(Op::Zext, width, n); };
    const Node shift = graph_.constantNode(static_cast<std::uint64_t>(high < 0 ? -high : high), width);
    return high >= 0 ? graph_.make(Op::Ule, 1, wide(a), graph_.make(Op::Add, width, wide(b), shift))
                     : graph_.make(Op::Ule, 1, graph_.make(Op::Add, width, wide(a), shift), wide(b));
  }

  /// Constants in the next-state function that the word may stop at, without passing other state words.
  void collectCaps(Word& word) {
    std::set<std::uint64_t> found;
    std::set<Node> visited;
    std::vector<Node> stack{system_.states[word.state].next};
    while (!stack.empty() && visited.size() < 200) {
      const Node n = stack.back();
      stack.pop_back();
      if (!visited.insert(n).second) continue;
      const NodeData& node = graph_[n];
      const bool isLeaf = node.op == Op::Variable;
      if (node.op == Op::Constant && node.value > 3 && node.value <= Graph::maskOf(word.width))
        found.insert(node.value);
      for (const Node child : node.child) {
        if (child != noNode && !isLeaf) stack.push_back(child);
      }
    }
    word.caps.assign(found.begin(), found.end());
    if (word.caps.size() > schedule::capLimit)
      word.caps.erase(word.caps.begin(), word.caps.end() - static_cast<std::ptrdiff_t>(schedule::capLimit));
  }

  const TransitionSystem& system_;
  Graph& graph_;
  const BitBlast& blast_;
  const Budget& budget_;
  SimulationRuns runs_;
  std::vector<Word> words_;
  std::vector<NodeClause> clauses_;
};

}  // namespace

std::vector<NodeClause> guessDifferences(const TransitionSystem& system, const BitBlast& blast, std::uint64_t seed,
                                         const Budget& budget) {
  return DifferenceGuess(system, blast, seed, budget).run();
}

}  // namespace rungproof
