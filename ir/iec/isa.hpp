// The instructions of the IEC 61131-3 machine without their meanings.
#pragma once

#include "ir/instruction_table.hpp"

namespace rungproof {

const InstructionTable& iecInstructions();

}  // namespace rungproof
