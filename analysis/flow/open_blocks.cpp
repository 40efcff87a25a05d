// What each kind of statement does to the data block registers, AR1 and AR2.
#include "analysis/flow/open_blocks.hpp"

#include <set>

#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

bool OpenBlock::join(const OpenBlock& other) {
  const OpenBlock old = *this;
  by |= other.by;
  if (number != other.number) number = 0;
  return by != old.by || number != old.number;
}

bool OpenState::join(const OpenState& other) {
  bool isChanged = db.join(other.db);
  isChanged = di.join(other.di) || isChanged;
  isChanged = isChanged || (other.isDiMoved && !isDiMoved) || (other.isAr2Moved && !isAr2Moved) ||
              (!other.isAr1Copy && isAr1Copy);
  isDiMoved = isDiMoved || other.isDiMoved;
  isAr2Moved = isAr2Moved || other.isAr2Moved;
  isAr1Copy = isAr1Copy && other.isAr1Copy;
  return isChanged;
}

bool reachesOpenBlock(const Operand& operand, bool inDi) {
  if (operand.kind != OperandKind::Indirect || operand.area != Area::DB || operand.reach == nullptr) return false;
  const Way way = operand.reach->way;
  return (way == Way::OpenBlock || way == Way::Pointer || way == Way::Register) && operand.reach->inDi == inDi;
}

namespace {

/// Follows one block. Places into which AR2 was saved stay known over the whole text: a restore may stand anywhere.
class Opening {
 public:
  Opening(const Program& program, const Flow& flow) : program_(program), first_(flow.steps.data()) {
    for (std::size_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& instruction = *flow.steps[at].instruction;
      if (statementRole(instruction) != StatementRole::StoreAr2) continue;
      if (!instruction.operands.empty()) {
        saved_.insert(toString(instruction.operands[0]));
      } else if (at + 1 < flow.steps.size() &&
                 statementRole(*flow.steps[at + 1].instruction) == StatementRole::Transfer) {
        saved_.insert(toString(flow.steps[at + 1].instruction->operands[0]));
      }
    }
  }

  void apply(OpenState& state, const FlowStep& step) const {
    const Instruction& instruction = *step.instruction;
    eachDataOperand(program_, instruction, [&](const Operand& operand, bool isParameter) {
      if (!isFullAddress(operand)) return;
      if (isParameter) {
        state.db = {static_cast<Openers>(state.db.by | openedByCall), 0};
      } else {
        state.db = {openedHere, blockOfByte(operand.offset)};
      }
    });
    switch (statementRole(instruction)) {
      case StatementRole::OpenBlock: return open(state, instruction.operands[0]);
      case StatementRole::ExchangeBlocks:
        std::swap(state.db, state.di);
        state.isDiMoved = !state.isDiMoved;
        return;
      case StatementRole::LoadAr2: state.isAr2Moved = !isRestore(step); return;
      case StatementRole::MoveAr2: state.isAr2Moved = true; return;
      case StatementRole::Ar1ToAr2: state.isAr2Moved = !state.isAr1Copy; return;
      case StatementRole::ExchangeAr:
        std::swap(state.isAr1Copy, state.isAr2Moved);
        state.isAr1Copy = !state.isAr1Copy;
        state.isAr2Moved = !state.isAr2Moved;
        return;
      case StatementRole::Ar2ToAr1: state.isAr1Copy = !state.isAr2Moved; return;
      case StatementRole::Call:
      case StatementRole::CallByRlo:
        if (opensInstance(instruction)) state.db = {static_cast<Openers>(state.db.by | openedByCall), 0};
        state.isAr1Copy = false;
        return;
      case StatementRole::LoadAr1:
      case StatementRole::MoveAr1: state.isAr1Copy = false; return;
      default: return;
    }
  }

 private:
  /// CALL FB 1, DB 1: behind it the instance may be open in DB. UC and CC give both registers back.
  static bool opensInstance(const Instruction& call) {
    return call.operands.size() > 1 && call.operands[0].kind == OperandKind::Constant &&
           hasInstance(blockTypeOf(static_cast<int>(call.operands[0].value)));
  }

  static void open(OpenState& state, const Operand& block) {
    const bool inDi = block.reach != nullptr && block.reach->inDi;
    const bool isKnown = block.kind == OperandKind::Direct;
    (inDi ? state.di : state.db) = {openedHere, isKnown ? blockOfByte(block.offset) : 0};
    state.isDiMoved = state.isDiMoved || inDi;
  }

  bool isRestore(const FlowStep& step) const {
    const Instruction& instruction = *step.instruction;
    if (!instruction.operands.empty()) return saved_.contains(toString(instruction.operands[0]));
    if (&step == first_) return false;
    const Instruction& before = *(&step - 1)->instruction;
    return statementRole(before) == StatementRole::Load && saved_.contains(toString(before.operands[0]));
  }

  const Program& program_;
  const FlowStep* first_;
  std::set<std::string> saved_;
};

}  // namespace

OpenStates openStates(const Program& program, const Flow& flow) {
  const Opening opening(program, flow);
  OpenState entry;
  const bool isInstance = hasInstance(*flow.pou);
  if (isInstance) entry.di.by = openedHere;
  return statesOf(flow, entry, [&](OpenState& state, const FlowStep& step) { opening.apply(state, step); });
}

}  // namespace rungproof
