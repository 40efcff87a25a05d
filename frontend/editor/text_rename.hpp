// Renaming a variable of structured text within its block. Tested by tests/editor/rename_test.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "frontend/editor/property_words.hpp"
#include "frontend/editor/structured_text.hpp"

namespace rungproof {

struct VariablePlaces {
  std::string name;
  std::vector<Span> spans;  ///< in the block that declares it
  /// Where a word of a property names it; empty if none can.
  std::function<std::optional<Span>(const PropertyWord&)> inProperty{};
};

/// The places of the variable that is named at an offset, in a block or in a property; or why it cannot be renamed:
/// what other blocks see (globals, parameters of functions and blocks, members, types) has places that this text alone
/// does not show.
std::variant<VariablePlaces, std::string> placesOfVariable(const CheckedDocument& document, std::uint32_t offset);

/// Why the variable at an offset cannot be called so, or nothing.
std::string variableFault(const CheckedDocument& document, std::uint32_t offset, std::string_view name);

}  // namespace rungproof
