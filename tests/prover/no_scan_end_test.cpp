// Properties are looked at when a scan ends. Of a program that ends no scan every property would hold, also two that
// contradict each other: nothing is proved by that.
#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

struct Row {
  std::string name, file, text, one, other;
};

class NoScanEnd : public ::testing::TestWithParam<Row> {};

TEST_P(NoScanEnd, ProvesNothing) {
  const Row& row = GetParam();
  const test::TemporaryFolder folder;
  const std::string program = folder.file(row.file, row.text);
  const std::string properties = folder.file(
      "p.prop", "prove one: " + row.one + "\nprove other: " + row.other + "\nreach third: " + row.one + "\n");
  const test::ProgramRun run = test::run({"prove", program, "--props", properties, "--isolated"});
  EXPECT_NE(run.exit, 0);
  EXPECT_TRUE(run.says("VACUOUS  one")) << run.out << run.err;
  EXPECT_TRUE(run.says("VACUOUS  other")) << run.out;
  EXPECT_TRUE(run.says("UNREACHABLE  third")) << run.out;
  EXPECT_TRUE(run.says("no run comes to the end of a scan")) << run.out;
}

INSTANTIATE_TEST_SUITE_P(
    Programs, NoScanEnd,
    ::testing::Values(
        // The watchdog ends what jumps back for ever (001:13920).
        Row{"s7200_jump", "a.awl",
            test::mainBlock("NETWORK 1\nLBL 1\nLD SM0.0\nJMP 1\nNETWORK 2\nLD SM0.0\nMOVW 1, VW10\n"), "VW10 = 1",
            "VW10 = 7"},
        // DB 1 has 2 bytes: OB121 is missing, STOP (002:1278).
        Row{"s7300_outside", "b.awl",
            "DATA_BLOCK DB 1\nSTRUCT\n w : WORD ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n"
            "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n t : ARRAY [0..19] OF BYTE ;\nEND_VAR\nBEGIN\nNETWORK\n"
            "L DB1.DBW 10;\nL 1;\nT MW 0;\nEND_ORGANIZATION_BLOCK\n",
            "MW0 = 1", "MW0 = 7"},
        Row{"iec_loop", "c.st",
            "PROGRAM P\nVAR x : INT; END_VAR\nx := 1;\nWHILE TRUE DO x := 2; END_WHILE;\nEND_PROGRAM\n", "x = 1",
            "x = 7"}),
    [](const auto& info) { return info.param.name; });

TEST(ScanEnd, AProgramThatOnlyMayStopIsAskedAsEver) {
  const test::TemporaryFolder folder;
  const std::string program =
      folder.file("a.awl", test::mainBlock("NETWORK 1\nLDN I0.0\nSTOP\nNETWORK 2\nLD SM0.0\nMOVW 1, VW10\n"));
  const std::string properties = folder.file("p.prop", "prove one: VW10 = 1\nprove other: VW10 = 7\n");
  const test::ProgramRun run = test::run({"prove", program, "--props", properties, "--isolated"});
  EXPECT_FALSE(run.says("VACUOUS")) << run.out;
  EXPECT_TRUE(run.says("VIOLATED  other")) << run.out;
}

}  // namespace
}  // namespace rungproof
