// What an ANY says of a variable that it is made of: the type of its elements and their count (002:2249).
// Tested by tests/mc7/call_recovery_test.cpp, tests/step7/handed_pointer_test.cpp.
#pragma once

#include <cstdint>

#include "ir/s7300/declaration.hpp"
#include "ir/s7300/pointer_code.hpp"

namespace rungproof::s7300 {

struct AnyElements {
  AnyType type = AnyType::Void;
  std::uint64_t count = 1;
  friend bool operator==(const AnyElements&, const AnyElements&) = default;
};

/// Arrays and structures count their bytes, an array of CHAR its characters (002:2249); a STRING its bytes.
AnyElements anyElementsOf(const Type& type);

}  // namespace rungproof::s7300
