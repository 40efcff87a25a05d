// Definite assignment in a block of an S7-300/400: temporary data that is read before it is written, and outputs of an
// FC that a path leaves unwritten. Temporary data holds any value at the start of a block except for the start
// information of an OB (002:2013-2015); an FC's output that is not written leaves its actual parameter alone.
// Tested by tests/rules/step7_control_rules_test.cpp.
#pragma once

#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

struct TempRead {
  const Instruction* instruction;
  const Operand* operand;
  bool isOnEveryPath;  ///< no path writes it before; otherwise some do
};
/// One for each variable, the first read in the order of the text. Nothing of blocks that write local data through
/// pointers.
std::vector<TempRead> unwrittenTemps(const Facts& facts, std::uint32_t block);

struct OutputGap {
  const LocalVariable* output;
  const Instruction* exit;  ///< BEU or the like; nullptr: the end of the block
  bool isNeverWritten;      ///< no statement of the block writes it
  bool isLatched;           ///< S and R alone write it, and only by a condition
};
/// Outputs and the return value of an FC; nothing of other blocks.
std::vector<OutputGap> unwrittenOutputs(const Facts& facts, std::uint32_t block);

}  // namespace rungproof
