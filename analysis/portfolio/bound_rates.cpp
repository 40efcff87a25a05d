// Multiples are as small as they can be: a clock that grows by 1 to 500 ms and a word that counts by 20 are compared as
// clock - 25 * word and word - 20 * clock.
#include "analysis/portfolio/bound_rates.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

/// A word that scans add constants to.
struct StepWord {
  std::size_t state = 0;
  std::set<std::uint64_t> up{}, down{};  ///< by how much
  std::set<std::uint64_t> upEnds{};      ///< where it may stop counting on: from there on
  std::set<std::uint64_t> downEnds{};    ///< and counting down: below
  bool isSigned = false;
};

class RateSearch {
 public:
  RateSearch(const TransitionSystem& system, const BitBlast& blast, const RateGuards& guards, const Budget& budget,
             BoundTemplates& to)
      : system_(system), graph_(*system.graph), blast_(blast), guards_(guards), budget_(budget), to_(to) {}

  void run(const std::vector<RateClock>& clocks, const std::vector<std::uint32_t>& states) {
    std::vector<StepWord> words;
    for (const std::uint32_t state : states) {
      const bool isClock = std::ranges::find(clocks, state, &RateClock::state) != clocks.end();
      if (auto word = isClock ? std::nullopt : stepWord(state)) words.push_back(std::move(*word));
    }
    for (const StepWord& word : words) {
      for (const RateClock& clock : clocks) {
        if (const auto limits = limitsOf(clock.increment)) compare(clock, *limits, word);
      }
    }
  }

 private:
  struct Range {
    std::uint64_t low, high;
  };

  int widthOf(Node n) const { return graph_[n].width; }
  Node word(std::size_t state) const { return system_.states[state].node; }
  /// The word, a sum of it with a constant, or what is chosen between these and anything else.
  bool leadsTo(Node n, Node self, int depth = 8) const {
    n = withoutExtension(graph_, n);
    const NodeData& node = graph_[n];
    if (n == self) return true;
    if (depth == 0) return false;
    if (node.op == Op::Extract) return node.value == 0 && leadsTo(node.child[0], self, depth - 1);
    if (node.op == Op::Add) return graph_[node.child[1]].op == Op::Constant && leadsTo(node.child[0], self, depth - 1);
    return node.op == Op::Ite && (leadsTo(node.child[1], self, depth - 1) || leadsTo(node.child[2], self, depth - 1));
  }

  std::optional<StepWord> stepWord(std::size_t state) const {
    const Node self = word(state);
    StepWord found{.state = state, .isSigned = widthOf(self) >= 16};
    if (widthOf(self) < 3 || widthOf(self) > 32) return std::nullopt;
    const Node roots[] = {system_.states[state].next};
    for (const Node n : coneOf(graph_, roots)) {
      const NodeData& node = graph_[n];
      if (node.op == Op::Add && graph_[node.child[1]].op == Op::Constant && leadsTo(node.child[0], self)) {
        const std::uint64_t value = graph_[node.child[1]].value, mask = Graph::maskOf(node.width);
        if (value <= mask / 2)
          found.up.insert(value);
        else
          found.down.insert((0 - value) & mask);
      }
      if (node.op != Op::Equal && !isOrder(node.op)) continue;
      for (const std::size_t side : {0U, 1U}) {
        if (!leadsTo(node.child[1 - side], self)) continue;
        // x < 5 and 4 < x part the numbers in front of 5, x <= 5 and 5 < x behind it.
        const bool isBehind =
            side == 1 ? node.op == Op::Ule || node.op == Op::Sle : node.op == Op::Ult || node.op == Op::Slt;
        for (const std::uint64_t limit : constantsOf(node.child[side])) {
          const std::uint64_t end = limit + (isBehind ? 1 : 0);
          if (end > Graph::maskOf(widthOf(self))) continue;
          found.upEnds.insert(end);
          found.downEnds.insert(node.op == Op::Equal ? end + 1 : end);
        }
      }
    }
    const bool counts = !found.up.empty() || !found.down.empty();
    if (!counts || found.up.size() + found.down.size() > schedule::stepsOfWord) return std::nullopt;
    for (std::set<std::uint64_t>* ends : {&found.upEnds, &found.downEnds}) {
      while (ends->size() > schedule::stopLimit) ends->erase(std::prev(ends->end()));
    }
    return found;
  }
  /// What a node is or may be chosen to be.
  std::set<std::uint64_t> constantsOf(Node n, int depth = 8) const {
    n = withoutExtension(graph_, n);
    const NodeData& node = graph_[n];
    if (node.op == Op::Constant) return {node.value};
    std::set<std::uint64_t> result;
    if (depth == 0) return result;
    if (node.op == Op::Extract && node.value == 0) return constantsOf(node.child[0], depth - 1);
    if (node.op == Op::Ite) {
      result = constantsOf(node.child[1], depth - 1);
      result.merge(constantsOf(node.child[2], depth - 1));
    }
    return result;
  }

