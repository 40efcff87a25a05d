// Files of loggers and oscilloscopes: separators, decimal commas, forms of numbers, units, dates, renamed columns, and
// the place of every mistake. All files are written down here by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "frontend/logger/moment.hpp"
#include "frontend/logger/recording.hpp"
#include "frontend/simulation/stimulus_reader.hpp"

namespace rungproof {
namespace {

struct Recorded {
  Trace trace;
  std::vector<std::string> failures;  ///< "place: message; help"
};

Recorded recorded(const std::string& bytes, const TraceImport& import = {}) {
  Recorded result;
  std::vector<Failure> failures;
  result.trace = readTrace("log.csv", bytes, failures, import);
  for (const Failure& f : failures) result.failures.push_back(f.place + ": " + f.message + "; " + f.help);
  return result;
}

/// "0: 1 0 | 12.5: x 1": times in ms and values.
std::string shown(const Recorded& read) {
  if (!read.failures.empty()) return read.failures.front();
  std::string text;
  for (const TraceRow& row : read.trace.rows) {
    text += fmt::format("{}{:g}:", text.empty() ? "" : " | ", static_cast<double>(row.timeUs) / 1000);
    for (const std::optional<TraceNumber>& value : row.values) text += value ? fmt::format(" {:g}", *value) : " x";
  }
  return text;
}

TraceImport importing(const std::string& column, const std::string& unit = {}) {
  TraceImport import;
  import.timeColumn = column;
  import.timeUnit = unit;
  return import;
}

TEST(LoggerFile, SeparatorsAreRecognised) {
  for (const char sign : {',', ';', '\t', '|'}) {
    std::string text = "Time [s]?I0.0?Q0.0\n0?1?0\n0.25?0?1\n";
    for (char& c : text) c = c == '?' ? sign : c;
    EXPECT_EQ(shown(recorded(text)), "0: 1 0 | 250: 0 1") << sign;
  }
  EXPECT_EQ(shown(recorded("sep=;\nTime [s];I0.0\n1;1\n")), "1000: 1");
  TraceImport bar;
  bar.separator = '|';
  EXPECT_EQ(shown(recorded("Time (ms)|VD0, raw\n5|2\n", bar)), "5: 2");
}

TEST(LoggerFile, DecimalCommas) {
  EXPECT_EQ(shown(recorded("Zeit/s;VD0\n0,5;1,25\n1,0;-3,5e2\n1.234,5;1.000.000,5\n")),
            "500: 1.25 | 1000: -350 | 1.2345e+06: 1e+06");
  EXPECT_EQ(shown(recorded("time_s,VD0\n\"0,5\",\"1,25\"\n")), "500: 1.25");
  // Three digits behind a comma, between commas: a fraction or thousands.
  EXPECT_EQ(
      shown(recorded("time_s,W\n1,\"1,234\"\n")),
      "log.csv:2:3: '1,234' is no value for W; write a number of its type; leave the cell empty or write x where it "
      "does not matter");
  EXPECT_EQ(
      shown(recorded("time_s,W\n0,5,7\n")),
      "log.csv:2:5: this row has 3 cells, the heading has 2; give every row one cell for each column; numbers with a "
      "decimal comma need quotes or another separator");
}

TEST(LoggerFile, FormsOfNumbersAndWords) {
  EXPECT_EQ(shown(recorded("Time [ms],A,B,C,D\n1,16#FF,0xfF,$FF,0b101\n2,on,OFF,True,false\n3,high,low,ein,AUS\n"
                           "4,wahr,falsch,ja,nein\n5,-,n/a,NaN,x\n")),
            "1: 255 255 255 5 | 2: 1 0 1 0 | 3: 1 0 1 0 | 4: 1 0 1 0 | 5: x x x x");
}

TEST(LoggerFile, UnitsOfTime) {
  struct Case {
    const char* unit;
    const char* result;
  };
  for (const Case& c : {Case{"us", "1.5: 1"}, Case{"ms", "1500: 1"}, Case{"s", "1.5e+06: 1"}, Case{"min", "9e+07: 1"},
                        Case{"ns", "0.002: 1"}})
    EXPECT_EQ(shown(recorded("T,I0.0\n1500,1\n", importing("T", c.unit))), c.result)
        << c.unit;  // ns: to the nearest us
  EXPECT_EQ(shown(recorded("Zeit in ms,I0.0\n7,1\n")), "7: 1");
  EXPECT_EQ(shown(recorded("Time,CH1\n(ms),(V)\n7,1\n")), "7: 1");
  EXPECT_EQ(shown(recorded("Time,I0.0\n7,1\n")),
            "log.csv:1:1: the column 'Time' does not say its unit; give --time-unit, such as --time-unit s");
}

TEST(LoggerFile, TimeColumnByNameByNumberAndBehindAnIntroduction) {
  const std::string text = "Device: PLC 7\n# made by a logger\n\nI0.0;Moment;Q0.0\n1;0,1;0\n1;0,2;1\n";
  EXPECT_EQ(shown(recorded(text, importing("moment", "s"))), "100: 1 0 | 200: 1 1");
  EXPECT_EQ(shown(recorded("I0.0,t,Q0.0\n1,3,0\n", importing("2", "ms"))), "3: 1 0");
  EXPECT_EQ(shown(recorded("I0.0,t,Q0.0\n1,3,0\n", importing("momen", "ms"))),
            "log.csv:1:1: no column is called 'momen'; give --time-column one of the 3 headings, or its number");
  EXPECT_EQ(
      shown(recorded("Sample,I0.0\n1,0\n")),
      "log.csv:1:1: the first column is 'Sample'; name it 'scan' or 'time_ms', or say with --time-column which one "
      "holds the time");
}

TEST(LoggerFile, DatesCountFromTheFirstRow) {
  EXPECT_EQ(shown(recorded("Time,I0.0\n2026-02-28T23:59:59.5Z,1\n2026-03-01T00:00:00.750Z,0\n")), "0: 1 | 1250: 0");
  EXPECT_EQ(shown(recorded("Zeit;I0.0\n28.02.2026 23:59:59,500;1\n01.03.2026 00:00:00,750;0\n")), "0: 1 | 1250: 0");
  EXPECT_EQ(shown(recorded("Time,I0.0\n2/28/2026 11:59:59.5 PM,1\n3/1/2026 12:00:00.75 AM,0\n")), "0: 1 | 1250: 0");
  EXPECT_EQ(shown(recorded("Datum;Uhrzeit;I0.0\n28.02.26;23:59:59;1\n01.03.26;00:00:01;0\n")), "0: 1 | 2000: 0");
  EXPECT_EQ(shown(recorded("Uhrzeit;I0.0\n23:59:59;1\n00:00:01,250;0\n")), "0: 1 | 2250: 0");  // past midnight
  EXPECT_EQ(shown(recorded("time_s,I0.0\n-0.5,1\n0.25,0\n")), "0: 1 | 750: 0");  // in front of the trigger
  EXPECT_EQ(shown(recorded("time_s,I0.0\n1767225600.5,1\n1767225601,0\n")), "0: 1 | 500: 0");
  EXPECT_EQ(shown(recorded("Time,I0.0\n2026-02-30 10:00:00,1\n")),
            "log.csv:2:1: '2026-02-30 10:00:00' is no time; write a number, or a date and time such as 2026-03-01 "
            "08:15:30.250 or 01.03.2026 08:15:30,250");
}

TEST(Moment, OffsetsAndOrders) {
  const auto us = [](std::string_view text, bool dayFirst = false) {
    return momentIn(text, dayFirst).value_or(Moment{-1}).us;
  };
  EXPECT_EQ(us("1970-01-02T01:00:00+01:00"), 86400LL * 1'000'000);
  EXPECT_EQ(us("1/2/1970 0:00:00"), 86400LL * 1'000'000);             // January the second
  EXPECT_EQ(us("1/2/1970 0:00:00", true), 31 * 86400LL * 1'000'000);  // February the first
  EXPECT_EQ(us("31/1/1970 00:00"), 30 * 86400LL * 1'000'000);
  EXPECT_EQ(us("12:00:00 AM"), 0);
  EXPECT_EQ(us("00:00:01,0000019"), 1'000'001);
  for (const char* text : {"", "24:00:00", "1:2", "10:00:60", "13:00 PM", "2026-13-01", "1.1.202", "x", "10:00:00 x"})
    EXPECT_FALSE(momentIn(text)) << text;
}

TEST(LoggerFile, RenamedAndLeftOutColumns) {
  TraceImport import;
  import.renames = {{"Motor links", "Q0.0"}, {"Kommentar", "-"}, { "Nichts", "Q1.0" }};
  const Recorded result = recorded("Time [s];Motor links;Kommentar\n1;on;gut\n", import);
  EXPECT_EQ(shown(result), "1000: 1");
  ASSERT_EQ(result.trace.signals.size(), 1U);
  EXPECT_EQ(result.trace.signals[0].name, "Q0.0");
  std::vector<Failure> failures;
  checkRenames(import, "log.csv", failures);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].message, "--rename names 'Nichts', which is no column");
}

