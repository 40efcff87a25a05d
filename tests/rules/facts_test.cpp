// Facts about calls, execution and conditions on small programs whose answers follow from the text beside them.
#include <gtest/gtest.h>

#include "ir/s7200/isa.hpp"
#include "ir/s7200/library_block.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

TEST(LibraryBlock, NamesHaveADigit) {
  ASSERT_NE(libraryBlockNamed("pto1_run"), nullptr);
  EXPECT_EQ(libraryBlockNamed("PTO1_RUN")->parameters.size(), 8U);
  EXPECT_EQ(libraryBlockNamed("USS_CTRL")->parameters.size(), 16U);  // the most that a call may have (001:6775)
  EXPECT_EQ(libraryBlockNamed("PTOA_RUN"), nullptr);
  EXPECT_EQ(libraryBlockNamed("MOTOR"), nullptr);
}

/// Long blocks, short ones and empty ones: each instruction has the place that a walk over the program gives it.
TEST(Facts, KnowThePlaceOfEachInstruction) {
  std::string text = "LD I0.0\n= Q0.0\nMEND\n";
  for (int block = 0; block < 60; ++block) {
    text += "SBR " + std::to_string(block) + "\n";
    for (int i = 0; i < block * block % 150; ++i) text += i % 3 == 0 ? "LD I0.1\n" : "A M0.0\n";
    if (block % 7 != 0) text += "RET\n";
  }
  const Linted linted(text);
  const Facts& facts = *linted.facts;
  std::uint32_t id = 0;
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    for (const Network& network : facts.program().pous[block].networks) {
      for (const Instruction& instruction : network.instructions) {
        const InstructionPlace place = facts.place(id);
        ASSERT_EQ(place.instruction, &instruction);
        ASSERT_EQ(place.block, block);
        ASSERT_EQ(&facts.networkOf(id), &network);
        ASSERT_EQ(facts.plan().flows[block].steps[place.step].instruction, &instruction);
        for (const Access& access : facts.accesses().of(id)) ASSERT_EQ(access.instruction, id);
        ++id;
      }
    }
  }
  EXPECT_EQ(facts.instructionCount(), id);
  std::size_t accesses = 0;
  while (id > 0) accesses += facts.accesses().of(--id).size();
  EXPECT_EQ(accesses, facts.accesses().all().size());
}

TEST(PlaceIndex, FindsBlockAndNetworkOfEachByte) {
  const Linted linted(
      "// before\nNetwork 1\nLD I0.0\n= Q0.0\n\nNetwork 2 // two\nLD I0.1\n= Q0.1\nMEND\n// between\nSBR 1\n// "
      "head\nNetwork 1\nLD I0.2\n= Q0.2\nRET\nSBR 2\nRET\n// behind\n");
  const PlaceIndex index(linted.program);
  const auto holds = [](const Span& span, std::uint32_t at) {
    return at >= span.offset && at < span.offset + span.length;
  };
  for (std::uint32_t at = 0; at < linted.program.sources->file(0).text().size() + 2; ++at) {
    ProgramPlace expected;
    for (const Pou& pou : linted.program.pous) {
      if (holds(pou.span, at)) expected.pou = &pou;
      for (const Network& network : pou.networks)
        if (holds(network.span, at)) expected.network = &network;
    }
    const ProgramPlace found = index.at({0, at, 1});
    ASSERT_EQ(found.pou, expected.pou) << at;
    ASSERT_EQ(found.network, expected.network) << at;
  }
}

TEST(CallGraph, CountsLevelsAndFindsCycles) {
  const Linted linted("LD SM0.0\nCALL 1\nMEND\nSBR 1\nCALL 2\nRET\nSBR 2\nCALL 3\nRET\nSBR 3\nCALL 2\nRET\n");
  const CallGraph& calls = linted.facts->calls();
  EXPECT_EQ(calls.sites().size(), 4U);
  EXPECT_GE(calls.depthBelow(0), 3);
  EXPECT_FALSE(calls.recursionThrough(1));
  EXPECT_TRUE(calls.recursionThrough(2));
  EXPECT_TRUE(calls.recursionThrough(3));
  EXPECT_TRUE(calls.reachedFromMain(3));
}

