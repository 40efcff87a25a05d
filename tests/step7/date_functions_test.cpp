// Functions of date and time on the engine. DATE_AND_TIME: BCD digits, weekday 1 = Sunday (002:1980-1996); DATE: days
// since 1990-01-01 (002:2605). Dates by the calendar: 2008-05-31 was a Saturday, 2009-04-01 is day 7030 (16#1B76).
#include "tests/step7/run7.hpp"
#include "tests/step7/step7_run.hpp"

namespace rungproof {
namespace {

std::string moments(const std::string& first, const std::string& second) {
  return "DATA_BLOCK DB 5\nSTRUCT\n  a : DATE_AND_TIME := " + first + ";\n  b : DATE_AND_TIME := " + second +
         ";\n  c : DATE_AND_TIME;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
}
constexpr const char* takeOut = "L DB5.DBD 16; T MD 0; L DB5.DBD 20; T MD 4; A BR; = M 92.0;";

std::string sumOf(int number, const std::string& moment, const std::string& time) {
  const Step7Run run(moments(moment, moment),
                     fmt::format("CALL FC {} (T := DB5.a, D := {}, RET_VAL := DB5.c); {}", number, time, takeOut));
  return run.bytes(0, 8);
}

TEST(DateFunctions, AddsTimeOverTheEndsOfDaysMonthsAndYears) {
  EXPECT_EQ(sumOf(1, "DT#2008-5-31-20:59:59.999", "T#1MS"), "08 05 31 21 00 00 00 07");
  EXPECT_EQ(sumOf(1, "DT#1999-12-31-23:59:59.999", "T#1MS"), "00 01 01 00 00 00 00 07");  // a Saturday
  EXPECT_EQ(sumOf(1, "DT#2008-2-28-12:0:0.0", "T#1D"), "08 02 29 12 00 00 00 06");        // a leap year
  EXPECT_EQ(sumOf(1, "DT#2009-2-28-12:0:0.0", "T#1D"), "09 03 01 12 00 00 00 01");
  EXPECT_EQ(sumOf(1, "DT#2000-2-28-12:0:0.0", "T#2D"), "00 03 01 12 00 00 00 04");
  EXPECT_EQ(sumOf(1, "DT#1990-1-2-0:0:0.0", "T#-1MS"), "90 01 01 23 59 59 99 92");  // a Monday
}

TEST(DateFunctions, SubtractsTime) {
  EXPECT_EQ(sumOf(35, "DT#2008-6-1-0:0:0.0", "T#1MS"), "08 05 31 23 59 59 99 97");
  EXPECT_EQ(sumOf(35, "DT#2008-3-1-0:0:0.0", "T#24D_20H_31M_23S_647MS"), "08 02 05 03 28 36 35 33");
}

TEST(DateFunctions, DifferenceInMilliseconds) {
  const auto difference = [](const std::string& x, const std::string& y) {
    const Step7Run run(moments(x, y), "CALL FC 34 (DT1 := DB5.a, DT2 := DB5.b, RET_VAL := MD 0);");
    return static_cast<std::int32_t>(run.at(Area::M, Width::DWord, 0));
  };
  EXPECT_EQ(difference("DT#2008-3-1-0:0:0.0", "DT#2008-2-28-0:0:0.0"), 2 * 86400000);
  EXPECT_EQ(difference("DT#2008-2-28-0:0:0.0", "DT#2008-2-28-0:0:1.5"), -1500);
}

TEST(DateFunctions, PartsOfADateAndTime) {
  const Step7Run run(
      moments("DT#2009-4-1-1:2:3.004", "DT#2008-5-31-20:59:59.999"),
      "CALL FC 6 (IN := DB5.a, RET_VAL := MW 0); CALL FC 8 (IN := DB5.a, RET_VAL := MD 4);\n"
      "CALL FC 7 (IN := DB5.b, RET_VAL := MW 8);\n"
      "CALL FC 3 (IN1 := MW 0, IN2 := MD 4, RET_VAL := DB5.c); L DB5.DBD 16; T MD 10; L DB5.DBD 20; T MD 14;");
  EXPECT_EQ(run.word(0), 7030U);
  EXPECT_EQ(run.at(Area::M, Width::DWord, 4), 3723004U);
  EXPECT_EQ(run.word(8), 7U);
  EXPECT_EQ(run.bytes(10, 8), "09 04 01 01 02 03 00 44");  // a Wednesday
}

TEST(DateFunctions, ComparisonsSeeTheCentury) {
  struct Case {
    const char *x, *y;
    int order;  ///< -1: x is earlier
  };
  for (const Case& c : {Case{"DT#1999-12-31-23:59:59.999", "DT#2000-1-1-0:0:0.0", -1},
                        Case{"DT#2008-5-31-20:59:59.999", "DT#2008-5-31-20:59:59.998", 1},
                        Case{"DT#2008-5-31-20:59:59.999", "DT#2008-5-31-20:59:59.999", 0}}) {
    std::string calls;
    const int numbers[] = {9, 12, 14, 18, 23, 28};
    for (int i = 0; i < 6; ++i)
      calls += fmt::format("CALL FC {} (DT1 := DB5.a, DT2 := DB5.b, RET_VAL := M 0.{});\n", numbers[i], i);
    const Step7Run run(moments(c.x, c.y), calls);
    const bool expected[] = {c.order == 0, c.order >= 0, c.order > 0, c.order <= 0, c.order < 0, c.order != 0};
    for (unsigned i = 0; i < 6; ++i) EXPECT_EQ(run.bit(0, i), expected[i]) << c.x << " FC " << numbers[i];
  }
}

TEST(DateFunctions, S5TimeAndTime) {
  for (const auto& [s5, ms] : {std::pair("S5T#10MS", 10),
                               {"S5T#9S990MS", 9990},
                               {"S5T#12S", 12000},
                               {"S5T#2H46M30S", 9990000},
                               {"S5T#0MS", 0}}) {
    const Step7Run run("",
                       fmt::format("CALL FC 33 (IN := {}, RET_VAL := MD 0); CALL FC 40 (IN := MD 0, RET_VAL := MW 4); "
                                   "L {}; T MW 6;",
                                   s5, s5));
    EXPECT_EQ(run.at(Area::M, Width::DWord, 0), static_cast<std::uint32_t>(ms)) << s5;
    EXPECT_EQ(run.word(4), run.word(6)) << s5;  // the smallest unit, as the constant has it (003:1016-1043)
  }
}

// SFC 0 sets the clock in the first scan; it goes on with the time of the run, which SFC 1 and SFC 64 tell: the second
// scan begins 10 ms later, the tenth 1130 ms after the first.
TEST(DateFunctions, TheClockRuns) {
  const std::string blocks =
      moments("DT#2008-5-31-23:59:59.0", "DT#1990-1-1-0:0:0.0") +
      test7::block(1, std::string("A M 100.0; JC on; CALL SFC 0 (PDT := DB5.a, RET_VAL := MW 80); A BR; = M 92.1; SET; "
                                  "= M 100.0; on: CALL SFC 1 (RET_VAL := MW 82, CDT := DB5.c); ") +
                          takeOut + " CALL SFC 64 (RET_VAL := MD 84)");
  const std::vector<std::string> rows =
      test7::rowsOf(blocks, "MB2,MB3,MB5,MB6,MB7,MD84,M92.0,M92.1", {"--scans", "10"}, "scan,scan_ms\n1,10\n2,140\n");
  ASSERT_EQ(rows.size(), 10U) << rows[0];
  EXPECT_TRUE(rows[0].ends_with(",49,35,89,0,7,0,1,1")) << rows[0];   // 31, 23 h, 59 s, 0 ms, a Saturday
  EXPECT_TRUE(rows[1].ends_with(",49,35,89,1,7,10,1,1")) << rows[1];  // 10 ms
  EXPECT_TRUE(rows[9].ends_with(",1,0,0,19,1,1130,1,1")) << rows[9];  // 1 June, 130 ms, a Sunday
}

// Two programs stand beside one clock: the minute that SFC 1 gives goes to QB4 in both, whatever else is worded anew.
TEST(DateFunctions, BothProgramsOfAComparisonSeeOneClock) {
  const test::TemporaryFolder folder;
  const std::string clock = moments("DT#1990-1-1-0:0:0.0", "DT#1990-1-1-0:0:0.0") +
                            "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL SFC 1 "
                            "(RET_VAL := MW 82, CDT := DB5.c); L DB5.DBB 20; T QB 4;\nNETWORK\n";
  folder.file("old.awl", clock + "A I 0.0; = Q 0.0;\nEND_ORGANIZATION_BLOCK\n");
  folder.file("new.awl", clock + "O I 0.0; = Q 0.0;\nEND_ORGANIZATION_BLOCK\n");
  const test7::Output output = test7::run({"equiv", folder.path("old.awl"), folder.path("new.awl")});
  EXPECT_TRUE(output.has("EQUAL")) << output.text;
  EXPECT_EQ(output.exit, 0) << output.text;
}

}  // namespace
}  // namespace rungproof
