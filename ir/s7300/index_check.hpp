// The names of the instructions that stand in bodies in SCL alone: one asks for the bounds of an array, one ends the
// body, one leaves a value open. Nobody writes them.
#pragma once

#include <string_view>

namespace rungproof {

inline constexpr std::string_view indexCheck = "INDEX";
inline constexpr std::string_view bodyEnd = "ENO";
inline constexpr std::string_view openValue = "ANY";

}  // namespace rungproof
