// Where the pointers stand that calls hand over.
#include "ir/s7300/pointer_parameter.hpp"

#include <algorithm>

#include "ir/subroutine_index.hpp"

namespace rungproof {

namespace {

/// Bytes of the pointers that a call of the block needs in the local data of the caller.
std::uint32_t pointersOfCall(const Pou& callee) {
  std::uint32_t bytes = 0;
  if (keepsPointers(callee)) return bytes;
  for (const LocalVariable& local : callee.locals) {
    if (isParameter(local) && takesPointer(local)) bytes += pointerSize(local.type);
  }
  return bytes;
}

}  // namespace

void placeHandedPointers(Program& program) {
  for (Pou& pou : program.pous) {
    std::uint32_t next = 0;
    for (LocalVariable& local : pou.locals) {
      if (!isParameter(local) || !takesPointer(local)) continue;
      pou.takesPointers = true;
      if (keepsPointers(pou)) continue;
      local.pointerByte = next;
      next += pointerSize(local.type);
    }
  }
  const SubroutineIndex blocks(program);
  for (Pou& pou : program.pous) {
    std::uint32_t most = 0;
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (instruction.desc->control != Control::BlockCall || instruction.operands.empty()) continue;
        if (instruction.operands[0].kind != OperandKind::Constant) continue;
        const Pou* callee = blocks[static_cast<int>(instruction.operands[0].value)];
        if (callee != nullptr) most = std::max(most, pointersOfCall(*callee));
      }
    }
    pou.pointerBytes = most;
    pou.localBytes += most;
  }
}

}  // namespace rungproof
