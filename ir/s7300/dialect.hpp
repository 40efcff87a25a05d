// The S7-300 and the S7-400 as dialects: one instruction set, two ranges of CPUs.
#pragma once

#include "ir/dialect.hpp"

namespace rungproof {

extern const Dialect s7300Dialect;
extern const Dialect s7400Dialect;

}  // namespace rungproof
