// Names and addresses of SCL as operands of statements, and elements of arrays whose index is computed: the address is
// what the CPU computes, over the bounds of the declaration; an index outside of them is a hazard of its own.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "frontend/step7/operand_parser.hpp"
#include "frontend/step7/scl_lowering.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/index_check.hpp"

namespace rungproof::step7 {

using s7300::ConstantKind;
using s7300::TypeKind;

namespace {

std::string sclBareName(std::string_view name) {
  if (name.starts_with('#')) name.remove_prefix(1);
  if (name.size() > 1 && name.starts_with('"') && name.ends_with('"')) name = name.substr(1, name.size() - 2);
  return std::string(name);
}

/// D0, DX0, DBX0, DW2, DBW2 ...: a place of a data block by its address.
bool readDataAddress(std::string_view name, Operand& operand) {
  std::string upper = iec::foldedName(name);
  if (upper.starts_with('%')) upper.erase(0, 1);
  const std::size_t digit = upper.find_first_of("0123456789");
  if (digit == std::string::npos || digit == 0 || upper.find_first_not_of("0123456789", digit) != std::string::npos)
    return false;
  std::string letters = upper.substr(0, upper.find_first_of(" \t0123456789"));
  if (letters.starts_with("DB") && letters.size() == 3) letters.erase(1, 1);
  operand.size = letters == "DW"   ? Size::Word
                 : letters == "DD" ? Size::DWord
                 : letters == "DB" ? Size::Byte
                                   : Size::Bit;
  if (letters != "D" && letters != "DX" && letters != "DB" && letters != "DW" && letters != "DD") return false;
  operand.place = Place::DB;
  operand.number = static_cast<std::uint32_t>(std::min(std::stoul(upper.substr(digit).substr(0, 9)), 70000UL));
  return true;
}

std::optional<std::uint32_t> dataBlockNumber(std::string_view name) {
  Cursor cursor(name, 0);
  const std::optional<BlockName> block = readBlockName(cursor);
  if (!block || block->kind != BlockKind::Db || !cursor.atEnd()) return std::nullopt;
  return block->number;
}

}  // namespace

bool SclLowering::isLocal(std::string_view name) const {
  if (name.starts_with('#')) return true;
  if (name.starts_with('"')) return false;
  return scope_.temporary->field(name) != nullptr || scope_.parameters->field(name) != nullptr ||
         scope_.constants->field(name) != nullptr ||
         (scope_.key.kind == BlockKind::Fc && s7300::isSameName(name, scope_.name));
}

BoundOperand SclLowering::bound(const Operand& operand) {
  BoundOperand made = operands_.bind(operand, scope_);
  if (!made.fault.empty()) {
    reports_.reportOnce(made.code, made.faultSpan, made.fault, scope_.name, network_->number, std::string(made.help));
    throw Refused{made.code == Syntax::NameUndefined};
  }
  return made;
}

SclLowering::Kind SclLowering::kindOf(const BoundOperand& bound, Span span, bool& isUntyped) {
  if (bound.constant) refuse(span, fmt::format("{} is a constant", written(span)), Syntax::SclType);
  if (bound.block) refuse(span, fmt::format("{} is a block and has no value", written(span)), Syntax::SclType);
  if (bound.type) {
    if (sclBits(bound.type->kind) == 0)
      refuse(span,
             fmt::format("{} is {}, which is not covered as a value", written(span), s7300::toString(*bound.type)));
    return bound.type->kind;
  }
  if (bound.operand.area == Area::T || bound.operand.area == Area::C) return Kind::Bool;
  isUntyped = true;
  switch (bound.operand.width) {
    case Width::Bit: isUntyped = false; return Kind::Bool;
    case Width::Byte: return Kind::Byte;
    case Width::Word: return Kind::Word;
    default: return Kind::DWord;
  }
}

/// I0.0, E0.0, MW10, T5, DB10.DW2, "Data".DBX0.0.
std::optional<Operand> SclLowering::absolute(const iec::Expr& expr) {
  using PartKind = iec::PathPart::Kind;
  const std::vector<iec::PathPart>& parts = expr.parts;
  Operand operand;
  operand.span = expr.span;
  const bool isSlice = parts.back().kind == PartKind::Bit && parts.back().isSlice;
  const bool hasBit = parts.back().kind == PartKind::Bit && parts.back().bits == 1 && !isSlice;
  const std::size_t names = parts.size() - (hasBit || isSlice ? 1 : 0);
  // Without a bit D0 and DX0 are names of data.
  const auto isPlace = [&] { return readDataAddress(parts[1].name, operand) && (hasBit || operand.size != Size::Bit); };
  if (names == 2 && parts[1].kind == PartKind::Name && isPlace()) {
    const std::optional<std::uint32_t> number = dataBlockNumber(parts[0].name);
    const bool isSymbol = parts[0].name.starts_with('"');
    if (number || isSymbol) {
      operand.form = OperandForm::Address;
      operand.block = number ? BlockName{BlockKind::Db, *number, {}, parts[0].span}
                             : BlockName{std::nullopt, 0, sclBareName(parts[0].name), parts[0].span};
      if (hasBit != (operand.size == Size::Bit) || (hasBit && parts.back().bit > 7))
        refuse(expr.span, fmt::format("{} is no address", written(expr.span)), Syntax::SclText);
      operand.bit = static_cast<std::uint8_t>(hasBit ? parts.back().bit : 0);
      return operand;
    }
  }
  if (names != 1 || parts[0].name.starts_with('"') || parts[0].name.starts_with('#')) return std::nullopt;
  std::string text = parts[0].name;
  if (hasBit) text += fmt::format(".{}", parts.back().bit);
  for (const MnemonicSet set : {MnemonicSet::International, MnemonicSet::German}) {
    Cursor cursor(text, expr.span.file);
    OperandOutcome outcome = readOperand7(cursor, {set, TextEncoding::Utf8});
    const bool isPlace = outcome.operand.form == OperandForm::Address || outcome.operand.form == OperandForm::Block;
    if (!isPlace || !cursor.atEnd()) continue;
    if (!outcome.fault.empty()) refuse(expr.span, outcome.fault, Syntax::SclText);
    outcome.operand.span = expr.span;
    if (outcome.operand.block) outcome.operand.block->span = expr.span;
    return outcome.operand;
  }
  return std::nullopt;
}

/// Indices that are no constants stand with the least ones of their bounds; `computed` tells the step of each.
Operand SclLowering::operandOf(const iec::Expr& expr,
                               std::vector<std::pair<std::size_t, const iec::PathPart*>>& computed,
                               const iec::PathPart** slice) {
  using PartKind = iec::PathPart::Kind;
  const std::string& first = expr.parts[0].name;
  const bool isOwn = isLocal(first);
  const bool isSlice = expr.parts.back().kind == PartKind::Bit && expr.parts.back().isSlice;
  if (isSlice && slice == nullptr)
    refuse(expr.parts.back().span, fmt::format("parts of a value such as {} are not covered here", written(expr.span)));
  if (isSlice) *slice = &expr.parts.back();
  if (!isOwn) {
    if (std::optional<Operand> address = absolute(expr)) return std::move(*address);
  }
  Operand operand;
  operand.span = expr.span;
  const std::optional<std::uint32_t> dataBlock = isOwn ? std::nullopt : dataBlockNumber(first);
  std::size_t next = 1;
  if (isOwn) {
    operand.form = OperandForm::Local;
    operand.path.push_back({sclBareName(first), {}, expr.parts[0].span});
  } else {
    operand.form = OperandForm::Symbol;
    operand.name = dataBlock ? fmt::format("DB{}", *dataBlock) : sclBareName(first);
    if (dataBlock) operand.block = BlockName{BlockKind::Db, *dataBlock, {}, expr.parts[0].span};
    const bool isKnown = first.starts_with('"') || dataBlock || catalogue_.symbol(first) != nullptr ||
                         catalogue_.keyOf(BlockName{std::nullopt, 0, first, expr.parts[0].span});
    if (!isKnown) {
      reports_.reportOnce(Syntax::NameUndefined, expr.parts[0].span, fmt::format("nothing declares {}", first),
                          scope_.name, network_->number);
      throw Refused{true};
    }
  }
  for (const std::size_t end = expr.parts.size() - (isSlice ? 1 : 0); next < end; ++next) {
    const iec::PathPart& part = expr.parts[next];
    if (part.kind == PartKind::Name) {
      operand.path.push_back({sclBareName(part.name), {}, part.span});
    } else if (part.kind == PartKind::Bit) {
      refuse(part.span, fmt::format("parts of a value such as {} are not covered", written(expr.span)));
    } else {
      if (operand.path.empty() || !operand.path.back().indices.empty())
        refuse(part.span, fmt::format("{} is no array", written(expr.span)));
      bool isComputed = false;
      for (const iec::ExprPtr& index : part.indices) {
        const std::optional<std::int64_t> number = numberOf(*index);
        isComputed = isComputed || !number;
        operand.path.back().indices.push_back(number.value_or(0));
      }
      if (isComputed) computed.emplace_back(operand.path.size() - 1, &part);
    }
  }
  return operand;
}

/// MW[i], M[i, 3], PIW[i], DB10.DW[i], "Data".DX[i, j]: an address whose byte, and whose bit, are computed. Beyond the
/// area the CPU itself finds the error.
std::optional<SclLowering::Spot> SclLowering::computedAddress(const iec::Expr& expr) {
  using PartKind = iec::PathPart::Kind;
  const std::size_t names = expr.parts.size() - 1;
  const iec::PathPart& last = expr.parts.back();
  const auto isName = [](const iec::PathPart& part) { return part.kind == PartKind::Name; };
  if (names < 1 || names > 2 || last.kind != PartKind::Index || last.indices.empty() || last.indices.size() > 2 ||
      !std::all_of(expr.parts.begin(), expr.parts.end() - 1, isName) || isLocal(expr.parts[0].name))
    return std::nullopt;
  const bool isBit = last.indices.size() == 2;
  iec::Expr first;  // the same at byte 0
  first.kind = iec::ExprKind::Path;
  first.span = expr.span;
  for (std::size_t i = 0; i < names; ++i) first.parts.push_back({PartKind::Name, expr.parts[i].name, {}, 0, 1, {}});
  std::string& name = first.parts.back().name;
  if (catalogue_.symbol(first.parts[0].name) != nullptr && names == 1) return std::nullopt;
  if (isBit && names == 1 && name.size() > 1 && (name.ends_with('X') || name.ends_with('x'))) name.pop_back();
  name += '0';
  if (isBit) first.parts.push_back({PartKind::Bit, {}, {}, 0, 1, expr.span});
  const std::optional<Operand> address = absolute(first);
  if (!address || address->form != OperandForm::Address) return std::nullopt;
  Spot spot;
  spot.operand = *address;
  spot.bound = bound(spot.operand);
  spot.indices.emplace_back(last.indices[0].get(), s7300::Bounds{0, 65535});
  spot.strides.push_back(8);
  if (isBit) {
    spot.indices.emplace_back(last.indices[1].get(), s7300::Bounds{0, 7});
    spot.strides.push_back(1);
  }
  return spot;
}

SclLowering::Spot SclLowering::placeOf(const iec::Expr& expr) {
  Spot spot = placeOrSlice(expr);
  if (spot.slice != nullptr)
    refuse(spot.slice->span, fmt::format("parts of a value such as {} are not covered here", written(expr.span)));
  return spot;
}

SclLowering::Spot SclLowering::placeOrSlice(const iec::Expr& expr) {
  if (std::optional<Spot> address = computedAddress(expr)) return std::move(*address);
  std::vector<std::pair<std::size_t, const iec::PathPart*>> computed;
  Spot spot;
  spot.operand = operandOf(expr, computed, &spot.slice);
  if (computed.empty()) {
    spot.bound = bound(spot.operand);
    return spot;
  }
  struct Index {
    std::size_t step, dimension;
  };
  std::vector<Index> where;
  // Bounds from the front: what stands behind an array has the least indices by then.
  for (const auto& [step, part] : computed) {
    Operand array = spot.operand;
    array.path.resize(step + 1);
    array.path[step].indices.clear();
    const BoundOperand declared = bound(array);
    if (!declared.type || declared.type->kind != Kind::Array)
      refuse(part->span, fmt::format("{} is no array", array.path[step].name), Syntax::SclType);
    const std::vector<s7300::Bounds>& bounds = declared.type->bounds;
    if (bounds.size() != part->indices.size())
      refuse(part->span, fmt::format("{} has another number of dimensions", array.path[step].name), Syntax::SclType);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if (numberOf(*part->indices[i])) continue;
      spot.operand.path[step].indices[i] = bounds[i].first;
      spot.indices.emplace_back(part->indices[i].get(), bounds[i]);
      where.push_back({step, i});
    }
  }
  spot.bound = bound(spot.operand);
  const auto bitAddress = [](const BoundOperand& at) { return std::int64_t{at.operand.offset} * 8 + at.operand.bit; };
  for (std::size_t i = 0; i < where.size(); ++i) {
    std::int64_t stride = 0;
    if (spot.indices[i].second.count() > 1) {
      Operand further = spot.operand;
      ++further.path[where[i].step].indices[where[i].dimension];
      stride = bitAddress(bound(further)) - bitAddress(spot.bound);
    }
    spot.strides.push_back(stride);
  }
  return spot;
}

