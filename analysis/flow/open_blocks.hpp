// Which data blocks are open in front of each statement of an S7-300/400 block, and whether an FB still has its own
// instance: DI and AR2 as the call has set them. What opens them: OPN, CDB, a full address (002:603, 002:640-653). A
// CALL may leave another block open (general knowledge): the instance of an FB, or that of a full address among its
// parameters.
// Tested by tests/rules/data_block_rules_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/flow/statement_paths.hpp"
#include "ir/s7300/block_operand.hpp"

namespace rungproof {

/// Who has opened a data block: a set.
using Openers = std::uint8_t;
inline constexpr Openers openedHere = 1, openedByCaller = 2, openedByCall = 4;

/// A data block register.
struct OpenBlock {
  Openers by = openedByCaller;
  std::uint32_t number = 0;  ///< 0: not known

  bool join(const OpenBlock& other);
};

struct OpenState {
  OpenBlock db, di;
  bool isDiMoved = false, isAr2Moved = false;  ///< may no longer be what the call of the FB has set
  bool isAr1Copy = false;                      ///< AR1 holds what AR2 was
  bool isDbCopy = false;                       ///< DB holds what DI was
  /// Local data that holds what AR2 or DI was, by its number among the places into which the block saves them.
  std::uint32_t saved = 0;

  bool join(const OpenState& other);
};

using OpenStates = std::vector<std::optional<OpenState>>;
/// By step of the flow; one more at the end.
OpenStates openStates(const Program& program, const Flow& flow);

/// Calls visit(operand, isParameter) for the operands of a statement and those that hold their pointers. The instance
/// of a call, blocks that it gives as parameters and the block of OPN are none of them.
template <class Visit>
void eachDataOperand(const Program& program, const Instruction& instruction, Visit&& visit) {
  const StatementRole role = statementRole(instruction);
  const bool isCall = role == StatementRole::Call || role == StatementRole::CallByRlo;
  for (std::size_t i = role == StatementRole::OpenBlock ? instruction.operands.size()
                       : isCall                         ? 1
                                                        : 0;
       i < instruction.operands.size(); ++i) {
    if (!isBlockOperand(program, instruction, i)) visit(instruction.operands[i], isCall);
  }
  for (const Operand& operand : instruction.operands) {
    if (operand.reach == nullptr) continue;
    const bool isPlace = operand.reach->way == Way::PointerTo && operand.reach->pointer.reach != nullptr;
    if (operand.reach->way == Way::Pointer || isPlace) visit(operand.reach->pointer, false);
  }
}

/// A place in the data block that is open in DB (or in DI, if `inDi`).
bool reachesOpenBlock(const Operand& operand, bool inDi);
/// A full address: DB10.DBW2, "Motor".speed.
inline bool isFullAddress(const Operand& operand) {
  return operand.kind == OperandKind::Direct && operand.area == Area::DB && operand.reach == nullptr;
}

}  // namespace rungproof
