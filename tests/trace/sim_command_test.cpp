// The commands sim and compare as a user runs them: files, exit codes, JSON, traces, mistakes.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;

class SimCommand : public testing::Test {
 protected:
  void SetUp() override {
    write("start.awl", "LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\nLD Q0.0\nTON T37, +3\nLD T37\n= Q0.1\n");
    write("start.csv", "scan,I0.0,I0.1\n1,1,0\n2,0,\n50,,1\n");
    write("good.csv", "scan,Q0.0,Q0.1\n1,1,0\n30,1,0\n31,1,1\n50,0,\n");
    write("bad.csv", "scan,Q0.0,Q0.1\n1,1,0\n30,1,1\n");
  }

  std::string path(const std::string& name) const { return folder_.path(name); }
  void write(const std::string& name, const std::string& text) const { folder_.file(name, text); }
  std::string content(const std::string& name) const { return test::contentOf(path(name)); }
  int run(std::vector<std::string> arguments) {
    arguments.push_back("--isolated");
    test::ProgramRun run = test::run(arguments);
    out_ = std::move(run.out);
    err_ = std::move(run.err);
    return run.exit;
  }

  test::TemporaryFolder folder_;
  std::string out_, err_;
};

TEST_F(SimCommand, AgreesWithTheExpectedTrace) {
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--expect", path("good.csv"), "--format",
                 "json"}),
            0)
      << err_;
  const nlohmann::json json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["command"], "sim");
  EXPECT_EQ(json["comparison"]["equal"], true);
  EXPECT_EQ(json["coverage"]["instructions"], 8);
}

