// CSV: reading with places, writing traces.
#include <gtest/gtest.h>

#include <sstream>

#include "frontend/logger/csv_table.hpp"
#include "frontend/trace_format.hpp"
#include "tests/trace/traces.hpp"

namespace rungproof {
namespace {

TEST(CsvTable, QuotesBomAndLineEnds) {
  std::vector<Failure> failures;
  const CsvTable table = readCsv("a.csv", "\xEF\xBB\xBFscan , \"a,b\" ,c\r\n1,\"x\"\"y\", 7\r\n\r\n2,,\r\n", failures);
  EXPECT_TRUE(failures.empty());
  ASSERT_EQ(table.heading.size(), 3U);
  EXPECT_EQ(table.heading[0].text, "scan");
  EXPECT_EQ(table.heading[1].text, "a,b");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][1].text, "x\"y");
  EXPECT_EQ(table.rows[0][2].text, "7");
  EXPECT_EQ(table.rows[0][2].line, 2U);
  EXPECT_EQ(table.rows[0][2].column, 11U);
  EXPECT_EQ(table.rows[1][1].line, 4U);
}

TEST(CsvTable, SemicolonsSeparateWhereTheHeadingHasNoComma) {
  std::vector<Failure> failures;
  const CsvTable table = readCsv("a.csv", "scan;Q0.0\n1;1\n", failures);
  EXPECT_EQ(table.heading.size(), 2U);
  EXPECT_EQ(table.rows[0][1].text, "1");
}

TEST(CsvTable, RaggedRowsOpenQuotesAndEmptyFilesAreFailures) {
  struct Case {
    std::string text;
    std::string place;
  };
  for (const Case& c : {Case{"scan,a\n1,2\n3\n", "a.csv:3:1"}, Case{"scan,a\n1,2,3\n", "a.csv:2:5"},
                        Case{"scan,a\n1,\"2\n", "a.csv:2:3"}, Case{"", "a.csv:1:1"}}) {
    std::vector<Failure> failures;
    readCsv("a.csv", c.text, failures);
    ASSERT_FALSE(failures.empty()) << c.text;
    EXPECT_EQ(failures[0].place, c.place) << c.text;
  }
}

TEST(CsvTrace, ScanTimeAndSignalsInColumns) {
  EXPECT_EQ(written(sampleTrace(), ".csv"),
            "scan,time_ms,scan_ms,I0.0,Q0.0,VW10,VD20,T37.value\n"
            "1,10,10,0,0,-5,1.5,\n"
            "2,20.5,10.5,1,0,-5,1.5,3\n"
            "3,30.5,10,1,1,12,0.1,3\n");
}

TEST(CsvTrace, NamesWithCommasAreQuoted) {
  Trace trace = sampleTrace();
  trace.signals[0].name = "a,\"b\"";
  EXPECT_NE(written(trace, ".csv").find(",\"a,\"\"b\"\"\",Q0.0"), std::string::npos);
}

TEST(TraceFormat, IsChosenByTheEndOfTheName) {
  for (const std::string ending : {".csv", ".vcd", ".json", ".svg", ".html"}) {
    ASSERT_NE(traceFormatOf("out" + ending), nullptr) << ending;
    EXPECT_EQ(traceFormatOf("out" + ending)->ending, ending);
  }
  EXPECT_EQ(traceFormatOf("out.txt"), nullptr);
  EXPECT_EQ(traceFormatOf(".csv"), nullptr);
}

TEST(TraceFormat, MillisecondsWithoutSuperfluousZeros) {
  EXPECT_EQ(millisecondsText(0), "0");
  EXPECT_EQ(millisecondsText(10000), "10");
  EXPECT_EQ(millisecondsText(10500), "10.5");
  EXPECT_EQ(millisecondsText(1), "0.001");
}

}  // namespace
}  // namespace rungproof