TEST(LoggerFile, Encodings) {
  const Recorded cp1252 = recorded("Zeit [s];K\xFChler\n1;1\n");
  ASSERT_EQ(cp1252.failures, std::vector<std::string>());
  EXPECT_EQ(cp1252.trace.signals[0].name, "Kühler");
  EXPECT_EQ(recorded("\xEF\xBB\xBFZeit [s];Kühler\n1;1\n").trace.signals.at(0).name, "Kühler");
  std::string utf16 = "\xFF\xFE";
  for (const char c : std::string("Zeit [\xB5s];I0.0\n1500;1\n")) utf16 += {c, '\0'};
  EXPECT_EQ(shown(recorded(utf16)), "1.5: 1");
}

TEST(LoggerFile, EveryMalformedCellHasItsPlace) {
  const Recorded result = recorded("Time [s];\"I0.0\";VD0\n1;\"1\";5\nlate;1;5\n3;maybe;5\n");
  ASSERT_EQ(result.failures.size(), 1U);  // without times nothing else is looked at
  EXPECT_EQ(result.failures[0], "log.csv:3:1: 'late' is no time; write a number, as in the rows above");
  const Recorded cells = recorded("Time [s];\"I0.0\";VD0\n1;2;5\n3;maybe;5,x\n");
  EXPECT_EQ(
      cells.failures,
      (std::vector<std::string>{
          "log.csv:2:3: I0.0 is a bit: 0 or 1, not 2; write 0 or 1; leave the cell empty or write x where it does "
          "not matter",
          "log.csv:3:3: 'maybe' is no value for I0.0; write 0 or 1; leave the cell empty or write x where it does "
          "not matter",
          "log.csv:3:9: '5,x' is no value for VD0; write a number of its type; leave the cell empty or write x "
          "where it does not matter"}));
  EXPECT_EQ(shown(recorded("Time [s],I0.0\n2,1\n1,0\n")),
            "log.csv:3:1: time 1000 comes after 2000 ms; rows must stand in ascending order");
}

TEST(LoggerFile, ColumnsOfOneAddressUnderOtherNames) {
  std::vector<Failure> failures;
  const std::vector<Symbol> symbols = [] {
    std::vector<Symbol> list(1);
    list[0].name = "Pumpe";
    list[0].address = direct(Area::Q, Width::Bit, 0, 1);
    return list;
  }();
  const Trace german = readTrace("a.csv", "scan,A0.0,Pumpe,Q0.2 Lampe\n1,1,1,0\n", failures, {}, symbols);
  const Trace plain = readTrace("b.csv", "scan,Q0.2,q0.1,Q0.0\n1,0,1,1\n", failures, {}, {});
  EXPECT_TRUE(failures.empty());
  for (const TraceSignal& signal : german.signals) EXPECT_GE(plain.indexOf(signal), 0) << signal.name;
  const Trace other = readTrace("c.csv", "scan,Lampe\n1,0\n", failures, {}, {});
  EXPECT_EQ(german.indexOf(other.signals[0]), 2);
}

}  // namespace
}  // namespace rungproof
