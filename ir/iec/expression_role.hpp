// What an instruction of IEC 61131-3 is for, in the words of those who follow expressions on the evaluation stack. The
// meanings stand in ir/iec/isa; here only their kinds. Tested by tests/iec/expression_role_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ir/program.hpp"

namespace rungproof {

enum class ExpressionRole : std::uint8_t {
  Other,
  LoadBit,   ///< a BOOL variable
  StoreBit,  ///< to a BOOL variable
  Load,      ///< a variable of several bits
  Store,
  Constant,  ///< its value and its width
  And,
  Or,
  Xor,
  Not,
  Select,   ///< one of two values
  Reading,  ///< whether an open point is read in one way: the number of the choice and that of its value
  PassTime  ///< the ms of a scan go into a clock
};

/// Other for what no one asks about, and for every instruction of another family.
ExpressionRole expressionRole(const Instruction& instruction);
/// Whether the role is of BOOL values: the width that stands behind it is 1.
bool isOfTruth(const Instruction& instruction);

struct StackUse {
  std::size_t pops = 0, pushes = 0;
};
/// Values that it takes off the evaluation stack, and that it leaves there.
StackUse stackUse(const Instruction& instruction);

}  // namespace rungproof
