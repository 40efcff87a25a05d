// The table of the instructions of the IEC 61131-3 machine.
#include "ir/iec/isa.hpp"
#include "ir/iec/isa/list.hpp"

namespace rungproof {

const InstructionTable& iecInstructions() {
  static const InstructionTable table(isa::iec::instructionTable, {});
  return table;
}

}  // namespace rungproof
