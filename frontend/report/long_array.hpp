// A JSON document with a long array whose items are written one after the other: all findings as one tree of values
// would take forty kilobytes each. Tested by tests/cli/report_test.cpp.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "frontend/files/json.hpp"
#include "ir/check.hpp"

namespace rungproof {

/// `document`, indented by two, with the items of its one empty array `key`, whose own indentation is `depth`.
template <class ItemAt>
void writeWithItems(std::ostream& out, const Json& document, std::string_view key, std::size_t depth, std::size_t count,
                    const ItemAt& itemAt) {
  const std::string text = document.dump(2);
  // Within a string the marks would be escaped: nothing else reads like this.
  const std::string place = "\n" + std::string(depth, ' ') + '"' + std::string(key) + "\": []";
  const std::size_t at = text.find(place);
  CHECK(at != std::string::npos, "the document has no such empty array");
  const std::string_view behind = std::string_view(text).substr(at + place.size());
  out << std::string_view(text).substr(0, at + place.size() - 1);
  const std::string margin = "\n" + std::string(depth + 2, ' ');
  for (std::size_t i = 0; i < count; ++i) {
    const std::string item = Json(itemAt(i)).dump(2);
    out << (i == 0 ? "" : ",");
    for (std::size_t begin = 0; begin <= item.size();) {
      const std::size_t end = std::min(item.find('\n', begin), item.size());
      out << margin << std::string_view(item).substr(begin, end - begin);
      begin = end + 1;
    }
  }
  if (count > 0) out << "\n" << std::string(depth, ' ');
  out << ']' << behind << '\n';
}

}  // namespace rungproof
