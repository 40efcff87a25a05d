// Names to places.
#include "frontend/step7/operand_binder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "frontend/step7/constant_spelling.hpp"
#include "frontend/step7/operand_parser.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/coverage.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof::step7 {

using s7300::ConstantKind;
using s7300::Field;
using s7300::PathFault;
using s7300::PathResult;
using s7300::Structure;
using s7300::Type;
using s7300::TypeKind;

namespace {

Width irWidth(Size size) { return static_cast<Width>(size); }

Area irArea(Place place) {
  switch (place) {
    case Place::I: return Area::I;
    case Place::Q: return Area::Q;
    case Place::M: return Area::M;
    case Place::PI: return Area::PI;
    case Place::PQ: return Area::PQ;
    case Place::L: return Area::L;
    case Place::T: return Area::T;
    case Place::C: return Area::C;
    default: return Area::DB;
  }
}

Shared<Reach> reachOf(Reach reach) { return Shared<Reach>(std::move(reach)); }

std::string stepText(const PathStep& step) {
  std::string text = step.name;
  for (std::size_t i = 0; i < step.indices.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "[" : ",", step.indices[i]);
  return step.indices.empty() ? text : text + "]";
}

std::string wholePath(const std::vector<PathStep>& path) {
  std::string text;
  for (const PathStep& step : path) text += (text.empty() ? "" : ".") + stepText(step);
  return text;
}

// What to do about a name that nothing defines, by what it names.
constexpr std::string_view localHelp =
    "declare it in a VAR section of the block, or write the name as it is declared there; its network is not covered";
constexpr std::string_view symbolHelp =
    "name the symbol table beside the sources (.sdf, .asc, .dif, .seq, .csv, or TIA tags as .xml), or a folder that "
    "holds all of them; its network is not covered";
constexpr std::string_view blockHelp =
    "name the source of the data block beside this one, and the symbol table that gives its number; its network is "
    "not covered";
constexpr std::string_view partHelp =
    "write the name and the indices as they are declared; a source that is older than the declaration has to be "
    "exported again; its network is not covered";

BoundOperand refused(Syntax code, Span span, std::string fault, std::string_view help = {}) {
  BoundOperand result;
  result.help = help;
  result.fault = std::move(fault);
  result.code = code;
  result.faultSpan = span;
  return result;
}

/// A value as a name of that type means it: -5 of a DINT is L#-5, 2 of a REAL 2.0.
Constant constantOfType(TypeKind kind, Constant value) {
  if (value.kind != ConstantKind::Integer) return value;
  if (kind == TypeKind::DInt) value.kind = ConstantKind::Long;
  if (kind == TypeKind::Real) {
    value.value = std::bit_cast<std::uint32_t>(static_cast<float>(value.value));
    value.kind = ConstantKind::Real;
  }
  return value;
}

BoundOperand badPath(const PathResult& found, const std::vector<PathStep>& path) {
  const PathStep& step = path[std::min(found.step, path.size() - 1)];
  const auto reason = [&]() -> std::string {
    switch (found.fault) {
      case PathFault::NoField: return fmt::format("nothing declares {}", step.name);
      case PathFault::NoStructure: return fmt::format("{} is no part: what stands before it has none", step.name);
      case PathFault::NoArray: return fmt::format("{} is no array", step.name);
      case PathFault::IndexCount: return fmt::format("{} has another number of dimensions", step.name);
      default: return fmt::format("the index of {} is outside of its bounds", stepText(step));
    }
  };
  return refused(Syntax::NameUndefined, step.span, reason(), partHelp);
}

BoundOperand constantBound(const Constant& value) {
  BoundOperand bound;
  bound.constant = value;
  const bool isReal = value.kind == s7300::ConstantKind::Real;
  bound.operand = constant(s7300::accumulatorBits(value), isReal ? ConstantForm::Real : ConstantForm::Typed);
  bound.operand.text = spellingOf(value);
  bound.operand.width = widthOfConstant(value);
  return bound;
}

}  // namespace

