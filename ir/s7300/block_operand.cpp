// The instance stands behind the block that is called; the parameters follow in the order of their declarations.
#include "ir/s7300/block_operand.hpp"

#include "ir/s7300/block.hpp"

namespace rungproof {

bool isBlockOperand(const Program& program, const Instruction& call, std::size_t operand) {
  if (call.desc == nullptr || call.desc->control != Control::BlockCall || operand == 0) return false;
  const int block = static_cast<int>(call.operands[0].value);
  const std::size_t first = hasInstance(blockTypeOf(block)) ? 2 : 1;
  if (operand < first) return true;
  const Operand& actual = call.operands[operand];
  if (actual.kind != OperandKind::Direct || actual.area != Area::DB || actual.width != Width::Byte) return false;
  const Pou* callee = program.subroutine(block);
  if (callee == nullptr) return false;
  std::size_t at = first;
  for (const LocalVariable& local : callee->locals) {
    if (local.section == VarSection::Temp || local.section == VarSection::Static) continue;
    if (at++ == operand) return local.type == DataType::BlockDb;
  }
  return false;
}

}  // namespace rungproof
