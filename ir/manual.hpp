// Where a reference such as "001:6551" stands: which of the source documents, which chapter, which section. The code
// keeps the bare reference (document, line of its text) beside each fact; what people read is made here.
// README names the documents. Tested by tests/ir/manual_test.cpp.
#pragma once

#include <string>
#include <string_view>

namespace rungproof {

/// "System Manual 2004, chapter 6, SIMATIC timers (001:6551)" for "001:6551"; of a range or a list the place of its
/// first line. A text that begins with no reference stays as it is.
std::string manualPlace(std::string_view reference);

/// "001:1719-1750" in a text as "System Manual 2004, chapter 4, PLC concepts": title and chapter, which a reader can
/// open.
std::string withManualTitles(std::string_view text);

}  // namespace rungproof
