// Actual parameters for POINTER and ANY: addresses, names, pointer constants, and pointers that the calling block has
// itself (002:2174-2288). What no pointer can be made of is refused: its network is not covered.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/step7/constant_spelling.hpp"
#include "frontend/step7/statement_binder.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/any_elements.hpp"
#include "ir/s7300/coverage.hpp"
#include "ir/s7300/declarations.hpp"
#include "ir/s7300/pointer_code.hpp"

namespace rungproof::step7 {

using s7300::AnyElements;
using s7300::ConstantKind;
using s7300::Field;
using s7300::Type;
using s7300::TypeKind;

namespace {

AnyElements elementsOf(const rungproof::Operand& operand) {
  if (operand.area == Area::T) return {AnyType::Timer};
  if (operand.area == Area::C) return {AnyType::Counter};
  switch (operand.width) {
    case Width::Bit: return {AnyType::Bool};
    case Width::Byte: return {AnyType::Byte};
    case Width::Word: return {AnyType::Word};
    default: return {AnyType::DWord};
  }
}

bool isTimerOrCounter(const BoundOperand& bound) {
  return bound.operand.area == Area::T || bound.operand.area == Area::C;
}

/// Places that a pointer can be made of when the call is made; of timers and counters an ANY can.
bool hasAddress(const BoundOperand& bound) {
  const rungproof::Operand& operand = bound.operand;
  if (!operand.isMemory() || bound.block) return false;
  if (operand.reach == nullptr) return true;
  const bool isBlockNumber = bound.type && isNumberType(bound.type->kind) && !isTimerOrCounter(bound);
  const Way way = operand.reach->way;
  return way == Way::Instance || way == Way::OpenBlock || (way == Way::Parameter && !isBlockNumber);
}

/// The same where the block may take the actual parameter for a value: the place has to be certain.
bool hasCertainPlace(const BoundOperand& bound) {
  const bool isOpenBlock = bound.operand.reach != nullptr && bound.operand.reach->way == Way::OpenBlock;
  return hasAddress(bound) && !isTimerOrCounter(bound) && !isOpenBlock;
}

rungproof::Operand pointerTo(rungproof::Operand place, AnyElements elements, std::string text) {
  rungproof::Operand operand = place;
  Reach reach{};
  reach.way = Way::PointerTo;
  reach.pointer = std::move(place);
  reach.anyType = static_cast<std::uint8_t>(elements.type);
  reach.anyCount = static_cast<std::uint16_t>(elements.count);
  operand.kind = OperandKind::Address;
  operand.text = std::move(text);
  operand.reach = Shared<Reach>(std::move(reach));
  return operand;
}

/// The place that a pointer constant means, for readers of the program; its double word is what is handed over. Local
/// data is area V for the block that is called.
rungproof::Operand ofConstant(const Constant& constant) {
  const auto bits = static_cast<std::uint32_t>(constant.value);
  const auto code = static_cast<PointerArea>(bits >> 24 & 7U);
  const std::uint32_t byte = (bits & 0x7FFFFU) >> 3;
  static constexpr Area areas[] = {Area::PI, Area::I, Area::Q, Area::M, Area::DB, Area::DB, Area::L, Area::L};
  rungproof::Operand place = direct(areas[static_cast<std::size_t>(code)], Width::Byte, byte, bits & 7U);
  if (code == PointerArea::Db) place.offset = dataByte(constant.block, byte);
  const AnyElements elements{static_cast<AnyType>(constant.anyType), constant.anyCount};
  if ((code == PointerArea::Db && constant.block == 0) || code == PointerArea::Di) {  // in the block that is open
    place.kind = OperandKind::Indirect;
    Reach reach{};
    reach.way = Way::OpenBlock;
    reach.inDi = code == PointerArea::Di;
    place.reach = Shared<Reach>(std::move(reach));
    return pointerTo(place, elements, spellingOf(constant));
  }
  rungproof::Operand pointer = rungproof::constant(bits, ConstantForm::Typed);
  if (code == PointerArea::L) pointer.value = bits | 0x01000000U;
  pointer.offset = constant.block;
  rungproof::Operand operand = pointerTo(place, elements, spellingOf(constant));
  Reach reach = *operand.reach;
  reach.pointer = std::move(pointer);
  operand.reach = Shared<Reach>(std::move(reach));
  return operand;
}

}  // namespace

std::optional<rungproof::Operand> StatementBinder::pointerActual(const Argument& argument, const BoundOperand& bound,
                                                                 const Field& formal, bool mayBeValue) {
  const Span span = argument.actual.span;
  const bool wantsAny = formal.type.kind == TypeKind::Any;
  const auto fail = [&](Syntax code, std::string message) {
    refuse(code, span, std::move(message));
    return std::nullopt;
  };
  const auto notCovered = [&] {
    return fail(Syntax::NotModelled, fmt::format("{} as {}: {}", toString(bound.operand), s7300::toString(formal.type),
                                                 s7300::gapReason(s7300::Gap::PointerParameter)));
  };
  if (bound.constant) {
    const bool isPointer = bound.constant->kind == ConstantKind::Pointer || bound.constant->kind == ConstantKind::Any;
    const bool hasArea = isPointer && (bound.constant->value & 0x80000000) != 0;
    if (mayBeValue && !isPointer) return bound.operand;
    if (!hasArea || (!wantsAny && bound.constant->kind == ConstantKind::Any))
      return fail(Syntax::CallList,
                  fmt::format("{} takes a pointer such as P#M 10.0{}", formal.name, wantsAny ? " BYTE 4" : ""));
    const auto code = static_cast<PointerArea>(bound.constant->value >> 24 & 7);
    // How many elements are meant without a type is not stated.
    const bool isOpen = wantsAny && bound.constant->kind == ConstantKind::Pointer;
    const bool isInOpenBlock = (code == PointerArea::Db && bound.constant->block == 0) || code == PointerArea::Di;
    if (isOpen || (mayBeValue && isInOpenBlock) || bound.constant->block > lastDataBlock) return notCovered();
    BoundOperand block;
    block.block = BlockKey{BlockKind::Db, bound.constant->block};
    if (refuseOpaque(block, span)) return std::nullopt;
    rungproof::Operand operand = ofConstant(*bound.constant);
    operand.span = span;
    const auto type = static_cast<AnyType>(bound.constant->anyType);
    const std::uint32_t length = std::max(1U, bytesOfElements(type, bound.constant->anyCount));
    if (code == PointerArea::L) scope_->localBytes = std::max(scope_->localBytes, operand.offset + length);
    return operand;
  }
  if (bound.block) return fail(Syntax::CallList, fmt::format("{} takes no whole block", formal.name));
  if (bound.operand.kind == OperandKind::Address)
    return fail(Syntax::CallList, fmt::format("{} takes no address of a parameter", formal.name));
  if (bound.type && isPointerKind(bound.type->kind)) {  // the caller's own pointer is handed on
    if (bound.type->kind != formal.type.kind)
      return fail(Syntax::CallList, fmt::format("{} takes {}, not {}", formal.name, s7300::toString(formal.type),
                                                s7300::toString(*bound.type)));
    return bound.operand;
  }
  if (isTimerOrCounter(bound) && !wantsAny && !bound.block)
    return fail(Syntax::CallList,
                fmt::format("{} takes a place in memory: only an ANY can name a timer or a counter", formal.name));
  if (!(mayBeValue ? hasCertainPlace(bound) : hasAddress(bound))) return notCovered();
  const AnyElements elements = bound.type ? s7300::anyElementsOf(*bound.type) : elementsOf(bound.operand);
  constexpr std::uint64_t mostElements = 65535;
  if (elements.count > mostElements) return notCovered();
  std::string text = bound.operand.text;
  rungproof::Operand operand = pointerTo(bound.operand, elements, std::move(text));
  if (mayBeValue) {
    Reach reach = *operand.reach;
    reach.isPlaceOrValue = true;
    operand.reach = Shared<Reach>(std::move(reach));
  }
  return operand;
}

}  // namespace rungproof::step7