int irNumber(BlockKey key) {
  const auto type = [&] {
    switch (key.kind) {
      case BlockKind::Ob: return BlockType::Ob;
      case BlockKind::Fb: return BlockType::Fb;
      case BlockKind::Sfc: return BlockType::Sfc;
      case BlockKind::Sfb: return BlockType::Sfb;
      default: return BlockType::Fc;
    }
  };
  return blockNumber(type(), static_cast<int>(key.number));
}

bool isPointerKind(TypeKind kind) { return kind == TypeKind::Pointer || kind == TypeKind::Any; }

bool isNumberType(TypeKind kind) {
  return kind == TypeKind::Timer || kind == TypeKind::Counter || kind == TypeKind::BlockDb ||
         kind == TypeKind::BlockSdb || kind == TypeKind::BlockFc || kind == TypeKind::BlockFb;
}

BoundOperand OperandBinder::bind(const Operand& operand, BlockScope& scope) {
  BoundOperand result = [&] {
    switch (operand.form) {
      case OperandForm::Address: return operand.name.empty() ? address(operand, scope) : namedAddress(operand, scope);
      case OperandForm::Local: return local(operand, scope, operand.path);
      case OperandForm::Symbol: return symbol(operand, scope);
      case OperandForm::Indirect: return indirect(operand, scope);
      case OperandForm::Parameter: return parameterAddress(operand, scope);
      case OperandForm::Block: {
        const std::optional<BlockKey> key = catalogue_.keyOf(*operand.block);
        return blockNamed(*key, operand);
      }
      case OperandForm::Constant: return constantBound(operand.constant);
      case OperandForm::Word: {  // a local name without its sign
        const std::vector<PathStep> path = {{operand.name, {}, operand.span}};
        return local(operand, scope, path);
      }
      default: return BoundOperand{};
    }
  }();
  result.operand.span = operand.span;
  if (!result.fault.empty()) result.dataBlock = dataBlockOf(operand);
  if (!result.fault.empty() && result.faultSpan.length == 0) result.faultSpan = operand.span;
  return result;
}

/// The data block that stands before the place of an operand; 0: none, or it has no number.
std::uint32_t OperandBinder::dataBlockOf(const Operand& operand) const {
  const bool isSymbol = operand.form == OperandForm::Symbol && !operand.path.empty();
  if (!isSymbol && (operand.form != OperandForm::Address || !operand.block)) return 0;
  const std::optional<BlockKey> key =
      catalogue_.keyOf(operand.block ? *operand.block : BlockName{std::nullopt, 0, operand.name, operand.span});
  return key && key->kind == BlockKind::Db && key->number <= lastDataBlock ? key->number : 0;
}

BoundOperand OperandBinder::blockNamed(BlockKey key, const Operand& operand) {
  BoundOperand result;
  result.block = key;
  const bool isData = key.kind == BlockKind::Db;
  if (isData && (key.number == 0 || catalogue_.entry(key) == nullptr) && operand.form != OperandForm::None) {
    // OPN DB 0 and blocks that only the CPU has are the business of who uses the operand.
    result.operand = direct(Area::DB, Width::Byte, dataByte(std::min(key.number, lastDataBlock), 0));
  } else if (isData) {
    result.operand = direct(Area::DB, Width::Byte, dataByte(std::min(key.number, lastDataBlock), 0));
  } else {
    result.operand = constant(irNumber(key), ConstantForm::Typed);
    result.operand.text = catalogue_.nameOf(key);
  }
  if (operand.block && operand.block->kind == BlockKind::Di) {
    Reach reach{};
    reach.way = Way::OpenBlock;
    reach.inDi = true;
    result.operand.reach = reachOf(std::move(reach));
  }
  return result;
}

std::uint32_t freeLocalByte(const BlockScope& scope) {
  const std::uint32_t declared = static_cast<std::uint32_t>(scope.temporary->size + 1) & ~1U;
  return scope.key.kind == BlockKind::Ob ? std::max(declared, startInformationBytes) : declared;
}

