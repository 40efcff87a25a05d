// Tables of dBase: fields, deleted rows, memos.
#include "frontend/s7project/dbase.hpp"

#include <gtest/gtest.h>

#include "tests/s7project/project_writer.hpp"

namespace rungproof {
namespace {

using s7project::DbaseTable;

TEST(Dbase, LiveRowsWithTheirFields) {
  test::TableWriter writer({{"NAME", 'C', 8}, {"N", 'N', 6}, {"M", 'M', 10}});
  writer.add({{"NAME", "old"}, {"N", "1"}}, true);
  writer.add({{"NAME", " two "}, {"N", "00012"}, {"M", writer.memo("text")}});
  writer.add({{"NAME", "gone"}}, true);
  writer.add({{"NAME", std::string("\0\1", 2)}});
  std::vector<std::string> faults;
  const DbaseTable table(writer.table(), writer.memos(), faults);
  EXPECT_TRUE(faults.empty());
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.record(0), 2U);
  EXPECT_EQ(table.text(0, "name"), "two");
  EXPECT_EQ(table.number(0, "N"), 12);
  EXPECT_EQ(table.memo(0, "M").bytes, "text");
  EXPECT_EQ(table.memo(1, "M").bytes, "");
  EXPECT_EQ(table.memo(1, "M").fault, "");
  EXPECT_EQ(table.text(1, "NAME"), "");
  EXPECT_FALSE(table.number(1, "N"));
  EXPECT_FALSE(table.has("X"));
}

TEST(Dbase, MemoFileMayBeMissing) {
  test::TableWriter writer({{"M", 'M', 10}});
  writer.add({{"M", writer.memo("text")}});
  std::vector<std::string> faults;
  EXPECT_NE(DbaseTable(writer.table(), std::nullopt, faults).memo(0, "M").fault.find("missing"), std::string::npos);
}

}  // namespace
}  // namespace rungproof
