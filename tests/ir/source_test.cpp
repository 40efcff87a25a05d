// Lines of source texts, of which the table has every fourth only: against a plain walk over the text.
#include "ir/source.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

void expectEveryPlace(const std::string& text) {
  const SourceFile file("x", text);
  std::uint32_t line = 1, column = 1, start = 0;
  for (std::uint32_t i = 0; i <= text.size(); ++i) {
    ASSERT_EQ(file.position(i).line, line) << i;
    ASSERT_EQ(file.position(i).column, column) << i;
    ASSERT_EQ(file.lineStart(line), start) << i;
    if (i < text.size() && text[i] == '\n') {
      ASSERT_EQ(file.line(line), text.substr(start, i - start));
      ++line;
      column = 1;
      start = i + 1;
    } else {
      ++column;
    }
  }
  EXPECT_EQ(file.line(line), text.substr(start));
  EXPECT_EQ(file.lineCount(), line);
  EXPECT_TRUE(file.line(line + 1).empty() && file.line(0).empty());
  EXPECT_EQ(file.position(static_cast<std::uint32_t>(text.size()) + 9).line, line);
}

TEST(Span, BeginsInAnother) {
  const Span outer{1, 10, 5};
  EXPECT_TRUE((Span{1, 10, 0}.beginsIn(outer)));
  EXPECT_TRUE((Span{1, 14, 9}.beginsIn(outer)));
  EXPECT_FALSE((Span{1, 9, 9}.beginsIn(outer)));
  EXPECT_FALSE((Span{1, 15, 0}.beginsIn(outer)));
  EXPECT_FALSE((Span{0, 12, 1}.beginsIn(outer)));
}

TEST(SourceFile, FindsLinesBetweenItsMarks) {
  std::string text;
  for (int lines = 0; lines < 40; ++lines) {
    expectEveryPlace(text);
    expectEveryPlace(text + "no end");
    text += std::string(static_cast<std::size_t>(lines % 5), 'a') + "\n";
  }
}

TEST(SourceFile, FindsPlacesInLongLines) {
  // Around the distance of two marks, between short lines and at the end of the text.
  for (const std::size_t length : {1022, 1023, 1024, 1025, 1026, 2047, 2048, 2049, 5000}) {
    const std::string longLine(length, 'a');
    expectEveryPlace(longLine);
    expectEveryPlace(longLine + "\n");
    expectEveryPlace("a\nb\n" + longLine + "\nc\n\nd\ne\nf\n" + longLine + longLine + "\n" + longLine);
  }
  // Two bytes a character: the 3000th begins at byte 5998.
  std::string wide = "\n";
  for (int i = 0; i < 4000; ++i) wide += "\xC3\xA4";
  const SourceFile file("x", wide);
  EXPECT_EQ(file.position(1 + 5998).line, 2U);
  EXPECT_EQ(file.position(1 + 5998).column, 3000U);
}

TEST(SourceFile, CountsCharactersAndLeavesOutLineEnds) {
  const SourceFile file("x", "LD I0.0\r\n\xC3\xA4\xC3\xB6 x\r\n");
  EXPECT_EQ(file.line(1), "LD I0.0");
  EXPECT_EQ(file.line(2), "\xC3\xA4\xC3\xB6 x");
  EXPECT_EQ(file.position(14).column, 4U);
}

}  // namespace
}  // namespace rungproof
