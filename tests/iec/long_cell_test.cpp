// Cells of traces, stimuli and expected values hold every number of 64 bits: no double comes between.
#include <filesystem>

#include "tests/iec/iec_output.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

// 2^53 + 1 is the first whole number that a double cannot hold; the ends of the types are further out.
constexpr const char* program =
    "PROGRAM P\nVAR_INPUT x : LINT; u : ULINT; w : LWORD; r : LREAL; END_VAR\n"
    "VAR y : LINT; v : ULINT; z : LWORD; q : LREAL; isOdd : BOOL; END_VAR\n"
    "y := x; v := u; z := w; q := r; isOdd := x = 9007199254740993;\nEND_PROGRAM\n";

/// The last line of the trace after one scan with that first value.
std::string lastRow(const std::string& set) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("main.st", program);
  const std::string trace = folder.path("t.csv");
  const test::ProgramRun run = test::run({"sim", file, "--set", set, "--scans", "1", "--trace", trace, "--isolated"});
  EXPECT_EQ(run.exit, 0) << run.err;
  std::string text = test::contentOf(trace);
  if (!text.empty()) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

TEST(LongCells, FirstValuesReachTheProgramWhole) {
  // scan, time_ms, scan_ms, x, u, w, r, y, v, z, q, isOdd
  EXPECT_EQ(lastRow("x=9223372036854775807"), "1,10,10,9223372036854775807,0,0,0,9223372036854775807,0,0,0,0");
  EXPECT_EQ(lastRow("x=-9223372036854775808"), "1,10,10,-9223372036854775808,0,0,0,-9223372036854775808,0,0,0,0");
  EXPECT_EQ(lastRow("x=9007199254740993"), "1,10,10,9007199254740993,0,0,0,9007199254740993,0,0,0,1");
  EXPECT_EQ(lastRow("x=16#7FFFFFFFFFFFFFFF"), "1,10,10,9223372036854775807,0,0,0,9223372036854775807,0,0,0,0");
  EXPECT_EQ(lastRow("u=18446744073709551615"), "1,10,10,0,18446744073709551615,0,0,0,18446744073709551615,0,0,0");
  EXPECT_EQ(lastRow("w=16#FFFFFFFFFFFFFFFF"), "1,10,10,0,0,18446744073709551615,0,0,0,18446744073709551615,0,0");
  EXPECT_EQ(lastRow("r=0.1"), "1,10,10,0,0,0,0.1,0,0,0,0.1,0");
  EXPECT_EQ(lastRow("r=9007199254740991.0"), "1,10,10,0,0,0,9007199254740991,0,0,0,9007199254740991,0");
}

TEST(LongCells, WhatDoesNotFitIsRefusedWithTheRange) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("main.st", program);
  const auto errorOf = [&](const std::string& set) {
    return test::run({"sim", file, "--set", set, "--scans", "1", "--isolated"}).err;
  };
  EXPECT_NE(errorOf("u=18446744073709551616").find("the range is 0 to 18446744073709551615"), std::string::npos);
  EXPECT_NE(errorOf("x=-9223372036854775809").find("the range is -9223372036854775808 to 18446744073709551615"),
            std::string::npos);
  EXPECT_NE(errorOf("w=16#10000000000000000").find("is no value for"), std::string::npos);
}

TEST(LongCells, ExpectedValuesAreComparedWhole) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("main.st",
                                       "PROGRAM P\nVAR n : LINT := 9007199254740993; r : LREAL; END_VAR\n"
                                       "r := LREAL#1.0 / LREAL#3.0;\nEND_PROGRAM\n");
  const auto exitWith = [&](const std::string& expected) {
    return test::run({"sim", file, "--expect", folder.file("e.csv", expected), "--isolated"}).exit;
  };
  EXPECT_EQ(exitWith("scan,n\n1,9007199254740993\n"), 0);
  EXPECT_EQ(exitWith("scan,n\n1,9007199254740992\n"), 1);
  EXPECT_EQ(exitWith("scan,n\n1,9007199254740994\n"), 1);
  EXPECT_EQ(exitWith("scan,r\n1,0.3333333333333333\n"), 0);
  EXPECT_EQ(exitWith("scan,r\n1,0.33333334\n"), 1);
}

TEST(LongCells, AWitnessShowsTheValueThatViolates) {
  const std::string text = std::string("//@ prove odd: never x = 9007199254740993\n") + program;
  const IecOutput proof = proofOfIec(text);
  EXPECT_EQ(proof.exit, 1);
  EXPECT_TRUE(proof.has("9007199254740993")) << proof.text;
  EXPECT_FALSE(proof.has("9007199254740992")) << proof.text;
}

TEST(LongCells, EveryFormOfTraceKeepsThem) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("main.st", program);
  for (const std::string ending : {"csv", "vcd"}) {
    const std::string trace = folder.path("t." + ending);
    ASSERT_EQ(test::run({"sim", file, "--set", "x=-9007199254740993", "--set", "u=18446744073709551615", "--set",
                         "r=0.1", "--scans", "3", "--trace", trace, "--isolated"})
                  .exit,
              0);
    const std::vector<std::string> again = {"sim", file,      "--stimulus", trace,       "--expect",
                                            trace, "--scans", "3",          "--isolated"};
    const test::ProgramRun run = test::run(again);
    EXPECT_EQ(run.exit, 0) << ending << "\n" << run.out << run.err;
  }
}

}  // namespace
}  // namespace rungproof