/// Loads a DINT; a value outside of the range is a hazard.
void SclLowering::checkRange(const SclValue& value, std::int64_t first, std::int64_t last, Span span) {
  load(value);
  const auto number = [&](std::int64_t bound) {
    Constant constant;
    constant.kind = ConstantKind::Long;
    constant.value = bound;
    return sclConstant(constant, span);
  };
  Statement check;
  check.mnemonic = {std::string(indexCheck), span};
  check.operand = number(first);
  check.instance = number(last);
  check.span = span;
  network_->statements.push_back(std::move(check));
}

Operand SclLowering::pointTo(const Spot& spot, Kind kind, Span span) {
  const auto number = [&](std::int64_t value) {
    Constant constant;
    constant.kind = ConstantKind::Long;
    constant.value = value;
    return sclConstant(constant, span);
  };
  const rungproof::Operand& base = spot.bound.operand;
  const bool isReferred = base.reach != nullptr && base.reach->way == Way::Parameter;
  std::int64_t start =
      std::int64_t{base.area == Area::DB && base.reach == nullptr ? byteInBlock(base.offset) : base.offset} * 8 +
      base.bit;
  std::optional<SclValue> sum;
  for (std::size_t i = 0; i < spot.indices.size(); ++i) {
    const iec::Expr& index = *spot.indices[i].first;
    const s7300::Bounds& bounds = spot.indices[i].second;
    checkRange(valueAs(index, Kind::DInt), bounds.first, bounds.last, index.span);
    const std::int64_t stride = spot.strides[i];
    start -= stride * bounds.first;
    if (std::has_single_bit(static_cast<std::uint64_t>(stride))) {
      if (stride > 1) {
        Constant count;
        count.value = std::countr_zero(static_cast<std::uint64_t>(stride));
        emit("SLD", sclConstant(count, span));
      }
    } else {
      emit("L", number(stride));
      emit("*D");
    }
    if (sum) {
      emit("L", sum->operand);
      emit("+D");
    }
    if (i + 1 < spot.indices.size()) sum = inTemporary(inRegister(Kind::DInt, span));
  }
  emit("L", number(start));
  emit("+D");
  Operand made;
  made.form = OperandForm::Indirect;
  made.size = sclSize(kind);
  made.addressRegister = 1;
  made.span = span;
  if (isReferred) {
    const SclValue offset = inTemporary(inRegister(Kind::DInt, span));
    Operand pointer;
    pointer.form = OperandForm::Parameter;
    pointer.path = {{spot.operand.path[0].name, {}, span}};
    pointer.span = span;
    emit("L", pointer);
    emit("LAR1");
    Operand part = made;
    part.crossesAreas = true;
    part.size = Size::Word;
    emit("L", part);
    const Operand block = temporary(Kind::Word);
    emit("T", block);
    Operand open;
    open.form = OperandForm::Indirect;
    open.block = BlockName{BlockKind::Db, 0, {}, {}};
    open.pointer = std::make_shared<Operand>(block);
    open.span = span;
    emit("OPN", open);
    part.size = Size::DWord;
    part.offset = 16;
    emit("L", part);
    emit("L", offset.operand);
    emit("+D");
    emit("LAR1");
    made.crossesAreas = true;
    return made;
  }
  if (base.area == Area::L) {
    made.place = Place::L;
  } else if (base.reach == nullptr && spot.operand.form == OperandForm::Address && base.area != Area::DB) {
    made.place = spot.operand.place;
  } else if (base.reach != nullptr && base.reach->way == Way::Instance) {
    emit("TAR2");
    emit("+D");
    made.place = Place::DI;
  } else if (base.area == Area::DB && base.reach == nullptr) {
    emit("LAR1");
    Operand open;
    open.form = OperandForm::Block;
    open.block = BlockName{BlockKind::Db, blockOfByte(base.offset), {}, span};
    open.span = span;
    emit("OPN", open);
    made.place = Place::DB;
    return made;
  } else {
    refuse(span, fmt::format("the computed index of {} is not covered", written(span)));
  }
  emit("LAR1");
  return made;
}

