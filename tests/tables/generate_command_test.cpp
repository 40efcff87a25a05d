// Generated tests: what they cover, that they hold at any scan time and with inputs early and late, what they write.
#include <cmath>
#include <filesystem>
#include <random>

#include "engine/testing/test_player.hpp"
#include "frontend/input/project.hpp"
#include "frontend/testing/table_reader.hpp"
#include "test_command.hpp"

namespace rungproof::test {
namespace {

class Generate : public TestCommand {
 protected:
  nlohmann::json generate(const std::string& program, int exit, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{program, "--generate", path("out"), "--timeout", "10s"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json(arguments, exit);
  }
  /// Everything is covered or proved impossible.
  static void expectAllSettled(const nlohmann::json& coverage) {
    for (const char* measure : {"networks", "contacts", "transitions", "mcdc"}) {
      const nlohmann::json& m = coverage[measure];
      EXPECT_EQ(m["open"], 0) << measure << m.dump(1);
      EXPECT_EQ(m["covered"].get<int>() + m["unreachable"].get<int>(), m["total"].get<int>()) << measure;
    }
  }
};

TEST_F(Generate, CoversALatchWithATimer) {
  const nlohmann::json report = generate(write("motor.awl", motorProgram), 0);
  expectAllSettled(report["coverage"]);
  EXPECT_EQ(report["coverage"]["contacts"]["covered"], 5);
  EXPECT_EQ(report["coverage"]["mcdc"]["covered"], 5);  // three of Q0.0, one of T37, one of Q0.1
  for (const nlohmann::json& one : report["tests"]) EXPECT_EQ(one["passed"], true) << one.dump();
  for (const char* name : {"out/tests.csv", "out/sheet.html", "out/sheet.md", "out/sheet/sheet.csv",
                           "out/coverage.html", "out/coverage.json"})
    EXPECT_FALSE(content(name).empty()) << name;
  const nlohmann::json coverage = nlohmann::json::parse(content("out/coverage.json"));
  EXPECT_EQ(coverage["mcdc"]["covered"], report["coverage"]["mcdc"]["covered"]);
  EXPECT_NE(content("out/sheet.html").find("switch on I0.0"), std::string::npos);
}

// M0.0 is I0.0 and not I0.0: never 1. So its contact is never 1, network 2 has no power flow, and nothing of it
// decides.
TEST_F(Generate, ProvesWhatCannotBeCovered) {
  const nlohmann::json report =
      generate(write("dead.awl", "Network 1\nLD I0.0\nAN I0.0\n= M0.0\nNetwork 2\nLD M0.0\nA I0.1\n= Q0.0\n"), 0);
  const nlohmann::json& c = report["coverage"];
  expectAllSettled(c);
  EXPECT_EQ(c["networks"]["unreachable"], 2);
  EXPECT_EQ(c["contacts"]["unreachable"], 1);
  // I0.0 decides neither way for itself twice: as 1 the first contact meets an open second one, as 0 the reverse.
  EXPECT_EQ(c["mcdc"]["unreachable"], 4);
}

// Only what is asked can be open: the tests for networks need not cover any pair.
TEST_F(Generate, CoversWhatIsAsked) {
  const nlohmann::json report =
      generate(write("or.awl", "Network 1\nLD I0.0\nO I0.1\n= Q0.0\n"), 0, {"--goal", "networks"});
  EXPECT_EQ(report["coverage"]["networks"]["covered"], 1);
  EXPECT_LT(report["coverage"]["mcdc"]["covered"].get<int>(), 2);
  EXPECT_EQ(report["coverage"], nlohmann::json::parse(content("out/coverage.json")));
}

TEST_F(Generate, ChangesOneInputAStep) {
  generate(write("and.awl", "Network 1\nLD I0.0\nA I0.1\nA I0.2\n= Q0.0\n"), 0);
  std::vector<Failure> failures;
  const Program program = readProgram({path("and.awl")});
  const TestTable table = readTestTable("tests.csv", content("out/tests.csv"), program, 0, failures);
  ASSERT_TRUE(failures.empty()) << failures[0].message;
  for (const TestCase& test : table.tests) {
    std::vector<double> values(table.sets.size(), 0);
    for (const TestRow& row : test.rows) {
      int changes = 0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!row.sets[i] || *row.sets[i] == values[i]) continue;
        ++changes;
        values[i] = *row.sets[i];
      }
      EXPECT_LE(changes, 1) << test.name << " " << row.step;
    }
  }
}

/// Plays a generated table at random scan times with inputs shifted by up to two scans: what fails stands in a row that
/// says so, and cells that are expected hold everywhere.
void replayAnywhere(const std::string& program, const std::string& text, unsigned seed) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::vector<Failure> failures;
  const Program read = readProgram({program});
  const TestTable table = readTestTable("tests.csv", text, read, 0, failures);
  ASSERT_TRUE(failures.empty()) << failures[0].message;
  std::mt19937 random(seed);
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t us = 1000 + random() % 99001;
    for (const TestCase& test : table.tests) {
      TestPlayOptions play;
      play.length = [us](std::uint64_t) { return us; };
      for (std::size_t i = 0; i < test.rows.size(); ++i) play.skews.push_back(static_cast<int>(random() % 5) - 2);
      play.stopsAtFailure = false;
      Simulator simulator(read, play.engine);
      const TestPlay played = playTest(simulator, table, test, play);
      for (const TestFailure& failure : played.failures)
        if (!test.rows[failure.step].note.starts_with("timing"))
          ADD_FAILURE() << test.name << " step " << failure.step + 1 << " at " << us << " us";
    }
  }
}