TEST(Execution, FollowsConstantConditions) {
  // The jump on SM0.0 always goes, so the coil behind it is never reached; the conditional one may skip.
  const Linted linted(
      "Network 1\nLD SM0.0\nJMP 1\nNetwork 2\nLD I0.0\n= Q0.0\nNetwork 3\nLBL 1\nNetwork 4\nLD I0.1\nJMP 2\nNetwork "
      "5\nLD I0.2\n= Q0.1\nNetwork 6\nLBL 2\n");
  const ExecutionTable& execution = linted.facts->execution();
  EXPECT_FALSE(execution.at(3).isReachable);
  EXPECT_TRUE(execution.at(8).isReachable);
  ASSERT_TRUE(execution.at(8).isSkipped);
  EXPECT_EQ(execution.skipper(8), 6U);
  EXPECT_FALSE(execution.at(4 + 1).isSkipped);
}

TEST(Execution, CountsCallsPerScan) {
  const Linted linted(
      "LD SM0.0\nCALL 1\nLD I0.0\nCALL 2\nLD I0.1\nCALL 3\nLD I0.2\nCALL 3\nLD SM0.1\nCALL 4\nMEND\nSBR 1\n= "
      "Q0.0\nRET\nSBR 2\n= Q0.1\nRET\nSBR 3\n= Q0.2\nRET\nSBR 4\n= Q0.3\nRET\nSBR 5\n= Q0.4\nRET\n");
  const ExecutionTable& execution = linted.facts->execution();
  EXPECT_EQ(execution.runs(1), Runs::Once);
  EXPECT_EQ(execution.runs(2), Runs::AtMostOnce);
  EXPECT_EQ(execution.runs(3), Runs::Several);
  EXPECT_EQ(execution.runs(5), Runs::Never);
  EXPECT_NE(execution.condition(4) & condition::FirstScan, 0);
}

TEST(Conditions, FlowThroughTheStack) {
  // SM0.1 AND anything is a first-scan condition; OR with an input is not; an edge bit with one coil stays a pulse.
  const Linted linted(
      "Network 1\nLD SM0.1\nA I0.0\nMOVB 1, VB0\nNetwork 2\nLD SM0.1\nO I0.0\nMOVB 1, VB0\nNetwork 3\nLD I0.0\nEU\n= "
      "M0.0\nNetwork 4\nLD M0.0\nMOVB 1, VB0\n");
  const StackRun& stack = linted.facts->stack();
  EXPECT_NE(stack.at(2).flow & condition::FirstScan, 0);
  EXPECT_EQ(stack.at(5).flow & condition::FirstScan, 0);
  EXPECT_NE(stack.at(10).flow & condition::Pulse, 0);
}

/// Outputs behind each other have the same rung in front of them: each is on in the scan in which I0.0 comes.
TEST(Conditions, AnEdgeByHandDrivesManyOutputs) {
  constexpr int count = 20'000;
  std::string text = "Network 1\nLD I0.0\nAN M0.0\n";
  for (int i = 0; i < count; ++i) text += "= V" + std::to_string(i / 8) + "." + std::to_string(i % 8) + "\n";
  text += "Network 2\nLD I0.0\n= M0.0\n";
  for (const std::string bit : {"V0.0", "V0.1", "V2499.7"}) text += "Network 3\nLD " + bit + "\nMOVB 1, VB3000\n";
  text += "Network 4\nLD I0.0\nAN M0.1\n= M2.0\nNetwork 5\nLD M2.0\nMOVB 1, VB3001\n";  // nothing drives M0.1
  const Linted linted(text);
  const StackRun& stack = linted.facts->stack();
  for (const std::uint32_t move : {count + 5U, count + 7U, count + 9U})
    EXPECT_NE(stack.at(move).flow & condition::Pulse, 0) << move;
  EXPECT_EQ(stack.at(count + 14U).flow & condition::Pulse, 0);
}

TEST(Facts, FindsSymbolsByNameAndAddress) {
  const Linted linted("Network 1\nLD Start\n= Q0.0\n", {}, "Symbol\tAddress\tComment\nStart\tI0.0\tbutton\n");
  ASSERT_NE(linted.facts->symbolNamed("Start"), nullptr);
  EXPECT_EQ(linted.facts->name(direct(Area::I, Width::Bit, 0, 0)), "I0.0 (Start)");
  EXPECT_EQ(linted.facts->name(direct(Area::I, Width::Bit, 0, 1)), "I0.1");
}

}  // namespace
}  // namespace rungproof::testing
