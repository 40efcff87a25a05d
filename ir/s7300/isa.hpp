// The instructions of the S7-300 and S7-400 without their meanings.
#pragma once

#include <string_view>
#include <vector>

#include "ir/instruction_table.hpp"

namespace rungproof {

const InstructionTable& s7300Instructions();

/// The mnemonic as it is written: the table calls an O without operand OR.
std::string_view writtenMnemonic(const Desc& desc, bool german);
/// Instructions that are written so, in the sets that are asked for: O with and without operand; behind them those that
/// an operand makes of it, as L T, L C and L STW of L.
std::vector<const Desc*> instructionsWritten(std::string_view word, bool international, bool german);

}  // namespace rungproof