BoundOperand OperandBinder::address(const Operand& operand, BlockScope& scope) {
  BoundOperand result;
  if (operand.block) {
    const std::optional<BlockKey> key = catalogue_.keyOf(*operand.block);
    if (!key)
      return refused(Syntax::NameUndefined, operand.block->span,
                     fmt::format("nothing defines {}", toString(*operand.block)), blockHelp);
    if (key->kind != BlockKind::Db)
      return refused(Syntax::Operand7, operand.block->span,
                     fmt::format("{} is no data block", toString(*operand.block)));
    if (catalogue_.entry(*key) == nullptr)
      return refused(Syntax::BlockMissing, operand.block->span,
                     fmt::format("{} is in none of the files", toString(*key)));
    if (key->number > lastDataBlock)
      return refused(Syntax::NotModelled, operand.block->span,
                     fmt::format("{} is above DB{}", toString(*key), lastDataBlock));
    if (types_.isOpaque(*key))
      return refused(Syntax::NotModelled, operand.block->span,
                     fmt::format("{}: {}", toString(*key), s7300::gapReason(s7300::Gap::SystemInstance)));
    result.operand = direct(Area::DB, irWidth(operand.size), dataByte(key->number, operand.number), operand.bit);
    return result;
  }
  std::uint32_t number = operand.number;
  if (operand.isBehindDeclared) number += freeLocalByte(scope);
  result.operand = direct(irArea(operand.place), irWidth(operand.size), number, operand.bit);
  if (operand.place == Place::DB || operand.place == Place::DI) {
    Reach reach{};
    reach.way = Way::OpenBlock;
    reach.inDi = operand.place == Place::DI;
    result.operand.kind = OperandKind::Indirect;
    result.operand.reach = reachOf(std::move(reach));
  }
  if (operand.place == Place::L) {
    const std::uint32_t end = number + static_cast<std::uint32_t>(bytes(irWidth(operand.size)));
    scope.localBytes = std::max(scope.localBytes, end);
  }
  return result;
}

BoundOperand OperandBinder::local(const Operand& operand, BlockScope& scope, const std::vector<PathStep>& path) {
  BoundOperand result;
  const PathResult temporary = lookUp(*scope.temporary, path);
  const bool isTemporary = temporary.field != nullptr;
  const PathResult found = isTemporary ? temporary : lookUp(*scope.parameters, path);
  if (found.field == nullptr) {
    if (const Field* named = path.size() == 1 ? scope.constants->field(path[0].name) : nullptr)
      return constantField(operand, *named);
    // TIA names the value of a function after the function.
    const bool isValue = scope.key.kind == BlockKind::Fc && path.size() == 1 && path[0].indices.empty() &&
                         s7300::isSameName(path[0].name, scope.name);
    if (isValue && scope.parameters->field("RET_VAL") != nullptr)
      return local(operand, scope, {{"RET_VAL", {}, path[0].span}});
    // Word without a sign that no declaration knows.
    return refused(Syntax::NameUndefined, path[0].span, fmt::format("nothing declares {}", path[0].name), localHelp);
  }
  if (found.fault != PathFault::None) return badPath(found, path);
  const Type& type = *found.type;
  if (type.kind == TypeKind::Unknown)
    return refused(Syntax::NameUndefined, operand.span, fmt::format("the type of {} is not known", wholePath(path)),
                   "name the source with its TYPE, FB or data block beside this one; its network is not covered");
  result.type = type;
  const std::optional<Width> width = s7300::accessWidth(type);
  result.operand = direct(Area::DB, width.value_or(Width::Byte), found.byte, found.bit);
  result.operand.text = "#" + wholePath(path);
  if (isTemporary) {
    result.operand.area = Area::L;
    return result;
  }
  result.operand.kind = OperandKind::Indirect;
  Reach reach{};
  const bool isInstance = scope.key.kind == BlockKind::Fb || scope.key.kind == BlockKind::Sfb;
  const bool byReference = !isInstance || found.byReference || isNumberType(found.field->type.kind);
  reach.way = byReference ? Way::Parameter : Way::Instance;
  if (byReference) {
    reach.parameter = static_cast<std::uint32_t>(found.field - scope.parameters->fields.data());
    if (isPointerKind(found.field->type.kind)) reach.way = Way::Handed;
    if (found.field->type.kind == TypeKind::Timer) result.operand.area = Area::T;
    if (found.field->type.kind == TypeKind::Counter) result.operand.area = Area::C;
    if (isNumberType(found.field->type.kind)) {
      result.operand.offset = 0;
      result.operand.bit = 0;
    }
  }
  result.operand.reach = reachOf(std::move(reach));
  return result;
}

