// Comments that speak to the tool: `//@ prove NAME: EXPR` is collected for analysis/property. The rule comments
// `// rungproof: allow ADR001 reason` stay ordinary comments and are read by the suppression.
// Tested by tests/reader/directive_test.cpp.
#pragma once

#include <optional>
#include <string_view>

namespace rungproof {

/// Text behind `//@` without surrounding blanks; nothing if the comment is none of the kind.
std::optional<std::string_view> directiveText(std::string_view comment);
/// Whether the comment is meant for the tool, `//@ ...` or `// rungproof: ...`, and so no title of a network.
bool speaksToTool(std::string_view comment);

}  // namespace rungproof
