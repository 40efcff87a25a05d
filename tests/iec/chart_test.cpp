// Sequential function charts: how tokens move, what each qualifier does, what is said against charts that are wrong.
// Scans last 10 ms. Expected values follow from the rules of evolution and of the action control; the reason stands
// beside each.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

using Inputs = std::vector<std::pair<std::string, Row>>;

TEST(IecChart, StepsTakeTurns) {  // transitions first; a token moves at most one transition in a scan
  IecRun run(iecProgram("VAR_INPUT go : BOOL; END_VAR VAR n : INT; END_VAR",
                        "INITIAL_STEP S1: count(N); END_STEP\nSTEP S2: END_STEP\n"
                        "TRANSITION FROM S1 TO S2 := go; END_TRANSITION\n"
                        "TRANSITION FROM S2 TO S1 := NOT go; END_TRANSITION\nACTION count: n := n + 1; END_ACTION"));
  EXPECT_EQ(run.follow("n", {{"go", {0, 0, 1, 1, 0}}}), (Row{1, 2, 2, 2, 3}));
}

const std::string parallel =
    iecProgram("VAR_INPUT go, x, y : BOOL; END_VAR",
               "INITIAL_STEP S0: END_STEP STEP A: END_STEP STEP B: END_STEP STEP A2: END_STEP STEP E: END_STEP\n"
               "TRANSITION FROM S0 TO (A, B) := go; END_TRANSITION\nTRANSITION FROM A TO A2 := x; END_TRANSITION\n"
               "TRANSITION FROM (A2, B) TO E := y; END_TRANSITION");

TEST(IecChart, AConvergenceWaitsForAllBranches) {  // A2 is active at the start of scan 4 only
  const Inputs inputs = {{"go", {1, 0, 0, 0}}, {"x", {0, 0, 1, 0}}, {"y", {0, 1, 1, 1}}};
  EXPECT_EQ(IecRun(parallel).follow("E.X", inputs), (Row{0, 0, 0, 1}));
  EXPECT_EQ(IecRun(parallel).follow("B.X", inputs), (Row{1, 1, 1, 0}));
  EXPECT_EQ(IecRun(parallel).follow("A2.X", inputs), (Row{0, 0, 1, 0}));
}

TEST(IecChart, LimitedAndDelayed) {  // the step is active from scan 2
  const std::string text = iecProgram("VAR_INPUT go : BOOL; END_VAR VAR l, d : BOOL; END_VAR",
                                      "INITIAL_STEP A: END_STEP STEP B: l(L, T#20ms); d(D, T#20ms); END_STEP\n"
                                      "TRANSITION FROM A TO B := go; END_TRANSITION");
  const Inputs inputs = {{"go", {0, 1, 0, 0, 0}}};
  EXPECT_EQ(IecRun(text).follow("l", inputs), (Row{0, 1, 1, 0, 0}));
  EXPECT_EQ(IecRun(text).follow("d", inputs), (Row{0, 0, 0, 1, 1}));
  EXPECT_EQ(IecRun(text).follow("B.T", inputs), (Row{0, 0, 10, 20, 30}));
}

/// A -go-> S -next-> E -back-> A; S has the action, E resets it if `resets`. S is active in the scans 2 to 4, E in 5
/// and 6.
std::string qualified(const std::string& association, const std::string& resets) {
  return iecProgram("VAR_INPUT go, next, back : BOOL; END_VAR VAR q : BOOL; n : INT; END_VAR",
                    "INITIAL_STEP A: END_STEP\nSTEP S: q" + association + "; run" + association +
                        "; END_STEP\nSTEP E: " + resets +
                        " END_STEP\n"
                        "TRANSITION FROM A TO S := go; END_TRANSITION\nTRANSITION FROM S TO E := next; END_TRANSITION\n"
                        "TRANSITION FROM E TO A := back; END_TRANSITION\nACTION run: n := n + 1; END_ACTION");
}
const Inputs roundTrip = {
    {"go", {0, 1, 0, 0, 0, 0, 0, 0}}, {"next", {0, 0, 0, 0, 1, 0, 0, 0}}, {"back", {0, 0, 0, 0, 0, 0, 1, 0}}};

