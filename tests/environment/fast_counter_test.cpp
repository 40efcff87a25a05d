// High-speed counters in proofs: what they have counted is any value in each scan while HSC has enabled them, bit 7 of
// the control byte (001:4302), and stays as it is while not. HDEF alone enables nothing.
#include <algorithm>

#include "analysis/equivalence/equivalence.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

/// The head of a program that defines HSC1 and runs HSC once, with that control byte (16#80 enables, 16#40 loads).
std::string defined(const std::string& control) {
  return "Network 1\nLD SM0.1\nMOVB " + control + ", SMB47\nMOVD 0, SMD48\nHDEF 1, 0\nHSC 1\n";
}
ProofRun provedOn(const std::string& properties, const std::string& text, Target target = {}) {
  ReadOptions options;
  options.target = target;
  ProgramInput input;
  input.program =
      readText("test.awl", "ORGANIZATION_BLOCK MAIN:OB1\n" + properties + "BEGIN\n" + text + "END_ORGANIZATION_BLOCK\n",
               options);
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  return prove(input.program, input.properties, usualOptions());
}
bool namesCounter(const ProofRun& run, const std::string& property) {
  const ProofResult* result = resultNamed(run, property);
  return result != nullptr && std::ranges::any_of(result->assumptions, [](const std::string& text) {
           return text.find("HC1 = any value") != std::string::npos;
         });
}

TEST(FastCounter, CountsOnlyWhileEnabled) {
  const std::string asks = "Network 2\nLDD> HC1, 100\n= Q0.0\nNetwork 3\nLD I0.7\n= Q0.1\n";
  const std::string properties = "//@ prove still: never Q0.0\n//@ prove other: I0.7 implies Q0.1\n";
  for (const char* control : {"16#00", "16#40", "16#78"}) {
    const ProofRun run = provedOn(properties, defined(control) + asks);
    EXPECT_EQ(outcomeOf(run, "still"), Outcome::Proved) << control;
    EXPECT_FALSE(namesCounter(run, "still")) << control;
  }
  for (const char* control : {"16#80", "16#C0", "16#F8"}) {
    const ProofRun run = provedOn(properties, defined(control) + asks);
    EXPECT_EQ(outcomeOf(run, "still"), Outcome::Violated) << control;
    EXPECT_TRUE(namesCounter(run, "still")) << control;
    EXPECT_FALSE(namesCounter(run, "other")) << control;
  }
  // Without HSC nothing is enabled.
  const ProofRun defines = provedOn(properties, "Network 1\nLD SM0.1\nMOVB 16#F8, SMB47\nHDEF 1, 0\n" + asks);
  EXPECT_EQ(outcomeOf(defines, "still"), Outcome::Proved);
}

// What is loaded stays where the counter is not enabled, and what it had counted stays when it is stopped.
TEST(FastCounter, KeepsItsValueWhileStopped) {
  const std::string loaded =
      "Network 1\nLD SM0.1\nMOVB 16#40, SMB47\nMOVD 500, SMD48\nHDEF 1, 0\nHSC 1\nNetwork 2\nLDD= HC1, 500\n= Q0.0\n";
  EXPECT_EQ(outcomeOf(provedOn("//@ prove loaded: Q0.0\n", loaded), "loaded"), Outcome::Proved);
  const auto stopped = [](const std::string& control) {
    return defined("16#80") +
           "Network 2\nLD M0.0\nAD<> HC1, VD0\n= Q0.0\nNetwork 3\nLD SM0.0\nMOVD HC1, VD0\n"
           "Network 4\nLD I0.0\nEU\nMOVB " +
           control + ", SMB47\nHSC 1\nS M0.0, 1\n";
  };
  const std::string still = "//@ prove still: never Q0.0\n//@ reach high: HC1 > 1000 and M0.0\n";
  const ProofRun off = provedOn(still, stopped("16#00"));
  EXPECT_EQ(outcomeOf(off, "still"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(off, "high"), Outcome::Reachable);
  EXPECT_EQ(outcomeOf(provedOn(still, stopped("16#80")), "still"), Outcome::Violated);
}

TEST(FastCounter, OfTheSmartToo) {
  const Cpu cpu = *cpuNamed("ST40");
  const auto outcome = [&](const std::string& control) {
    return outcomeOf(provedOn("//@ prove still: never Q0.0\n",
                              "Network 1\nLD SM0.1\nMOVB " + control +
                                  ", SMB37\nMOVD 0, SMD38\nHDEF 0, 0\nHSC 0\nNetwork 2\nLDD> HC0, 100\n= Q0.0\n",
                              {cpu, usualEdition(cpu)}),
                     "still");
  };
  EXPECT_EQ(outcome("16#40"), Outcome::Proved);
  EXPECT_EQ(outcome("16#C0"), Outcome::Violated);
}

// The surroundings give a counter a value only while it counts: from the second scan on, as HSC runs in the first.
TEST(FastCounter, TakesNoValueInARunWhileStopped) {
  for (const auto& [control, expected] : {std::pair("16#40", "0000"), {"16#C0", "0111"}}) {
    const ProgramInput input = inputOf("", defined(control) + "Network 2\nLDD= HC1, 500\n= Q0.0\n");
    Simulator simulator(input.program);
    std::string wave;
    for (int scan = 0; scan < 4; ++scan) {
      simulator.write(operandNamed("HC1"), 500);
      simulator.scan({});
      wave += std::to_string(simulator.read(operandNamed("Q0.0")));
    }
    EXPECT_EQ(wave, expected) << control;
  }
}

Equality compared(const std::string& before, const std::string& after) {
  const ProgramInput one = inputOf("", before), other = inputOf("", after);
  EquivalenceOptions options;
  options.prover = usualOptions();
  return compareBehaviour({&one.program, one.properties}, {&other.program, other.properties}, options).equality;
}

// Both programs count the same as long as both ask the same. Two counters that stand at different values leave the
// comparison of everything else alone.
TEST(FastCounter, IsOneForBothProgramsOfAComparison) {
  const std::string asks = "Network 2\nLDD> HC1, 100\n= Q0.0\n";
  EXPECT_EQ(compared(defined("16#C0") + asks, defined("16#C0") + asks), Equality::Equal);
  EXPECT_EQ(compared(defined("16#40") + asks, defined("16#40") + asks), Equality::Equal);
  EXPECT_NE(compared(defined("16#40") + asks, defined("16#C0") + asks), Equality::Equal);
  const auto loads = [](int value, const std::string& rest) {
    return "Network 1\nLD SM0.1\nMOVB 16#40, SMB47\nMOVD " + std::to_string(value) +
           ", SMD48\nHDEF 1, 0\nHSC 1\nNetwork 2\nLDD> HC1, 1\n= Q0.0\nNetwork 3\n" + rest;
  };
  EXPECT_EQ(compared(loads(5, "LD I0.0\n= Q0.1\n"), loads(7, "LDN I0.0\n= Q0.1\n")), Equality::Different);
}

}  // namespace
}  // namespace rungproof::test
