// Inputs with R_EDGE and F_EDGE, tasks that an event starts, paths from outside (VAR_ACCESS).
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

TEST(IecEdgeInput, TheBodySeesAnEdgeOfWhatIsGiven) {  // as R_TRIG and F_TRIG: also in the first scan
  IecRun run(
      "FUNCTION_BLOCK f VAR_INPUT up : BOOL R_EDGE; down : BOOL F_EDGE; END_VAR VAR_OUTPUT n, m : INT; END_VAR\n"
      "IF up THEN n := n + 1; END_IF; IF down THEN m := m + 1; END_IF; END_FUNCTION_BLOCK\n" +
      iecProgram("VAR_INPUT x : BOOL; END_VAR VAR i : f; given : BOOL; END_VAR",
                 "i(up := x, down := x); given := i.up;"));
  EXPECT_EQ(run.follow("i.n", {{"x", {1, 1, 0, 1}}}), (Row{1, 1, 1, 2}));
  EXPECT_EQ(run.get("i.m"), 1);
  EXPECT_EQ(run.get("given"), 1) << "from outside the input is what was given";
}

TEST(IecEdgeInput, AnInputThatIsNotGivenHasNoNewEdge) {  // it keeps the value of the call before
  IecRun run(
      "FUNCTION_BLOCK f VAR_INPUT up : BOOL R_EDGE; END_VAR VAR_OUTPUT n : INT; END_VAR\n"
      "IF up THEN n := n + 1; END_IF; END_FUNCTION_BLOCK\n" +
      iecProgram("VAR_INPUT x : BOOL; END_VAR VAR i : f; END_VAR", "i(up := x); i();"));
  EXPECT_EQ(run.follow("i.n", {{"x", {1, 1, 0, 1}}}), (Row{1, 1, 1, 2}));
}

TEST(IecEdgeInput, TwoInstancesHaveTheirOwnEdges) {
  IecRun run(
      "FUNCTION_BLOCK f VAR_INPUT up : BOOL R_EDGE; END_VAR VAR_OUTPUT n : INT; END_VAR\n"
      "IF up THEN n := n + 1; END_IF; END_FUNCTION_BLOCK\n" +
      iecProgram("VAR_INPUT x, y : BOOL; END_VAR VAR i, k : f; END_VAR", "i(up := x); k(up := y);"));
  run.follow("i.n", {{"x", {1, 0, 1}}, {"y", {0, 0, 1}}});
  EXPECT_EQ(run.get("i.n"), 2);
  EXPECT_EQ(run.get("k.n"), 1);
}

std::string onEvent(const std::string& task, const std::string& globals = "VAR_GLOBAL ev : BOOL; END_VAR") {
  return "PROGRAM counter VAR n : INT; END_VAR n := n + 1; END_PROGRAM\n"
         "PROGRAM setter VAR_EXTERNAL ev : BOOL; END_VAR VAR_INPUT x : BOOL; END_VAR ev := x; END_PROGRAM\n"
         "CONFIGURATION c " +
         globals + " RESOURCE r ON PLC TASK t(" + task +
         ");\nPROGRAM s : setter; PROGRAM p WITH t : counter; END_RESOURCE END_CONFIGURATION\n";
}

TEST(IecEvent, ATaskRunsOnceAtEachRisingEdge) {  // the event of scan k is seen in scan k + 1: it is asked at the start
  IecRun run(onEvent("SINGLE := ev, PRIORITY := 1"));
  EXPECT_EQ(run.follow("n", {{"x", {1, 1, 0, 1, 1, 1}}}), (Row{0, 1, 1, 1, 2, 2}));
}

TEST(IecEvent, WithAnIntervalItRunsThenToo) {  // every 20 ms, in scans of 20 ms: in each
  IecRun run(onEvent("SINGLE := ev, INTERVAL := T#20ms, PRIORITY := 1"));
  EXPECT_EQ(run.follow("n", {{"x", {0, 0, 0}}}), (Row{1, 2, 3}));
}

TEST(IecEvent, AnUnknownEventIsAnError) {
  EXPECT_NE(findingsIec(readIecText(onEvent("SINGLE := nothing, PRIORITY := 1"))).find("there is no variable nothing"),
            std::string::npos);
}

TEST(IecAccess, APathForWritingMakesAVariableFree) {
  const auto text = [](const std::string& direction) {
    return "PROGRAM main VAR n : INT; q : BOOL; END_VAR q := n > 5; END_PROGRAM\n"
           "CONFIGURATION c RESOURCE r ON PLC PROGRAM p : main; END_RESOURCE\n"
           "VAR_ACCESS panel : r.p.n : INT " +
           direction + "; END_VAR END_CONFIGURATION\n";
  };
  EXPECT_EQ(verdictOf(text("READ_WRITE"), "never q"), "VIOLATED");
  EXPECT_EQ(verdictOf(text("READ_ONLY"), "never q"), "PROVED");
}

}  // namespace
}  // namespace rungproof
