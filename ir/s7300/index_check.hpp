// The name of the instruction by which a body in SCL asks for the bounds of an array; nobody writes it.
#pragma once

#include <string_view>

namespace rungproof {

inline constexpr std::string_view indexCheck = "INDEX";

}  // namespace rungproof