TEST_F(SimCommand, PrintsTheFirstDifference) {
  EXPECT_EQ(
      run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--expect", path("bad.csv"), "--format", "json"}),
      1);
  const nlohmann::json expected = {{"equal", false},   {"scan", 30},    {"time_ms", 300},
                                   {"signal", "Q0.1"}, {"expected", 1}, {"actual", 0}};
  EXPECT_EQ(nlohmann::json::parse(out_)["comparison"], expected);
  EXPECT_EQ(
      run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--expect", path("bad.csv"), "--slack", "1"}), 0);
}

TEST_F(SimCommand, AWrittenTraceReproducesTheRun) {
  ASSERT_EQ(
      run({"sim",     path("start.awl"), "--stimulus", path("start.csv"), "--scan-time", "3ms..25ms",   "--seed",
           "7",       "--scans",         "80",         "--trace",         path("t.csv"), "--trace",     path("t.vcd"),
           "--trace", path("t.html"),    "--trace",    path("t.svg"),     "--trace",     path("t.json")}),
      0)
      << err_;
  for (const std::string name : {"t.vcd", "t.html", "t.svg", "t.json"})
    EXPECT_GT(fs::file_size(path(name)), 100U) << name;
  EXPECT_EQ(
      run({"sim", path("start.awl"), "--stimulus", path("t.csv"), "--expect", path("t.csv"), "--trace", path("u.csv")}),
      0)
      << out_;
  EXPECT_EQ(content("t.csv"), content("u.csv"));
  EXPECT_EQ(run({"compare", path("t.csv"), path("u.csv")}), 0);
}

TEST_F(SimCommand, WithoutOtherWishesTheTraceIsTheOutput) {
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--signals", "Q0.0,T37.value"}), 0);
  EXPECT_TRUE(out_.starts_with("scan,time_ms,scan_ms,Q0.0,T37.value\n1,10,10,1,0\n")) << out_;
  EXPECT_EQ(std::count(out_.begin(), out_.end(), '\n'), 51);
}

TEST_F(SimCommand, RunTimeErrorsAreFindings) {
  write("bad.awl", "LD SM0.0\nMOVD 16#FF000000, VD0\nLD I0.0\nMOVB *VD0, VB10\nLD I0.1\nLBL 1\nLD SM0.0\nJMP 1\n");
  write("bad_stimulus.csv", "scan,I0.0\n5,1\n");
  EXPECT_EQ(run({"sim", path("bad.awl"), "--format", "json", "--scans", "3"}), 1);
  const nlohmann::json json = nlohmann::json::parse(out_);
  ASSERT_EQ(json["findings"].size(), 1U);
  EXPECT_EQ(json["findings"][0]["rule"], "RUN002");
  EXPECT_EQ(json["findings"][0]["severity"], "error");
}

TEST_F(SimCommand, BlocksWithoutTextAreNamed) {
  write("call.awl", "LD SM0.0\nCALL MBUS_SLAVE, Q0.1, VB10\n");
  EXPECT_EQ(run({"sim", path("call.awl"), "--format", "json"}), 0) << out_ << err_;
  const nlohmann::json approximated = nlohmann::json::parse(out_)["coverage"]["approximated"];
  ASSERT_EQ(approximated.size(), 1U);
  EXPECT_NE(approximated[0].get<std::string>().find("MBUS_SLAVE at"), std::string::npos);
}

TEST_F(SimCommand, CompareCommand) {
  write("e.csv", "scan,Q0.0,VW10\n1,1,100\n2,1,100\n");
  write("a.csv", "scan,Q0.0,VW10,M0.0\n1,1,100,0\n2,1,104,0\n");
  EXPECT_EQ(run({"compare", path("e.csv"), path("a.csv")}), 1);
  EXPECT_NE(out_.find("scan 2"), std::string::npos) << out_;
  EXPECT_NE(out_.find("VW10"), std::string::npos);
  EXPECT_EQ(run({"compare", path("e.csv"), path("a.csv"), "--tolerance", "VW10=4"}), 0);
  EXPECT_EQ(run({"compare", path("a.csv"), path("e.csv")}), 2);  // M0.0 is missing
  EXPECT_NE(err_.find("no column 'M0.0'"), std::string::npos) << err_;
}

// A scan lasts as long as scan_ms says from there on, and 10 ms where nothing does: the third one ends at 30, or at
// 5 + 5 + 20 ms.
TEST_F(SimCommand, TracesThatCountScansHaveTimes) {
  const std::pair<std::string, double> traces[] = {{"scan,Q0.0\n1,0\n2,0\n3,1\n", 30},
                                                   {"scan,scan_ms,Q0.0\n1,5,0\n2,,0\n3,20,1\n", 30},
                                                   {"scan,scan_ms,Q0.0\n1,5,0\n2,,0\n3,,1\n", 15}};
  write("e.csv", "scan,Q0.0\n1,0\n3,0\n");
  for (const auto& [trace, time] : traces) {
    write("a.csv", trace);
    EXPECT_EQ(run({"compare", path("e.csv"), path("a.csv"), "--format", "json"}), 1) << trace;
    const nlohmann::json comparison = nlohmann::json::parse(out_)["comparison"];
    EXPECT_EQ(comparison["scan"], 3);
    EXPECT_EQ(comparison["time_ms"], time) << trace;
  }
}

TEST_F(SimCommand, TwoColumnsOfOnePlaceAreRefused) {
  write("twice.csv", "scan,I0.0,IB0\n1,1,0\n");
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("twice.csv")}), 2);
  EXPECT_NE(err_.find("columns 'I0.0' and 'IB0' name the same place"), std::string::npos) << err_;
  // A trace shows a place as often as it was asked to, and says the same of it each time.
  EXPECT_EQ(run({"sim", path("start.awl"), "--set", "I0.0=1", "--scans", "3", "--signals", "I0.0,IB0,Q0.0", "--trace",
                 path("shown.csv")}),
            0)
      << err_;
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("shown.csv"), "--expect", path("shown.csv")}), 0) << err_;
}

/// What is wrong with a table, where it shows, and what the message says of it.
struct BadTable {
  std::string kind, text, place, message;
};
const std::vector<BadTable> badTables = {
    {"unknown signal", "scan,I0.0,Strat\n1,1,1\n", ":1:11", "'Strat' is no address and no symbol"},
    {"address that the CPU lacks", "scan,I99.0\n1,1\n", ":1:6", "the CPU 226 has no I99.0"},
    {"unsorted scans", "scan,I0.0\n3,1\n2,0\n", ":3:1", "scan 2 comes after scan 3"},
    {"unsorted times", "time_ms,I0.0\n10,1\n10,0\n", ":3:1", "time 10 comes after 10 ms"},
    {"wrong type", "scan,I0.0\n1,up\n", ":2:3", "'up' is no value for I0.0"},
    {"fraction in a word", "scan,VW0\n1,1.5\n", ":2:3", "VW0 takes whole numbers"},
    {"value out of range", "scan,VW0\n1,70000\n", ":2:3", "VW0 does not hold 70000"},
    {"bit out of range", "scan,I0.0\n1,2\n", ":2:3", "I0.0 is a bit"},
    {"ragged row", "scan,I0.0\n1,1\n2\n", ":3:1", "this row has 1 cells, the heading has 2"},
    {"missing heading", "1,1\n2,0\n", ":1:1", "the first column is '1'"},
    {"column without heading", "scan,\n1,1\n", ":1:6", "this column has no heading"},
    {"column twice", "scan,I0.0,I0.0\n1,1,1\n", ":1:11", "stands here twice"},
    {"scan number", "scan,I0.0\n0,1\n", ":2:1", "'0' is no scan number"},
    {"time", "time_ms,I0.0\n-5,1\n", ":2:1", "'-5' is no time in ms"},
    {"empty file", "", ":1:1", "the file is empty"},
    {"blank lines only", "\n\n", ":1:1", "the file is empty"},
    {"open quotes", "scan,I0.0\n1,\"1\n", ":2:3", "are not closed"},
};

