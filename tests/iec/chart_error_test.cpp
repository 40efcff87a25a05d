// Charts that are wrong, damaged or not covered, and verdicts on charts.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

struct WrongChart {
  const char* chart;
  const char* message;
  std::uint32_t line, column;
};

const char* const good = "INITIAL_STEP A: END_STEP\nSTEP B: END_STEP\nTRANSITION FROM A TO B := x; END_TRANSITION\n";

/// The charts begin in line 3.
constexpr WrongChart wrongCharts[] = {
    {"STEP A: END_STEP\nSTEP B: END_STEP\nTRANSITION FROM A TO B := x; END_TRANSITION", "the chart has no initial step",
     3, 1},
    {"INITIAL_STEP A: END_STEP\nINITIAL_STEP B: END_STEP\nTRANSITION FROM A TO B := x; END_TRANSITION",
     "A and B are both initial steps of one chart", 4, 1},
    {"INITIAL_STEP A: END_STEP\nTRANSITION FROM A TO C := x; END_TRANSITION", "there is no step C", 4, 22},
    {"INITIAL_STEP A: END_STEP\nTRANSITION FROM D TO A := x; END_TRANSITION", "there is no step D", 4, 17},
    {"INITIAL_STEP A: END_STEP\nSTEP A: END_STEP", "the name A of a step is taken", 4, 1},
    {"INITIAL_STEP x: END_STEP", "the name x of a step is taken", 3, 1},
    {"INITIAL_STEP A: q(Q); END_STEP", "'Q' is no qualifier of an action", 3, 19},
    {"INITIAL_STEP A: q(L); END_STEP", "L needs a duration", 3, 20},
    {"INITIAL_STEP A: q(N, T#5s); END_STEP", "N takes no duration", 3, 22},
    {"INITIAL_STEP A: nobody(N); END_STEP", "there is no variable nobody", 3, 17},
    {"INITIAL_STEP A: n(N); END_STEP", "BOOL does not fit into INT", 3, 17},
    {"INITIAL_STEP A: q(L, 5); END_STEP", "a duration is written T#5s", 3, 22},
    {"INITIAL_STEP A: END_STEP\nTRANSITION FROM A TO A := n; END_TRANSITION", "BOOL and INT do not go together", 4, 27},
    {"INITIAL_STEP A: END_STEP\nTRANSITION FROM A TO A := y; END_TRANSITION", "there is no variable y", 4, 27},
    {"INITIAL_STEP A: END_STEP\nTRANSITION FROM A := x; END_TRANSITION", "'TO' is needed here, not ':='", 4, 19},
    {"INITIAL_STEP A: END_STEP\nTRANSITION FROM A TO A x; END_TRANSITION", "':=' and a condition are needed here", 4,
     24},
    {"INITIAL_STEP A: END_STEP\nTRANSITION FROM A TO A : x; END_TRANSITION",
     "a condition is an expression behind ':=', or a list of IL behind ':'", 4, 26},
    {"INITIAL_STEP A: END_STEP\nTRANSITION FROM A TO A := x AND; END_TRANSITION", "a value is needed here, not ';'", 4,
     32},
    {"INITIAL_STEP A: END_STEP\nTRANSITION (PRIORITY := q) FROM A TO A := x; END_TRANSITION",
     "a number is needed here, not 'q'", 4, 25},
    {"INITIAL_STEP A END_STEP", "':' is needed here, not 'END_STEP'", 3, 16},
    {"INITIAL_STEP A: q(N)\nSTEP B: END_STEP", "';' is needed here, not 'STEP'", 4, 1},
    {"INITIAL_STEP A: END_STEP\nq := x;", "STEP, TRANSITION or ACTION is needed here, not 'q'", 4, 1},
    {"INITIAL_STEP A: go; END_STEP\nACTION go: q := 5; END_ACTION", "5 is no BOOL", 4, 17},
    {"INITIAL_STEP A: go; END_STEP\nACTION go: A.X := x; END_ACTION", "A is a step: only its chart writes it", 4, 12},
    {"INITIAL_STEP A: go; END_STEP\nACTION go: q := x; END_ACTION\nACTION go: q := x; END_ACTION",
     "two actions are named go", 5, 1},
    {"INITIAL_STEP A: go; END_STEP\nACTION go: go(); END_ACTION", "the action go calls itself", 4, 12},
    {"INITIAL_STEP A: END_STEP\nTRANSITION FROM A TO A :\nCAL t(IN := x)\nLD t.Q\nEND_TRANSITION",
     "a function block in such a condition of a transition is not modelled", 5, 5},
};

std::string chartProgram(const std::string& chart, const std::string& properties = "") {
  return "PROGRAM main\nVAR_INPUT x : BOOL; END_VAR VAR q : BOOL; n : INT; t : TON; END_VAR" + properties + "\n" +
         chart + "\nEND_PROGRAM\n";
}

TEST(IecChartErrors, WrongChartsAreNamedAtTheirPlaces) {
  for (const WrongChart& wrong : wrongCharts) {
    SCOPED_TRACE(wrong.chart);
    expectErrorAt(readIecText(chartProgram(wrong.chart)), wrong.message, wrong.line, wrong.column);
  }
}

