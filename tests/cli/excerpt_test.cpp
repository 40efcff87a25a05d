// Excerpts: the mark stands below the characters of the span, whatever they are.
#include "frontend/text/excerpt.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

Excerpt excerptIn(const std::string& text, const std::string& marked) {
  const SourceFile file("a.awl", text);
  return excerptOf(file, {0, static_cast<std::uint32_t>(text.find(marked)), static_cast<std::uint32_t>(marked.size())});
}

TEST(DisplayWidth, CountsColumnsOfATerminal) {
  EXPECT_EQ(displayWidth("LD I0.0"), 7);
  EXPECT_EQ(displayWidth("水泵"), 4);       // two wide characters
  EXPECT_EQ(displayWidth("насос"), 5);      // Cyrillic is narrow
  EXPECT_EQ(displayWidth("e\xCC\x81"), 1);  // e and a combining accent
  EXPECT_EQ(displayWidth("\t"), 4);
  EXPECT_EQ(displayWidth("\xFF"), 1);  // not UTF-8: one replacement character
}

TEST(ExcerptOf, MarksTheSpan) {
  const Excerpt excerpt = excerptIn("LD I0.0\n=  Q0.9 // out\n", "Q0.9");
  EXPECT_EQ(excerpt.lineNumber, 2u);
  EXPECT_EQ(excerpt.line, "=  Q0.9 // out");
  EXPECT_EQ(excerpt.markBegin, 3);
  EXPECT_EQ(excerpt.markWidth, 4);
}

TEST(ExcerptOf, ReplacesTabs) {
  const Excerpt excerpt = excerptIn("LD\tI0.9", "I0.9");
  EXPECT_EQ(excerpt.line, "LD    I0.9");
  EXPECT_EQ(excerpt.markBegin, 6);  // two letters and one tab of four
}

TEST(ExcerptOf, CountsWideCharactersTwice) {
  const Excerpt excerpt = excerptIn("LD 水泵 //", "水泵");
  EXPECT_EQ(excerpt.markBegin, 3);
  EXPECT_EQ(excerpt.markWidth, 4);
}

TEST(ExcerptOf, ShowsControlCharacters) {
  const Excerpt excerpt = excerptIn("LD\x01I0.0", "I0.0");
  EXPECT_EQ(excerpt.line, "LD\xE2\x90\x81I0.0");  // U+2401, the picture of 01
  EXPECT_EQ(excerpt.markBegin, 3);
}

TEST(ExcerptOf, CutsAWindowOutOfLongLines) {
  const Excerpt excerpt = excerptIn(std::string(5000, 'a') + "Q0.9" + std::string(5000, 'b'), "Q0.9");
  EXPECT_EQ(excerpt.line.substr(0, 3), "...");
  EXPECT_EQ(excerpt.line.substr(excerpt.line.size() - 3), "...");
  EXPECT_LE(displayWidth(excerpt.line), excerptWidth + excerptWidth / 3 + 6);
  EXPECT_EQ(excerpt.line.substr(static_cast<std::size_t>(excerpt.markBegin), 4), "Q0.9");
}

TEST(ExcerptOf, CutsAMarkThatIsLongerThanTheWindow) {
  const Excerpt excerpt = excerptIn(std::string(5000, 'x'), std::string(5000, 'x'));
  EXPECT_EQ(excerpt.markBegin, 0);
  EXPECT_EQ(excerpt.markWidth, excerptWidth);
}

TEST(ExcerptOf, EndsTheMarkAtTheEndOfTheLine) {
  const Excerpt excerpt = excerptIn("LD I0.0\nA I0.1\n", "I0.0\nA I0.1");
  EXPECT_EQ(excerpt.markWidth, 4);
}

TEST(ExcerptOf, StandsAPlaceBehindTheLastCharacter) {
  const std::string text = "LD I0.0";
  const SourceFile file("a.awl", text);
  const Excerpt excerpt = excerptOf(file, {0, 7, 0});
  EXPECT_EQ(excerpt.markBegin, 7);
  EXPECT_EQ(excerpt.markWidth, 1);
}

}  // namespace
}  // namespace rungproof