TEST_F(SimCommand, BadStimulusNamesFileLineColumnAndHelp) {
  for (const BadTable& bad : badTables) {
    write("table.csv", bad.text);
    EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("table.csv")}), 2) << bad.kind;
    EXPECT_NE(err_.find(path("table.csv") + bad.place), std::string::npos) << bad.kind << ": " << err_;
    EXPECT_NE(err_.find(bad.message), std::string::npos) << bad.kind << ": " << err_;
    EXPECT_NE(err_.find("help: "), std::string::npos) << bad.kind << ": " << err_;
    EXPECT_EQ(out_, "") << bad.kind;
  }
}

TEST_F(SimCommand, BadExpectedTraceNamesFileLineColumnAndHelp) {
  for (const BadTable& bad : badTables) {
    write("table.csv", bad.text);
    EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--expect", path("table.csv")}), 2)
        << bad.kind;
    EXPECT_NE(err_.find(path("table.csv") + bad.place), std::string::npos) << bad.kind << ": " << err_;
    EXPECT_NE(err_.find(bad.message), std::string::npos) << bad.kind << ": " << err_;
    EXPECT_NE(err_.find("help: "), std::string::npos) << bad.kind << ": " << err_;
  }
}

/// compare knows no program: any name is a signal, and its type is what its column holds.
TEST_F(SimCommand, BadTraceOfCompareNamesFileLineColumnAndHelp) {
  for (const BadTable& bad : badTables) {
    if (bad.kind == "unknown signal" || bad.kind == "fraction in a word" || bad.kind == "value out of range" ||
        bad.kind == "bit out of range" || bad.kind == "address that the CPU lacks")
      continue;
    write("table.csv", bad.text);
    for (const bool first : {true, false}) {
      EXPECT_EQ(run({"compare", path(first ? "table.csv" : "good.csv"), path(first ? "good.csv" : "table.csv")}), 2)
          << bad.kind;
      EXPECT_NE(err_.find(path("table.csv") + bad.place), std::string::npos) << bad.kind << ": " << err_;
      EXPECT_NE(err_.find("help: "), std::string::npos) << bad.kind << ": " << err_;
    }
  }
}