struct QualifierRow {
  const char* association;
  Row active, withReset;
};

TEST(IecChart, Qualifiers) {
  const QualifierRow rows[] = {
      {"", {0, 1, 1, 1, 0, 0, 0, 0}, {0, 1, 1, 1, 0, 0, 0, 0}},  // none is N
      {"(N)", {0, 1, 1, 1, 0, 0, 0, 0}, {0, 1, 1, 1, 0, 0, 0, 0}},
      {"(L, T#20ms)", {0, 1, 1, 0, 0, 0, 0, 0}, {0, 1, 1, 0, 0, 0, 0, 0}},
      {"(L, T#100ms)", {0, 1, 1, 1, 0, 0, 0, 0}, {0, 1, 1, 1, 0, 0, 0, 0}},  // ends with the step
      {"(D, T#20ms)", {0, 0, 0, 1, 0, 0, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 0}},
      {"(D, T#100ms)", {0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0}},
      {"(P)", {0, 1, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 0, 0}},
      {"(P1)", {0, 1, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 0, 0}},
      {"(S)", {0, 1, 1, 1, 1, 1, 1, 1}, {0, 1, 1, 1, 0, 0, 0, 0}},
      {"(SD, T#20ms)", {0, 0, 0, 1, 1, 1, 1, 1}, {0, 0, 0, 1, 0, 0, 0, 0}},
      {"(SD, T#50ms)", {0, 0, 0, 0, 0, 0, 1, 1}, {0, 0, 0, 0, 0, 0, 0, 0}},  // 50 ms behind scan 2 is scan 7
      {"(DS, T#20ms)", {0, 0, 0, 1, 1, 1, 1, 1}, {0, 0, 0, 1, 0, 0, 0, 0}},
      {"(DS, T#50ms)", {0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0}},  // the step left before
      {"(SL, T#30ms)", {0, 1, 1, 1, 0, 0, 0, 0}, {0, 1, 1, 1, 0, 0, 0, 0}},
      {"(SL, T#50ms)", {0, 1, 1, 1, 1, 1, 0, 0}, {0, 1, 1, 1, 0, 0, 0, 0}},
  };
  for (const QualifierRow& row : rows) {
    SCOPED_TRACE(row.association);
    for (const bool resets : {false, true}) {
      const std::string text = qualified(row.association, resets ? "q(R); run(R);" : "");
      const Row& active = resets ? row.withReset : row.active;
      EXPECT_EQ(IecRun(text).follow("q", roundTrip), active);
      Row runs = active;  // the body runs in the scans in which the action is active
      for (std::size_t i = 1; i < runs.size(); ++i) runs[i] += runs[i - 1];
      EXPECT_EQ(IecRun(text).follow("n", roundTrip), runs);
    }
  }
}

