// Which family a text belongs to and in which set of mnemonics it is written, by counting words that only one of them
// has: `CALL FC`, `SPB`, `OPN` against `LD`, `MOVW`, `SM0.1`. Words that mean something in both count for neither.
// Tested by tests/step7/likeness_test.cpp.
#pragma once

#include <string_view>

namespace rungproof::step7 {

struct Step7Likeness {
  bool hasHeading = false;    ///< a heading that only sources of the S7-300/400 have
  bool otherHeading = false;  ///< a heading that only exports of the S7-200 have
  int step7 = 0;              ///< words of the S7-300/400 alone
  int s7200 = 0;              ///< words of the S7-200 alone
  int german = 0;             ///< words of one set of mnemonics alone
  int international = 0;
  int scans = 0;        ///< A, O, X and their kind: both families have them, the S7-200 only behind a load
  int statements = 0;   ///< lines that were looked at
  int structured = 0;   ///< IF, CASE and other words of SCL
  int assignments = 0;  ///< lines with := at their beginning, as SCL has them

  /// Whether the text is of an S7-300/400 rather than of an S7-200.
  bool isStep7() const;
  /// Whether the text is SCL rather than a statement list.
  bool isStructuredText() const { return structured > 0 || (assignments > 0 && step7 == 0 && scans == 0); }
  /// Whether as much speaks for one family as for the other.
  bool isTied() const { return !hasHeading && !otherHeading && step7 > 0 && step7 == s7200; }
};

/// Looks at the first 20,000 lines, or no further than it takes to know an S7-200.
Step7Likeness step7Likeness(std::string_view text);

}  // namespace rungproof::step7
