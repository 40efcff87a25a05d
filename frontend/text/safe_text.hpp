// Text of programs, names and messages made safe for the place where it is shown. Programs come from elsewhere: their
// names and comments may hold control characters that move a terminal's cursor, bidirectional controls that show
// another order than the one that runs, line breaks that begin a command of a build server, and what XML forbids. Each
// kind of output has its function here, and no other place escapes. Tested by tests/cli/safe_text_test.cpp.
#pragma once

#include <string>
#include <string_view>

namespace rungproof {

/// Whether a character must not be shown as it is: controls but line feed and tab, bidirectional controls, separators
/// of lines and paragraphs, and what is no character.
bool isHazard(char32_t c);

/// For terminals and logs: controls as their pictures (ESC as U+241B), other hazards by number ("<U+202E>"), bytes that
/// are no UTF-8 as U+FFFD. Line feeds and tabs stay.
std::string visibleText(std::string_view text);
/// The same on one line: line feeds are pictures too.
std::string lineText(std::string_view text);
/// lineText() of a message, whose middle is left out where it is too long to be read: a name may have megabytes.
std::string messageText(std::string_view text);
/// The same for XML, SVG and HTML: as characters of an element or of an attribute in double quotes.
std::string xmlText(std::string_view text);
/// The data of a workflow command of GitHub Actions, or the value of one of its properties.
std::string workflowText(std::string_view text, bool isProperty);
/// A cell of comma-separated values: on one line, in quotes where it needs them.
std::string csvCell(std::string_view text);
/// A basic string of TOML with its quotes; reading it back gives the text, as far as it is UTF-8.
std::string tomlText(std::string_view text);
/// JSON whose strings may hold hazards: the same value with these as \u escapes.
std::string jsonText(std::string json);

/// visibleText() of a text that comes in pieces, which may end within a character.
class VisiblePieces {
 public:
  enum class Colors : bool { Hidden, Kept };  ///< Kept: the codes that Paint and progress lines write
  explicit VisiblePieces(Colors colors) : colors_(colors) {}
  /// What can be shown by now; valid until the next call.
  std::string_view next(std::string_view piece);
  /// What was held back of the last piece.
  std::string_view rest();

 private:
  Colors colors_;
  std::string held_;  ///< the beginning of a character or of a colour code
  std::string text_;
};

}  // namespace rungproof
