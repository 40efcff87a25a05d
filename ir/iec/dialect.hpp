// IEC 61131-3 as a row of the dialects.
#pragma once

#include "ir/dialect.hpp"

namespace rungproof {

extern const Dialect iecDialect;

}  // namespace rungproof
