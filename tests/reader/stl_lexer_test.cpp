// Words, comments, quotes and banners of a line.
#include "frontend/stl/stl_lexer.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rungproof {
namespace {

/// Words in brackets, "," before those behind a comma, then the comment.
std::string cut(std::string_view text) {
  StlLexer lexer(text);
  Line line;
  std::string result;
  while (lexer.next(line)) {
    if (!result.empty()) result += '\n';
    for (const Word& word : line.words) result += (word.afterComma ? ",[" : "[") + std::string(lexer.slice(word)) + "]";
    if (line.hasComment())
      result += std::string(line.isBanner ? "#" : "") + "{" +
                std::string(lexer.slice(line.commentBegin, line.commentEnd)) + "}";
    if (line.openQuote) result += "!";
    if (line.endsWithComma) result += "+";
  }
  return result;
}

TEST(StlLexerTest, Words) {
  EXPECT_EQ(cut("LD     I0.0"), "[LD][I0.0]");
  EXPECT_EQ(cut("S Q0.0,1\r\n"), "[S][Q0.0],[1]");
  EXPECT_EQ(cut("S\tQ0.0 ,\t1"), "[S][Q0.0],[1]");
  EXPECT_EQ(cut("a\xC2\xA0"
                "b\xE3\x80\x80"
                "c\xEF\xBC\x8C"
                "d"),
            "[a][b][c],[d]");
  EXPECT_EQ(cut("CALL 1, 2,"), "[CALL][1],[2]+");
  EXPECT_EQ(cut(""), "");
  EXPECT_EQ(cut("a\n\nb"), "[a]\n\n[b]");
}

TEST(StlLexerTest, Comments) {
  EXPECT_EQ(cut("// x"), "{// x}");
  EXPECT_EQ(cut("LD I0.0 // c\r\n= Q0.0//d"), "[LD][I0.0]{// c}\n[=][Q0.0]{//d}");
  EXPECT_EQ(cut("/I 5, AC0"), "[/I][5],[AC0]");
}

TEST(StlLexerTest, Quotes) {
  EXPECT_EQ(cut("X \"a, b // c\", 'd e'"), "[X][\"a, b // c\"],['d e']");
  EXPECT_EQ(cut("X \"a$\"b\" y"), "[X][\"a$\"b\"][y]");
  EXPECT_EQ(cut("X 'a b // c"), "[X]['a][b]{// c}!");
  EXPECT_EQ(cut("X \xE2\x80\x9C"
                "a b\xE2\x80\x9D y"),
            "[X][\xE2\x80\x9C"
            "a b\xE2\x80\x9D][y]");
  EXPECT_EQ(cut("X \xC2\xAB"
                "a b\xC2\xBB"),
            "[X][\xC2\xAB"
            "a b\xC2\xBB]");
}

TEST(StlLexerTest, Semicolons) {
  EXPECT_EQ(cut("LD I0.0; = Q0.0; // c"), "[LD][I0.0]\n[=][Q0.0]{// c}");
  EXPECT_EQ(cut("LD I0.0;\n= Q0.0"), "[LD][I0.0]\n[=][Q0.0]");
}

TEST(StlLexerTest, Banners) {
  EXPECT_EQ(cut("* * * main * * *"), "#{* * * main * * *}");
  EXPECT_EQ(cut("*****\r\n"), "#{*****}");
  EXPECT_EQ(cut("/* main"), "#{/* main}");
  EXPECT_EQ(cut("-----------"), "#{-----------}");
  EXPECT_EQ(cut("*I 5, AC0"), "[*I][5],[AC0]");
  EXPECT_EQ(cut("-1 500, VW0"), "[-1][500],[VW0]");
  EXPECT_EQ(cut("= Q0.0"), "[=][Q0.0]");
  EXPECT_EQ(cut("*"), "[*]");
}

TEST(StlLexerTest, Trimmed) {
  EXPECT_EQ(trimmed(" \t a b \r"), "a b");
  EXPECT_EQ(trimmed("\xE3\x80\x80x\xC2\xA0"), "x");
  EXPECT_EQ(trimmed("  "), "");
}

}  // namespace
}  // namespace rungproof
