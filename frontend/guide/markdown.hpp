// The small part of Markdown that the chapters of the guide are written in: headings, paragraphs, lists, tables, code
// blocks, `code`, **bold** and [links](page.html). Tested by tests/guide/markdown_test.cpp.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof {

/// A block of code: what stands behind the three backquotes, and its lines.
struct CodeBlock {
  std::string kind;  ///< "file press.awl", "console", "toml"
  std::string text;
};

/// What stands for a line "{{word}}".
using Insertion = std::function<std::string(std::string_view word)>;

/// XHTML of a chapter; its headings get places made of their names.
std::string htmlOf(std::string_view markdown, const Insertion& inserted = {});
/// The first heading.
std::string titleOf(std::string_view markdown);
/// All blocks of code in their order.
std::vector<CodeBlock> codeBlocksOf(std::string_view markdown);

}  // namespace rungproof
