// The instructions of the S7-200 and the S7-200 SMART. Meanings are in ir/s7200/isa/*.hpp and reach the rest only
// through a domain's dispatch table (ir/machine/dispatch.hpp).
#pragma once

#include "ir/instruction_table.hpp"

namespace rungproof {

/// In the order of ir/s7200/isa/list.hpp.
const InstructionTable& s7200Instructions();

}  // namespace rungproof