TEST_F(Generate, HoldsAtAnyScanTime) {
  const std::string program = write("motor.awl", motorProgram);
  generate(program, 0);
  replayAnywhere(program, content("out/tests.csv"), 7);
}

// Steps behind each other, one of them by time: a fill of 2 s, then a stirrer until the stop.
TEST_F(Generate, CoversStepsAndTimes) {
  const std::string program =
      write("steps.awl",
            "Network 1\nLD SM0.1\nS S0.1, 1\nNetwork 2\nLSCR S0.1\nNetwork 3\nLD I0.0\nSCRT S0.2\nNetwork 4\nSCRE\n"
            "Network 5\nLSCR S0.2\nNetwork 6\nLD SM0.0\nTON T37, 20\nNetwork 7\nLD T37\nSCRT S0.3\nNetwork 8\nSCRE\n"
            "Network 9\nLSCR S0.3\nNetwork 10\nLD I0.1\nSCRT S0.1\nNetwork 11\nSCRE\nNetwork 12\nLD S0.2\n= Q0.0\n"
            "Network 13\nLD S0.3\n= Q0.1\n");
  const nlohmann::json report = generate(program, 0);
  expectAllSettled(report["coverage"]);
  EXPECT_EQ(report["coverage"]["transitions"]["covered"], 4);
  replayAnywhere(program, content("out/tests.csv"), 11);
}

// Each input decides in every row; a pair needs a row of outcome 0 too, which no condition alone asks for.
TEST_F(Generate, CoversBothOutcomesOfAnExclusiveOr) {
  const std::string program = write(
      "x.st", "PROGRAM P\nVAR_INPUT A, B : BOOL; END_VAR\nVAR_OUTPUT Q : BOOL; END_VAR\nQ := A XOR B;\nEND_PROGRAM\n");
  const nlohmann::json report = generate(program, 0, {"--goal", "mcdc"});
  EXPECT_EQ(report["coverage"]["mcdc"]["covered"], 2);
  EXPECT_EQ(report["coverage"]["mcdc"]["open"], 0);
}

