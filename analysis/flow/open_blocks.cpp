// What each kind of statement does to the data block registers, AR1 and AR2.
#include "analysis/flow/open_blocks.hpp"

#include <iterator>
#include <map>

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
              (!other.isAr1Copy && isAr1Copy) || (!other.isDbCopy && isDbCopy) || (saved & ~other.saved) != 0;
  isDiMoved = isDiMoved || other.isDiMoved;
  isAr2Moved = isAr2Moved || other.isAr2Moved;
  isAr1Copy = isAr1Copy && other.isAr1Copy;
  isDbCopy = isDbCopy && other.isDbCopy;
  saved &= other.saved;
  return isChanged;
}

bool reachesOpenBlock(const Operand& operand, bool inDi) {
  if (operand.kind != OperandKind::Indirect || operand.area != Area::DB || operand.reach == nullptr) return false;
  const Way way = operand.reach->way;
  return (way == Way::OpenBlock || way == Way::Pointer || way == Way::Register) && operand.reach->inDi == inDi;
}

namespace {

/// Follows one block. AR2 and DI may be kept in local data into which nothing else is written.
class Opening {
 public:
  Opening(const Program& program, const Flow& flow) : program_(program), first_(flow.steps.data()) {
    for (const FlowStep& step : flow.steps) {
      const Operand* place = savedAt(step);
      if (place != nullptr && places_.size() < 32) places_.emplace(toString(*place), *place);
    }
    for (const FlowStep& step : flow.steps) {
      const Operand* saved = savedAt(step);
      std::erase_if(places_, [&](const auto& place) { return mayWrite(*step.instruction, place.second, saved); });
    }
  }

  void apply(OpenState& state, const FlowStep& step) const {
    const Instruction& instruction = *step.instruction;
    eachDataOperand(program_, instruction, [&](const Operand& operand, bool isParameter) {
      if (!isFullAddress(operand)) return;
      state.isDbCopy = false;
      if (isParameter) {
        state.db = {static_cast<Openers>(state.db.by | openedByCall), 0};
      } else {
        state.db = {openedHere, blockOfByte(operand.offset)};
      }
    });
    if (const Operand* place = savedAt(step)) {
      const bool isMoved = savesBlock(step) ? state.isDiMoved : state.isAr2Moved;
      const std::uint32_t bit = bitOf(*place);
      state.saved = isMoved ? state.saved & ~bit : state.saved | bit;
    }
    switch (statementRole(instruction)) {
      case StatementRole::OpenBlock: return open(state, instruction.operands[0]);
      case StatementRole::ExchangeBlocks: {
        std::swap(state.db, state.di);
        const bool isDiCopy = state.isDbCopy;
        state.isDbCopy = !state.isDiMoved;
        state.isDiMoved = !isDiCopy;
        return;
      }
      case StatementRole::LoadAr2: state.isAr2Moved = !isRestore(state, step); return;
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
        state.isAr1Copy = state.isDbCopy = false;
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

  void open(OpenState& state, const Operand& block) const {
    const bool inDi = block.reach != nullptr && block.reach->inDi;
    const bool isKnown = block.kind == OperandKind::Direct;
    const bool isOwn = block.kind == OperandKind::Indirect && block.reach != nullptr &&
                       (state.saved & bitOf(block.reach->pointer)) != 0;
    OpenBlock opened{openedHere, isKnown ? blockOfByte(block.offset) : 0};
    (inDi ? state.di : state.db) = opened;
    (inDi ? state.isDiMoved : state.isDbCopy) = inDi != isOwn;
  }

  bool isRestore(const OpenState& state, const FlowStep& step) const {
    const Instruction& instruction = *step.instruction;
    if (!instruction.operands.empty()) return (state.saved & bitOf(instruction.operands[0])) != 0;
    if (&step == first_) return false;
    const Instruction& before = *(&step - 1)->instruction;
    return statementRole(before) == StatementRole::Load && !before.operands.empty() &&
           (state.saved & bitOf(before.operands[0])) != 0;
  }

  /// Whether it is the transfer behind L DINO.
  bool savesBlock(const FlowStep& step) const {
    return &step != first_ && statementRole(*step.instruction) == StatementRole::Transfer &&
           loadsInstanceNumber(*(&step - 1)->instruction);
  }
  /// The local data into which the statement saves AR2 or DI, or nullptr: TAR2 #k; TAR2, T #k; L DINO, T #k.
  const Operand* savedAt(const FlowStep& step) const {
    const Instruction& instruction = *step.instruction;
    const StatementRole role = statementRole(instruction);
    const bool isBehindTar2 = &step != first_ && role == StatementRole::Transfer &&
                              statementRole(*(&step - 1)->instruction) == StatementRole::StoreAr2 &&
                              (&step - 1)->instruction->operands.empty();
    if (role != StatementRole::StoreAr2 && !isBehindTar2 && !savesBlock(step)) return nullptr;
    if (instruction.operands.empty()) return nullptr;
    const Operand& place = instruction.operands[0];
    return place.kind == OperandKind::Direct && place.area == Area::L ? &place : nullptr;
  }
  /// Whether the statement may write there, other than by saving into it.
  static bool mayWrite(const Instruction& instruction, const Operand& place, const Operand* saved) {
    const auto end = [](const Operand& o) { return o.offset + static_cast<std::uint32_t>(bytes(o.width)); };
    const bool isCall = instruction.desc->control == Control::BlockCall;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      const Operand& operand = instruction.operands[i];
      const bool isRead =
          !isCall && i < instruction.desc->operandCount && instruction.desc->operands[i].direction == Direction::In;
      if (isRead || operand.area != Area::L) continue;
      if (operand.kind != OperandKind::Direct) return true;
      const bool isSave = &operand == saved && toString(operand) == toString(place);
      if (!isSave && operand.offset < end(place) && place.offset < end(operand)) return true;
    }
    return false;
  }
  std::uint32_t bitOf(const Operand& place) const {
    const auto found = places_.find(toString(place));
    return found == places_.end() ? 0 : std::uint32_t{1} << std::distance(places_.begin(), found);
  }

  const Program& program_;
  const FlowStep* first_;
  std::map<std::string, Operand> places_;
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
