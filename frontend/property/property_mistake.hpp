// A mistake in a statement of the property language, and the types that are asked for in several places.
// Tested by tests/property/language_test.cpp.
#pragma once

#include <initializer_list>
#include <string>

#include "analysis/unsigned_number.hpp"
#include "frontend/property/property_message.hpp"

namespace rungproof {

/// Leaves the parser at once, becomes a finding.
struct PropertyMistake {
  const char* rule;
  Span span;
  std::string message;
  std::string help;
};

/// Sums and REAL have a sign.
inline void needSigns(const Expr& e, std::initializer_list<std::uint32_t> sides, Span at) {
  for (const std::uint32_t side : sides) {
    const ExprNode& n = e.nodes[side];
    if (!isUnsigned64(e, n)) continue;
    throw PropertyMistake{propertyMessages[2].id.data(), n.span.length != 0 ? n.span : at,
                          "a number of 64 bits without a sign can be compared with whole numbers, nothing else",
                          "let the program compute what is asked, and compare its result"};
  }
}

}  // namespace rungproof
