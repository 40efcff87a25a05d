// Renaming a variable of structured text within its block. Tested by tests/editor/rename_test.cpp.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "frontend/editor/structured_text.hpp"

namespace rungproof {

/// The places of the variable that is named at an offset, its name there included; or why it cannot be renamed: what
/// other blocks see (globals, parameters of functions and blocks, members, types) has places that this text alone does
/// not show.
std::variant<std::vector<Span>, std::string> placesOfVariable(const CheckedDocument& document, std::uint32_t offset);

/// Why the variable at an offset cannot be called so, or nothing.
std::string variableFault(const CheckedDocument& document, std::uint32_t offset, std::string_view name);

}  // namespace rungproof
