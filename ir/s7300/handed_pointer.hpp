// Pointers that a call hands over: for parameters of type POINTER and ANY, and for the complex types that an FC, or an
// IN_OUT of an FB, takes by reference (002:2181-2288). A POINTER has six bytes: the number of the data block or 0, and
// the pointer with its area. An ANY has ten: 16#10, a code of the type and the number of elements before the same six.
// Those of an FC lie in local data of the caller, behind what the caller itself uses; the FC finds them in area V.
// Those of an FB lie in its instance. What is local data of the caller is area V in the pointer (16#87). Members of
// Step7Places. Tested by tests/step7/handed_pointer_test.cpp.
#pragma once

#include "ir/s7300/place.hpp"
#include "ir/s7300/pointer_parameter.hpp"

namespace rungproof {

/// First of the values that stand for what of pointers is not known, by parameter (External::UnknownResult).
inline constexpr std::uint32_t unknownPointer = 0x400, unknownsOfPointer = 8;

template <class D>
Spot<D> Step7Places<D>::handedPlace(const Context& c, std::uint32_t parameter, std::uint32_t offset, Width width) {
  Spot<D> spot;
  const LocalVariable& local = c.running->pou->locals[parameter];
  if (keepsPointers(*c.running->pou))
    return at(location(number(static_cast<std::uint64_t>(Area::DB), 8), c.di,
                       beyond(address(c.ar2), local.pointerByte + offset, 0)),
              width);
  const Activation<D>* caller = c.running->caller;
  if (caller == nullptr || actual(c, parameter) == nullptr) {  // UC gives no parameters
    spot.isUnresolved = true;
    return spot;
  }
  spot.isPlace = true;
  spot.area = Area::L;
  spot.offset = caller->localBase + ownPointers(*caller->pou) + local.pointerByte + offset;
  return spot;
}

/// Where in the local data of a block the pointers begin that its calls hand over.
template <class D>
std::uint32_t Step7Places<D>::ownPointers(const Pou& pou) {
  return pou.localBytes - pou.pointerBytes;
}

/// P##name of a parameter that is handed over by a pointer: the place of the pointer.
template <class D>
typename D::Bits Step7Places<D>::handedAddress(std::uint32_t parameter) {
  const Activation<D>& running = *m_.step7.running;
  const LocalVariable& local = running.pou->locals[parameter];
  if (keepsPointers(*running.pou)) return areaPointer(PointerArea::Di, number(local.pointerByte * 8, 24));
  if (running.caller == nullptr) return m_.external(External::UnknownResult, unknownPointer, 32);
  return areaPointer(PointerArea::V, number((ownPointers(*running.caller->pou) + local.pointerByte) * 8, 24));
}

/// P##name of an elementary parameter of an FC: the pointer to what the caller gives, if that lies in I, Q, M, P or the
/// caller's own local data, by Choice::ParameterPointer; otherwise, and of a part of a parameter, any value.
template <class D>
typename D::Bits Step7Places<D>::elementaryAddress(const Operand& o) {
  const Bits any = m_.external(External::UnknownResult, unknownPointer + o.reach->parameter * unknownsOfPointer, 32);
  if (!isElementaryReference(o) || hasInstance(*m_.step7.running->pou)) return any;
  Context c = here();
  const Operand* given = &o;
  bool isCallers = false;  // local data of the direct caller
  for (int level = 0; given != nullptr && given->reach != nullptr && given->reach->way == Way::Parameter; ++level) {
    isCallers = level == 0;
    given = actual(c, given->reach->parameter);
    c = callerOf(c);
  }
  if (given == nullptr || given->kind != OperandKind::Direct) return any;
  const auto area = [&]() -> std::optional<PointerArea> {
    switch (given->area) {
      case Area::PI:
      case Area::PQ: return PointerArea::P;
      case Area::I: return PointerArea::I;
      case Area::Q: return PointerArea::Q;
      case Area::M: return PointerArea::M;
      case Area::L: return isCallers ? std::optional(PointerArea::V) : std::nullopt;
      default: return std::nullopt;
    }
  }();
  if (!area) return any;
  const Bits known = areaPointer(*area, number(given->offset * 8 + given->bit, 24));
  return d_.select(m_.reads({Choice::ParameterPointer, "actual"}), known, any, 32);
}

/// The pointer to a place that the block of the context names. `isOwn`: it is the block that calls; local data of other
/// ones has no pointer, and neither has a constant: any value. For a timer or a counter bytes 6 to 9 of the ANY end in
/// its number; whether byte 6 repeats the code of the type is stated either way (general knowledge).
template <class D>
HandedPointer<D> Step7Places<D>::pointerTo(const Operand& o, const Context& c, std::uint32_t moreBits, bool isOwn,
                                           std::uint32_t unknown) {
  const std::uint32_t bits = o.bit + moreBits;
  const auto fixed = [&](PointerArea area, std::uint32_t block, std::uint32_t byte) {
    return HandedPointer<D>{{}, number(block, 16), areaPointer(area, number(byte * 8 + bits, 24))};
  };
  if (o.kind == OperandKind::Constant)
    return {{}, number(o.offset, 16), number(static_cast<std::uint64_t>(o.value), 32)};
  if (o.kind == OperandKind::Direct) {
    switch (o.area) {
      case Area::PI:
      case Area::PQ: return fixed(PointerArea::P, 0, o.offset);
      case Area::I: return fixed(PointerArea::I, 0, o.offset);
      case Area::Q: return fixed(PointerArea::Q, 0, o.offset);
      case Area::M: return fixed(PointerArea::M, 0, o.offset);
      case Area::DB: return fixed(PointerArea::Db, blockOfByte(o.offset), byteInBlock(o.offset));
      case Area::L:
        if (isOwn) return fixed(PointerArea::V, 0, o.offset);
        break;
      case Area::T:
      case Area::C: {
        const AnyType type = o.area == Area::T ? AnyType::Timer : AnyType::Counter;
        const Bool repeats = d_.bit(m_.external(External::UnknownResult, unknown + 3, 1), 0);
        const Bits code = d_.select(repeats, number(static_cast<std::uint64_t>(type), 8), number(0, 8), 8);
        return {{}, number(0, 16), d_.concat(code, 8, number(o.offset, 24), 24)};
      }
      default: break;
    }
  }
  if (o.kind == OperandKind::Indirect && o.reach != nullptr) {
    if (o.reach->way == Way::Instance)
      return {{}, c.di, areaPointer(PointerArea::Db, beyond(address(c.ar2), o.offset, bits))};
    if (o.reach->way == Way::OpenBlock) {
      const Bool isNumber = m_.reads({Choice::OpenBlockPointer, "number"});
      const HandedPointer<D> zero = fixed(o.reach->inDi ? PointerArea::Di : PointerArea::Db, 0, o.offset);
      return {{},
              d_.select(isNumber, o.reach->inDi ? c.di : c.db, zero.block, 16),
              d_.select(isNumber, fixed(PointerArea::Db, 0, o.offset).pointer, zero.pointer, 32)};
    }
    const Operand* given = o.reach->way == Way::Parameter ? actual(c, o.reach->parameter) : nullptr;
    if (given != nullptr && given->isMemory())
      return pointerTo(*given, callerOf(c), o.offset * 8 + bits, false, unknown);
  }
  return unknownPlace(unknown);
}

template <class D>
HandedPointer<D> Step7Places<D>::unknownPlace(std::uint32_t index) {
  return {{}, m_.external(External::UnknownResult, index, 16), m_.external(External::UnknownResult, index + 1, 32)};
}

/// Whether the operand is an elementary parameter that the running block was given by reference. Its place is that of
/// the actual parameter, whose address the call has handed over; that a pointer is made of it is a choice.
template <class D>
bool Step7Places<D>::isElementaryReference(const Operand& o) const {
  if (o.reach == nullptr || o.reach->way != Way::Parameter || o.area == Area::T || o.area == Area::C) return false;
  return !isComplexType(m_.step7.running->pou->locals[o.reach->parameter].type);
}

/// What a call makes of the actual parameter for a formal one of that type, the `index`th.
template <class D>
HandedPointer<D> Step7Places<D>::handed(const Operand& actual, DataType formal, std::uint32_t index) {
  const std::uint32_t unknown = unknownPointer + index * unknownsOfPointer;
  if (!isPointerType(formal)) return pointerTo(actual, here(), 0, true, unknown);
  if (actual.kind == OperandKind::Address && actual.reach != nullptr) {
    HandedPointer<D> result = pointerTo(actual.reach->pointer, here(), 0, true, unknown);
    if (isElementaryReference(actual.reach->pointer) && !actual.reach->isPlaceOrValue) {
      const Bool isActual = m_.reads({Choice::ParameterPointer, "actual"});
      const HandedPointer<D> other = unknownPlace(unknown + 4);
      result.block = d_.select(isActual, result.block, other.block, 16);
      result.pointer = d_.select(isActual, result.pointer, other.pointer, 32);
    }
    const auto head = [&](std::uint32_t type, std::uint32_t count) {
      return number(0x10000000U | type << 16 | count, 32);
    };
    const std::uint32_t type = actual.reach->anyType, count = actual.reach->anyCount;
    result.head = head(type, count);
    // Whether a STRING is one element or its bytes is not stated: either.
    if (type == static_cast<std::uint32_t>(AnyType::String) && formal == DataType::Any)
      result.head = d_.select(d_.bit(m_.external(External::UnknownResult, unknown + 2, 1), 0), head(type, 1),
                              head(static_cast<std::uint32_t>(AnyType::Byte), count), 32);
    return result;
  }
  const auto part = [&](std::uint32_t byte, Width width) {
    Operand place = actual;
    place.offset += byte;
    return load(find(place, width), width);
  };
  const std::uint32_t block = formal == DataType::Any ? 4 : 0;
  return {formal == DataType::Any ? part(0, Width::DWord) : number(0, 32), d_.extract(part(block, Width::Word), 15, 0),
          part(block + 2, Width::DWord)};
}

/// Writes a pointer to where the called block, which runs already, finds it.
template <class D>
void Step7Places<D>::saveHanded(const HandedPointer<D>& pointer, std::uint32_t parameter) {
  const Context c = here();
  const bool isAny = c.running->pou->locals[parameter].type == DataType::Any;
  if (isAny) save(handedPlace(c, parameter, 0, Width::DWord), Width::DWord, pointer.head);
  const std::uint32_t block = isAny ? 4 : 0;
  save(handedPlace(c, parameter, block, Width::Word), Width::Word, d_.zext(pointer.block, 16, 32));
  save(handedPlace(c, parameter, block + 2, Width::DWord), Width::DWord, pointer.pointer);
}

template <class D>
HandedPointer<D> Step7Places<D>::loadHanded(std::uint32_t parameter) {
  const Context c = here();
  const bool isAny = c.running->pou->locals[parameter].type == DataType::Any;
  const std::uint32_t block = isAny ? 4 : 0;
  return {isAny ? load(handedPlace(c, parameter, 0, Width::DWord), Width::DWord) : number(0, 32),
          d_.extract(load(handedPlace(c, parameter, block, Width::Word), Width::Word), 15, 0),
          load(handedPlace(c, parameter, block + 2, Width::DWord), Width::DWord)};
}

/// The number of the data block stands in the pointer; in area DI its meaning is not stated.
template <class D>
typename D::Bits Step7Places<D>::locationOf(const HandedPointer<D>& pointer) {
  Context c = here();
  c.db = pointer.block;
  const Bits isDi = number(0x85, 8);
  const Bits found = crossing(pointer.pointer, 0, 0, c);
  return d_.select(d_.equal(d_.extract(pointer.pointer, 31, 24), isDi, 8),
                   number(std::uint64_t{255} << 40, locationBits), found, locationBits);
}

}  // namespace rungproof