BoundOperand OperandBinder::constantField(const Operand& operand, const Field& field) {
  std::vector<std::uint8_t> bytes(s7300::sizeOf(field.type));
  if (field.initial.size() != 1 || s7300::isComplex(field.type) ||
      s7300::writeValues(field.type, field.initial, 0, 0, bytes))
    return refused(Syntax::Operand7, operand.span, fmt::format("the constant {} has no value of its type", field.name));
  return constantBound(constantOfType(field.type.kind, field.initial[0]));
}

BoundOperand OperandBinder::dataField(const Operand& operand, BlockKey block) {
  if (catalogue_.entry(block) == nullptr)
    return refused(Syntax::BlockMissing, operand.span, fmt::format("{} is in none of the files", toString(block)));
  if (block.number > lastDataBlock)
    return refused(Syntax::NotModelled, operand.span, fmt::format("{} is above DB{}", toString(block), lastDataBlock));
  const std::shared_ptr<const Structure> structure = types_.structure(block);
  if (structure == nullptr || !types_.isKnown(block))
    return refused(Syntax::NameUndefined, operand.span,
                   fmt::format("the declaration of {} is not known", toString(block)), blockHelp);
  const PathResult found = lookUp(*structure, operand.path);
  if (found.fault != PathFault::None) return badPath(found, operand.path);
  if (found.byReference)
    return refused(Syntax::Operand7, operand.span,
                   fmt::format("{} is handed on by pointer and reached in its block only", operand.path[0].name));
  BoundOperand result;
  result.type = *found.type;
  const std::optional<Width> width = s7300::accessWidth(*found.type);
  result.operand = direct(Area::DB, width.value_or(Width::Byte), dataByte(block.number, found.byte), found.bit);
  const std::string_view mark = operand.block ? "" : "\"";  // DB10.speed
  result.operand.text = fmt::format("{0}{1}{0}.{2}", mark, operand.name, wholePath(operand.path));
  return result;
}

/// "Motor":Q4.0: where the table knows the name, it has to have the same address.
BoundOperand OperandBinder::namedAddress(const Operand& operand, BlockScope& scope) {
  BoundOperand written = address(operand, scope);
  const SymbolRow* row = written.fault.empty() ? catalogue_.symbol(operand.name) : nullptr;
  if (row == nullptr) return written;
  const bool isAddress = row->address.form == OperandForm::Address;
  BoundOperand known = isAddress ? symbol(operand, scope) : BoundOperand{};
  const auto shown = [](rungproof::Operand place) {
    place.text = std::string();
    return toString(place);
  };
  if (!isAddress || !known.fault.empty() || shown(known.operand) != shown(written.operand))
    return refused(Syntax::Operand7, operand.span,
                   fmt::format("the symbol table has another address for \"{}\" than {}, which is written here",
                               operand.name, shown(written.operand)));
  return known;
}

BoundOperand OperandBinder::symbol(const Operand& operand, BlockScope& scope) {
  const BlockName name{std::nullopt, 0, operand.name, operand.span};
  const std::optional<BlockKey> key = catalogue_.keyOf(operand.block ? *operand.block : name);
  if (!operand.path.empty()) {
    if (!key || key->kind != BlockKind::Db)
      return refused(Syntax::NameUndefined, operand.span,
                     fmt::format("nothing defines the data block \"{}\"", operand.name), blockHelp);
    return dataField(operand, *key);
  }
  const SymbolRow* row = catalogue_.symbol(operand.name);
  if (row != nullptr && row->address.form == OperandForm::Constant) {
    Field field;
    field.name = row->name.text;
    field.type = s7300::typeNamed(row->type).value_or(s7300::Type{});
    field.initial = {row->address.constant};
    return constantField(operand, field);
  }
  if (row != nullptr && row->address.form == OperandForm::Address) {
    BoundOperand result = address(row->address, scope);
    if (operand.isPeripheral) {
      const Area area = result.operand.area;
      if ((area != Area::I && area != Area::Q) || result.operand.width == Width::Bit)
        return refused(Syntax::Operand7, operand.span, std::string(peripheralRule));
      result.operand.area = area == Area::I ? Area::PI : Area::PQ;
      return result;
    }
    result.operand.text = row->name.text;
    result.type = s7300::typeNamed(row->type);
    return result;
  }
  if (key) {
    BoundOperand result = blockNamed(*key, operand);
    return result;
  }
  return refused(Syntax::NameUndefined, operand.span, fmt::format("nothing defines \"{}\"", operand.name), symbolHelp);
}

