// Goes down the structure that a data block or a block has.
#include "analysis/flow/declared_value.hpp"

#include <algorithm>

#include "ir/block_map.hpp"

namespace rungproof {

namespace {

using s7300::TypeKind;

void addValues(const s7300::Structure& structure, std::uint64_t base, const std::string& path, BitRange range,
               std::vector<DeclaredValue>& values);

void addValues(const s7300::Type& type, std::uint64_t first, const std::string& path, BitRange range,
               std::vector<DeclaredValue>& values) {
  const std::uint64_t size = type.kind == TypeKind::Bool ? 1 : s7300::sizeOf(type) * 8;
  if (first >= range.end || first + size <= range.first) return;
  if (type.structure != nullptr) return addValues(*type.structure, first, path, range, values);
  if (type.kind != TypeKind::Array || type.element == nullptr) {
    values.push_back({type.kind, first, first + size, path});
    return;
  }
  const bool isBits = type.element->kind == TypeKind::Bool;
  const std::uint64_t each = isBits ? 1 : std::max<std::uint64_t>(s7300::sizeOf(*type.element), 1) * 8;
  const std::uint64_t from = range.first > first ? (range.first - first) / each : 0;
  for (std::uint64_t i = from; first + i * each < std::min(range.end, first + size); ++i)
    addValues(*type.element, first + i * each, path + "[]", range, values);
}

void addValues(const s7300::Structure& structure, std::uint64_t base, const std::string& path, BitRange range,
               std::vector<DeclaredValue>& values) {
  for (const s7300::Field& field : structure.fields) {
    if (field.byReference || !field.viewOf.empty()) continue;
    addValues(field.type, base + field.byte * 8ULL + field.bit, path.empty() ? field.name : path + "." + field.name,
              range, values);
  }
}

const s7300::Structure* structureOf(const std::map<int, std::shared_ptr<const s7300::Structure>>& table, int block) {
  const auto found = table.find(block);
  return found == table.end() ? nullptr : found->second.get();
}

TypeKind onlyType(const std::vector<DeclaredValue>& values, BitRange range) {
  const bool isOne = values.size() == 1 && values[0].first == range.first && values[0].end == range.end;
  return isOne ? values[0].kind : TypeKind::Unknown;
}

/// The type of the symbol at just that address, of the width of the access.
TypeKind ofSymbol(const s7300::Declarations& declarations, const Operand& operand) {
  const auto found = declarations.symbolTypes.find({operand.area, operand.offset});
  if (found == declarations.symbolTypes.end() || operand.width == Width::Bit) return TypeKind::Unknown;
  s7300::Type type;
  type.kind = found->second;
  const bool isWhole = found->second != TypeKind::Bool && s7300::accessWidth(type) == operand.width;
  return isWhole ? found->second : TypeKind::Unknown;
}

}  // namespace

std::vector<DeclaredValue> valuesIn(const s7300::Structure& structure, BitRange range) {
  std::vector<DeclaredValue> values;
  addValues(structure, 0, {}, range, values);
  return values;
}

TypeKind declaredTypeOf(const Facts& facts, const Flow& flow, const Operand& operand) {
  const s7300::Declarations* declarations = facts.program().declarations.get();
  if (declarations == nullptr || !operand.isMemory()) return TypeKind::Unknown;
  const auto rangeFrom = [&](std::uint64_t byte) {
    const std::uint64_t first = byte * 8 + (operand.width == Width::Bit ? operand.bit : 0);
    return BitRange{first, first + static_cast<std::uint64_t>(bits(operand.width))};
  };
  const auto in = [&](const s7300::Structure* structure, std::uint64_t byte) {
    return structure == nullptr ? TypeKind::Unknown : onlyType(valuesIn(*structure, rangeFrom(byte)), rangeFrom(byte));
  };
  const int block = flow.pou->number;
  if (operand.reach == nullptr) {
    if (operand.area == Area::L) return in(structureOf(declarations->temporary, block), operand.offset);
    if (operand.kind != OperandKind::Direct) return TypeKind::Unknown;
    if (operand.area != Area::DB) return ofSymbol(*declarations, operand);
    const auto found = declarations->dataBlocks.find(blockOfByte(operand.offset));
    return found == declarations->dataBlocks.end() ? TypeKind::Unknown
                                                   : in(found->second.get(), byteInBlock(operand.offset));
  }
  const s7300::Structure* parameters = structureOf(declarations->parameters, block);
  if (operand.reach->way == Way::Instance) return in(parameters, operand.offset);
  if (operand.reach->way != Way::Parameter || parameters == nullptr) return TypeKind::Unknown;
  if (operand.reach->parameter >= flow.pou->locals.size()) return TypeKind::Unknown;
  const s7300::Field* field = parameters->field(flow.pou->locals[operand.reach->parameter].name);
  if (field == nullptr) return TypeKind::Unknown;
  std::vector<DeclaredValue> values;
  addValues(field->type, 0, field->name, rangeFrom(operand.offset), values);
  return onlyType(values, rangeFrom(operand.offset));
}

}  // namespace rungproof
