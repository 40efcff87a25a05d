// The S7-200 and the S7-200 SMART as a dialect: one instruction set, of which each CPU has a part.
#pragma once

#include "ir/dialect.hpp"

namespace rungproof {

extern const Dialect s7200Dialect;

}  // namespace rungproof