  /// The least and the largest value of an increment under the constraints.
  std::optional<Range> limitsOf(Node increment) {
    if (graph_[increment].op == Op::Constant) return Range{graph_[increment].value, graph_[increment].value};
    const auto [known, isNew] = limits_.try_emplace(indexOf(increment));
    if (!isNew) return known->second;
    Unrolling scan(blast_.bits(), Unrolling::Start::Any);
    Sat sat(Sat::Use::Many);
    BitCnf cnf(scan.graph(), sat);
    for (const Lit constraint : blast_.bits().constraints) sat.add({cnf.literal(scan.at(0, constraint))});
    std::vector<int> bits;
    for (const Lit l : blast_.of(increment)) bits.push_back(cnf.literal(scan.at(0, l)));
    const auto extreme = [&](bool isLargest) -> std::optional<std::uint64_t> {
      std::vector<int> assumed;
      std::uint64_t value = 0;
      for (std::size_t i = bits.size(); i-- > 0;) {
        assumed.push_back(isLargest ? bits[i] : -bits[i]);
        const Sat::Outcome outcome = sat.solve(assumed, budget_);
        if (outcome == Sat::Outcome::Unknown) return std::nullopt;
        const bool isPossible = outcome == Sat::Outcome::Satisfiable;
        if (!isPossible) assumed.back() = -assumed.back();
        if (isPossible == isLargest) value |= 1ULL << i;
      }
      return value;
    };
    const auto high = extreme(true), low = extreme(false);
    if (high && low && *high > 0 && *high < Graph::maskOf(static_cast<int>(bits.size()))) known->second = {*low, *high};
    return known->second;
  }

  void compare(const RateClock& clock, const Range& scan, const StepWord& step) {
    const std::vector<Node> guards = guards_(clock.state, step.state);
    for (const bool isDown : {false, true}) {
      const std::set<std::uint64_t>& amounts = isDown ? step.down : step.up;
      if (amounts.empty()) continue;
      // The clock is at most so far ahead of the word that counts by the least amount in every scan, until it stops.
      const Node ahead = difference(clock, *amounts.begin(), step, scan.high, isDown, false);
      // The word that counts by the largest amount is at most so far ahead of the clock, until that stops.
      const Node behind = scan.low == 0 ? noNode : difference(clock, *amounts.rbegin(), step, scan.low, isDown, true);
      for (const Node guard : guards) {
        to_.templates.push_back({guard, noNode, ahead});
        for (const std::uint64_t end : isDown ? step.downEnds : step.upEnds)
          to_.templates.push_back({guard, hasStopped(step, end, isDown), ahead});
        if (behind == noNode) continue;
        to_.templates.push_back({guard, noNode, behind});
        for (const std::uint64_t stop : clock.stops) {
          const Node at = word(clock.state);
          const Node isOver = graph_.make(Op::Ule, 1, graph_.constantNode(stop, widthOf(at)), at);
          to_.templates.push_back({guard, isOver, behind});
        }
      }
    }
  }
  Node hasStopped(const StepWord& step, std::uint64_t end, bool isDown) {
    const Node at = word(step.state);
    const Node isBelow = graph_.make(step.isSigned ? Op::Slt : Op::Ult, 1, at,
                                     graph_.constantNode(end & Graph::maskOf(widthOf(at)), widthOf(at)));
    return isDown ? isBelow : graph_.make(Op::Not, 1, isBelow);
  }
  /// amount * clock - length * word where the word counts on, the sum where it counts down; or the negative of either.
  Node difference(const RateClock& clock, std::uint64_t amount, const StepWord& step, std::uint64_t length, bool isDown,
                  bool isBehind) {
    Rate rate{noNode, word(clock.state), clock.increment, word(step.state), amount, isDown, isBehind, step.isSigned};
    const std::uint64_t common = std::gcd(amount, length);
    amount /= common;
    length /= common;
    const auto bitsOf = [](std::uint64_t factor) { return static_cast<int>(std::bit_width(factor)); };
    const int width = 2 + std::max(widthOf(rate.clock) + bitsOf(amount), widthOf(rate.word) + bitsOf(length));
    const auto times = [&](Node n, std::uint64_t factor, Op extension) {
      const Node wide = graph_.make(extension, width, n);
      return factor == 1 ? wide : graph_.make(Op::Mul, width, wide, graph_.constantNode(factor, width));
    };
    const Node time = times(rate.clock, amount, Op::Zext);
    Node way = times(rate.word, length, step.isSigned ? Op::Sext : Op::Zext);
    if (isDown) way = graph_.make(Op::Sub, width, graph_.constantNode(0, width), way);
    rate.difference = isBehind ? graph_.make(Op::Sub, width, way, time) : graph_.make(Op::Sub, width, time, way);
    to_.rates.push_back(rate);
    return rate.difference;
  }

  const TransitionSystem& system_;
  Graph& graph_;
  const BitBlast& blast_;
  const RateGuards& guards_;
  const Budget& budget_;
  std::map<std::uint32_t, std::optional<Range>> limits_;  ///< by node of an increment
  BoundTemplates& to_;
};

}  // namespace

void addRates(BoundTemplates& to, const TransitionSystem& system, const BitBlast& blast,
              const std::vector<RateClock>& clocks, const std::vector<std::uint32_t>& states, const RateGuards& guards,
              const Budget& budget) {
  RateSearch(system, blast, guards, budget, to).run(clocks, states);
}

}  // namespace rungproof
