// Operands behind those that the instruction itself has, or that stand for parameters, are actual ones of a call.
#include "ir/written_operand.hpp"

#include "ir/overlap.hpp"

namespace rungproof {

bool isWritten(const Program& program, const Operand& operand, Actuals actuals) {
  const auto writes = [&](const Instruction& instruction, std::size_t i) {
    const bool isActual = i >= instruction.desc->operandCount || instruction.desc->operands[i].type == Type::Parameter;
    if (isActual) return actuals == Actuals::Written;
    return instruction.desc->operands[i].direction != Direction::In;
  };
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
          if (writes(instruction, i) && overlaps(instruction.operands[i], operand)) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace rungproof