TEST_F(SimCommand, ProgressStandsOnATerminalOnly) {
  const auto errors = [&](bool isTerminal, std::vector<std::string> more) {
    // Long enough to be told of: machine code would be at the end before.
    std::vector<std::string> arguments = {"sim",      path("start.awl"), "--isolated", "--signals",      "Q0.0",
                                          "--scans",  "400000",          "--trace",    path("long.vcd"), "--engine",
                                          "reference"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::istringstream in;
    std::ostringstream out, err;
    EXPECT_EQ(runProgram(arguments, {in, out, err, false, isTerminal}), 0) << err.str();
    return err.str();
  };
  const std::string shown = errors(true, {});
  EXPECT_NE(shown.find("\rsim: scan "), std::string::npos) << shown;
  EXPECT_NE(shown.find("\r\x1B[K"), std::string::npos) << "the line is taken away at the end";
  EXPECT_EQ(errors(true, {"--quiet"}).find("sim: scan"), std::string::npos);
  EXPECT_EQ(errors(false, {}).find("sim: scan"), std::string::npos);
}

TEST_F(SimCommand, MistakesEndWithTwoAndAReason) {
  struct Case {
    std::vector<std::string> arguments;
    std::string reason;
  };
  write("wrong.csv", "scan,I9.9\n1,1\n");
  write("syntax.awl", "LD I0.0\nFOO\n");
  write("library.awl", "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD SM0.0\n= Q0.0\nEND_SUBROUTINE_BLOCK\n");
  const std::string program = path("start.awl");
  for (const Case& c : {Case{{"sim", program, "--stimulus", path("none.csv")}, "cannot be read"},
                        Case{{"sim", program, "--stimulus", path("wrong.csv")}, "wrong.csv:1:6"},
                        Case{{"sim", program, "--trace", path("t.txt")}, "no ending that names a trace form"},
                        Case{{"sim", program, "--slack", "1"}, "belong to --expect"},
                        Case{{"sim", program, "--duration", "soon"}, "'soon' is no duration"},
                        Case{{"sim", program, "--signals", "Q99.0"}, "the CPU 226 has no Q99.0"},
                        Case{{"sim", program, "--expect", path("good.csv"), "--tolerance", "Q5.0=1"},
                             "no column of the expected trace"},
                        Case{{"sim", path("library.awl")}, "no main program"},
                        Case{{"compare", path("good.csv"), path("none.csv")}, "cannot be read"}}) {
    EXPECT_EQ(run(c.arguments), 2) << c.reason;
    EXPECT_NE(err_.find(c.reason), std::string::npos) << err_;
  }
  EXPECT_EQ(run({"sim", path("syntax.awl")}), 2);
  EXPECT_NE(out_.find("FOO"), std::string::npos);
}

/// A run ends, in memory and in time: what asks for more is refused at its place, before anything has run.
TEST_F(SimCommand, RunsThatAreTooLongAreRefused) {
  struct Case {
    std::string name, text, place, reason;
  };
  for (const Case& c : {Case{"a.csv", "scan,I0.0\n1,1\n99999999999,0\n", "a.csv:3:1", "beyond the longest run"},
                        Case{"b.csv", "scan,I0.0\n16#FFFFFFFF,1\n", "b.csv:2:1", "beyond the longest run"},
                        Case{"c.csv", "scan,I0.0\n16#FFFFFFFFF,1\n", "c.csv:2:1", "beyond the longest run"},
                        Case{"d.csv", "scan,I0.0\n-1,1\n", "d.csv:2:1", "is no scan number"},
                        Case{"e.csv", "time_ms,I0.0\n-0.5,1\n", "e.csv:2:1", "is no time in ms"},
                        Case{"f.csv", "time_ms,I0.0\n0,1\n999999999999,0\n", "f.csv", "more than 100000000 scans"},
                        Case{"g.csv", "time_ms,I0.0\n0,1\n1e300,0\n", "g.csv:3:1", "is no time in ms"},
                        Case{"i.csv", "scan,scan_ms,I0.0\n1,-5,1\n", "i.csv:2:3", "is no length of a scan"},
                        Case{"j.csv", "scan,HSC0.pulses\n1,4000000000\n", "j.csv:2:3", "more than a counter can"},
                        Case{"k.csv", "scan,HSC0.down\n1,-1\n", "k.csv:2:3", "does not hold"}}) {
    write(c.name, c.text);
    EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path(c.name)}), 2) << c.name;
    EXPECT_NE(err_.find(c.reason), std::string::npos) << c.name << ": " << err_;
    EXPECT_NE(err_.find(c.place), std::string::npos) << c.name << ": " << err_;
    EXPECT_NE(err_.find("= help: "), std::string::npos) << err_;
    EXPECT_EQ(out_, "");
  }
  write("far.csv", "scan,Q0.0\n123456789012,1\n");
  EXPECT_EQ(run({"sim", path("start.awl"), "--expect", path("far.csv")}), 2);
  EXPECT_NE(err_.find("far.csv:2:1"), std::string::npos) << err_;
}

TEST_F(SimCommand, LengthsOnTheCommandLineHaveTheSameLimits) {
  const std::string program = path("start.awl");
  for (const std::vector<std::string>& length : {std::vector<std::string>{"--scans", "99999999999"},
                                                 {"--scans", "100000001"},
                                                 {"--scans", "-3"},
                                                 {"--duration", "-3s"},
                                                 {"--duration", "100000min", "--scan-time", "1ms"}}) {
    std::vector<std::string> arguments = {"sim", program};
    arguments.insert(arguments.end(), length.begin(), length.end());
    EXPECT_EQ(run(arguments), 2) << length[1];
    EXPECT_NE(err_, "");
  }
  // The trace of 40,000 scans with 6 signals is more than a megabyte; what nobody looks at is not kept.
  EXPECT_EQ(run({"sim", program, "--scans", "40000", "--memory", "1MB", "--trace", path("t.vcd")}), 2);
  EXPECT_NE(err_.find("does not fit into 1 MB"), std::string::npos) << err_;
  EXPECT_EQ(run({"sim", program, "--scans", "40000", "--memory", "1MB", "--format", "json"}), 0) << err_;
}

