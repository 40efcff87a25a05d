// Operands are REAL by their instruction, by the parameter that they are given for, or by their declaration.
#include "engine/real_places.hpp"

#include <algorithm>
#include <optional>

#include "ir/block_map.hpp"
#include "ir/desc.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/block_operand.hpp"
#include "ir/s7300/declarations.hpp"
#include "ir/s7300/pointer_code.hpp"
#include "ir/s7300/statement_detail.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

/// The type of what a call gives as its operand `i`.
std::optional<DataType> formalType(const Program& program, const Instruction& call, std::size_t i) {
  const bool isCall = call.desc->control == Control::Call || call.desc->control == Control::BlockCall;
  if (!isCall || i == 0 || call.operands[0].kind != OperandKind::Constant) return std::nullopt;
  const Pou* callee = program.subroutine(static_cast<int>(call.operands[0].value));
  if (callee == nullptr) return std::nullopt;
  std::size_t at = hasInstance(*callee) ? 2 : 1;
  for (const LocalVariable& local : callee->locals) {
    if (local.section == VarSection::Temp || local.section == VarSection::Static) continue;
    if (at++ == i) return local.type;
  }
  return std::nullopt;
}

bool holdsReal(const s7300::Structure& structure, std::uint32_t byte);

bool holdsReal(const s7300::Type& type, std::uint32_t byte) {
  if (type.kind == s7300::TypeKind::Real) return byte == 0;
  if (type.kind == s7300::TypeKind::Struct && type.structure != nullptr) return holdsReal(*type.structure, byte);
  if (type.kind != s7300::TypeKind::Array || type.element == nullptr) return false;
  std::uint64_t size = s7300::sizeOf(*type.element);
  size += size > 1 ? size % 2 : 0;
  return size != 0 && holdsReal(*type.element, static_cast<std::uint32_t>(byte % size));
}

bool holdsReal(const s7300::Structure& structure, std::uint32_t byte) {
  for (const s7300::Field& field : structure.fields) {
    const bool isInside = byte >= field.byte && byte < field.byte + s7300::sizeOf(field.type);
    if (isInside && !field.byReference) return holdsReal(field.type, byte - field.byte);
  }
  return false;
}

bool isDeclaredReal(const Program& program, const Operand& operand) {
  if (program.declarations == nullptr || operand.area != Area::DB) return false;
  const auto found = program.declarations->dataBlocks.find(blockOfByte(operand.offset));
  return found != program.declarations->dataBlocks.end() && holdsReal(*found->second, byteInBlock(operand.offset));
}

/// What stands in an accumulator: a REAL, or what was loaded from there.
struct Held {
  const Operand* from = nullptr;
  bool isReal = false;
};

}  // namespace

RealPlaces::RealPlaces(const Program& program) : program_(program) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
          const Operand& operand = instruction.operands[i];
          addRow(operand);
          const bool isListed = i < instruction.desc->operandCount;
          const bool isTaken = isListed && instruction.desc->operands[i].type == Type::Real;
          if (isTaken || formalType(program, instruction, i) == DataType::Real) add(operand);
        }
      }
      followAccumulators(network);
    }
  }
}

void RealPlaces::add(const Operand& operand) {
  if (operand.kind == OperandKind::Direct && operand.width == Width::DWord)
    places_.emplace(operand.area, operand.offset);
}

/// Whether a pointer that a call hands over leads to a row of REAL numbers.
void RealPlaces::addRow(const Operand& given) {
  if (given.reach == nullptr || given.reach->way != Way::PointerTo) return;
  if (static_cast<AnyType>(given.reach->anyType) != AnyType::Real) return;
  const Operand& place = given.reach->pointer;
  if (place.kind != OperandKind::Constant && place.kind != OperandKind::Direct) return;
  const std::uint32_t first = place.kind == OperandKind::Constant ? given.offset : place.offset;
  rows_.push_back({given.area, first, given.reach->anyCount});
}

/// Along the statements of a network as they stand: what is loaded and then added, compared or stored as a REAL.
void RealPlaces::followAccumulators(const Network& network) {
  Held first, second;  // ACCU1 and ACCU2
  const auto takeAsReal = [&](const Held& held) {
    if (held.from != nullptr) add(*held.from);
  };
  for (const Instruction& instruction : network.instructions) {
    const Operand* operand = instruction.operands.empty() ? nullptr : &instruction.operands[0];
    switch (const StatementRole role = statementRole(instruction)) {
      case StatementRole::Load:
        second = first;
        first = {operand, operand != nullptr && operand->form == ConstantForm::Real};
        break;
      case StatementRole::Transfer:
        if (first.isReal && operand != nullptr) add(*operand);
        break;
      case StatementRole::RealMath:
        takeAsReal(first);
        takeAsReal(second);
        first = {nullptr, true};
        second = {};
        break;
      case StatementRole::Compare:
      case StatementRole::CompareRealEqual:
        if (!comparesReals(instruction)) break;
        takeAsReal(first);
        takeAsReal(second);
        break;
      case StatementRole::Other:
        if (wantsNoNegative(instruction) || givesEitherSign(instruction)) {
          takeAsReal(first);
          first = {nullptr, true};
          break;
        }
        first = second = {};
        break;
      case StatementRole::JumpAlways:
      case StatementRole::End:
      case StatementRole::Call:
      case StatementRole::CallByRlo:
      case StatementRole::FromBcd:
      case StatementRole::IntegerMath:
      case StatementRole::IntegerStep:
      case StatementRole::MoveAccus: first = second = {}; break;
      default: static_cast<void>(role); break;
    }
  }
}

bool RealPlaces::contains(const Operand& operand) const {
  if (operand.kind != OperandKind::Direct || operand.width != Width::DWord) return false;
  if (isDeclaredReal(program_, operand) || places_.contains({operand.area, operand.offset})) return true;
  return std::ranges::any_of(rows_, [&](const Row& row) {
    return row.area == operand.area && operand.offset >= row.first && operand.offset < row.first + 4U * row.count &&
           (operand.offset - row.first) % 4 == 0;
  });
}

}  // namespace rungproof
