// Worked examples of the course book that need blocks of their own or of the library: their stated properties.
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

/// A source with properties behind the first line of its OB1.
ProofRun proofOfSource(const std::string& directives, const std::string& blocks, const std::string& statements,
                       const char* s5Time = "") {
  const ProgramInput input = inputOfSource(blocks + "ORGANIZATION_BLOCK OB 1\n" + directives + "BEGIN\nNETWORK\n" +
                                           statements + "\nEND_ORGANIZATION_BLOCK\n");
  ProverOptions options = usualOptions(60);
  options.time.high = 150;  // cycle monitoring of an S7-300
  if (*s5Time != '\0') {
    EXPECT_TRUE(options.choices.set("s5-time", s5Time));
  }
  return prove(input.program, input.properties, options);
}

// 002:303-309: FC6 computes (A + B) / C and says by BR, which becomes the ENO of its call, whether the result counts.
TEST(Step7Examples, BrTellsWhetherTheQuotientCounts) {
  const std::string fc6 =
      "FUNCTION FC 6 : VOID\nVAR_INPUT\n  A : INT;\n  B : INT;\n  C : INT;\nEND_VAR\nVAR_OUTPUT\n  Q : INT;\nEND_VAR\n"
      "VAR_TEMP\n  Sum : INT;\nEND_VAR\nBEGIN\nNETWORK\n      L #A;\n      L #B;\n      +I;\n      T #Sum;\n      AN "
      "OV;\n"
      "      A(;\n      L #C;\n      L 0;\n      >I;\n      );\n      SAVE;\n      JNB done;\n      L #Sum;\n      L "
      "#C;\n"
      "      /I;\n      T #Q;\ndone: NOP 0;\nEND_FUNCTION\n";
  const ProofRun run = proofOfSource(
      "//@ prove counts: Q0.0 = (IW0 + IW2 <= 32767 and IW0 + IW2 >= -32768 and IW4 > 0)\n"
      "//@ reach counts at the border: Q0.0 and IW0 + IW2 = 32767\n",
      fc6, "CALL FC 6 (A := IW 0, B := IW 2, C := IW 4, Q := MW 10);\nA BR;\n= Q 0.0;");
  EXPECT_EQ(outcomeOf(run, "counts"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "counts at the border"), Outcome::Reachable);
}

// 002:2516-2554: an IEC on-delay timer. Q needs IN; ET is between 0 and PT; Q comes no sooner than PT after IN, less
// the scan before the one that sees IN.
TEST(Step7Examples, AnIecTimerDelays) {
  for (const char* reading : {"synchronous", "any"}) {
    const ProofRun run = proofOfSource(
        "//@ prove signal: Q0.0 implies I0.0\n"
        "//@ prove rest: not I0.0 implies MD10 = 0\n"
        "//@ prove whole: Q0.0 implies MD10 = 2000\n"
        "//@ reach ends: Q0.0\n",
        "DATA_BLOCK DB 1\n SFB 4\nBEGIN\nEND_DATA_BLOCK\n",
        "CALL SFB 4, DB 1 (IN := I 0.0, PT := T#2S, Q := Q 0.0, ET := MD 10);", reading);
    for (const char* name : {"signal", "rest", "whole"})
      EXPECT_EQ(outcomeOf(run, name), Outcome::Proved) << name << " " << reading;
    EXPECT_EQ(outcomeOf(run, "ends"), Outcome::Reachable) << reading;
  }
}

// 002:2458-2513: the time between two rising edges of an input, by SFC 64, whose tick wraps.
TEST(Step7Examples, ThePeriodOfASignalMayGoBack) {
  const std::string fb2 =
      "FUNCTION_BLOCK FB 2\nVAR_INPUT\n  event : BOOL;\nEND_VAR\nVAR_OUTPUT\n  time_period : REAL;\nEND_VAR\nVAR\n"
      "  help_edge : BOOL;\n  prev_time : DINT;\nEND_VAR\nVAR_TEMP\n  pos_edge : BOOL;\n  now : TIME;\nEND_VAR\nBEGIN\n"
      "NETWORK\n      A #event;\n      FP #help_edge;\n      = #pos_edge;\n      AN #pos_edge;\n      BEC;\n"
      "      CALL SFC 64 (RET_VAL := #now);\n      L #now;\n      L #prev_time;\n      -D;\n      DTR;\n      L "
      "1000.0;\n"
      "      /R;\n      T #time_period;\n      L #now;\n      T #prev_time;\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 2\n FB 2\nBEGIN\nEND_DATA_BLOCK\n";
  const ProofRun run = proofOfSource(
      "//@ prove edge: DB2.DBX6.0 = I0.0\n"
      "//@ reach goes back: not first_scan and DB2.DBD8 < prev(DB2.DBD8)\n",
      fb2, "CALL FB 2, DB 2 (event := I 0.0, time_period := MD 20);");
  EXPECT_EQ(outcomeOf(run, "edge"), Outcome::Proved);
  EXPECT_EQ(outcomeOf(run, "goes back"), Outcome::Reachable);  // the finding of the example: the tick wraps
}

}  // namespace
}  // namespace rungproof::test