SclValue SclLowering::path(const iec::Expr& expr) {
  const std::string& first = expr.parts[0].name;
  const bool isAlone = expr.parts.size() == 1;
  if (isAlone && !isLocal(first)) {
    for (const SclConstant& constant : body_->constants) {
      if (!s7300::isSameName(constant.name, first)) continue;
      if (++constantDepth_ > 50)
        refuse(expr.span, fmt::format("the constant {} is made of itself", first), Syntax::SclText);
      SclValue made;
      if (const std::optional<std::int64_t> number = numberOf(*constant.value)) {
        Constant value;
        value.value = *number;
        made.kind = *number >= -32768 && *number <= 32767 ? Kind::Int : Kind::DInt;
        made.isPlain = made.isLiteral = true;
        made.operand = sclConstant(value, expr.span);
      } else {
        made = value(*constant.value);
      }
      --constantDepth_;
      if (!made.isPlain || made.operand.form != OperandForm::Constant)
        refuse(expr.span, fmt::format("what {} is has to be computed, which is not covered", first));
      return made;
    }
    const std::string word = iec::foldedName(first);
    if (word == "OK")
      refuse(expr.span,
             "whether a computation has cleared OK depends on how the block was compiled: it can only be written");
    if (word == "ENO" || word == "EN")
      refuse(expr.span, fmt::format("{} has no value outside of a parameter list", word));
  }
  const Spot spot = placeOrSlice(expr);
  SclValue made;
  made.span = expr.span;
  if (spot.bound.constant && spot.slice == nullptr) {
    made.isPlain = true;
    made.operand = sclConstant(*spot.bound.constant, expr.span);
    const s7300::Field* const field = isAlone ? scope_.constants->field(sclBareName(first)) : nullptr;
    const bool isReal = made.operand.constant.kind == ConstantKind::Real;
    made.kind = field != nullptr ? field->type.kind : isReal ? Kind::Real : Kind::Int;
    made.isLiteral = field == nullptr && !isReal;
    return made;
  }
  made.kind = kindOf(spot.bound, expr.span, made.isUntyped);
  if (spot.indices.empty()) {
    made.isPlain = true;
    made.operand = spot.operand;
    return spot.slice != nullptr ? slice(spot, made) : made;
  }
  if (spot.slice != nullptr) kindOfSlice(spot, made.kind);
  const Operand at = pointTo(spot, made.kind, expr.span);
  if (made.kind == Kind::Bool)
    emit("A", at);
  else
    emit("L", at);
  return spot.slice != nullptr ? slice(spot, made) : made;
}

void SclLowering::store(const Spot& spot, const SclValue& value, Span span) {
  if (spot.indices.empty()) {
    if (value.kind == Kind::Bool)
      scan(value);
    else
      load(value);
    return store(spot.operand, value.kind);
  }
  // Reading it later could open another data block than that of the place.
  const bool isConstant = value.isPlain && value.operand.form == OperandForm::Constant;
  const SclValue held = isConstant ? value : inTemporary(value);
  const Operand at = pointTo(spot, value.kind, span);
  if (value.kind == Kind::Bool)
    scan(held);
  else
    load(held);
  store(at, value.kind);
}

}  // namespace rungproof::step7
