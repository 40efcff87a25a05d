// The table of the instructions of the S7-300/400.
#include "ir/s7300/isa.hpp"

#include "ir/s7300/isa_list.hpp"

namespace rungproof {

const InstructionTable& s7300Instructions() {
  static const InstructionTable table(isa::step7::instructionTable, {});
  return table;
}

}  // namespace rungproof