TEST(IecChart, PulseAtTheEnd) {  // the scan in which the step is left
  EXPECT_EQ(IecRun(qualified("(P0)", "")).follow("q", roundTrip), (Row{0, 0, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(IecRun(qualified("(P0)", "")).follow("n", roundTrip), (Row{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(IecChart, TheFinalScanIsAReading) {  // a body runs once more where its action ends; pulses P0 and P1 have none
  const auto runs = [](const char* association) {
    return IecRun(qualified(association, ""), 10, {{"iec-sfc-final-scan", "yes"}}).follow("n", roundTrip);
  };
  EXPECT_EQ(runs("(N)"), (Row{0, 1, 2, 3, 4, 4, 4, 4}));
  EXPECT_EQ(runs("(P)"), (Row{0, 1, 2, 2, 2, 2, 2, 2}));  // P runs twice
  EXPECT_EQ(runs("(P1)"), (Row{0, 1, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(runs("(P0)"), (Row{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(runs("(L, T#20ms)"), (Row{0, 1, 2, 3, 3, 3, 3, 3}));
}

TEST(IecChart, TheInitialStepMayBeActivatedByTheStart) {
  const std::string text =
      iecProgram("VAR_INPUT x : BOOL; END_VAR VAR n : INT; END_VAR",
                 "INITIAL_STEP A: run(P); END_STEP STEP B: END_STEP\n"
                 "TRANSITION FROM A TO B := x; END_TRANSITION\n"
                 "TRANSITION FROM B TO A := TRUE; END_TRANSITION\nACTION run: n := n + 1; END_ACTION");
  const Inputs inputs = {{"x", {0, 0, 1, 0, 0}}};
  EXPECT_EQ(IecRun(text).follow("n", inputs), (Row{1, 1, 1, 2, 2}));
  EXPECT_EQ(IecRun(text, 10, {{"iec-sfc-initial-edge", "no"}}).follow("n", inputs), (Row{0, 0, 0, 1, 1}));
}

TEST(IecChart, ActionsMayRunBeforeTheTransitions) {  // then scan 1 runs the action of the initial step in any case
  const std::string text = iecProgram("VAR_INPUT x : BOOL; END_VAR VAR q, r : BOOL; END_VAR",
                                      "INITIAL_STEP A: q; END_STEP STEP B: r; END_STEP\n"
                                      "TRANSITION FROM A TO B := x; END_TRANSITION");
  const Inputs inputs = {{"x", {1, 1, 1}}};
  EXPECT_EQ(IecRun(text).follow("q", inputs), (Row{0, 0, 0}));
  EXPECT_EQ(IecRun(text).follow("r", inputs), (Row{1, 1, 1}));
  const IecChoices before = {{"iec-sfc-order", "actions-first"}};
  EXPECT_EQ(IecRun(text, 10, before).follow("q", inputs), (Row{1, 0, 0}));
  EXPECT_EQ(IecRun(text, 10, before).follow("r", inputs), (Row{0, 1, 1}));
}

TEST(IecChart, ActionsRunAsTheyAreDeclaredOrByTheirNames) {  // z doubles, a adds one: (0 * 2) + 1 or (0 + 1) * 2
  const std::string text =
      iecProgram("VAR_INPUT x : BOOL; END_VAR VAR n : INT; END_VAR",
                 "INITIAL_STEP S: a; z; END_STEP\nSTEP S2: END_STEP TRANSITION FROM S TO S2 := x; END_TRANSITION\n"
                 "ACTION z: n := n * 2; END_ACTION\nACTION a: n := n + 1; END_ACTION");
  EXPECT_EQ(IecRun(text).follow("n", {{"x", {0, 0}}}), (Row{1, 3}));
  EXPECT_EQ(IecRun(text, 10, {{"iec-sfc-action-order", "alphabetical"}}).follow("n", {{"x", {0, 0}}}), (Row{2, 6}));
}

/// A chart with a selection out of S; which branch a scan with both conditions takes.
std::string selection(const std::string& first, const std::string& second) {
  return iecProgram("VAR_INPUT x, y : BOOL; END_VAR",
                    "INITIAL_STEP S: END_STEP STEP A: END_STEP STEP B: END_STEP\nTRANSITION " + first +
                        "FROM S TO A := x; END_TRANSITION\nTRANSITION " + second + "FROM S TO B := y; END_TRANSITION");
}

TEST(IecChart, ASelectionTakesOneBranch) {  // the left one, or that with the lower number
  const Inputs both = {{"x", {1}}, {"y", {1}}};
  EXPECT_EQ(IecRun(selection("", "")).follow("A.X", both), (Row{1}));
  EXPECT_EQ(IecRun(selection("", "")).follow("B.X", both), (Row{0}));
  EXPECT_EQ(IecRun(selection("(PRIORITY := 2) ", "(PRIORITY := 1) ")).follow("A.X", both), (Row{0}));
  EXPECT_EQ(IecRun(selection("one (PRIORITY := 2) ", "two (PRIORITY := 1) ")).follow("B.X", both), (Row{1}));
  EXPECT_EQ(IecRun(selection("", "")).follow("B.X", {{"x", {0}}, {"y", {1}}}), (Row{1}));
}

TEST(IecChart, AStepThatIsLeftAndEnteredAtOnceStaysActive) {  // its time begins anew, but it is not activated again
  const std::string text = iecProgram("VAR_INPUT x : BOOL; END_VAR VAR n : INT; END_VAR",
                                      "INITIAL_STEP S: run(P1); END_STEP TRANSITION FROM S TO S := x; END_TRANSITION\n"
                                      "ACTION run: n := n + 1; END_ACTION");
  const Inputs inputs = {{"x", {0, 0, 1, 0}}};
  EXPECT_EQ(IecRun(text).follow("S.T", inputs), (Row{0, 10, 0, 10}));
  EXPECT_EQ(IecRun(text).follow("n", inputs), (Row{1, 1, 1, 1}));
}

TEST(IecChart, TimesOfStepsInConditions) {  // 30 ms after the activation in scan 2 is scan 5; T keeps its last value
  const std::string text =
      iecProgram("VAR_INPUT go : BOOL; END_VAR VAR CONSTANT wait : TIME := T#30ms; END_VAR VAR t : TIME; END_VAR",
                 "INITIAL_STEP A: END_STEP STEP B: END_STEP STEP C: note(N); END_STEP\nTRANSITION FROM A TO B := go; "
                 "END_TRANSITION\n"
                 "TRANSITION FROM B TO C := B.T >= wait; END_TRANSITION\nACTION note: t := B.T; END_ACTION");
  const Inputs inputs = {{"go", {0, 1, 0, 0, 0, 0}}};
  EXPECT_EQ(IecRun(text).follow("C.X", inputs), (Row{0, 0, 0, 0, 1, 1}));
  EXPECT_EQ(IecRun(text).follow("B.T", inputs), (Row{0, 0, 10, 20, 30, 30}));
  EXPECT_EQ(IecRun(text).follow("t", inputs), (Row{0, 0, 0, 0, 30, 30}));
}

TEST(IecChart, ConditionsAndActionsInAList) {
  IecRun run(
      iecProgram("VAR_INPUT x, y : BOOL; END_VAR VAR n : INT; END_VAR",
                 "INITIAL_STEP A: END_STEP STEP B: add; END_STEP\n"
                 "TRANSITION FROM A TO B : LD x\nAND y\nEND_TRANSITION\n"
                 "TRANSITION FROM B TO A :\n  LDN x\nEND_TRANSITION\nACTION add:\nLD n\nADD 2\nST n\nEND_ACTION"));
  EXPECT_EQ(run.follow("n", {{"x", {1, 1, 1, 0}}, {"y", {0, 1, 0, 1}}}), (Row{0, 2, 4, 4}));
}

TEST(IecChart, AConditionIsComputedOnlyWhileItsStepIsActive) {  // 10 / d would end the scan
  IecRun run(
      iecProgram("VAR_INPUT go : BOOL; d : INT; END_VAR",
                 "INITIAL_STEP A: END_STEP STEP B: END_STEP STEP C: END_STEP\n"
                 "TRANSITION FROM A TO B := go; END_TRANSITION TRANSITION FROM B TO C := 10 / d > 2; END_TRANSITION"));
  EXPECT_EQ(run.follow("C.X", {{"go", {0, 1, 0}}, {"d", {0, 0, 3}}}), (Row{0, 0, 1}));
  EXPECT_TRUE(run.simulator.isRunning());
}

TEST(IecChart, ChartsWithinActions) {  // the inner chart keeps its step while the outer one is elsewhere
  IecRun run(
      iecProgram("VAR_INPUT x, y : BOOL; END_VAR VAR n : INT; END_VAR",
                 "INITIAL_STEP A: inner; END_STEP STEP B: END_STEP\nTRANSITION FROM A TO B := x; END_TRANSITION\n"
                 "TRANSITION FROM B TO A := NOT x; END_TRANSITION\nACTION inner:\n  INITIAL_STEP I: END_STEP\n"
                 "  STEP J: count; END_STEP\n  TRANSITION FROM I TO J := y; END_TRANSITION\n"
                 "  ACTION count: n := n + 1; END_ACTION\nEND_ACTION"));
  EXPECT_EQ(run.follow("n", {{"x", {0, 0, 1, 1, 0}}, {"y", {0, 1, 0, 0, 0}}}), (Row{0, 1, 1, 1, 2}));
}

TEST(IecChart, ChartsOfFunctionBlocks) {  // each instance has its own steps
  const std::string text =
      "FUNCTION_BLOCK toggle VAR_INPUT go : BOOL; END_VAR VAR_OUTPUT lamp : BOOL; END_VAR\n"
      "INITIAL_STEP Dark: END_STEP STEP Bright: lamp(N); END_STEP\nTRANSITION FROM Dark TO Bright := go; "
      "END_TRANSITION\n"
      "TRANSITION FROM Bright TO Dark := NOT go; END_TRANSITION\nEND_FUNCTION_BLOCK\n" +
      iecProgram("VAR_INPUT a, b : BOOL; END_VAR VAR s, t : toggle; END_VAR", "s(go := a); t(go := b);");
  const Inputs inputs = {{"a", {1, 1, 0}}, {"b", {0, 1, 1}}};
  EXPECT_EQ(IecRun(text).follow("s.lamp", inputs), (Row{1, 1, 0}));
  EXPECT_EQ(IecRun(text).follow("t.Bright.X", inputs), (Row{0, 1, 1}));
}

TEST(IecChart, ABlockWithInOutIsWrittenOut) {
  IecRun run(
      "FUNCTION_BLOCK fill VAR_INPUT go : BOOL; END_VAR VAR_IN_OUT level : INT; END_VAR\n"
      "INITIAL_STEP Idle: END_STEP STEP Pour: add(N); END_STEP\nTRANSITION FROM Idle TO Pour := go; END_TRANSITION\n"
      "ACTION add: IF level >= 2 THEN RETURN; END_IF; level := level + 1; END_ACTION\nEND_FUNCTION_BLOCK\n" +
      iecProgram("VAR_INPUT a : BOOL; END_VAR VAR f : fill; l, n : INT; END_VAR",
                 "f(go := a, level := l); n := n + 1;"));
  EXPECT_EQ(run.follow("l", {{"a", {0, 1, 1, 1}}}), (Row{0, 1, 2, 2}));
  EXPECT_EQ(run.get("n"), 4);
}

TEST(IecChart, AVariableOfAnActionMayBeWrittenElsewhere) {  // FALSE is written in the scan of deactivation only
  IecRun run(
      "CONFIGURATION c VAR_GLOBAL q : BOOL; END_VAR RESOURCE r ON PLC TASK t(INTERVAL := T#10ms, PRIORITY := 1); "
      "PROGRAM m WITH t : main; PROGRAM o WITH t : other; END_RESOURCE END_CONFIGURATION\n"
      "PROGRAM other VAR_INPUT w : BOOL; END_VAR VAR_EXTERNAL q : BOOL; END_VAR IF w THEN q := TRUE; END_IF; "
      "END_PROGRAM\n" +
      iecProgram("VAR_INPUT x : BOOL; END_VAR VAR_EXTERNAL q : BOOL; END_VAR",
                 "INITIAL_STEP A: END_STEP STEP B: q; END_STEP\nTRANSITION FROM A TO B := x; END_TRANSITION\n"
                 "TRANSITION FROM B TO A := NOT x; END_TRANSITION"));
  EXPECT_EQ(run.follow("q", {{"x", {0, 1, 0, 0, 0}}, {"w", {0, 0, 0, 1, 0}}}), (Row{0, 1, 0, 1, 1}));
}

TEST(IecChart, RIsStrongerThanAnyOther) {  // while a step with R is active nothing else counts
  IecRun run(iecProgram("VAR_INPUT go : BOOL; END_VAR VAR q : BOOL; END_VAR",
                        "INITIAL_STEP S0: q(N); END_STEP STEP A: q(N); END_STEP STEP B: q(R); END_STEP\n"
                        "TRANSITION FROM S0 TO (A, B) := go; END_TRANSITION"));
  EXPECT_EQ(run.follow("q", {{"go", {0, 1, 0}}}), (Row{1, 0, 0}));
}

TEST(IecChart, StepAndTransitionMayNameVariables) {  // where they are no chart's words
  IecRun run(iecProgram("VAR step : INT; transition : BOOL; END_VAR", "step := step + 1; transition := step > 1;"));
  run.scan();
  EXPECT_EQ(run.get("step"), 1);
}

}  // namespace
}  // namespace rungproof
