// Paths through a block of the S7-300/400, reasoned from the jumps of each text (002:2790-2824).
#include <algorithm>
#include <set>

#include "analysis/flow/statement_paths.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

/// Steps that may follow the step of that number.
std::vector<std::uint32_t> nextOf(const std::string& statements, std::uint32_t at) {
  const Linted linted(ob1(statements), {*cpuNamed("319-3"), usualEdition(*cpuNamed("319-3"))});
  std::vector<std::uint32_t> next;
  eachNext(linted.facts->plan().flows[0], at, [&](std::uint32_t step) { next.push_back(step); });
  std::sort(next.begin(), next.end());
  return next;
}
using Steps = std::vector<std::uint32_t>;

TEST(StatementPaths, JumpsEndsAndLists) {
  EXPECT_EQ(nextOf("A I 0.0;\nJC m;\nS Q 0.0;\nm: NOP 0;", 0), (Steps{1}));
  EXPECT_EQ(nextOf("A I 0.0;\nJC m;\nS Q 0.0;\nm: NOP 0;", 1), (Steps{2, 3}));  // the label is a step of its own
  EXPECT_EQ(nextOf("A I 0.0;\nJU m;\nS Q 0.0;\nm: NOP 0;", 1), (Steps{3}));
  EXPECT_EQ(nextOf("A I 0.0;\nBEC;\nS Q 0.0;", 1), (Steps{2, 3}));
  EXPECT_EQ(nextOf("A I 0.0;\nBEU;\nS Q 0.0;", 1), (Steps{3}));
  EXPECT_EQ(nextOf("L MB 0;\nJL e;\nJU a;\nJU a;\ne: NOP 0;\na: NOP 0;", 1), (Steps{2, 3, 4}));
  EXPECT_EQ(nextOf("m: L 1;\nT MW 0;\nLOOP m;", 3), (Steps{0, 4}));
}

struct Seen {
  std::set<std::uint32_t> steps;
  bool join(const Seen& other) {
    const std::size_t before = steps.size();
    steps.insert(other.steps.begin(), other.steps.end());
    return steps.size() != before;
  }
};

TEST(StatementPaths, StatesMeetAtLabelsAndGoRoundLoops) {
  const Linted linted(ob1("m: A I 0.0;\nJC e;\nS Q 0.0;\nJU m;\ne: NOP 0;"),
                      {*cpuNamed("319-3"), usualEdition(*cpuNamed("319-3"))});
  const Flow& flow = linted.facts->plan().flows[0];
  const auto before = statesOf(flow, Seen{}, [&](Seen& state, const FlowStep& step) {
    state.steps.insert(static_cast<std::uint32_t>(&step - flow.steps.data()));
  });
  ASSERT_EQ(flow.steps.size(), 7U);  // two labels
  EXPECT_EQ(before[0]->steps, (std::set<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(before[5]->steps, (std::set<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(before[7].has_value());
  EXPECT_TRUE(isPath(flow, 3, 1));
  EXPECT_FALSE(isPath(flow, 5, 1));
}

TEST(StatementPaths, WhatNoPathReachesHasNoState) {
  const Linted linted(ob1("A I 0.0;\nBEU;\n= Q 0.0;"), {*cpuNamed("319-3"), usualEdition(*cpuNamed("319-3"))});
  const auto before = statesOf(linted.facts->plan().flows[0], Seen{}, [](Seen&, const FlowStep&) {});
  EXPECT_FALSE(before[2].has_value());
  EXPECT_TRUE(before[3].has_value());
}

}  // namespace
}  // namespace rungproof::testing