TEST(IecChartErrors, DamagedTextsEndInMessages) {  // each prefix of a chart, and each chart without one character
  const std::string whole = chartProgram(
      "INITIAL_STEP A: q(SD, T#5s); go(P1); END_STEP\nSTEP B: END_STEP\nTRANSITION one (PRIORITY := 1) FROM A "
      "TO (B, A) := x AND A.T > T#3s; END_TRANSITION\nTRANSITION FROM (A, B) TO A : LD x\nANDN "
      "q\nEND_TRANSITION\nACTION go: n := n + 1; END_ACTION");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    static_cast<void>(readIecText(whole.substr(0, i)));
    const Program program = readIecText(whole.substr(0, i) + whole.substr(i + 1));
    EXPECT_GT(program.sources->size(), 0U);
  }
}

TEST(IecChartErrors, NestingIsLimited) {
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "INITIAL_STEP A: END_STEP ACTION a: ";
  EXPECT_NE(findingsIec(readIecText(chartProgram(deep))).find("nested too deeply"), std::string::npos);
}

TEST(IecChartErrors, SizesAreLimited) {  // and a chart of the greatest size is read
  const auto chart = [](int steps, int branches) {
    std::string text = "INITIAL_STEP S0: END_STEP\n";
    for (int i = 1; i < steps; ++i)
      text += fmt::format("STEP S{0}: END_STEP TRANSITION FROM S{1} TO S{0} := x; END_TRANSITION\n", i, i - 1);
    for (int i = 1; i < branches; ++i) text += "TRANSITION FROM S0 TO S0 := x; END_TRANSITION\n";
    return findingsIec(readIecText(chartProgram(text)));
  };
  EXPECT_EQ(chart(900, 100), "");
  for (const std::string& findings : {chart(1100, 1), chart(2, 101), chart(20'000, 20'000)})
    EXPECT_NE(findings.find("a chart of more than 1000 steps or transitions"), std::string::npos) << findings;
}

TEST(IecChartErrors, AFunctionIsNoChart) {
  EXPECT_NE(
      findingsIec(readIecText("FUNCTION f : INT VAR_INPUT x : BOOL; END_VAR\nINITIAL_STEP A: END_STEP\nEND_FUNCTION\n" +
                              chartProgram(good)))
          .find("a FUNCTION keeps no state and cannot be a chart"),
      std::string::npos);
}

TEST(IecChartErrors, AStepThatWasNotReadLeavesNothingProved) {
  const IecOutput output = proofOfIec(
      chartProgram(std::string(good) + "STEP C: q(Z); END_STEP", "\n//@ prove q: not q\n//@ prove n: n = 0"));
  EXPECT_TRUE(output.has("NOT COVERED  q") && output.has("NOT COVERED  n")) << output.text;
  EXPECT_EQ(output.exit, 2);
}

TEST(IecChartErrors, AnUnreadConditionIsAnyCondition) {  // n does not depend on it
  const IecOutput output = proofOfIec(
      chartProgram("INITIAL_STEP A: END_STEP STEP B: q; END_STEP\nTRANSITION FROM A TO B := missing; END_TRANSITION",
                   "\n//@ prove q: not q\n//@ prove n: n = 0"));
  EXPECT_TRUE(output.has("NOT COVERED  q") && output.has("PROVED  n")) << output.text;
}

TEST(IecChartErrors, AnUnreadStatementOfAnActionSparesTheOthers) {
  const IecOutput output =
      proofOfIec(chartProgram("INITIAL_STEP A: go; END_STEP\nACTION go: n := missing;\nq := x; END_ACTION",
                              "\n//@ prove q: q = x\n//@ prove n: n = 0"));
  EXPECT_TRUE(output.has("PROVED  q") && output.has("NOT COVERED  n")) << output.text;
}

TEST(IecChartProofs, VerdictsOnCharts) {
  const std::string text =
      "PROGRAM main\nVAR_INPUT go, done : BOOL; END_VAR VAR motor, lamp : BOOL; END_VAR\n"
      "//@ prove one step: not (Run.X and Idle.X)\n//@ prove some step: Run.X or Idle.X\n"
      "//@ prove motor: motor implies once(go)\n//@ prove never: not Run.X\n"
      "//@ reach late: lamp and Run.T >= 50\n//@ prove early: lamp implies Run.T >= 50\n"
      "INITIAL_STEP Idle: END_STEP\nSTEP Run: motor(N); lamp(D, T#50ms); END_STEP\n"
      "TRANSITION FROM Idle TO Run := go; END_TRANSITION\n"
      "TRANSITION FROM Run TO Idle := done OR Run.T > T#10s; END_TRANSITION\nEND_PROGRAM\n";
  const IecOutput output = proofOfIec(text, {"--scan-time", "10ms"});
  for (const char* const part :
       {"PROVED  one step", "PROVED  some step", "PROVED  motor", "VIOLATED  never", "REACHABLE  late"})
    EXPECT_TRUE(output.has(part)) << part << "\n" << output.text;
  // With the actions first the lamp is still lit in the scan that leaves Run, and keeps its time.
  EXPECT_TRUE(output.has("PROVED  early")) << output.text;
}

