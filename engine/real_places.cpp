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

NumberUse useOfType(DataType type) {
  if (type == DataType::Real) return NumberUse::Real;
  return type == DataType::DInt || type == DataType::Time ? NumberUse::Whole : NumberUse::Unknown;
}

NumberUse useOfType(Type type) {
  return type == Type::Real ? NumberUse::Real : type == Type::DInt ? NumberUse::Whole : NumberUse::Unknown;
}

NumberUse useOfType(s7300::TypeKind kind) {
  if (kind == s7300::TypeKind::Real) return NumberUse::Real;
  const bool isWhole =
      kind == s7300::TypeKind::DInt || kind == s7300::TypeKind::Time || kind == s7300::TypeKind::TimeOfDay;
  return isWhole ? NumberUse::Whole : NumberUse::Unknown;
}

/// What a constant says of the place that it is moved to; 0 is the same number in both, and a pattern says nothing.
NumberUse useOfConstant(const Operand& constant) {
  if (constant.form == ConstantForm::Real) return NumberUse::Real;
  const bool isAmount = constant.form == ConstantForm::Decimal || constant.form == ConstantForm::SignedDecimal ||
                        constant.form == ConstantForm::Typed;
  return isAmount && constant.value != 0 ? NumberUse::Whole : NumberUse::Unknown;
}

NumberUse declaredUse(const s7300::Structure& structure, std::uint32_t byte);

NumberUse declaredUse(const s7300::Type& type, std::uint32_t byte) {
  if (type.kind == s7300::TypeKind::Struct && type.structure != nullptr) return declaredUse(*type.structure, byte);
  if (type.kind != s7300::TypeKind::Array) return byte == 0 ? useOfType(type.kind) : NumberUse::Unknown;
  if (type.element == nullptr) return NumberUse::Unknown;
  std::uint64_t size = s7300::sizeOf(*type.element);
  size += size > 1 ? size % 2 : 0;
  return size == 0 ? NumberUse::Unknown : declaredUse(*type.element, static_cast<std::uint32_t>(byte % size));
}

NumberUse declaredUse(const s7300::Structure& structure, std::uint32_t byte) {
  for (const s7300::Field& field : structure.fields) {
    const bool isInside = byte >= field.byte && byte < field.byte + s7300::sizeOf(field.type);
    if (isInside && !field.byReference) return declaredUse(field.type, byte - field.byte);
  }
  return NumberUse::Unknown;
}

NumberUse declaredUse(const Program& program, const Operand& operand) {
  if (program.declarations == nullptr) return NumberUse::Unknown;
  if (operand.area == Area::DB) {
    const auto found = program.declarations->dataBlocks.find(blockOfByte(operand.offset));
    return found == program.declarations->dataBlocks.end() ? NumberUse::Unknown
                                                           : declaredUse(*found->second, byteInBlock(operand.offset));
  }
  const auto symbol = program.declarations->symbolTypes.find({operand.area, operand.offset});
  return symbol == program.declarations->symbolTypes.end() ? NumberUse::Unknown : useOfType(symbol->second);
}

/// What stands in an accumulator, and where it was loaded from.
struct Held {
  const Operand* from = nullptr;
  NumberUse use = NumberUse::Unknown;
};

bool isDoubleWord(const Operand& operand) {
  return operand.kind == OperandKind::Direct && operand.width == Width::DWord;
}

}  // namespace

RealPlaces::RealPlaces(const Program& program) : program_(program) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) addInstruction(instruction);
      followAccumulators(network);
    }
  }
  spread();
}

void RealPlaces::addInstruction(const Instruction& instruction) {
  const Desc& desc = *instruction.desc;
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    const Operand& operand = instruction.operands[i];
    addRow(operand);
    if (i < desc.operandCount) add(operand, useOfType(desc.operands[i].type));
    if (const auto type = formalType(program_, instruction, i)) add(operand, useOfType(*type));
  }
  if (!isMoveOf(desc, Type::DWord) || instruction.operands.size() != 2) return;
  const Operand &from = instruction.operands[0], &to = instruction.operands[1];
  if (from.kind == OperandKind::Constant) add(to, useOfConstant(from));
  copy(from, to);
}

void RealPlaces::add(const Operand& operand, NumberUse use) {
  if (!isDoubleWord(operand)) return;
  if (use == NumberUse::Real) reals_.emplace(operand.area, operand.offset);
  if (use == NumberUse::Whole) wholes_.emplace(operand.area, operand.offset);
}