// The same latch in the other families: three contacts, three conditions of the output.
TEST_F(Generate, CoversOtherFamilies) {
  const std::string step7 = write("l.awl",
                                  "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      A(;\n      O I 0.0;\n      O Q 4.0;\n"
                                  "      );\n      AN I 0.1;\n      = Q 4.0;\nEND_ORGANIZATION_BLOCK\n");
  const nlohmann::json rlo = generate(step7, 0, {"--dialect", "s7-300"});
  expectAllSettled(rlo["coverage"]);
  EXPECT_EQ(rlo["coverage"]["mcdc"]["covered"], 3);
  const std::string iec =
      write("p.st",
            "PROGRAM P\nVAR_INPUT Start, Stop : BOOL; END_VAR\nVAR_OUTPUT Motor, Lamp : BOOL; END_VAR\n"
            "VAR Late : TON; END_VAR\nMotor := (Start OR Motor) AND NOT Stop;\n"
            "Late(IN := Motor, PT := T#2s);\nLamp := Late.Q;\nEND_PROGRAM\n");
  const nlohmann::json expressions = generate(iec, 0);
  expectAllSettled(expressions["coverage"]);
  EXPECT_EQ(expressions["coverage"]["mcdc"]["covered"], 5);  // three of Motor, one of Late.IN, one of Lamp
  replayAnywhere(iec, content("out/tests.csv"), 13);
  const nlohmann::json kills = json({iec, "--table", path("out/tests.csv"), "--kill"}, 0)["kills"];
  EXPECT_GT(kills["noticed"].get<int>(), kills["unnoticed"].get<int>()) << kills.dump(1);
}

TEST_F(Generate, NamesRequirementsAndTheirTests) {
  const std::string program = write("motor.awl", motorProgram);
  const std::string properties = write("p.prop", "prove stop: I0.1 implies not Q0.0\nprove other: VB100 = 0\n");
  generate(program, 0, {"--props", properties});
  const std::string sheet = content("out/sheet.md");
  EXPECT_NE(sheet.find("| stop | prove stop: I0.1 implies not Q0.0 | T0"), std::string::npos) << sheet;
  EXPECT_NE(sheet.find("| other | prove other: VB100 = 0 | no test exercises it |"), std::string::npos) << sheet;
}

// The tests of the motor notice faults of each kind that the other tests of this file reason about.
TEST_F(Generate, KillsPlantedFaults) {
  const std::string program = write("motor.awl", motorProgram);
  generate(program, 0);
  const nlohmann::json report = json({program, "--table", path("out/tests.csv"), "--kill"}, 0);
  const nlohmann::json& kills = report["kills"];
  EXPECT_GT(kills["noticed"].get<int>(), 10);
  bool hasPolarity = false;
  for (const nlohmann::json& fault : kills["faults"]) {
    const bool isPolarity = fault["kind"] == "contact polarity" && fault["text"] == "LDN I0.0 for LD I0.0";
    hasPolarity = hasPolarity || isPolarity;
    if (isPolarity) {
      EXPECT_EQ(fault["fate"], "noticed");
    }
  }
  EXPECT_TRUE(hasPolarity);
}

// A number is tried at each limit, one below and one above: > for >= and 101 for 100 are noticed, in a list too, where
// each line is a network of its own.
TEST_F(Generate, NumbersAreTriedAtTheirLimits) {
  const std::string variables = "PROGRAM main\nVAR_INPUT level : INT; END_VAR\nVAR_OUTPUT high, low : BOOL; END_VAR\n";
  for (const std::string body : {"high := level >= 100; low := level < 20;",
                                 "  LD level\n  GE 100\n  ST high\n  LD level\n  LT 20\n  ST low\n"}) {
    const std::string program = write("limits.st", variables + body + "\nEND_PROGRAM\n");
    generate(program, 0);
    const nlohmann::json kills = json({program, "--table", path("out/tests.csv"), "--kill"}, 0)["kills"];
    EXPECT_EQ(kills["unnoticed"], 0) << body << kills.dump(1);
    EXPECT_GE(kills["noticed"].get<int>(), 4) << body << kills.dump(1);
  }
}

// The guard is a make contact in series with the start; what moves the motor stands in the purpose with its symbol.
TEST_F(Generate, SaysWhatATestIsForAndLeadsToTheNetworks) {
  const std::string program = write("guard.awl", "Network 1\nLD I0.0\nO Q0.0\nA I0.1\n= Q0.0\n");
  generate(program, 0, {"--symbols", write("s.csv", "Start,I0.0,green button S1\nGuard,I0.1,\nMotor,Q0.0,\n")});
  const std::string sheet = content("out/sheet.md");
  EXPECT_NE(sheet.find("Purpose: Motor (Q0.0) comes when "), std::string::npos) << sheet;
  EXPECT_NE(sheet.find("values to be seen are proved"), std::string::npos) << sheet;
  EXPECT_EQ(sheet.find("not proved"), std::string::npos) << sheet;
  EXPECT_NE(sheet.find("| Start | I0.0 | green button S1 |"), std::string::npos) << sheet;
  EXPECT_NE(content("out/sheet.html").find("<a href=\"coverage.html#n0-0\">MAIN:1</a>"), std::string::npos);
  EXPECT_NE(content("out/coverage.html").find("id=\"n0-0\""), std::string::npos);
}

