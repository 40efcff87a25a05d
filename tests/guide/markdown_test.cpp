// The part of Markdown that the chapters use.
#include "frontend/guide/markdown.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

TEST(Markdown, ConvertsWhatTheChaptersUse) {
  EXPECT_EQ(htmlOf("one\ntwo `a<b`\n\n**bold** [text](page.html#x)\n"),
            "<p>one two <code>a&lt;b</code></p>\n<p><b>bold</b> <a href=\"page.html#x\">text</a></p>\n");
  EXPECT_EQ(htmlOf("- a\n  goes on\n- b\n"), "<ul>\n<li>a goes on</li>\n<li>b</li>\n</ul>\n");
  EXPECT_EQ(htmlOf("1. a\n2. b\n"), "<ol>\n<li>a</li>\n<li>b</li>\n</ol>\n");
  EXPECT_EQ(htmlOf("```file a.awl\nLD <x>\n```\n"), "<p class=\"quiet\">a.awl</p>\n<pre>LD &lt;x&gt;\n</pre>\n");
  EXPECT_NE(htmlOf("| a | b |\n|---|---|\n| `c` | d |\n").find("<tr><td><code>c</code></td><td>d</td></tr>"),
            std::string::npos);
  EXPECT_NE(htmlOf("## Two words\n").find("<h2 id=\"Two-words\">Two words<a"), std::string::npos);
  EXPECT_EQ(htmlOf("{{word}}\n", [](std::string_view word) { return "[" + std::string(word) + "]"; }), "[word]");
}

TEST(Markdown, UnclosedMarksAreText) {
  EXPECT_EQ(htmlOf("a ` b ** c [d\n"), "<p>a ` b ** c [d</p>\n");
  EXPECT_EQ(htmlOf("```\nto the end"), "<pre>to the end\n</pre>\n");
  EXPECT_EQ(htmlOf(""), "");
}

TEST(Markdown, FindsTitleAndBlocks) {
  constexpr std::string_view text = "# Title\ntext\n```file a.awl\nLD\n```\n```console\n$ x\n```\n";
  EXPECT_EQ(titleOf(text), "Title");
  const std::vector<CodeBlock> blocks = codeBlocksOf(text);
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0].kind, "file a.awl");
  EXPECT_EQ(blocks[0].text, "LD\n");
  EXPECT_EQ(blocks[1].text, "$ x\n");
}

}  // namespace
}  // namespace rungproof
