// The built-in checks on programs made so that each answer is known beforehand.
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

ProofRun builtins(const ProgramInput& input) {
  ProverOptions options = usualOptions(10);
  options.checks.builtin = true;
  return prove(input.program, input.properties, options);
}

/// Outcomes of the built-in checks of one kind whose name contains `part`.
std::vector<Outcome> outcomes(const ProofRun& run, BuiltinKind kind, const std::string& part = "") {
  std::vector<Outcome> found;
  for (const ProofResult& result : run.results) {
    if (result.builtin && result.builtin->kind == kind && result.builtin->name.find(part) != std::string::npos) found.push_back(result.outcome);
  }
  return found;
}
using Outcomes = std::vector<Outcome>;

const char* const subroutine = "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\nR Q0.0, 1\nEND_SUBROUTINE_BLOCK\n";

TEST(Builtin, SetAndResetInMainAndSubroutine) {
  const ProofRun run = builtins(inputOf("", "Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLD SM0.0\nCALL SBR_0\n", subroutine));
  EXPECT_EQ(outcomes(run, BuiltinKind::SetReset, "Q0.0"), Outcomes{Outcome::Violated});
}

TEST(Builtin, SetAndResetUnderOppositeConditionsIsNoConflict) {
  const ProofRun run = builtins(inputOf("", "Network 1\nLD I0.0\nS Q0.0, 1\nNetwork 2\nLDN I0.0\nCALL SBR_0\n",
                                        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD SM0.0\nR Q0.0, 1\nEND_SUBROUTINE_BLOCK\n"));
  for (const Outcome outcome : outcomes(run, BuiltinKind::SetReset, "Q0.0")) EXPECT_EQ(outcome, Outcome::Proved);
}

TEST(Builtin, SetInMainAndResetInInterrupt) {
  // Event 0: rising edge of I0.0. The routine may come in the scan in which the main program sets the bit.
  const ProofRun run = builtins(inputOf("", "Network 1\nLD SM0.1\nATCH INT_0, 0\nENI\nNetwork 2\nLD I0.5\nS M0.0, 1\n",
                                        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nR M0.0, 1\nEND_INTERRUPT_BLOCK\n"));
  const Outcomes found = outcomes(run, BuiltinKind::SetReset, "M0.0");
  ASSERT_FALSE(found.empty());
  for (const Outcome outcome : found) EXPECT_EQ(outcome, Outcome::Violated);
}

TEST(Builtin, SlowTimerSkippedByAJump) {
  // T37 has a resolution of 100 ms; with I0.0 its box is jumped over.
  const ProofRun run = builtins(inputOf("", "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.1\nTON T37, 10\nNetwork 3\nLBL 1\nNetwork 4\nLD T37\n= Q0.0\n"));
  EXPECT_EQ(outcomes(run, BuiltinKind::TimerOncePerScan, "T37"), Outcomes{Outcome::Violated});
}

TEST(Builtin, SlowTimerCalledTwice) {
  const ProofRun run = builtins(inputOf("", "Network 1\nLD SM0.0\nCALL SBR_0\nNetwork 2\nLD I0.7\nCALL SBR_0\n",
                                        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\nTON T37, 10\nLD T37\n= Q0.0\nEND_SUBROUTINE_BLOCK\n"));
  EXPECT_EQ(outcomes(run, BuiltinKind::TimerOncePerScan, "T37"), Outcomes{Outcome::Violated});
}

TEST(Builtin, SlowTimerInEveryScanAndFastTimersAreNoQuestion) {
  const ProofRun run = builtins(inputOf("", "Network 1\nLD I0.1\nTON T37, 10\nNetwork 2\nLD I0.0\nJMP 1\nNetwork 3\nLD I0.1\nTON T33, 10\nNetwork 4\nLBL 1\n"));
  EXPECT_EQ(outcomes(run, BuiltinKind::TimerOncePerScan), Outcomes{});
}

TEST(Builtin, NestingAtTheLimitAndBeyond) {
  // Eight levels are allowed (001:6723); SBR n calls SBR n + 1.
  const auto chain = [](int levels) {
    std::string blocks;
    for (int n = 0; n < levels; ++n) {
      blocks += "SUBROUTINE_BLOCK SBR_" + std::to_string(n) + ":SBR" + std::to_string(n) + "\nBEGIN\nNetwork 1\nLD SM0.0\n";
      blocks += n + 1 < levels ? "CALL SBR_" + std::to_string(n + 1) + "\n" : std::string("= Q0.0\n");
      blocks += "END_SUBROUTINE_BLOCK\n";
    }
    return builtins(inputOf("", "Network 1\nLD I0.0\nCALL SBR_0\n", blocks));
  };
  for (const Outcome outcome : outcomes(chain(8), BuiltinKind::Nesting)) EXPECT_EQ(outcome, Outcome::Proved);
  const Outcomes tooDeep = outcomes(chain(9), BuiltinKind::Nesting);
  EXPECT_NE(std::count(tooDeep.begin(), tooDeep.end(), Outcome::Violated), 0);
}

TEST(Builtin, PointerThatMayLeaveItsArea) {
  // The offset is an input byte times 256: up to 65280 bytes behind VB0, V ends at 10239.
  const ProofRun wide = builtins(inputOf("", "Network 1\nLD SM0.0\nMOVD &VB0, VD0\nMOVB IB1, VB6\nMOVB 0, VB7\nMOVB 0, VB4\nMOVB 0, VB5\n+D VD4, VD0\nMOVB *VD0, QB0\n"));
  const Outcomes found = outcomes(wide, BuiltinKind::OperandRange);
  EXPECT_NE(std::count(found.begin(), found.end(), Outcome::Violated), 0);
  // One byte of offset cannot leave it.
  const ProofRun narrow = builtins(inputOf("", "Network 1\nLD SM0.0\nMOVD &VB0, VD0\nMOVB IB1, VB7\nMOVB 0, VB6\nMOVB 0, VB4\nMOVB 0, VB5\n+D VD4, VD0\nMOVB *VD0, QB0\n"));
  for (const Outcome outcome : outcomes(narrow, BuiltinKind::OperandRange)) EXPECT_EQ(outcome, Outcome::Proved);
}

TEST(Builtin, DivisionIsGuardedOrNot) {
  const ProofRun open = builtins(inputOf("", "Network 1\nLD SM0.0\nMOVW IW0, VW0\n/I IW2, VW0\n"));
  EXPECT_EQ(outcomes(open, BuiltinKind::Division), Outcomes{Outcome::Violated});
  const ProofRun guarded = builtins(inputOf("", "Network 1\nLDW<> IW2, 0\nMOVW IW0, VW0\n/I IW2, VW0\n"));
  for (const Outcome outcome : outcomes(guarded, BuiltinKind::Division)) EXPECT_EQ(outcome, Outcome::Proved);
}

TEST(Builtin, TimerThatCanComeOnAndOneThatCannot) {
  // T37 waits 5 s behind its input; T38 is reset by its own first tick of the program: its input is on for one scan only.
  const ProofRun run = builtins(inputOf("", "Network 1\nLD I0.0\nTON T37, 50\nNetwork 2\nLD I0.1\nEU\nTON T38, 100\nNetwork 3\nLD T37\nO T38\n= Q0.0\n"));
  EXPECT_EQ(outcomes(run, BuiltinKind::TimerReachable, "T37"), Outcomes{Outcome::Reachable});
  EXPECT_EQ(outcomes(run, BuiltinKind::TimerResettable, "T37"), Outcomes{Outcome::Reachable});
  EXPECT_EQ(outcomes(run, BuiltinKind::TimerReachable, "T38"), Outcomes{Outcome::Unreachable});
}

TEST(Builtin, LoopBeyondTheLimitLeavesProofsOpen) {
  // A jump back that an input keeps going is followed 256 times only; what lies behind is left out, so nothing that the
  // loop could spoil is proved.
  const ProgramInput input = inputOf("//@ prove counter stays small: VW0 <> 300\n",
                                     "Network 1\nLBL 1\nNetwork 2\nLD SM0.0\nINCW VW0\nNetwork 3\nLDW< VW0, 1000\nJMP 1\nNetwork 4\nLD SM0.0\nMOVW 0, VW0\n");
  const ProofRun run = prove(input.program, input.properties, usualOptions(2));
  EXPECT_EQ(outcomeOf(run, "counter stays small"), Outcome::NotCovered);
}

}  // namespace
}  // namespace rungproof::test
