// Pairing of jumps, loops and segments in a block, and what does not fit together (001:5750-5841).
#include "ir/flow.hpp"

#include <gtest/gtest.h>

#include "tests/manual/statement.hpp"

namespace rungproof {
namespace {

/// The flow of a main program; each text is a statement, a new network begins at "Network".
struct Sample {
  explicit Sample(const std::vector<std::string>& lines) {
    pou.networks.push_back({});
    for (const std::string& line : lines) {
      if (line == "Network")
        pou.networks.push_back({});
      else
        pou.networks.back().instructions.push_back(manual::statement(line));
    }
    flow = flowOf(pou);
  }
  std::uint32_t partner(std::uint32_t i) const { return flow.steps[i].partner; }
  /// The faults as (problem, index of the instruction).
  std::vector<std::pair<FlowProblem, std::uint32_t>> faults() const {
    std::vector<std::pair<FlowProblem, std::uint32_t>> list;
    for (const FlowFault& fault : flow.faults) list.emplace_back(fault.problem, indexOf(fault.instruction));
    return list;
  }
  std::uint32_t indexOf(const Instruction* instruction) const {
    for (std::uint32_t i = 0; i < flow.steps.size(); ++i) {
      if (flow.steps[i].instruction == instruction) return i;
    }
    return noPartner;
  }

  Pou pou;
  Flow flow;
};
using Faults = std::vector<std::pair<FlowProblem, std::uint32_t>>;

}  // namespace

TEST(Flow, StepsKnowTheirNetwork) {
  const Sample sample({"LD I0.0", "= Q0.0", "Network", "LD I0.1", "= Q0.1"});
  ASSERT_EQ(sample.flow.steps.size(), 4U);
  EXPECT_EQ(sample.flow.steps[1].network, 0U);
  EXPECT_EQ(sample.flow.steps[2].network, 1U);
  EXPECT_EQ(sample.partner(0), noPartner);
  EXPECT_TRUE(sample.faults().empty());
}

TEST(Flow, JumpsFindTheirLabelsInBothDirections) {
  const Sample sample({"LBL 1", "JMP 2", "JMP 1", "Network", "LBL 2", "JMP 3"});
  EXPECT_EQ(sample.partner(1), 3U);
  EXPECT_EQ(sample.partner(2), 0U);
  EXPECT_EQ(sample.partner(0), noPartner);
  EXPECT_EQ(sample.partner(4), noPartner);
  EXPECT_EQ(sample.faults(), (Faults{{FlowProblem::LabelMissing, 4}}));
}

TEST(Flow, ALabelStandsOnce) {
  const Sample sample({"LBL 7", "LBL 7", "JMP 7"});
  EXPECT_EQ(sample.faults(), (Faults{{FlowProblem::LabelTwice, 1}}));
  EXPECT_EQ(sample.flow.faults[0].other, sample.flow.steps[0].instruction);
  EXPECT_EQ(sample.partner(2), 0U) << "the first label counts";
}

TEST(Flow, LoopsNest) {
  const Sample sample({"FOR VW0, 1, 2", "FOR VW2, 1, 2", "NEXT", "NEXT"});
  EXPECT_EQ(sample.partner(0), 3U);
  EXPECT_EQ(sample.partner(1), 2U);
  EXPECT_EQ(sample.partner(2), 1U);
  EXPECT_EQ(sample.partner(3), 0U);
  EXPECT_TRUE(sample.faults().empty());
}

TEST(Flow, LoopsWithoutPartnerAndTooDeep) {
  EXPECT_EQ(Sample({"NEXT", "FOR VW0, 1, 2"}).faults(),
            (Faults{{FlowProblem::NextWithoutFor, 0}, {FlowProblem::ForWithoutNext, 1}}));
  std::vector<std::string> lines;
  for (int i = 0; i < 8; ++i) lines.push_back("FOR VW0, 1, 2");
  for (int i = 0; i < 8; ++i) lines.push_back("NEXT");
  EXPECT_TRUE(Sample(lines).faults().empty()) << "eight levels (001:5752)";
  lines.insert(lines.begin(), "FOR VW0, 1, 2");
  lines.push_back("NEXT");
  EXPECT_EQ(Sample(lines).faults(), (Faults{{FlowProblem::ForTooDeep, 8}}));
}

TEST(Flow, SegmentsPairAndKnowTheirTransitions) {
  const Sample sample({"LSCR S0.1", "SCRT S0.2", "CSCRE", "SCRE", "LSCR S0.2", "SCRT S0.1", "SCRE"});
  EXPECT_EQ(sample.partner(0), 3U);
  EXPECT_EQ(sample.partner(3), 0U);
  EXPECT_EQ(sample.partner(1), 0U) << "SCRT knows the segment it leaves";
  EXPECT_EQ(sample.partner(2), 3U) << "CSCRE goes to the end of its segment";
  EXPECT_EQ(sample.partner(5), 4U);
  EXPECT_TRUE(sample.faults().empty());
}

TEST(Flow, SegmentsThatDoNotFit) {
  EXPECT_EQ(Sample({"SCRE"}).faults(), (Faults{{FlowProblem::ScreWithoutLscr, 0}}));
  EXPECT_EQ(Sample({"LSCR S0.1"}).faults(), (Faults{{FlowProblem::LscrWithoutScre, 0}}));
  EXPECT_EQ(Sample({"LSCR S0.1", "LSCR S0.2", "SCRE"}).faults(), (Faults{{FlowProblem::LscrInsideSegment, 1}}));
  EXPECT_EQ(Sample({"SCRT S0.1", "CSCRE"}).faults(),
            (Faults{{FlowProblem::ScrtOutsideSegment, 0}, {FlowProblem::ScrtOutsideSegment, 1}}));
  EXPECT_EQ(Sample({"LSCR S0.1", "END", "SCRE", "END"}).faults(), (Faults{{FlowProblem::EndInsideSegment, 1}}));
}

TEST(Flow, JumpsStayInTheirSegment) {
  // 001:5792, 001:5818: within a segment, or over whole segments; not into one or out of one.
  EXPECT_TRUE(Sample({"LSCR S0.1", "JMP 1", "LBL 1", "SCRE"}).faults().empty());
  EXPECT_TRUE(Sample({"JMP 1", "LSCR S0.1", "SCRE", "LBL 1"}).faults().empty());
  EXPECT_EQ(Sample({"JMP 1", "LSCR S0.1", "LBL 1", "SCRE"}).faults(), (Faults{{FlowProblem::JumpAcrossScr, 0}}));
  EXPECT_EQ(Sample({"LSCR S0.1", "JMP 1", "SCRE", "LBL 1"}).faults(), (Faults{{FlowProblem::JumpAcrossScr, 1}}));
  EXPECT_EQ(Sample({"LSCR S0.1", "JMP 1", "SCRE", "LSCR S0.2", "LBL 1", "SCRE"}).faults(),
            (Faults{{FlowProblem::JumpAcrossScr, 1}}));
}

}  // namespace rungproof