// A subroutine drives the output that it is given: it is compared, and the input given stays an input.
TEST_F(Generate, ActualParametersAreInputsAndOutputs) {
  const std::string program = write("sub.awl",
                                    "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR_0, I0.0, Q0.0\n"
                                    "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nin:BOOL;\n"
                                    "END_VAR\nVAR_OUTPUT\nout:BOOL;\nEND_VAR\nBEGIN\nNetwork 1\nLD L0.0\n= L0.1\n"
                                    "END_SUBROUTINE_BLOCK\n");
  generate(program, 0);
  EXPECT_TRUE(content("out/tests.csv").starts_with("test,step,wait,set I0.0,expect Q0.0,note\n"))
      << content("out/tests.csv");
}

// I0.0 and I0.1 are never on together: no run lets power flow, and neither contact decides as 1. The sheet says what is
// taken for granted.
TEST_F(Generate, UsesAssumptions) {
  const nlohmann::json report =
      generate(write("limits.awl", "Network 1\nLD I0.0\nA I0.1\n= Q0.0\n"), 0,
               {"--props", write("limits.prop", "assume lim: not (I0.0 and I0.1)\nprove p: not Q0.0\n")});
  expectAllSettled(report["coverage"]);
  EXPECT_EQ(report["coverage"]["networks"]["unreachable"], 1);
  EXPECT_EQ(report["coverage"]["mcdc"]["unreachable"], 2);
  EXPECT_NE(report["coverage"]["networks"]["goals"][0]["reason"].get<std::string>().find("assuming 'lim'"),
            std::string::npos)
      << report["coverage"]["networks"].dump(1);
  EXPECT_NE(content("out/sheet.md").find("The surroundings keep to: assume lim: not (I0.0 and I0.1)"),
            std::string::npos);
}

// In which scan the slower task begins nobody can set; a variable of that name is an input as any other.
TEST_F(Generate, SetsNoPhaseOfATask) {
  for (const std::string own : {"", ", phase"}) {
    const std::string program =
        write("tasks.st",
              "PROGRAM Fast\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\nq := a;\nEND_PROGRAM\n"
              "PROGRAM Slow\nVAR_INPUT b" +
                  own + " : BOOL; END_VAR\nVAR_OUTPUT lamp : BOOL; END_VAR\nlamp := b" +
                  std::string(own.empty() ? "" : " AND phase") +
                  ";\nEND_PROGRAM\nCONFIGURATION C\nRESOURCE R ON PLC\n"
                  "TASK T1(INTERVAL := T#10ms, PRIORITY := 1);\nTASK T2(INTERVAL := T#200ms, PRIORITY := 2);\n"
                  "PROGRAM F1 WITH T1 : Fast;\nPROGRAM S1 WITH T2 : Slow;\nEND_RESOURCE\nEND_CONFIGURATION\n");
    run({program, "--generate", path("out"), "--timeout", "10s"});
    const std::string table = content("out/tests.csv");
    const std::string heading = table.substr(0, table.find('\n'));
    EXPECT_EQ(heading.find("PHASE"), std::string::npos) << heading;
    EXPECT_NE(heading.find("set a"), std::string::npos) << heading << err_;
    EXPECT_NE(heading.find("set b"), std::string::npos) << heading;
    EXPECT_EQ(heading.find("set phase") == std::string::npos, own.empty()) << heading;
  }
}

