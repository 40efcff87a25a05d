// Text of a page: names for places that stay the same as long as a property or a network keeps its own name, so that a
// link that somebody has copied still leads there; and symbol names beside addresses. Tested by
// tests/page/page_text_test.cpp.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/acceptance_record.hpp"
#include "ir/manual.hpp"

namespace rungproof {

/// "star and delta" as "star-and-delta": letters, digits and what is not ASCII, joined by hyphens.
std::string placeName(std::string_view text);

/// Places that have been given so far; the second of a name gets "-2" behind it.
class PlaceNames {
 public:
  std::string of(std::string_view text);

 private:
  std::set<std::string> given_;
  std::map<std::string, int> last_;  ///< number behind a name
};

/// Writes texts with the symbol behind each address and the address behind each symbol.
class AddressNames {
 public:
  AddressNames() = default;
  explicit AddressNames(const std::vector<NamedAddress>& names);

  /// As XML text; what was added stands in <span class="also">. In sentences only words with digits are addresses.
  std::string marked(std::string_view text, bool isExpression = false) const;
  /// The same for "prove NAME: EXPR": the name stays as it is.
  std::string markedStatement(std::string_view text) const;
  /// The other name of an address or symbol, or empty.
  std::string otherName(std::string_view word) const;

 private:
  std::map<std::string, std::string, std::less<>> symbolOf_;   ///< by address
  std::map<std::string, std::string, std::less<>> addressOf_;  ///< by symbol, in capitals
};

/// A link that holds the text itself: it works wherever the page has been copied to.
std::string dataLink(std::string_view mediaType, std::string_view text);

/// When the page was made, "2026-11-23 17:30 UTC"; SOURCE_DATE_EPOCH sets it.
std::string pageDate();

}  // namespace rungproof