TEST(IecChartProofs, TheOrderOfAScanIsAReading) {
  const std::string text =
      "PROGRAM main\nVAR_INPUT go : BOOL; END_VAR VAR q : BOOL; END_VAR\n"
      "//@ prove at once: q = Run.X\nINITIAL_STEP Idle: END_STEP\nSTEP Run: q(N); END_STEP\n"
      "TRANSITION FROM Idle TO Run := go; END_TRANSITION\n"
      "TRANSITION FROM Run TO Idle := NOT go; END_TRANSITION\nEND_PROGRAM\n";
  const IecOutput output = proofOfIec(text);
  EXPECT_TRUE(output.has("VIOLATED  at once") && output.has("iec-sfc-order")) << output.text;
  EXPECT_TRUE(proofOfIec(text, {"--choice", "iec-sfc-order=transitions-first"}).has("PROVED  at once"));
}

TEST(IecChartProofs, NamesOfStepsInStimuliAndTables) {
  const IecOutput output =
      runIec({"sim", "--scans", "2", "--set", "x=1", "--trace", "-", "--signals", "B.X,B.T"}, chartProgram(good));
  EXPECT_EQ(output.exit, 0) << output.text;
  EXPECT_TRUE(output.has("B.X") && output.has("B.T")) << output.text;
  const IecOutput uses = runIec({"xref", "B.X"}, chartProgram(good));
  EXPECT_EQ(uses.exit, 0) << uses.text;
}

TEST(IecChartProofs, WitnessesRepeat) {  // with names that mean something else in tables of other families
  const test::TemporaryFolder folder;
  folder.file(
      "main.st",
      "FUNCTION_BLOCK keep VAR_INPUT value : INT; END_VAR END_FUNCTION_BLOCK\n"
      "PROGRAM main VAR_INPUT start : BOOL; END_VAR VAR n, T1 : INT; k : keep; END_VAR\n//@ prove never: n < 3\n"
      "INITIAL_STEP A: END_STEP\nSTEP B: add(P); END_STEP\nTRANSITION FROM A TO B := start; END_TRANSITION\n"
      "TRANSITION FROM B TO A : LDN start\nEND_TRANSITION\nACTION add: n := n + 1; T1 := n; k(value := n); "
      "END_ACTION\nEND_PROGRAM\n");
  const auto run = [](std::vector<std::string> arguments) {
    std::istringstream in;
    std::ostringstream out, err;
    arguments.emplace_back("--isolated");
    const int exit = runProgram(arguments, {in, out, err});
    return std::make_pair(exit, out.str() + err.str());
  };
  EXPECT_EQ(run({"prove", folder.path("main.st"), "--traces", folder.path("runs")}).first, 1);
  const std::string trace = folder.path("runs/never.csv");
  const auto [exit, text] = run({"sim", folder.path("main.st"), "--stimulus", trace, "--expect", trace});
  EXPECT_EQ(exit, 0) << text;
}

TEST(IecChartShow, AChartIsShownAsText) {  // and with a scan of a trace its active steps are marked
  const test::TemporaryFolder folder;
  folder.file("main.st", chartProgram("INITIAL_STEP A: END_STEP\nSTEP B: q(D, T#2s); END_STEP\nSTEP C: END_STEP\n"
                                      "TRANSITION (PRIORITY := 2) FROM A TO (B, C) := x; END_TRANSITION\n"
                                      "TRANSITION FROM (B, C) TO A : LDN x\nAND q\nEND_TRANSITION",
                                      "\n//@ prove never: not B.X"));
  const auto run = [](std::vector<std::string> arguments) {
    std::istringstream in;
    std::ostringstream out, err;
    arguments.emplace_back("--isolated");
    runProgram(arguments, {in, out, err});
    return out.str() + err.str();
  };
  const std::string file = folder.path("main.st");
  const std::string plain = run({"show", file, "--pou", "main"});
  EXPECT_NE(plain.find("  [[A]]\n    | 2: x => (B, C)\n  [B]  q(D, T#2s)\n    | (B, C): LDN x; AND q -> A\n  [C]\n"),
            std::string::npos)
      << plain;
  run({"prove", file, "--traces", folder.path("runs")});
  const std::string lit = run({"show", file, "--pou", "main", "--at", folder.path("runs/never.csv") + ":1"});
  const std::string drawn = run({"show", file, "--pou", "main", "--svg", "--at", folder.path("runs/never.csv") + ":1"});
  EXPECT_NE(drawn.find("<rect class=\"rb on\""), std::string::npos) << drawn;
  EXPECT_NE(drawn.find("q(D, T#2s)</text>"), std::string::npos) << drawn;
  EXPECT_NE(lit.find("    [[A]]\n      | 2: x => (B, C)\n  * [B]"), std::string::npos) << lit;
}

}  // namespace
}  // namespace rungproof
