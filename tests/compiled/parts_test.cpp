// What machine code does where instructions do not run: boxes behind one power flow are branched around, their status
// bits and ENO follow, and errors are counted without being looked at until somebody asks.
#include <gtest/gtest.h>

#include <functional>

#include "frontend/input/project.hpp"
#include "tests/compiled/engine_pair.hpp"

namespace rungproof::test {
namespace {

SimulatorOptions optionsOf(EngineKind kind) {
  SimulatorOptions options;
  options.engine = kind;
  return options;
}

Program networks(const std::string& text) {
  Program program = readText("parts.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" + text + "END_ORGANIZATION_BLOCK\n");
  EXPECT_TRUE(program.findings.empty()) << program.findings.front().message;
  return program;
}

const char* const partPrograms[] = {
    // ENO of a box that did not run is 0, and that of the last one that ran is its own (001:2274).
    "Network 1\nLD I0.0\nMOVW VW0, VW2\nAENO\n= Q0.0\nNetwork 2\nLD I0.1\n+I VW4, VW6\nINCW VW8\nAENO\n= Q0.1\n",
    // A jump to between two boxes: the second runs with the power flow of two ways.
    "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.1\nMOVW VW0, VW2\nNetwork 3\nLBL 1\nNetwork 4\nLD I0.2\n+I VW2, VW4\n"
    "S M0.0, 1\n-I VW6, VW4\nLD SM1.1\n= Q0.0\nLD SM1.2\n= Q0.1\nLD SM1.0\n= Q0.2\n",
    // Bits that were known before the boxes, written by them and read behind them.
    "Network 1\nLD I0.0\n= M0.1\nLD I0.1\nAN I0.0\nMOVB VB0, MB0\nMOVW VW2, VW4\nR I0.0, 1\nLD M0.1\n= Q0.0\nLD I0.0\n"
    "= Q0.1\nLD M0.2\n= Q0.2\n",
    // The condition itself changes within, and is read within the part and behind it.
    "Network 1\nLD M0.0\nMOVB VB1, MB0\nMOVW VW2, VW4\nLD M0.0\n= Q0.0\nLDN M0.0\nA I0.0\n= M0.0\n",
    // A segment of the sequence in which boxes stand.
    "Network 1\nLD SM0.1\nS S0.0, 1\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD I0.0\nINCW VW0\n+D VD4, VD8\nNetwork 4\nLD "
    "I0.1\n"
    "SCRT S0.1\nNetwork 5\nSCRE\nNetwork 6\nLSCR S0.1\nNetwork 7\nLD I0.2\nDECW VW0\nNetwork 8\nLD I0.3\nSCRT S0.0\n"
    "Network 9\nSCRE\n",
};

TEST(Parts, ProgramsAgree) {
  for (const char* const text : partPrograms) {
    const Program program = networks(text);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      RandomSource random(seed);
      const PairOutcome outcome = runBoth(program, random);
      EXPECT_EQ(outcome.difference, "") << text << "seed " << seed;
      EXPECT_GE(outcome.compiled, 10U) << text;
    }
  }
}

/// A bit is looked for behind what masks have left of its word: sixty masks whose operands are both the same value are
/// sixty steps, not 2^60; and of a byte that is also a part of a word, one bit is written a hundred times.
TEST(Parts, BitsBehindManyMasksAgree) {
  std::string text = "Network 1\nLD I0.0\nMOVW IW0, VW0\n";
  for (int i = 0; i < 60; ++i) text += i % 2 == 0 ? "ANDW VW0, VW0\n" : "ORW VW0, VW0\n";
  text += "Network 2\nLD V1.3\n= Q0.0\n";
  for (int i = 0; i < 100; ++i) text += "LD I0." + std::to_string(i % 8) + "\nAN V1.3\n= V1.0\nMOVB VB1, VB2\n";
  text += "LD V1.3\n= Q0.1\nLD V1.0\n= Q0.2\n";
  const Program program = networks(text);
  RandomSource random(11);
  const PairOutcome outcome = runBoth(program, random);
  EXPECT_EQ(outcome.difference, "");
  EXPECT_GE(outcome.compiled, 10U);
}

/// Both engines for so many scans, and nobody looks in between.
void compareInTheEnd(const Program& program, int scans, const std::function<void(Simulator&, int)>& before,
                     std::uint64_t leastCompiled) {
  Simulator reference(program, optionsOf(EngineKind::Reference)), compiled(program, optionsOf(EngineKind::Compiled));
  for (Simulator* const simulator : {&reference, &compiled}) {
    for (int scan = 1; scan <= scans; ++scan) {
      before(*simulator, scan);
      simulator->scan();
    }
  }
  EXPECT_EQ(firstDifference(reference, compiled), "");
  EXPECT_GE(compiled.compiledScans(), leastCompiled);
}

const Operand firstInputs = direct(Area::I, Width::Byte, 0, 0);

/// VW0 overflows in each scan in which I0.0 is on; the first time is one for the reference engine.
TEST(Parts, ErrorsAreCountedUntilSomebodyAsks) {
  const Program program = networks("Network 1\nLD I0.0\n+I 30000, VW0\n+I 30000, VW0\nLD I0.1\n-I 30000, VW2\n");
  compareInTheEnd(
      program, 60, [](Simulator& s, int scan) { s.write(firstInputs, static_cast<std::uint64_t>(scan % 3)); }, 50);
}

/// With I0.7 the scan has a STOP behind the overflow and is run again by the reference engine, which counts it once.
TEST(Parts, AnErrorOfAScanThatIsGivenUpIsCountedOnce) {
  const Program program = networks("Network 1\nLD I0.0\n+I 30000, VW0\n+I 30000, VW0\nNetwork 2\nLD I0.7\nSTOP\n");
  compareInTheEnd(
      program, 60,
      [](Simulator& s, int scan) {
        s.write(firstInputs, scan % 20 == 0 ? 0x81U : 1U);
        s.run();
      },
      20);
}

/// Errors before the power was off are forgotten, those that machine code has counted too.
TEST(Parts, ErrorsAreForgottenWithoutPower) {
  const Program program = networks("Network 1\nLD I0.0\n+I 30000, VW0\n+I 30000, VW0\n");
  compareInTheEnd(
      program, 60,
      [](Simulator& s, int scan) {
        s.write(firstInputs, 1);
        if (scan == 40) s.powerCycle();
      },
      40);
}

/// SM0.0 is on (001:14050), unless somebody outside says otherwise: then the reference engine sees it off.
TEST(Parts, TheBitThatIsAlwaysOnIsLookedAt) {
  const Program program = networks("Network 1\nLD SM0.0\nINCW VW0\nLDN SM0.0\nINCW VW2\n");
  compareInTheEnd(
      program, 60,
      [](Simulator& s, int scan) { s.write(direct(Area::SM, Width::Bit, 0, 0), scan >= 20 && scan < 30 ? 0 : 1); }, 40);
}

}  // namespace
}  // namespace rungproof::test
