// By mnemonic.
#include "ir/s7300/statement_detail.hpp"

#include <string_view>

namespace rungproof {

bool jumpsOnOne(const Instruction& jump) {
  const std::string_view name = jump.desc->stl;
  return name == "JC" || name == "JCB" || name == "JBI";
}

bool setsBit(const Instruction& instruction) {
  return statementRole(instruction) == StatementRole::Latch && instruction.desc->stl == "S";
}

bool startsOnDelay(const Instruction& instruction) {
  return statementRole(instruction) == StatementRole::StartTimer && instruction.desc->stl == "SD";
}

bool comparesReals(const Instruction& instruction) {
  return isComparison(statementRole(instruction)) && instruction.desc->stl.ends_with('R');
}

}  // namespace rungproof
