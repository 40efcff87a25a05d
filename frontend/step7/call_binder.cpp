// Calls: the block, its instance, and one operand for each of its parameters (002:145-247).
#include <fmt/format.h>

#include <algorithm>

#include "frontend/step7/library_source.hpp"
#include "frontend/step7/statement_binder.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/coverage.hpp"
#include "ir/s7300/declarations.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/pointer_code.hpp"

namespace rungproof::step7 {

using s7300::Field;
using s7300::Structure;
using s7300::Type;
using s7300::TypeKind;

namespace {

bool isParameter(const Field& field) { return field.section <= Section::InOut; }

rungproof::Operand missingOperand(Span span) {
  rungproof::Operand operand;
  operand.kind = OperandKind::Missing;
  operand.span = span;
  return operand;
}

/// The bits of a constant as a value of the type, or nothing if it is none.
std::optional<std::int64_t> bitsOfType(const Type& type, const Constant& value) {
  if (s7300::isComplex(type)) return std::nullopt;
  std::vector<std::uint8_t> bytes(s7300::sizeOf(type));
  if (bytes.size() > 4 || s7300::writeValues(type, std::span(&value, 1), 0, 0, bytes)) return std::nullopt;
  std::int64_t bits = 0;
  for (const std::uint8_t byte : bytes) bits = bits << 8 | byte;
  return bits;
}

bool actsBeyondParameters(BlockKey callee) {
  if (callee.kind != BlockKind::Sfc && callee.kind != BlockKind::Sfb) return false;
  const auto numbers =
      callee.kind == BlockKind::Sfc ? s7300::functionsBeyondParameters() : s7300::blocksBeyondParameters();
  return std::ranges::find(numbers, callee.number) != numbers.end();
}

/// What a call of an FB hands over by name or by a pointer instead of copying it into the instance.
bool isHandedBesideInstance(const Type& type) {
  const bool isNumber = type.kind == TypeKind::Timer || type.kind == TypeKind::Counter ||
                        type.kind == TypeKind::BlockDb || type.kind == TypeKind::BlockFc ||
                        type.kind == TypeKind::BlockFb || type.kind == TypeKind::BlockSdb;
  return isNumber || isPointerKind(type.kind) || s7300::isComplex(type);
}

/// A pointer, or a variable of complex type: a block that works over many scans may write there in between.
bool hasMemoryOfItsOwn(const BoundOperand& bound) {
  if (bound.constant)
    return bound.constant->kind == s7300::ConstantKind::Pointer || bound.constant->kind == s7300::ConstantKind::Any;
  return bound.type && (isPointerKind(bound.type->kind) || s7300::isComplex(*bound.type));
}

bool isModelledBlock(BlockKey callee) {
  const s7300::LibraryBlock* block = s7300::libraryBlock(blockTypeOf(irNumber(callee)), callee.number);
  return block != nullptr && isModelled(*block);
}

}  // namespace

std::shared_ptr<const Structure> StatementBinder::parametersOf(BlockKey callee) {
  if (const CatalogueEntry* entry = catalogue_.entry(callee))
    return callee.kind == BlockKind::Fb || callee.kind == BlockKind::Sfb ? types_.structure(callee)
                                                                         : types_.parameters(*entry->syntax);
  const BlockType type = blockTypeOf(irNumber(callee));
  const s7300::LibraryBlock* library = s7300::libraryBlock(type, callee.number);
  return library != nullptr ? s7300::interfaceOf(*library) : nullptr;
}

/// An SFC or SFB that no table describes: what its calls name are its parameters, each of any type and in either
/// direction.
bool StatementBinder::isUndescribed(BlockKey callee) const {
  constexpr std::uint32_t lastNumber = 255;
  const bool isOfSystem = callee.kind == BlockKind::Sfc || callee.kind == BlockKind::Sfb;
  return isOfSystem && callee.number <= lastNumber && catalogue_.entry(callee) == nullptr &&
         s7300::libraryBlock(blockTypeOf(irNumber(callee)), callee.number) == nullptr && !actsBeyondParameters(callee);
}

/// Data of an instance of which nothing is known.
bool StatementBinder::refuseOpaque(const BoundOperand& operand, Span span) {
  if (!operand.block || !types_.isOpaque(*operand.block)) return false;
  refuse(Syntax::NotModelled, span,
         fmt::format("{}: {}", toString(*operand.block), s7300::gapReason(s7300::Gap::SystemInstance)));
  return true;
}

std::shared_ptr<const Structure> StatementBinder::undescribedInterface(BlockKey callee) const {
  const auto found = undescribed_.find(callee);
  return found == undescribed_.end() ? nullptr : found->second;
}

void StatementBinder::noteParameters(BlockKey callee, const Statement& statement) {
  std::shared_ptr<Structure>& structure = undescribed_[callee];
  if (structure == nullptr) structure = std::make_shared<Structure>();
  for (const Argument& argument : statement.arguments) {
    if (structure->field(argument.formal.text) != nullptr) continue;
    Field field;
    field.name = argument.formal.text;
    field.type.kind = TypeKind::Any;
    field.section = Section::InOut;
    field.byReference = callee.kind == BlockKind::Sfb;
    field.span = argument.formal.span;
    structure->fields.push_back(std::move(field));
  }
}

bool StatementBinder::call(const Desc& desc, const Statement& statement) {
  if (statement.operand.form == OperandForm::None)
    return refuse(Syntax::Operand7, statement.mnemonic.span, fmt::format("{} needs a block", statement.mnemonic.text));
  BoundOperand target;
  if (statement.operand.form == OperandForm::Word) {  // CALL TON: a block by its usual name
    const std::optional<BlockKey> key =
        catalogue_.keyOf(BlockName{std::nullopt, 0, statement.operand.name, statement.operand.span});
    if (key) {
      target.block = key;
      target.operand = constant(irNumber(*key), ConstantForm::Typed);
      target.operand.text = statement.operand.name;
    }
  }
  if (!target.block) target = operands_.bind(statement.operand, *scope_);
  if (!target.fault.empty()) return refuse(target);
  target.operand.span = statement.operand.span;
  const bool isIndirect = target.operand.kind == OperandKind::Indirect;
  // CALL #instance: the multi-instance says which block it is.
  const bool isMultiInstance = target.type && target.type->kind == TypeKind::Struct && !target.type->name.empty();
  if (isIndirect && !isMultiInstance) return indirectCall(desc, statement, std::move(target));
  if (isMultiInstance) {
    const std::string& name = target.type->name;
    const bool isSystem = name.starts_with("SFB");
    if (!isSystem && !name.starts_with("FB"))
      return refuse(Syntax::Operand7, statement.operand.span,
                    fmt::format("{} is no instance of a block", target.operand.text));
    target.block = BlockKey{isSystem ? BlockKind::Sfb : BlockKind::Fb,
                            static_cast<std::uint32_t>(std::stoul(name.substr(name.find(' ') + 1)))};
  }
  const std::string& mnemonic = statement.mnemonic.text;
  // CALL "Motor_1" of a drawing: an instance by itself, which says whose it is.
  std::optional<rungproof::Operand> ownInstance;
  if (target.block && target.block->kind == BlockKind::Db && statement.operand.form == OperandForm::Symbol &&
      statement.operand.path.empty() && statement.instance.form == OperandForm::None) {
    const CatalogueEntry* entry = catalogue_.entry(*target.block);
    if (const auto of = entry != nullptr ? types_.instanceOf(*entry->syntax) : std::nullopt) {
      ownInstance = target.operand;
      ownInstance->reach = nullptr;
      ownInstance->text = statement.operand.name;
      target.block = of;
    }
  }
  if (!target.block || target.block->kind == BlockKind::Db || target.block->kind == BlockKind::Ob ||
      target.block->kind == BlockKind::Udt)
    return refuse(Syntax::Operand7, statement.operand.span, fmt::format("{} takes an FC, FB, SFC or SFB", mnemonic));
  const BlockKey callee = *target.block;
  if (actsBeyondParameters(callee) && catalogue_.entry(callee) == nullptr)
    return refuse(Syntax::LibraryBlock, statement.operand.span,
                  fmt::format("what {} does besides its parameters is not modelled", toString(callee)));
  // Of a system block that a project declares, the interface is known and what it does is not.
  if (callee.kind == BlockKind::Sfb && catalogue_.entry(callee) != nullptr)
    return refuse(Syntax::LibraryBlock, statement.operand.span,
                  fmt::format("what {} does is not modelled", toString(callee)));
  if (isUndescribed(callee)) noteParameters(callee, statement);
  const std::shared_ptr<const Structure> parameters =
      isUndescribed(callee) ? undescribedInterface(callee) : parametersOf(callee);
  // The number of a library FC is no library call unless the parameters are those of the library.
  const bool isOtherFc =
      parameters != nullptr && callee.kind == BlockKind::Fc && catalogue_.entry(callee) == nullptr &&
      (statement.arguments.empty() || std::ranges::any_of(statement.arguments, [&](const Argument& argument) {
         return parameters->field(argument.formal.text) == nullptr;
       }));
  if (parameters == nullptr || isOtherFc)
    return miss(Syntax::BlockMissing, statement.operand.span,
                fmt::format("{} is in none of the files", toString(callee)), standInHelp);
  const bool isBlockWithInstance = callee.kind == BlockKind::Fb || callee.kind == BlockKind::Sfb;
  Instruction instruction;
  rungproof::Operand number = constant(irNumber(callee), ConstantForm::Typed);
  number.text = catalogue_.nameOf(callee);
  number.span = statement.operand.span;
  instruction.operands.push_back(std::move(number));
  if (mnemonic != "CALL") {
    if (statement.hasArguments)
      return refuse(Syntax::CallList, statement.operand.span,
                    fmt::format("what {} gives in braces is not known", mnemonic));
    // An FB works on the data that DI and AR2 name; the editor looks at no parameters (002:246). Those of which the
    // instance holds no value have none.
    const bool isFb = callee.kind == BlockKind::Fb;
    const bool lacksSome = std::ranges::any_of(parameters->fields, [&](const Field& field) {
      return isParameter(field) && (!isFb || isHandedBesideInstance(field.type));
    });
    if (callee.kind == BlockKind::Sfb || lacksSome)
      return refuse(Syntax::CallList, statement.operand.span,
                    fmt::format("{} gives no parameters, but {} has some", mnemonic, toString(callee)));
    if (isFb) {
      append(desc, statement, std::move(instruction.operands));
      return true;
    }
  } else if (isBlockWithInstance) {
    std::optional<rungproof::Operand> instance = ownInstance       ? ownInstance
                                                 : isMultiInstance ? std::optional(target.operand)
                                                                   : instanceOf(statement, callee);
    if (!instance) return false;
    instance->width = Width::Byte;
    instruction.operands.push_back(std::move(*instance));
  } else if (statement.instance.form != OperandForm::None) {
    return refuse(Syntax::Operand7, statement.instance.span,
                  fmt::format("{} has no instance data block", toString(callee)));
  }
  if (!arguments(statement, callee, *parameters, instruction)) return false;
  if (catalogue_.entry(callee) == nullptr && !isModelledBlock(callee) && !isUndescribed(callee))
    return refuse(Syntax::LibraryBlock, statement.operand.span,
                  fmt::format("what {} of the library does is not modelled", toString(callee)));
  append(desc, statement, std::move(instruction.operands));
  return true;
}

/// UC FC[MW10], UC FB[MW10], UC #block: which block it is, the run decides. An FB works on the data that DI and AR2
/// name (002:246).
bool StatementBinder::indirectCall(const Desc& desc, const Statement& statement, BoundOperand target) {
  const std::string& mnemonic = statement.mnemonic.text;
  const bool byNumber = target.block && (target.block->kind == BlockKind::Fc || target.block->kind == BlockKind::Fb);
  const bool byParameter = target.type && target.type->kind == TypeKind::BlockFc;
  if (mnemonic == "CALL" || (!byNumber && !byParameter))
    return refuse(Syntax::Operand7, statement.operand.span,
                  fmt::format("{} does not call such a block", mnemonic == "CALL" ? "CALL" : mnemonic));
  if (statement.hasArguments)
    return refuse(Syntax::CallList, statement.operand.span, fmt::format("{} gives no parameters", mnemonic));
  append(desc, statement, {std::move(target.operand)});
  return true;
}

std::optional<rungproof::Operand> StatementBinder::instanceOf(const Statement& statement, BlockKey callee) {
  const Operand& written = statement.instance;
  if (written.form == OperandForm::None) {
    refuse(Syntax::CallList, statement.operand.span, fmt::format("{} needs an instance data block", toString(callee)));
    return std::nullopt;
  }
  BoundOperand bound = operands_.bind(written, *scope_);
  if (!bound.fault.empty()) {
    refuse(bound);
    return std::nullopt;
  }
  if (!bound.block || bound.block->kind != BlockKind::Db) {
    refuse(Syntax::Operand7, written.span, "an instance is a data block");
    return std::nullopt;
  }
  const CatalogueEntry* entry = catalogue_.entry(*bound.block);
  if (entry == nullptr) {
    miss(Syntax::BlockMissing, written.span, fmt::format("{} is in none of the files", toString(*bound.block)));
    return std::nullopt;
  }
  if (bound.block->number > lastDataBlock) {
    refuse(Syntax::NotModelled, written.span, fmt::format("{} is above DB{}", toString(*bound.block), lastDataBlock));
    return std::nullopt;
  }
  if (types_.instanceOf(*entry->syntax) != callee) {
    refuse(Syntax::CallList, written.span,
           fmt::format("{} is no instance of {}", toString(*bound.block), toString(callee)));
    reports_.relate(entry->syntax->heading, "the data block");
    return std::nullopt;
  }
  bound.operand.reach = nullptr;
  bound.operand.text = written.form == OperandForm::Symbol ? written.name : "";
  return bound.operand;
}

bool StatementBinder::arguments(const Statement& statement, BlockKey callee, const Structure& parameters,
                                Instruction& instruction) {
  bool isWhole = true;
  std::map<std::string, const Argument*> given;
  for (const Argument& argument : statement.arguments) {
    const Field* field = parameters.field(argument.formal.text);
    if (field == nullptr || !isParameter(*field)) {
      isWhole = refuse(Syntax::CallList, argument.formal.span,
                       fmt::format("{} has no parameter {}", toString(callee), argument.formal.text));
    } else if (!given.emplace(s7300::foldedName(argument.formal.text), &argument).second) {
      isWhole = refuse(Syntax::CallList, argument.formal.span, fmt::format("{} is given twice", argument.formal.text));
    }
  }
  const bool needsAll = (callee.kind == BlockKind::Fc || callee.kind == BlockKind::Sfc) && !isUndescribed(callee);
  for (const Field& field : parameters.fields) {
    if (!isParameter(field)) continue;
    const auto found = given.find(s7300::foldedName(field.name));
    const bool isGiven = found != given.end() && found->second->actual.form != OperandForm::None;
    if (!isGiven) {
      // What an FB is not given stays in its instance; places that it takes by reference have to be given.
      const bool isReferred = field.byReference && !isUndescribed(callee);
      if (statement.mnemonic.text == "CALL" && (needsAll || isReferred || isNumberType(field.type.kind))) {
        isWhole = refuse(Syntax::CallList, statement.operand.span,
                         fmt::format("{} needs a value for {}", toString(callee), field.name));
      }
      instruction.operands.push_back(missingOperand(statement.operand.span));
      continue;
    }
    std::optional<rungproof::Operand> operand = actual(*found->second, field, callee);
    if (!operand) isWhole = false;
    instruction.operands.push_back(operand ? std::move(*operand) : missingOperand(found->second->span));
  }
  return isWhole;
}

/// P#DB10.DBX 240.0 for a parameter of complex type: a variable of that type that begins there.
std::optional<rungproof::Operand> StatementBinder::placeOfPointer(const BoundOperand& bound, const Field& formal,
                                                                  BlockKey callee, Span span) {
  const Constant& pointer = *bound.constant;
  const auto bits = static_cast<std::uint32_t>(pointer.value);
  const auto code = static_cast<PointerArea>(bits >> 24 & 7U);
  const std::uint32_t byte = (bits & 0x7FFFFU) >> 3;
  const auto fail = [&](Syntax error, std::string message) {
    refuse(error, span, std::move(message));
    return std::nullopt;
  };
  const bool hasArea = (bits & 0x80000000U) != 0 && (code != PointerArea::Db || pointer.block != 0);
  if (!hasArea || (bits & 7U) != 0 || code == PointerArea::P || code == PointerArea::Di || code == PointerArea::V)
    return fail(Syntax::CallList, fmt::format("{} of {} takes a pointer to a whole byte, such as P#DB10.DBX 240.0",
                                              formal.name, toString(callee)));
  // How much of a text is copied, its own declaration would say.
  if (formal.type.kind == TypeKind::String && callee.kind == BlockKind::Fb && !formal.byReference)
    return fail(Syntax::NotModelled, fmt::format("{} of {}: the length of the text is not known: how it is copied is "
                                                 "not modelled",
                                                 formal.name, toString(callee)));
  const std::uint64_t end = byte + s7300::sizeOf(formal.type);
  if (code == PointerArea::Db) {
    const BlockKey block{BlockKind::Db, pointer.block};
    const CatalogueEntry* entry = catalogue_.entry(block);
    if (entry == nullptr) {
      miss(Syntax::BlockMissing, span, fmt::format("{} is in none of the files", toString(block)));
      return std::nullopt;
    }
    if (pointer.block > lastDataBlock)
      return fail(Syntax::NotModelled, fmt::format("{} is above DB{}", toString(block), lastDataBlock));
    BoundOperand opaque;
    opaque.block = block;
    if (refuseOpaque(opaque, span)) return std::nullopt;
    const std::shared_ptr<const Structure> structure = types_.structure(block);
    if (structure != nullptr && types_.isKnown(block) && end > structure->size)
      return fail(Syntax::CallList, fmt::format("{} of {} takes {} bytes, and {} has {}", formal.name, toString(callee),
                                                s7300::sizeOf(formal.type), toString(block), structure->size));
    rungproof::Operand place = direct(Area::DB, Width::Byte, dataByte(pointer.block, byte));
    place.span = span;
    return place;
  }
  constexpr Area areas[] = {Area::PI, Area::I, Area::Q, Area::M, Area::DB, Area::DB, Area::L, Area::L};
  rungproof::Operand place = direct(areas[static_cast<std::size_t>(code)], Width::Byte, byte);
  place.span = span;
  if (code == PointerArea::L) scope_->localBytes = std::max(scope_->localBytes, static_cast<std::uint32_t>(end));
  return place;
}

std::optional<rungproof::Operand> StatementBinder::actual(const Argument& argument, const Field& formal,
                                                          BlockKey callee) {
  const Span span = argument.actual.span;
  const auto fail = [&](std::string message) {
    refuse(Syntax::CallList, span, std::move(message));
    return std::nullopt;
  };
  BoundOperand bound = operands_.bind(argument.actual, *scope_);
  if (!bound.fault.empty()) {
    refuse(bound);
    return std::nullopt;
  }
  const Type& type = formal.type;
  const std::string wanted = s7300::toString(type);
  if (refuseOpaque(bound, span)) return std::nullopt;
  if (callee.kind == BlockKind::Sfb && isUndescribed(callee) && hasMemoryOfItsOwn(bound)) {
    refuse(Syntax::NotModelled, span,
           fmt::format("{} of {}: {}", formal.name, toString(callee), s7300::gapReason(s7300::Gap::SystemInstance)));
    return std::nullopt;
  }
  if (isPointerKind(type.kind)) return pointerActual(argument, bound, formal, isUndescribed(callee));
  if (bound.operand.kind == OperandKind::Address) return fail(fmt::format("{} takes no pointer", formal.name));
  if (isNumberType(type.kind)) {
    const bool fits = [&] {
      if (bound.type) return bound.type->kind == type.kind;
      switch (type.kind) {
        case TypeKind::Timer: return bound.operand.area == Area::T && bound.operand.isMemory() && !bound.block;
        case TypeKind::Counter: return bound.operand.area == Area::C && bound.operand.isMemory() && !bound.block;
        case TypeKind::BlockDb: return bound.block && bound.block->kind == BlockKind::Db;
        case TypeKind::BlockFc: return bound.block && bound.block->kind == BlockKind::Fc;
        case TypeKind::BlockFb: return bound.block && bound.block->kind == BlockKind::Fb;
        default: return false;
      }
    }();
    if (!fits) return fail(fmt::format("{} of {} takes a {}", formal.name, toString(callee), wanted));
    return std::move(bound.operand);
  }
  if (bound.block) return fail(fmt::format("{} of {} takes a {}", formal.name, toString(callee), wanted));
  if (bound.constant && s7300::isComplex(type) && bound.constant->kind == s7300::ConstantKind::Pointer)
    return placeOfPointer(bound, formal, callee, span);
  if (bound.constant) {
    if (formal.section != Section::Input)
      return fail(fmt::format("{} of {} takes no constant: the block writes it", formal.name, toString(callee)));
    const std::optional<std::int64_t> bits = bitsOfType(type, *bound.constant);
    if (!bits) return fail(fmt::format("the value for {} is no {}", formal.name, wanted));
    bound.operand.value = *bits;
    bound.operand.width = s7300::accessWidth(type).value_or(Width::DWord);
    return std::move(bound.operand);
  }
  if (s7300::isComplex(type)) {
    if (!bound.type || bound.type->kind != type.kind ||
        (type.kind != TypeKind::String && !s7300::isSameType(*bound.type, type)))
      return fail(fmt::format("{} of {} takes {} of the same shape, by name", formal.name, toString(callee), wanted));
    const bool isCopied = callee.kind == BlockKind::Fb && !formal.byReference;
    if (isCopied && type.kind == TypeKind::String && type.length != bound.type->length) {
      refuse(
          Syntax::NotModelled, span,
          fmt::format("{} of {} has another length: how it is copied is not modelled", formal.name, toString(callee)));
      return std::nullopt;
    }
    return std::move(bound.operand);
  }
  if (bound.type && s7300::isComplex(*bound.type))
    return fail(
        fmt::format("{} of {} takes {}, not {}", formal.name, toString(callee), wanted, s7300::toString(*bound.type)));
  const Width width = s7300::accessWidth(type).value_or(Width::DWord);
  const bool isElement = bound.operand.area == Area::T || bound.operand.area == Area::C;
  if (bound.operand.width != width || isElement)
    return fail(fmt::format("{} of {} is {}: the operand has another width", formal.name, toString(callee), wanted));
  if (formal.section != Section::Input && bound.operand.area == Area::PI)
    return fail(fmt::format("{} of {} is written, and inputs of modules are not", formal.name, toString(callee)));
  return std::move(bound.operand);
}

}  // namespace rungproof::step7
