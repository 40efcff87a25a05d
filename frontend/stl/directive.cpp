// Recognises comments with the property sign.
#include "frontend/stl/directive.hpp"

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

std::optional<std::string_view> directiveText(std::string_view comment) {
  if (comment.substr(0, 3) != "//@") return std::nullopt;
  return trimmed(comment.substr(3));
}

bool speaksToTool(std::string_view comment) {
  if (directiveText(comment)) return true;
  return comment.substr(0, 2) == "//" && equalsIgnoringCase(trimmed(comment.substr(2)).substr(0, 10), "rungproof:");
}

}  // namespace rungproof
