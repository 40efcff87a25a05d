// What of a program of the S7-300/400 is read but not modelled, so that nothing is proved beside it: one row each. The
// rows are what `rungproof explain coverage` prints, what the report of a program says
// (analysis/unread/unread_code.cpp) and what the list in README is compared with (tests/step7/explain_test.cpp). A
// program for each: tests/step7/gap_test.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace rungproof::s7300 {

enum class Gap : std::uint8_t {
  OrganizationBlock,
  PointerParameter,
  LibraryBlock,
  SystemInstance,
  MissingBlock,
  ProtectedBlock,
  HighDataBlock,
  Drawing
};

struct GapRow {
  Gap gap;
  std::string_view subject;  ///< in the words of README
  std::string_view reason;   ///< what a report says of a place
};

std::span<const GapRow> gapRows();
std::string_view gapReason(Gap gap);

}  // namespace rungproof::s7300
