// The instructions of the S7-300 and S7-400 without their meanings.
#pragma once

#include "ir/instruction_table.hpp"

namespace rungproof {

const InstructionTable& s7300Instructions();

}  // namespace rungproof
