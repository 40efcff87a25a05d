// Every code that a finding can carry.
#include "frontend/settings/code_list.hpp"

#include <algorithm>

#include "analysis/rule.hpp"
#include "frontend/property/property_message.hpp"
#include "frontend/stl/syntax_message.hpp"

namespace rungproof {

std::vector<Code> allCodes() {
  std::vector<Code> codes;
  for (const Rule* rule : allRules())
    codes.push_back({rule->id, rule->title, rule->severity, {}, true, rule->enabledByDefault});
  const auto firstMessage = static_cast<std::ptrdiff_t>(codes.size());
  for (const PropertyMessage& message : propertyMessages)
    codes.push_back({message.id, message.title, Severity::Error, message.help});
  for (const SyntaxMessage& message : syntaxMessages)
    codes.push_back({message.id, message.title, message.severity, message.help});
  std::sort(codes.begin() + firstMessage, codes.end(), [](const Code& a, const Code& b) { return a.id < b.id; });
  return codes;
}

std::optional<Code> codeNamed(std::string_view id) {
  static const std::vector<Code> codes = allCodes();
  const auto found = std::find_if(codes.begin(), codes.end(), [&](const Code& code) { return code.id == id; });
  return found == codes.end() ? std::nullopt : std::optional<Code>(*found);
}

std::string asCode(std::string_view text) {
  std::string code(text);
  std::ranges::transform(code, code.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return code;
}

}  // namespace rungproof