/// A stimulus that makes the scans shorter as it goes is stopped while it runs.
TEST_F(SimCommand, ARunThatTurnsOutTooLongEnds) {
  write("shorter.csv", "time_ms,scan_ms,I0.0\n0,300,1\n300,0.001,0\n10000,,1\n");
  EXPECT_EQ(
      run({"sim", path("start.awl"), "--stimulus", path("shorter.csv"), "--memory", "1MB", "--trace", path("t.vcd")}),
      2);
  EXPECT_NE(err_.find("does not fit into 1 MB"), std::string::npos) << err_;
}

// One trace is written while the run goes on, several when it has ended.
TEST_F(SimCommand, ATraceIsTheSameWhetherItIsKeptOrNot) {
  const std::vector<std::string> one = {"sim",         path("start.awl"), "--stimulus", path("start.csv"),
                                        "--scan-time", "7ms..12ms"};
  std::vector<std::string> alone = one, beside = one;
  alone.insert(alone.end(), {"--trace", path("alone.csv"), "--names", "both"});
  beside.insert(beside.end(), {"--trace", path("kept.csv"), "--trace", path("kept.json"), "--names", "both"});
  ASSERT_EQ(run(alone), 0) << err_;
  ASSERT_EQ(run(beside), 0) << err_;
  EXPECT_EQ(content("alone.csv"), content("kept.csv"));
  EXPECT_GT(content("alone.csv").size(), 1000U);
  for (const std::vector<std::string>& length : {std::vector<std::string>(), {"--scans", "50"}}) {
    std::vector<std::string> shown = one;
    shown.insert(shown.end(), {"--names", "both"});
    shown.insert(shown.end(), length.begin(), length.end());
    ASSERT_EQ(run(shown), 0);
    EXPECT_EQ(out_, content("alone.csv"));
  }
}

TEST_F(SimCommand, ARunThatCannotEndLeavesTheOldTrace) {
  write("run.csv", "as it was");
  EXPECT_EQ(run({"sim", path("start.awl"), "--duration", "2000h", "--scan-time", "1ms", "--trace", path("run.csv")}),
            2);
  EXPECT_EQ(content("run.csv"), "as it was");
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--trace", path("start.csv")}), 2);
  EXPECT_NE(err_.find("has been read as input"), std::string::npos) << err_;
}

// A trace whose scans are told by their times alone: `sim` and `compare` find the run in it, `test --record` a table
// that the program passes. T37 runs for 50 ms and more.
TEST_F(SimCommand, ATraceByTimeIsTheSameRun) {
  write("late.awl", "Network 1\nLD I0.0\nTON T37, 1\nNetwork 2\nLD T37\n= Q0.0\n");
  write("press.csv", "scan,I0.0\n1,0\n3,1\n30,0\n33,0\n");
  for (const std::string scans : {"7ms..12ms", "10ms"}) {
    ASSERT_EQ(run({"sim", path("late.awl"), "--stimulus", path("press.csv"), "--scan-time", scans, "--trace",
                   path("run.csv"), "--signals", "I0.0,Q0.0"}),
              0)
        << err_;
    std::istringstream lines(content("run.csv"));
    std::string line, outputs, all;
    std::getline(lines, line);
    ASSERT_EQ(line, "scan,time_ms,scan_ms,I0.0,Q0.0");
    while (std::getline(lines, line)) {
      std::vector<std::string> cells;
      std::istringstream row(line);
      for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
      ASSERT_EQ(cells.size(), 5U);
      outputs += cells[1] + "," + cells[4] + "\n";
      all += cells[1] + "," + cells[3] + "," + cells[4] + "\n";
    }
    write("cut.csv", "time_ms,Q0.0\n" + outputs);
    write("all.csv", "time_ms,I0.0,Q0.0\n" + all);
    EXPECT_EQ(run({"sim", path("late.awl"), "--stimulus", path("press.csv"), "--scan-time", scans, "--expect",
                   path("cut.csv")}),
              0)
        << out_ << err_;
    EXPECT_EQ(run({"compare", path("cut.csv"), path("run.csv")}), 0) << out_;
    EXPECT_EQ(run({"compare", path("run.csv"), path("all.csv")}), 0) << out_ << err_;
    EXPECT_EQ(run({"compare", path("cut.csv"), path("cut.csv")}), 0) << out_;
  }
  ASSERT_EQ(run({"test", path("late.awl"), "--record", path("all.csv"), "-o", path("table.csv")}), 0) << err_;
  EXPECT_EQ(run({"test", path("late.awl"), "--table", path("table.csv")}), 0) << out_ << content("table.csv");
}

}  // namespace
}  // namespace rungproof
