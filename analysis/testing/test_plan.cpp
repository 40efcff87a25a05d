// The shortest ways in the graph of the search; fragile steps count as long ways.
#include "analysis/testing/test_plan.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <random>

namespace rungproof {

namespace {

constexpr std::array<std::uint64_t, 6> timesBetween{100000, 200000, 300000, 500000, 800000, 1500000};  // us
constexpr std::size_t mostSteps = 60, fragileCost = 30;
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

class Planner {
 public:
  explicit Planner(const BenchSearch& search) : search_(search), leaving_(search.nodes().size()) {
    const std::vector<BenchSearch::Edge>& edges = search.edges();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      leaving_[edges[i].from].push_back(i);
      if (edges[i].isUseful) open_.push_back(i);
    }
  }

  std::vector<BenchTest> run() {
    std::vector<BenchTest> tests;
    while (!open_.empty()) {
      BenchTest test;
      std::size_t at = 0;
      while (test.size() < mostSteps) {
        const std::vector<std::size_t> way = nearest(at, test.empty());
        if (way.empty()) break;
        for (const std::size_t edge : way) {
          test.push_back(search_.edges()[edge].step);
          at = search_.edges()[edge].to;
          std::erase(open_, edge);
        }
      }
      if (test.empty()) break;
      tests.push_back(std::move(test));
    }
    return tests;
  }

 private:
  static std::size_t costOf(const BenchSearch::Edge& edge) { return edge.isFragile ? fragileCost : 1; }

  /// The way to and along the nearest open edge; empty: none, or a new test gets there sooner.
  std::vector<std::size_t> nearest(std::size_t from, bool isBeginning) const {
    const std::vector<BenchSearch::Edge>& edges = search_.edges();
    std::vector<std::size_t> cost(search_.nodes().size(), nowhere), by(search_.nodes().size(), nowhere);
    using Entry = std::pair<std::size_t, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    cost[from] = 0;
    queue.push({0, from});
    std::size_t best = nowhere, found = nowhere;
    while (!queue.empty() && queue.top().first < best) {
      const auto [now, node] = queue.top();
      queue.pop();
      if (now > cost[node]) continue;
      for (const std::size_t i : leaving_[node]) {
        const BenchSearch::Edge& edge = edges[i];
        const std::size_t next = now + costOf(edge);
        if (std::ranges::find(open_, i) != open_.end() && next < best) {
          best = next;
          found = i;
        }
        if (edge.to == 0 || next >= cost[edge.to]) continue;
        cost[edge.to] = next;
        by[edge.to] = i;
        queue.push({next, edge.to});
      }
    }
    if (found == nowhere) return {};
    if (!isBeginning && best > search_.nodes()[edges[found].from].depth + 2) return {};
    std::vector<std::size_t> way{found};
    for (std::size_t at = edges[found].from; at != from; at = edges[by[at]].from) way.insert(way.begin(), by[at]);
    return way;
  }

  const BenchSearch& search_;
  std::vector<std::vector<std::size_t>> leaving_;  ///< edges by node
  std::vector<std::size_t> open_;                  ///< useful edges that no test has
};

}  // namespace

std::vector<BenchTest> plannedTests(const BenchSearch& search) { return Planner(search).run(); }

std::vector<BenchTest> walks(const BenchSearch& search, std::uint64_t seed, std::size_t count, std::size_t length,
                             Pace pace) {
  std::vector<std::vector<std::size_t>> leaving(search.nodes().size());
  for (std::size_t i = 0; i < search.edges().size(); ++i) {
    const BenchSearch::Edge& edge = search.edges()[i];
    const bool isSettled = !edge.isFragile && (edge.step.wait.isTime() || edge.step.wait.scans > 1);
    if (edge.to != 0 && (isSettled || pace != Pace::Settled)) leaving[edge.from].push_back(i);
  }
  std::mt19937_64 random(seed);
  std::vector<std::size_t> uses(search.edges().size(), 0);
  std::vector<BenchTest> tests;
  while (tests.size() < count) {
    BenchTest test;
    for (std::size_t at = 0; test.size() < length && !leaving[at].empty();) {
      // Of three drawn ones the least used: walks spread, and time passes as often as inputs change.
      std::size_t edge = leaving[at][random() % leaving[at].size()];
      for (int i = 0; i < 2; ++i) {
        const std::size_t other = leaving[at][random() % leaving[at].size()];
        if (uses[other] < uses[edge]) edge = other;
      }
      ++uses[edge];
      test.push_back(search.edges()[edge].step);
      const bool isQuick = pace == Pace::Quick || (pace != Pace::Settled && random() % 2 == 0);
      const bool isTimed = pace == Pace::Timed && !isQuick;
      if (isQuick && !test.back().wait.isTime()) test.back().wait = {1, 0};
      if (isTimed && !test.back().changes.empty()) test.back().wait = {1, timesBetween[random() % timesBetween.size()]};
      at = search.edges()[edge].to;
    }
    if (test.empty()) break;
    tests.push_back(std::move(test));
  }
  return tests;
}

BenchTest wayTo(const BenchSearch& search, const BenchSearch::Edge& edge) {
  BenchTest way{edge.step};
  for (std::size_t at = edge.from; at != 0; at = search.nodes()[at].parent)
    way.insert(way.begin(), search.nodes()[at].step);
  return way;
}

}  // namespace rungproof
