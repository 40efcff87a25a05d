// Excerpts of source text with a marked range, as compilers print them: correct with tabs, wide characters (CJK takes
// two columns of a terminal), combining marks and very long lines, of which a window around the range is shown.
// Tested by tests/cli/excerpt_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "ir/source.hpp"

namespace rungproof {

/// Colours of a terminal, or nothing.
struct Paint {
  bool on = false;
  std::string red(std::string_view text) const { return with("1;31", text); }
  std::string yellow(std::string_view text) const { return with("1;33", text); }
  std::string green(std::string_view text) const { return with("1;32", text); }
  std::string blue(std::string_view text) const { return with("1;34", text); }
  std::string cyan(std::string_view text) const { return with("1;36", text); }
  std::string bold(std::string_view text) const { return with("1", text); }

 private:
  std::string with(std::string_view code, std::string_view text) const;
};

/// Columns that a terminal needs for UTF-8 text; tabs count as four, control characters as one.
int displayWidth(std::string_view text);

/// The line of a span and the columns below it that belong to the span.
struct Excerpt {
  std::uint32_t lineNumber = 1;
  std::string line;   ///< as shown: tabs replaced, control characters made visible, cut to the window
  int markBegin = 0;  ///< columns from 0, in `line`
  int markWidth = 1;  ///< at least 1
};
/// Longest line that is shown whole, in columns.
inline constexpr int excerptWidth = 100;
Excerpt excerptOf(const SourceFile& file, Span span);
/// The same for who knows the line already.
Excerpt excerptOf(const SourceFile& file, Span span, std::uint32_t lineNumber);

/// "   |\n12 | MOVW 1, VW2047\n   |         ^^^^^^\n"; the mark is repeated `mark`, already painted by `paintMark`.
std::string drawExcerpt(const Excerpt& excerpt, int gutter, char mark, const Paint& paint,
                        std::string (Paint::*paintMark)(std::string_view) const);

/// "press.awl:12:5" for a place.
std::string placeText(const SourceSet& sources, Span span);

}  // namespace rungproof
