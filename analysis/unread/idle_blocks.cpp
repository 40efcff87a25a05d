// Collects the numbers of data blocks that operands name.
#include "analysis/unread/idle_blocks.hpp"

#include "ir/block_map.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

void NamedBlocks::addText(const Program& program) {
  for (const Pou& pou : program.pous) {
    // A block of the system follows pointers, whose numbers may come from memory.
    isAny_ = isAny_ || (pou.isBuiltIn && pou.takesPointers);
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) add(instruction);
    }
  }
}

void NamedBlocks::addQuestions(const PropertySet& set) {
  for (const Property& property : set.properties) {
    for (const Operand* operand : addressesOf(property)) add(*operand);
  }
  for (const ExternalRange& range : set.externals) {
    if (range.first.area != Area::DB) continue;
    for (std::uint32_t block = blockOfByte(range.first.offset); block <= blockOfByte(range.last.offset); ++block)
      numbers_.insert(block);
  }
}

void NamedBlocks::add(const Instruction& instruction) {
  const bool opens = statementRole(instruction) == StatementRole::OpenBlock,
             calls = instruction.desc->control == Control::BlockCall;
  for (const Operand& operand : instruction.operands) {
    add(operand);
    // A number is that of a data block where one is opened, and may be one where a call hands it over.
    if ((opens || calls) && operand.kind == OperandKind::Constant)
      numbers_.insert(static_cast<std::uint32_t>(operand.value));
    isAny_ = isAny_ || (opens && operand.kind == OperandKind::Indirect && operand.reach->way != Way::Parameter);
  }
}

void NamedBlocks::add(const Operand& operand) {
  if (operand.area == Area::DB && operand.kind == OperandKind::Direct) numbers_.insert(blockOfByte(operand.offset));
  if (operand.reach == nullptr) return;
  const Operand& pointer = operand.reach->pointer;
  if (operand.reach->way == Way::PointerTo && pointer.kind == OperandKind::Constant) numbers_.insert(pointer.offset);
  add(pointer);
}

void leaveOutBlocks(Program& program, const NamedBlocks& named) {
  std::erase_if(program.dataBlocks, [&](const DataBlock& block) { return !named.mayOpen(block.number); });
}

void leaveOutIdleBlocks(Program& program, const PropertySet& set) {
  NamedBlocks named;
  named.addText(program);
  named.addQuestions(set);
  leaveOutBlocks(program, named);
}

}  // namespace rungproof
