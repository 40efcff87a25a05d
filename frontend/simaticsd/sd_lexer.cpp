// Braces.
#include "frontend/simaticsd/sd_lexer.hpp"

#include <algorithm>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::simaticsd {

namespace {

/// The byte behind the part that ends at a semicolon outside of marks, or at the end.
std::size_t endOfPart(std::string_view text, std::size_t at) {
  bool isQuoted = false;
  for (; at < text.size() && (isQuoted || text[at] != ';'); ++at) isQuoted = isQuoted != (text[at] == '"');
  return at;
}

std::string_view withoutMarks(std::string_view text) {
  const bool isMarked =
      text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return isMarked ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

std::string_view valueOf(const SdAttributes& attributes, std::string_view key) {
  const auto found = std::ranges::find_if(
      attributes, [&](const SdAttribute& attribute) { return equalsIgnoringCase(attribute.key, key); });
  return found == attributes.end() ? std::string_view() : std::string_view(found->value);
}

SdAttributes partsOf(std::string_view text) {
  SdAttributes attributes;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = endOfPart(text, at);
    const std::string_view part = text.substr(at, end - at);
    at = end + 1;
    const std::size_t sign = part.find(":=");
    if (sign == std::string_view::npos) continue;
    attributes.push_back(
        {std::string(trimmed(part.substr(0, sign))), std::string(withoutMarks(trimmed(part.substr(sign + 2))))});
  }
  return attributes;
}

SdAttributes readAttributes(step7::Cursor& cursor) {
  SdAttributes attributes;
  for (cursor.skipSpace(); cursor.peek() == '{'; cursor.skipSpace()) {
    const std::uint32_t begin = cursor.at() + 1;
    bool isQuoted = false;
    for (cursor.skip(1); !cursor.atEnd() && (isQuoted || cursor.peek() != '}'); cursor.skip(1))
      isQuoted = isQuoted != (cursor.peek() == '"');
    const SdAttributes more = partsOf(cursor.slice(begin, cursor.at()));
    attributes.insert(attributes.end(), more.begin(), more.end());
    cursor.take('}');
  }
  return attributes;
}

}  // namespace rungproof::simaticsd