BoundOperand OperandBinder::indirect(const Operand& operand, BlockScope& scope) {
  BoundOperand result;
  rungproof::Operand& bound = result.operand;
  bound.kind = OperandKind::Indirect;
  bound.area = operand.block ? Area::DB : irArea(operand.place);
  bound.width = irWidth(operand.size);
  Reach reach{};
  reach.inDi = operand.place == Place::DI || (operand.block && operand.block->kind == BlockKind::Di);
  if (operand.addressRegister != 0) {
    reach.way = operand.crossesAreas ? Way::Crossing : Way::Register;
    reach.byAr2 = operand.addressRegister == 2;
    bound.offset = operand.offset >> 3;
    bound.bit = static_cast<std::uint8_t>(operand.offset & 7U);
    if (bound.width != Width::Bit && bound.bit != 0)
      return refused(Syntax::Operand7, operand.span, "the offset of a byte or word has no bit part");
    if (!operand.crossesAreas && (operand.place == Place::T || operand.place == Place::C))
      return refused(Syntax::Operand7, operand.span, "timers and counters have no address registers");
    bound.reach = reachOf(std::move(reach));
    return result;
  }
  BoundOperand pointer = bind(*operand.pointer, scope);
  if (!pointer.fault.empty()) return pointer;
  if (const std::string* name =
          operand.block && operand.block->kind ? catalogue_.withoutNumber(*operand.block->kind) : nullptr)
    return refused(
        Syntax::BlockMissing, operand.span,
        fmt::format("this number may be that of \"{}\", and no file says which number that block has", *name),
        "add the symbol table, or write the number in the head of the block");
  const bool isNumber = operand.block || operand.place == Place::T || operand.place == Place::C;
  const Width wanted = isNumber ? Width::Word : Width::DWord;
  if (!pointer.operand.isMemory() || pointer.operand.width != wanted ||
      (pointer.type && isNumberType(pointer.type->kind)))
    return refused(Syntax::Operand7, operand.pointer->span,
                   isNumber ? "the number stands in a word" : "the pointer stands in a double word");
  reach.way = Way::Pointer;
  reach.pointer = pointer.operand;
  bound.reach = reachOf(std::move(reach));
  if (operand.block) {
    const BlockKind kind = *operand.block->kind;
    result.block = BlockKey{kind == BlockKind::Di ? BlockKind::Db : kind, 0};
    bound.width = Width::Byte;
    if (kind != BlockKind::Db && kind != BlockKind::Di) bound.value = irNumber(*result.block);
  }
  return result;
}

BoundOperand OperandBinder::parameterAddress(const Operand& operand, BlockScope& scope) {
  BoundOperand result = local(operand, scope, operand.path);
  if (!result.fault.empty()) return result;
  result.operand.kind = OperandKind::Address;
  result.operand.text = "P#" + result.operand.text;
  const bool isReferred = result.operand.reach != nullptr &&
                          (result.operand.reach->way == Way::Parameter || result.operand.reach->way == Way::Handed);
  if (isReferred) result.operand.area = Area::V;
  // Of a complex type the call makes a pointer, which stands for the whole; elementary ones have no address.
  if (isReferred && operand.path.size() == 1 && operand.path[0].indices.empty() && s7300::isComplex(*result.type)) {
    Reach reach = *result.operand.reach;
    reach.way = Way::Handed;
    result.operand.reach = reachOf(std::move(reach));
  }
  result.type.reset();
  return result;
}

}  // namespace rungproof::step7