// Q0.0 comes in the fiftieth scan with I0.0: after 0.5 s with scans of 10 ms, after 5 s with those of 100 ms. VW0 is
// kept without power.
TEST_F(Generate, TellsScansFromTimesOnTheSheet) {
  const std::string program = write("scans.awl",
                                    "Network 1\nLD I0.0\nAW< VW0, 1000\nINCW VW0\nNetwork 2\nLDN I0.0\nMOVW 0, VW0\n"
                                    "Network 3\nLDW>= VW0, 50\n= Q0.0\n");
  run({program, "--generate", path("out"), "--timeout", "10s"});
  const std::string sheet = content("out/sheet.md");
  EXPECT_NE(sheet.find(" scans: "), std::string::npos) << sheet;
  EXPECT_EQ(sheet.find("switch on I0.0 | 0.6 s | nothing changes"), std::string::npos) << sheet;
  EXPECT_NE(sheet.find("Retentive ones keep their values without power: clear them before each test."),
            std::string::npos)
      << sheet;
}

// What is compared in runs with a pulse output was tried only, and each step says why.
TEST_F(Generate, MarksWhatDevicesKeepFromBeingProved) {
  const std::string program = write("pls.awl", "Network 1\nLD I0.0\nPLS 0\nNetwork 2\nLD I0.1\n= Q0.1\n");
  generate(program, 0, {"--goal", "contacts"});
  std::vector<Failure> failures;
  const TestTable table = readTestTable("tests.csv", content("out/tests.csv"), readProgram({program}), 0, failures);
  ASSERT_TRUE(failures.empty()) << failures[0].message;
  for (const TestCase& test : table.tests) {
    for (const TestRow& row : test.rows)
      EXPECT_TRUE(row.note.starts_with("timing: tried, not proved, as devices")) << row.note;
  }
  EXPECT_NE(content("out/sheet.md").find("steps with the remark 'timing: tried'"), std::string::npos);
}

// Any value above 0 lets Temp > 0 be true; nobody sets 1e-45.
TEST_F(Generate, SetsNumbersThatPeopleSet) {
  const std::string program =
      write("real.st",
            "PROGRAM P\nVAR_INPUT Temp : REAL; END_VAR\nVAR_OUTPUT Q, R : BOOL; END_VAR\nQ := Temp > 0.0;\n"
            "R := Temp * 3.0 > 50.0 AND Temp * 3.0 < 50.5;\nEND_PROGRAM\n");
  expectAllSettled(generate(program, 0)["coverage"]);
  std::vector<Failure> failures;
  const TestTable table = readTestTable("tests.csv", content("out/tests.csv"), readProgram({program}), 0, failures);
  ASSERT_TRUE(failures.empty()) << failures[0].message;
  for (const TestCase& test : table.tests) {
    for (const TestRow& row : test.rows) {
      if (!row.sets[0]) continue;
      const bool isEasy = std::abs(*row.sets[0] * 1000 - std::round(*row.sets[0] * 1000)) < 1e-3L;
      EXPECT_TRUE(isEasy || row.note.find("Temp counts with all its digits") != std::string::npos)
          << static_cast<double>(*row.sets[0]) << row.note;
      EXPECT_FALSE(*row.sets[0] != 0 && std::abs(*row.sets[0]) < 1e-3L) << static_cast<double>(*row.sets[0]);
    }
  }
}

TEST_F(Generate, HoldsAtAnyScanTimeWithInterrupts) {
  const std::string program =
      write("count.awl",
            "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nMOVB 50, SMB34\nATCH INT_0, 10\nENI\n"
            "Network 2\nLDN I0.0\nMOVW 0, VW0\nNetwork 3\nLDW>= VW0, 20\n= Q0.0\nEND_ORGANIZATION_BLOCK\n"
            "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD I0.0\nINCW VW0\nEND_INTERRUPT_BLOCK\n");
  generate(program, 0);
  replayAnywhere(program, content("out/tests.csv"), 3);
}

TEST_F(Generate, WritesNothingWhereItCannot) {
  const std::string program = write("motor.awl", motorProgram);
  const std::string blocked = write("file", "");  // a file where the folder should be
  EXPECT_EQ(run({program, "--generate", blocked, "--timeout", "5s"}), 2);
  EXPECT_TRUE(content("file").empty());
}

}  // namespace
}  // namespace rungproof::test
