// Dates and times of day: DATE and DT count seconds since 1970-01-01, TOD counts ms since midnight.
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

double resultOfDate(const std::string& type, const std::string& statements) {
  IecRun run(iecProgram("VAR r : " + type + "; d : DATE := D#2024-02-28; t : TOD := TOD#15:36:55.36; " +
                            "u : DT := DT#2024-02-28-15:36:55; l : LDT := LDT#2024-02-28-15:36:55.000000001; END_VAR",
                        statements));
  run.scan();
  return run.get("r");
}

constexpr double day = 86400;
/// 54 years with 13 leap days (1972 ... 2020), then 58 days to 2024-02-28.
constexpr double lastOfFebruary = (54 * 365 + 13 + 58) * day;
constexpr double clock15 = 15 * 3600 + 36 * 60 + 55;

TEST(IecCalendar, LiteralsCount) {
  EXPECT_EQ(resultOfDate("DATE", "r := d;"), lastOfFebruary);
  EXPECT_EQ(resultOfDate("DATE", "r := D#2024-03-01;"), lastOfFebruary + 2 * day);  // 2024 has a 29 February
  EXPECT_EQ(resultOfDate("TOD", "r := t;"), clock15 * 1000 + 360);
  EXPECT_EQ(resultOfDate("DT", "r := u;"), lastOfFebruary + clock15);
  EXPECT_EQ(resultOfDate("DATE", "r := D#1970-01-01;"), 0);
  EXPECT_EQ(resultOfDate("DT", "r := DATE_AND_TIME#1970-01-02-00:00:01;"), day + 1);
}

/// Two literals mean what two variables with these values mean.
TEST(IecCalendar, TwoLiteralsCountEachInItsOwnUnit) {
  EXPECT_EQ(resultOfDate("DT", "r := DT#2024-02-28-15:36:55 + T#2s;"), lastOfFebruary + clock15 + 2);
  EXPECT_EQ(resultOfDate("DT", "r := DT#2024-02-28-15:36:55 - T#1m;"), lastOfFebruary + clock15 - 60);
  EXPECT_EQ(resultOfDate("BOOL", "r := DT#2024-02-28-15:36:55 + T#2s > DT#2024-02-28-15:37:00;"), 0);
  EXPECT_EQ(resultOfDate("TIME", "r := DT#2024-02-28-15:36:55 - DT#2024-02-28-15:36:50;"), 5000);
  EXPECT_EQ(resultOfDate("TIME", "r := D#2024-03-01 - D#2024-02-28;"), 2 * day * 1000);
  EXPECT_EQ(resultOfDate("TIME", "r := TOD#15:36:55 - TOD#15:36:54.5;"), 500);
  EXPECT_EQ(resultOfDate("LTIME", "r := T#1s + LT#1s;"), 2e9);
  EXPECT_EQ(resultOfDate("LTIME", "r := LT#5s - T#1s;"), 4e9);
  EXPECT_EQ(resultOfDate("BOOL", "r := LT#1s + T#1s = LT#2s;"), 1);
  EXPECT_EQ(resultOfDate("TIME", "r := T#1s + T#500ms;"), 1500);
  EXPECT_EQ(resultOfDate("TIME", "r := T#1s * 3;"), 3000);
}

TEST(IecCalendar, SumsAndDifferences) {
  EXPECT_EQ(resultOfDate("TIME", "r := D#2024-03-01 - d;"), 2 * day * 1000);
  EXPECT_EQ(resultOfDate("TIME", "r := SUB_DATE_DATE(d, D#2024-02-27);"), day * 1000);
  EXPECT_EQ(resultOfDate("TOD", "r := t + T#1s;"), clock15 * 1000 + 1360);
  EXPECT_EQ(resultOfDate("TIME", "r := t - TOD#15:36:55;"), 360);
  EXPECT_EQ(resultOfDate("DT", "r := u - T#55s;"), lastOfFebruary + clock15 - 55);
  EXPECT_EQ(resultOfDate("DT", "r := ADD_DT_TIME(u, T#1h);"), lastOfFebruary + clock15 + 3600);
  EXPECT_EQ(resultOfDate("TIME", "r := u - DT#2024-02-28-15:36:50;"), 5000);
  EXPECT_EQ(resultOfDate("DT", "r := CONCAT_DATE_TOD(d, t);"), lastOfFebruary + clock15);
  EXPECT_EQ(resultOfDate("LTIME", "r := l - LDT#2024-02-28-15:36:55;"), 1);
  EXPECT_EQ(resultOfDate("BOOL", "r := d < D#2024-02-29 AND u > DT#2024-02-28-00:00:00;"), 1);
}

// 10 s / 3000000000 is less than a ms, and 2^32 + 2 is not 2: the divisor has more bits than a TIME.
TEST(IecCalendar, DurationsAreDividedByWideNumbers) {
  IecRun run(
      iecProgram("VAR a, b, c, d : TIME; u : UDINT := 3000000000; l : LINT := 4294967298; m : LINT := -2; e : LTIME; "
                 "END_VAR",
                 "a := T#24d / u; b := T#10s / l; c := T#10s / m; d := DIVTIME(T#24d, u); e := LTIME#9s / u;"));
  run.scan();
  EXPECT_EQ(run.get("a"), 0);
  EXPECT_EQ(run.get("b"), 0);
  EXPECT_EQ(run.get("c"), -5000);
  EXPECT_EQ(run.get("d"), 0);
  EXPECT_EQ(run.get("e"), 3);
  const auto said = [](const std::string& statement) {
    return findingsIec(readIecText(iecProgram("VAR t : TIME; l : LTIME; u : ULINT; END_VAR", statement)));
  };
  EXPECT_NE(said("t := t / u;").find("a duration divided by ULINT is not modelled"), std::string::npos);
  EXPECT_NE(said("l := l / u;").find("a duration divided by ULINT is not modelled"), std::string::npos);
}

TEST(IecCalendar, PartsOfADateAndTime) {
  EXPECT_EQ(resultOfDate("DATE", "r := DT_TO_DATE(u);"), lastOfFebruary);
  EXPECT_EQ(resultOfDate("TOD", "r := DATE_AND_TIME_TO_TIME_OF_DAY(u);"), clock15 * 1000);
  EXPECT_EQ(resultOfDate("DT", "r := DATE_TO_DT(d);"), lastOfFebruary);
}

TEST(IecCalendar, WhatIsNoDateIsNamed) {
  const auto said = [](const std::string& statements) {
    return findingsIec(readIecText(iecProgram("VAR d : DATE; t : TOD; i : INT; END_VAR", statements)));
  };
  EXPECT_NE(said("d := D#2023-02-29;").find("D#2023-02-29 is no DATE"), std::string::npos);
  EXPECT_NE(said("d := D#1969-12-31;").find("is no DATE"), std::string::npos);
  EXPECT_NE(said("t := TOD#24:00:00;").find("TOD#24:00:00 is no TOD"), std::string::npos);
  EXPECT_NE(said("d := 5;").find("a DATE is written D#2024-12-31"), std::string::npos);
  EXPECT_NE(said("d := d + d;").find("+ of DATE"), std::string::npos);
  EXPECT_NE(said("i := DATE_TO_INT(d);").find("DATE_TO_INT is not modelled"), std::string::npos);
}

}  // namespace
}  // namespace rungproof