/// Accumulators and local data hold one number here and another there.
void RealPlaces::copy(const Operand& from, const Operand& to) {
  const auto isLasting = [](const Operand& operand) {
    return isDoubleWord(operand) && operand.area != Area::AC && operand.area != Area::L;
  };
  if (!isLasting(from) || !isLasting(to)) return;
  copies_[{from.area, from.offset}].emplace(to.area, to.offset);
  copies_[{to.area, to.offset}].emplace(from.area, from.offset);
}

/// What is copied from each other holds the same, where all of them that tell agree.
void RealPlaces::spread() {
  std::set<Place> seen;
  for (const auto& [start, others] : copies_) {
    if (!seen.insert(start).second) continue;
    std::vector<Place> group{start};
    for (std::size_t at = 0; at < group.size(); ++at) {
      for (const Place& next : copies_.at(group[at])) {
        if (seen.insert(next).second) group.push_back(next);
      }
    }
    bool isReal = false, isWhole = false;
    for (const auto& [area, offset] : group) {
      const NumberUse use = useOf(direct(area, Width::DWord, offset));
      isReal = isReal || use == NumberUse::Real;
      isWhole = isWhole || use == NumberUse::Whole;
    }
    if (isReal == isWhole) continue;
    for (const Place& place : group) ofCopies_[place] = isReal ? NumberUse::Real : NumberUse::Whole;
  }
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

/// Along the statements of a network as they stand: what is loaded and then added, compared, converted or stored.
void RealPlaces::followAccumulators(const Network& network) {
  Held first, second;  // ACCU1 and ACCU2
  const auto take = [&](const Held& held, NumberUse use) {
    if (held.from != nullptr) add(*held.from, use);
  };
  const auto takeBoth = [&](NumberUse use) {
    take(first, use);
    take(second, use);
  };
  for (const Instruction& instruction : network.instructions) {
    const Operand* operand = instruction.operands.empty() ? nullptr : &instruction.operands[0];
    switch (statementRole(instruction)) {
      case StatementRole::Load:
        second = first;
        first = {operand};
        if (operand != nullptr && operand->kind == OperandKind::Constant) first = {nullptr, useOfConstant(*operand)};
        break;
      case StatementRole::Transfer:
        if (operand == nullptr) break;
        add(*operand, first.use);
        if (first.from != nullptr) copy(*first.from, *operand);
        break;
      case StatementRole::RealMath:
        takeBoth(NumberUse::Real);
        first = {nullptr, NumberUse::Real};
        second = {};
        break;
      case StatementRole::IntegerMath:
      case StatementRole::IntegerStep:
        takeBoth(NumberUse::Whole);
        first = {nullptr, NumberUse::Whole};
        second = {};
        break;
      case StatementRole::Compare:
      case StatementRole::CompareRealEqual:
        takeBoth(comparesReals(instruction) ? NumberUse::Real : NumberUse::Whole);
        break;
      case StatementRole::Other:
        if (instruction.desc->control == Control::LabelMark) break;
        if (const auto step = numberStep(instruction)) {
          take(first, step->takesReal ? NumberUse::Real : NumberUse::Whole);
          first = {nullptr, step->givesReal ? NumberUse::Real : NumberUse::Whole};
          break;
        }
        first = second = {};
        break;
      case StatementRole::JumpAlways:
      case StatementRole::End:
      case StatementRole::Call:
      case StatementRole::CallByRlo:
      case StatementRole::FromBcd:
      case StatementRole::MoveAccus: first = second = {}; break;
      default: break;
    }
  }
}

NumberUse RealPlaces::useOf(const Operand& operand) const {
  if (!isDoubleWord(operand)) return NumberUse::Unknown;
  if (operand.area == Area::HC) return NumberUse::Whole;
  if (const NumberUse declared = declaredUse(program_, operand); declared != NumberUse::Unknown) return declared;
  const Place place{operand.area, operand.offset};
  if (reals_.contains(place)) return NumberUse::Real;
  const bool isInRow = std::ranges::any_of(rows_, [&](const Row& row) {
    return row.area == operand.area && operand.offset >= row.first && operand.offset < row.first + 4U * row.count &&
           (operand.offset - row.first) % 4 == 0;
  });
  if (isInRow) return NumberUse::Real;
  if (wholes_.contains(place)) return NumberUse::Whole;
  const auto copied = ofCopies_.find(place);
  return copied == ofCopies_.end() ? NumberUse::Unknown : copied->second;
}

}  // namespace rungproof
