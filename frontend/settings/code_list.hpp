// Every code that a finding can carry: the rules, and the messages of the readers of programs and properties.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/finding.hpp"

namespace rungproof {

struct Code {
  std::string_view id;
  std::string_view title;
  Severity severity = Severity::Error;
  std::string_view help;  ///< for messages of the readers; rules have a page
  bool isRule = false;
  bool onByDefault = true;
};

/// Rules first, in their order, then the readers' messages by id.
std::vector<Code> allCodes();
std::optional<Code> codeNamed(std::string_view id);
/// A code as somebody wrote it, in capitals.
std::string asCode(std::string_view text);

}  // namespace rungproof
