// By the roles of statements, then by the places that their operands name.
#include "analysis/unread/register_use.hpp"

#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace registers {
namespace {

RegisterUse useOfRole(const Instruction& instruction, bool goesOn) {
  const StatementRole role = statementRole(instruction);
  const bool hasOperand = !instruction.operands.empty();
  const Mask string = goesOn ? rlo : 0;
  switch (role) {
    case StatementRole::AndScan:
    case StatementRole::OrScan:
    case StatementRole::XorScan: {
      const bool isOfStatus = hasOperand && instruction.operands[0].kind == OperandKind::Constant;
      const Mask status = isOfStatus ? br | result : 0;
      return {static_cast<Mask>(string | status), rlo, static_cast<Mask>(goesOn ? 0 : rlo)};
    }
    case StatementRole::Open: return {string, rlo, 0};
    case StatementRole::OrOfAnds:
    case StatementRole::Close:
    case StatementRole::Edge:
    case StatementRole::Negate: return {rlo, rlo, 0};
    case StatementRole::SetRlo:
    case StatementRole::ClearRlo: return {0, rlo, rlo};
    case StatementRole::Save: return {rlo, br, br};
    case StatementRole::Compare:
    case StatementRole::CompareRealEqual: return {accu1 | accu2, rlo | result, rlo};
    case StatementRole::Assign:
    case StatementRole::Latch:
    case StatementRole::ResetTimer:
    case StatementRole::FreeTimer:
    case StatementRole::CountUp:
    case StatementRole::CountDown:
    case StatementRole::ResetCounter:
    case StatementRole::FreeCounter: return {rlo, 0, 0};
    case StatementRole::StartTimer:
    case StatementRole::SetCounter: return {rlo | accu1, 0, 0};
    case StatementRole::JumpByRlo:
    case StatementRole::EndByRlo: return {rlo, rlo, rlo};
    case StatementRole::JumpKeepingRlo: return {rlo, rlo | br, rlo | br};
    case StatementRole::JumpByBr: return {br, 0, 0};
    case StatementRole::JumpByResult: return {result, result, 0};
    case StatementRole::Loop: return {accu1, accu1, accu1};
    case StatementRole::Distributor: return {accu1, 0, 0};
    case StatementRole::Call: return {0, all, 0};
    case StatementRole::CallByRlo: return {rlo, all, 0};
    case StatementRole::Load: return {0, accu1 | accu2, accu1};
    case StatementRole::Transfer: return {accu1, 0, 0};
    case StatementRole::TransferStatus: return {accu1, rlo | br | result, rlo | br | result};
    case StatementRole::LoadAr1: return {static_cast<Mask>(hasOperand ? 0 : accu1), ar1, ar1};
    case StatementRole::LoadAr2: return {static_cast<Mask>(hasOperand ? 0 : accu1), ar2, ar2};
    case StatementRole::StoreAr1: return {ar1, static_cast<Mask>(hasOperand ? 0 : accus), 0};
    case StatementRole::StoreAr2: return {ar2, static_cast<Mask>(hasOperand ? 0 : accus), 0};
    case StatementRole::Ar2ToAr1: return {ar2, ar1, ar1};
    case StatementRole::Ar1ToAr2: return {ar1, ar2, ar2};
    case StatementRole::ExchangeAr: return {ar1 | ar2, ar1 | ar2, 0};
    case StatementRole::MoveAr1: return {static_cast<Mask>(hasOperand ? ar1 : ar1 | accu1), ar1, 0};
    case StatementRole::MoveAr2: return {static_cast<Mask>(hasOperand ? ar2 : ar2 | accu1), ar2, 0};
    case StatementRole::OpenBlock: {
      const Operand& block = instruction.operands[0];
      const Mask opened = block.reach != nullptr && block.reach->inDi ? di : db;
      return {0, opened, opened};
    }
    case StatementRole::ExchangeBlocks: return {db | di, db | di, 0};
    case StatementRole::FromBcd:
    case StatementRole::IntegerStep: return {accu1, accu1, 0};
    case StatementRole::IntegerMath:
    case StatementRole::RealMath: return {accus, accus | result, 0};
    case StatementRole::MoveAccus: return {accus, accus, 0};
    case StatementRole::JumpAlways:
    case StatementRole::End:
    case StatementRole::OpenRelay:
    case StatementRole::CloseRelay:
    case StatementRole::Relay:
    case StatementRole::Nothing: return {};
    case StatementRole::Other: break;
  }
  if (instruction.desc->control == Control::LabelMark) return {};
  if (loadsElement(instruction)) return {0, accu1 | accu2, accu1};
  if (loadsStatus(instruction)) return {rlo | br | result, accus, 0};
  if (loadsBlockFact(instruction)) return {db | di, accus, 0};
  return {accus | result, accus | result, 0};
}

/// What the places of the operands take from registers, and the block that a full address opens (002:640-653).
void addPlaces(const Instruction& instruction, RegisterUse& use) {
  const bool isCall = instruction.desc->control == Control::BlockCall;
  const bool opens = statementRole(instruction) == StatementRole::OpenBlock;
  const auto add = [&](const Operand& operand) {
    const Mask open = operand.reach != nullptr && operand.reach->inDi ? di : db;
    const Mask ofArea = operand.area == Area::DB ? open : 0;
    if (operand.reach == nullptr) {
      if (operand.area == Area::DB && operand.isMemory() && !opens) use.writes |= db;
      if (operand.area == Area::DB && operand.isMemory() && !opens && !isCall) use.set |= db;
      return;
    }
    switch (operand.reach->way) {
      case Way::OpenBlock: use.reads |= opens ? Mask{0} : open; return;
      case Way::Instance: use.reads |= di | ar2; return;
      case Way::Pointer: use.reads |= opens ? Mask{0} : ofArea; return;
      case Way::Register: use.reads |= ofArea | (operand.reach->byAr2 ? ar2 : ar1); return;
      case Way::Crossing: use.reads |= db | di | (operand.reach->byAr2 ? ar2 : ar1); return;
      default: return;
    }
  };
  for (const Operand& operand : instruction.operands) {
    add(operand);
    if (operand.reach != nullptr) add(operand.reach->pointer);
  }
}

}  // namespace
}  // namespace registers

RegisterUse registerUse(const Instruction& instruction, bool goesOn) {
  RegisterUse use = registers::useOfRole(instruction, goesOn);
  registers::addPlaces(instruction, use);
  return use;
}

}  // namespace rungproof
