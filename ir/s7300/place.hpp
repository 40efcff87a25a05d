// Operands of an S7-300/400 made ready for an access: direct ones, those that lie in open blocks and instances, formal
// parameters, and pointers (002:1622-1711). A place that depends on registers is written as one number of area, block
// and bit address; the domain lists the numbers it can be. What no access may reach is a synchronous error
// (002:1284-1290).
#pragma once

#include <optional>
#include <vector>

#include "ir/block_map.hpp"
#include "ir/check.hpp"
#include "ir/machine/machine.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/pointer_code.hpp"

namespace rungproof {

/// The number of a place in a data block: area, block and bit address, from the top.
constexpr std::uint64_t locationInBlock(std::uint32_t block, std::uint32_t bitAddress) {
  return static_cast<std::uint64_t>(Area::DB) << 40 | static_cast<std::uint64_t>(block) << 24 | bitAddress;
}
/// The data block in which a place lies of whose number some bits are known; nothing if it may lie elsewhere.
constexpr std::optional<std::uint32_t> blockOfLocation(std::uint64_t value, std::uint64_t known) {
  if ((known >> 24 & 0xFFFFFF) != 0xFFFFFF || value >> 40 != static_cast<std::uint64_t>(Area::DB)) return std::nullopt;
  return static_cast<std::uint32_t>(value >> 24 & 0xFFFF);
}

/// A place or several, or a value; none of them: a place that no access reaches.
template <class D>
struct Spot {
  using Bits = typename D::Bits;
  bool isValue = false;
  bool isUnresolved = false;  ///< a pointer whose targets are not known: reads give anything
  bool isPlace = false;
  bool isComputed = false;  ///< a place that the domain itself follows, by the address in `value`
  Bits value{};             ///< 32 bits
  Area area = Area::M;
  std::uint32_t offset = 0;  ///< byte; L: counted from the beginning of all local memory
  std::uint32_t bit = 0;
  typename D::Targets targets{};
};

struct ByteRow;

template <class D>
class Step7Places {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  explicit Step7Places(Machine<D>& machine) : m_(machine), d_(machine.d) {}

  /// Finds the operand as the running block sees it; errors are met on the way.
  Spot<D> find(const Operand& o, Width width) { return find(o, width, here(), 0, 0, true); }
  /// Value of a place, zero-extended to 32 bits.
  Bits load(const Spot<D>& spot, Width width);
  Bool loadBit(const Spot<D>& spot) { return d_.bit(load(spot, Width::Bit), 0); }
  /// Bit of any operand, timers and counters by number included.
  Bool bitOf(const Operand& o);
  void save(const Spot<D>& spot, Width width, Bits value);
  void saveBit(const Spot<D>& spot, Bool value) { save(spot, Width::Bit, d_.fromBool(value, 1)); }

  /// Calls visit(number) under the condition that the operand, a timer or counter, is that number.
  template <class Visit>
  void eachNumber(const Operand& o, Visit&& visit);
  /// Number of a block that an operand names: a constant, a parameter, or the word in memory. 16 bits.
  Bits blockNumberOf(const Operand& o);
  /// The pointer to an operand (P##name): area code and bit address, 32 bits. In an FB the address counts from where
  /// its own data begin, so that a multi-instance has to add AR2 (general knowledge).
  Bits addressOf(const Operand& o);
  /// Pointers that calls hand over: ir/s7300/handed_pointer.hpp.
  HandedPointer<D> handed(const Operand& actual, DataType formal, std::uint32_t index);
  void saveHanded(const HandedPointer<D>& pointer, std::uint32_t parameter);
  HandedPointer<D> loadHanded(std::uint32_t parameter);
  /// Where an ANY of the running block leads, as a number; its bytes there. Tested with ir/s7300/system_args.hpp.
  Bits locationOf(const HandedPointer<D>& pointer);
  bool rowAt(std::uint64_t location, std::uint32_t length, bool isBits, ByteRow& row) const;
  Bits loadFrom(Area area, std::uint32_t offset, std::uint32_t bit, Width width) {
    return loadPlace(area, offset, bit, width);
  }
  void saveTo(Area area, std::uint32_t offset, std::uint32_t bit, Width width, Bits value) {
    savePlace(area, offset, bit, width, value);
  }
  /// A place as a number: area in bits 47-40, block in bits 39-24, bit address below.
  static constexpr int locationBits = 48;

 private:
  /// What the operands of a block depend on.
  struct Context {
    const Activation<D>* running;
    Bits db, di, ar2;
  };
  Context here() const { return {m_.step7.running, m_.step7.db, m_.step7.di, m_.step7.ar[1]}; }
  Context callerOf(const Context& c) const {
    return {c.running->caller, c.running->callerDb, c.running->callerDi, c.running->callerAr2};
  }
  /// What the call gives for a formal parameter, or nullptr.
  static const Operand* actual(const Context& c, std::uint32_t parameter) {
    if (c.running == nullptr || c.running->call == nullptr) return nullptr;
    const Operands& operands = c.running->call->operands;
    const std::size_t first = hasInstance(*c.running->pou) ? 2 : 1;
    return first + parameter < operands.size() ? &operands[first + parameter] : nullptr;
  }

  Bits location(Bits area, Bits block, Bits address) {
    return d_.concat(area, 8, d_.concat(block, 16, address, 24), 40);
  }
  Bits number(std::uint64_t value, int width) { return d_.literal(value, width); }
  Bits address(Bits pointer) { return d_.zext(d_.extract(pointer, 18, 0), 19, 24); }
  /// `offset` bytes and `bit` bits beyond what a register or a pointer says.
  Bits beyond(Bits start, std::uint32_t offset, std::uint32_t bit) {
    return d_.add(start, number(offset * 8 + bit, 24), 24);
  }

  Spot<D> find(const Operand& o, Width width, const Context& c, std::uint32_t moreBytes, std::uint32_t moreBits,
               bool opens);
  Spot<D> direct(const Operand& o, Width width, const Context& c, std::uint32_t moreBytes, std::uint32_t moreBits,
                 bool opens);
  Spot<D> at(Bits location, Width width);
  Bits crossing(Bits pointer, std::uint32_t offset, std::uint32_t bit, const Context& c);
  Bits areaPointer(PointerArea area, Bits address) {
    return d_.bor(number(0x80000000U | static_cast<std::uint64_t>(area) << 24, 32), d_.zext(address, 24, 32), 32);
  }
  Spot<D> handedPlace(const Context& c, std::uint32_t parameter, std::uint32_t offset, Width width);
  static std::uint32_t ownPointers(const Pou& pou);
  Bits handedAddress(std::uint32_t parameter);
  Bits elementaryAddress(const Operand& o);
  HandedPointer<D> pointerTo(const Operand& o, const Context& c, std::uint32_t moreBits, bool isOwn,
                             std::uint32_t unknown);
  HandedPointer<D> unknownPlace(std::uint32_t index);
  bool isElementaryReference(const Operand& o) const;
  Bits pointerValue(const Operand& o, const Context& c);
  /// Of a data block in the work memory; one that stays in the load memory is not loaded (002:537-563).
  std::uint32_t loadedLength(std::uint32_t block) const {
    return m_.plan.blocks->isUnlinked(block) ? 0 : m_.plan.blocks->length(block);
  }
  /// Decodes a location; false if no access of that width may reach it, with the error.
  bool decode(std::uint64_t location, Width width, Area& area, std::uint32_t& offset, std::uint32_t& bit,
              Hazard& error) const;
  void meetErrorsAt(Bits location, Width width);
  Bits loadPlace(Area area, std::uint32_t offset, std::uint32_t bit, Width width);
  void savePlace(Area area, std::uint32_t offset, std::uint32_t bit, Width width, Bits value);
  Bool answersNot(std::uint32_t offset);

  Machine<D>& m_;
  D& d_;
};

template <class D>
Spot<D> Step7Places<D>::find(const Operand& o, Width width, const Context& c, std::uint32_t moreBytes,
                             std::uint32_t moreBits, bool opens) {
  switch (o.kind) {
    case OperandKind::Constant: {
      Spot<D> spot;
      spot.isValue = true;
      spot.value = number(static_cast<std::uint64_t>(o.value) & 0xFFFFFFFF, 32);
      return spot;
    }
    case OperandKind::Direct: return direct(o, width, c, moreBytes, moreBits, opens);
    case OperandKind::Address: {
      Spot<D> spot;
      spot.isValue = true;
      spot.value = addressOf(o);
      return spot;
    }
    case OperandKind::Indirect: break;
    default: return {.isValue = true, .value = number(0, 32)};
  }
  CHECK(o.reach != nullptr, "an indirect operand of an S7-300 says how it finds its place");
  const Reach& reach = *o.reach;
  const std::uint32_t offset = o.offset + moreBytes, bit = o.bit + moreBits;
  // Pointers within the area count local memory from the block's own; crossing() knows by itself.
  const std::uint32_t own = o.area == Area::L && c.running != nullptr ? c.running->localBase : 0;
  const Bits area = number(static_cast<std::uint64_t>(o.area), 8);
  const Bits block = o.area == Area::DB ? (reach.inDi ? c.di : c.db) : number(0, 16);
  switch (reach.way) {
    case Way::OpenBlock: return at(location(area, block, number(offset * 8 + bit, 24)), width);
    case Way::Instance: return at(location(area, c.di, beyond(address(c.ar2), offset, bit)), width);
    case Way::Parameter: {
      const Operand* given = actual(c, reach.parameter);
      if (given == nullptr || given->kind == OperandKind::Missing) return {.isValue = true, .value = number(0, 32)};
      return find(*given, width, callerOf(c), offset, bit, false);
    }
    case Way::Pointer:
      return at(location(area, block, beyond(address(pointerValue(reach.pointer, c)), offset + own, bit)), width);
    case Way::Register: {
      const Bits start = address(reach.byAr2 ? c.ar2 : m_.step7.ar[0]);
      return at(location(area, block, beyond(start, offset + own, bit)), width);
    }
    case Way::Crossing: return at(crossing(reach.byAr2 ? c.ar2 : m_.step7.ar[0], offset, bit, c), width);
    case Way::Handed: return handedPlace(c, reach.parameter, offset, width);
    case Way::PointerTo: break;  // an actual parameter: read by handed()
  }
  return {};
}

template <class D>
Spot<D> Step7Places<D>::direct(const Operand& o, Width width, const Context& c, std::uint32_t moreBytes,
                               std::uint32_t moreBits, bool opens) {
  Spot<D> spot;
  const std::uint32_t bits = o.bit + moreBits;
  spot.area = o.area;
  spot.offset = o.offset + moreBytes + bits / 8;
  spot.bit = bits % 8;
  spot.isPlace = true;
  if (o.area == Area::L) {
    spot.offset += c.running == nullptr ? 0 : c.running->localBase;
  } else if (o.area == Area::DB) {
    const std::uint32_t block = blockOfByte(o.offset);
    if (opens) m_.put(m_.step7.db, number(block, 16), 16);
    const std::uint32_t length = loadedLength(block);
    const std::uint32_t end = byteInBlock(spot.offset) + static_cast<std::uint32_t>(bytes(width));
    if (end <= length) return spot;
    m_.error(length == 0 ? Hazard::S7BlockMissing : Hazard::S7AreaLength, d_.constant(true));
    return {};
  } else if (!hasBitAndWord(o.area) && spot.offset + static_cast<std::uint32_t>(bytes(width)) > m_.areaSize(o.area)) {
    m_.error(Hazard::S7AreaLength, d_.constant(true));
    return {};
  }
  return spot;
}

/// The pointer that stands in memory; a word is a number, a double word a bit address.
template <class D>
typename D::Bits Step7Places<D>::pointerValue(const Operand& o, const Context& c) {
  return load(find(o, o.width, c, 0, 0, false), o.width);
}

template <class D>
typename D::Bits Step7Places<D>::crossing(Bits pointer, std::uint32_t offset, std::uint32_t bit, const Context& c) {
  const Bits code = d_.extract(pointer, 26, 24);
  const auto isCode = [&](PointerArea area) { return d_.equal(code, number(static_cast<std::uint64_t>(area), 3), 3); };
  Bits area = number(255, 8), block = number(0, 16);
  const std::pair<PointerArea, Area> areas[] = {
      {PointerArea::P, Area::PI},  {PointerArea::I, Area::I},   {PointerArea::Q, Area::Q}, {PointerArea::M, Area::M},
      {PointerArea::Db, Area::DB}, {PointerArea::Di, Area::DB}, {PointerArea::L, Area::L}, {PointerArea::V, Area::L}};
  for (const auto& [from, to] : areas)
    area = d_.select(isCode(from), number(static_cast<std::uint64_t>(to), 8), area, 8);
  area = d_.select(d_.bit(pointer, 31), area, number(255, 8), 8);
  block = d_.select(isCode(PointerArea::Db), c.db, block, 16);
  block = d_.select(isCode(PointerArea::Di), c.di, block, 16);
  const std::uint32_t own = c.running == nullptr ? 0 : c.running->localBase;
  const std::uint32_t callers = c.running == nullptr || c.running->caller == nullptr ? 0 : c.running->caller->localBase;
  Bits start = beyond(address(pointer), offset, bit);
  start = d_.select(isCode(PointerArea::L), d_.add(start, number(own * 8, 24), 24), start, 24);
  start = d_.select(isCode(PointerArea::V), d_.add(start, number(callers * 8, 24), 24), start, 24);
  return location(area, block, start);
}

template <class D>
bool Step7Places<D>::decode(std::uint64_t location, Width width, Area& area, std::uint32_t& offset, std::uint32_t& bit,
                            Hazard& error) const {
  const auto code = static_cast<std::uint32_t>(location >> 40);
  const auto block = static_cast<std::uint32_t>(location >> 24 & 0xFFFF);
  const auto address = static_cast<std::uint32_t>(location & 0xFFFFFF);
  if (code >= areaCount) {
    error = Hazard::S7AreaUnknown;
    return false;
  }
  area = static_cast<Area>(code);
  offset = address / 8;
  bit = address % 8;
  if (width != Width::Bit && bit != 0) {
    error = Hazard::S7Alignment;
    return false;
  }
  const std::uint32_t end = offset + static_cast<std::uint32_t>(bytes(width));
  const std::uint32_t length = area == Area::DB  ? loadedLength(block)
                               : area == Area::L ? m_.plan.localBytes
                                                 : m_.areaSize(area);
  if (area == Area::DB) offset = dataByte(block, offset);
  error = area == Area::DB && length == 0 ? Hazard::S7BlockMissing : Hazard::S7AreaLength;
  return end <= length;
}

template <class D>
Spot<D> Step7Places<D>::at(Bits location, Width width) {
  Spot<D> spot;
  Hazard error{};
  if (const auto known = d_.known(location)) {
    if (decode(*known, width, spot.area, spot.offset, spot.bit, error)) {
      spot.isPlace = true;
      return spot;
    }
    m_.error(error, d_.constant(true));
    return {};
  }
  if constexpr (requires { d_.follows(m_, location, width, spot); }) {
    if (d_.follows(m_, location, width, spot)) return spot;
  }
  if constexpr (!std::same_as<Bool, bool>) {
    std::optional<std::vector<std::uint64_t>> values = d_.locations(m_, location);
    const bool isComplete = values.has_value();
    if (!isComplete) values = d_.locationsInBlock(m_, location, width);
    if (!values) {
      meetErrorsAt(location, width);
      spot.isUnresolved = true;
      return spot;
    }
    Bool isAmong = d_.constant(isComplete);
    for (const std::uint64_t value : *values) {
      const Bool isValue = d_.equal(location, number(value, locationBits), locationBits);
      isAmong = d_.lor(isAmong, isValue);
      PointerTarget<D> target{isValue, Area::M, 0};
      if (decode(value, width, target.area, target.offset, target.bit, error))
        spot.targets.push_back(target);
      else
        m_.error(error, isValue);
    }
    if (!isComplete) {
      const Bool isBeyond = d_.lnot(isAmong), isBit = d_.constant(width == Width::Bit);
      const Bool isWhole = d_.lor(isBit, d_.equal(d_.extract(location, 2, 0), number(0, 3), 3));
      m_.error(Hazard::S7Alignment, d_.land(isBeyond, d_.lnot(isWhole)));
      m_.error(Hazard::S7AreaLength, d_.land(isBeyond, isWhole));
    }
  }
  return spot;
}

/// What decode() says, of a place that can be too many to be listed: which access is an error is exact, only what
/// stands there is not known.
template <class D>
void Step7Places<D>::meetErrorsAt(Bits location, Width width) {
  const Bits code = d_.extract(location, 47, 40), block = d_.extract(location, 39, 24),
             bit = d_.extract(location, 23, 0);
  const Bool isBit = d_.constant(width == Width::Bit);
  const Bool isWhole = d_.lor(isBit, d_.equal(d_.extract(bit, 2, 0), number(0, 3), 3));
  const auto isIn = [&](Area area) { return d_.equal(code, number(static_cast<std::uint64_t>(area), 8), 8); };
  // The access begins in front of the first bit address at which it would pass the end.
  const auto fits = [&](std::uint32_t length) {
    const auto own = static_cast<std::uint32_t>(bytes(width));
    if (length < own) return d_.constant(false);
    const std::uint64_t end = (static_cast<std::uint64_t>(length) - own + 1) * 8;
    return end > 0xFFFFFF ? d_.constant(true) : d_.ult(bit, number(end, 24), 24);
  };
  Bool reaches = d_.constant(false), isLoaded = d_.constant(false);
  for (std::uint32_t i = 0; i < areaCount; ++i) {
    const auto area = static_cast<Area>(i);
    if (area == Area::DB) continue;
    const Bool here = isIn(area);
    if (const auto known = d_.truth(here); known && !*known) continue;
    reaches = d_.lor(reaches, d_.land(here, fits(area == Area::L ? m_.plan.localBytes : m_.areaSize(area))));
  }
  const Bool isData = isIn(Area::DB);
  const auto data = d_.truth(isData);
  for (std::uint32_t n = 0; (!data || *data) && n <= lastDataBlock; ++n) {
    if (loadedLength(n) == 0) continue;
    const Bool here = d_.land(isData, d_.equal(block, number(n, 16), 16));
    isLoaded = d_.lor(isLoaded, here);
    reaches = d_.lor(reaches, d_.land(here, fits(loadedLength(n))));
  }
  const Bool isArea = d_.ult(code, number(areaCount, 8), 8);
  const Bool isMissing = d_.land(isData, d_.lnot(isLoaded));
  m_.error(Hazard::S7AreaUnknown, d_.lnot(isArea));
  m_.error(Hazard::S7Alignment, d_.land(isArea, d_.lnot(isWhole)));
  m_.error(Hazard::S7BlockMissing, d_.land(isWhole, isMissing));
  m_.error(Hazard::S7AreaLength, d_.land(d_.land(isArea, isWhole), d_.land(d_.lnot(isMissing), d_.lnot(reaches))));
}

/// Whether the module does not answer, which calls OB122 (002:1292). Without OB122 all of them do.
template <class D>
typename D::Bool Step7Places<D>::answersNot(std::uint32_t offset) {
  if (m_.plan.block(accessErrorBlock) == nullptr) return d_.constant(false);
  const Bool fails = d_.bit(m_.external(External::AccessError, offset, 1), 0);
  m_.accessError(fails);
  return fails;
}

template <class D>
typename D::Bits Step7Places<D>::loadPlace(Area area, std::uint32_t offset, std::uint32_t bit, Width width) {
  if (area == Area::I && m_.isStartUp) return number(0, bits(width));
  if (area != Area::PI) return m_.store.load(area, offset * 8 + bit, bits(width));
  const int w = bits(width);
  const Bool fails = answersNot(offset);
  const auto unlessFailed = [&](Bits value) {
    constexpr std::uint32_t index = 0x301;
    if (m_.plan.block(accessErrorBlock) == nullptr) return value;
    return d_.select(fails, m_.external(External::UnknownResult, index, w), value, w);
  };
  // A module is read at once; its words are samples of their own.
  if (width == Width::DWord) {
    const Bits first = m_.external(External::AnalogInput, offset, 16);
    return unlessFailed(d_.concat(first, 16, m_.external(External::AnalogInput, offset + 2, 16), 16));
  }
  const Bits word = m_.external(External::AnalogInput, offset, 16);
  return unlessFailed(width == Width::Word ? word : d_.extract(word, 15, 8));
}

template <class D>
typename D::Bits Step7Places<D>::load(const Spot<D>& spot, Width width) {
  const int w = bits(width);
  const auto wide = [&](Bits value) { return w == 32 ? value : d_.zext(value, w, 32); };
  if (spot.isValue) return w == 32 ? spot.value : wide(d_.extract(spot.value, w - 1, 0));
  if (spot.isUnresolved) return wide(d_.unresolved(m_, w));
  if constexpr (requires { d_.loadComputed(spot, width); }) {
    if (spot.isComputed) return wide(d_.loadComputed(spot, width));
  }
  if (spot.isPlace) return wide(loadPlace(spot.area, spot.offset, spot.bit, width));
  Bits result = number(0, w);
  Bool isReached = d_.constant(false);
  for (const PointerTarget<D>& t : spot.targets) {
    isReached = d_.lor(isReached, t.condition);
    m_.when(t.condition,
            [&] { result = d_.select(t.condition, loadPlace(t.area, t.offset, t.bit, width), result, w); });
  }
  // Where the program goes on behind the error, any value.
  constexpr std::uint32_t index = 0x300;  // beside what instructions leave open
  if (m_.survivesErrors())
    m_.when(d_.lnot(isReached),
            [&] { result = d_.select(isReached, result, m_.external(External::UnknownResult, index, w), w); });
  return wide(result);
}

template <class D>
void Step7Places<D>::savePlace(Area area, std::uint32_t offset, std::uint32_t bit, Width width, Bits value) {
  if (area == Area::I && m_.isStartUp) return;  // gone when the inputs are read
  if (area == Area::PI) area = Area::PQ;        // P in pointers: what is written goes out
  if (area == Area::DB && m_.plan.blocks->isReadOnly(blockOfByte(offset)))
    return m_.error(Hazard::S7WriteProtected, d_.constant(true));  // 002:1288
  if (area != Area::PQ) return m_.store.save(area, offset * 8 + bit, bits(width), value, m_.guard);
  constexpr std::uint32_t index = 0x302;
  const Bool guard = m_.guard, fails = answersNot(offset);
  // Whether the image has what the module did not take is not stated: either.
  if (m_.plan.block(accessErrorBlock) != nullptr)
    m_.guard = d_.land(guard, d_.lor(d_.lnot(fails), d_.bit(m_.external(External::UnknownResult, index, 1), 0)));
  m_.store.save(area, offset * 8 + bit, bits(width), value, m_.guard);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(bytes(width)); ++i) {  // the image follows
    if (offset + i >= m_.areaSize(Area::Q)) break;
    m_.store.save(Area::Q, (offset + i) * 8, 8, m_.store.load(Area::PQ, (offset + i) * 8, 8), m_.guard);
  }
  m_.guard = guard;
}

/// `value`: at least the width of the access.
template <class D>
void Step7Places<D>::save(const Spot<D>& spot, Width width, Bits value) {
  if (spot.isUnresolved) return d_.havoc(m_);
  const int w = bits(width);
  const Bits cut = width == Width::Bit || width == Width::DWord ? value : d_.extract(value, w - 1, 0);
  if constexpr (requires { d_.saveComputed(spot, width, cut); }) {
    if (spot.isComputed) return d_.saveComputed(spot, width, cut);
  }
  if (spot.isPlace) return savePlace(spot.area, spot.offset, spot.bit, width, cut);
  for (const PointerTarget<D>& t : spot.targets)
    m_.when(t.condition, [&] { savePlace(t.area, t.offset, t.bit, width, cut); });
}

template <class D>
template <class Visit>
void Step7Places<D>::eachNumber(const Operand& o, Visit&& visit) {
  const Operand* operand = &o;
  Context c = here();
  while (operand != nullptr && operand->reach != nullptr && operand->reach->way == Way::Parameter) {
    operand = actual(c, operand->reach->parameter);
    c = callerOf(c);
  }
  if (operand == nullptr || operand->kind == OperandKind::Missing) return;
  const bool isTimer = o.area == Area::T;
  const std::uint32_t count = m_.areaSize(isTimer ? Area::T : Area::C);
  const Hazard error = isTimer ? Hazard::S7TimerNumber : Hazard::S7CounterNumber;
  if (operand->kind == OperandKind::Direct) {
    if (operand->offset < count) return visit(operand->offset);
    return m_.error(error, d_.constant(true));
  }
  const Bits word = d_.extract(pointerValue(operand->reach->pointer, c), 15, 0);
  const Bool exists = d_.ult(word, number(count, 16), 16);
  m_.error(error, d_.lnot(exists));
  if (const auto known = d_.known(word)) {
    if (*known < count) visit(static_cast<std::uint32_t>(*known));
    return;
  }
  for (std::uint32_t i = 0; i < count; ++i) m_.when(d_.equal(word, number(i, 16), 16), [&] { visit(i); });
}

template <class D>
typename D::Bool Step7Places<D>::bitOf(const Operand& o) {
  if (!hasBitAndWord(o.area) || !o.isMemory()) return loadBit(find(o, Width::Bit));
  Bool result = d_.constant(false);
  eachNumber(o, [&](std::uint32_t number) {
    const Bool bit = m_.getBit(o.area == Area::T ? Reg::TimerBit : Reg::CounterBit, number);
    result = d_.select(m_.guard, bit, result);
  });
  return result;
}

template <class D>
typename D::Bits Step7Places<D>::blockNumberOf(const Operand& o) {
  const Operand* operand = &o;
  Context c = here();
  while (operand != nullptr && operand->reach != nullptr && operand->reach->way == Way::Parameter) {
    operand = actual(c, operand->reach->parameter);
    c = callerOf(c);
  }
  if (operand == nullptr || operand->kind == OperandKind::Missing) return number(0, 16);
  if (operand->kind == OperandKind::Constant) return number(static_cast<std::uint64_t>(operand->value) & 0xFFFF, 16);
  if (operand->kind == OperandKind::Direct) return number(blockOfByte(operand->offset), 16);
  return d_.extract(pointerValue(operand->reach->pointer, c), 15, 0);
}

template <class D>
typename D::Bits Step7Places<D>::addressOf(const Operand& o) {
  if (o.reach != nullptr && o.reach->way == Way::Handed) return handedAddress(o.reach->parameter);
  if (o.reach != nullptr && o.reach->way == Way::Parameter) return elementaryAddress(o);
  if (o.reach != nullptr && o.reach->way == Way::Instance)
    return areaPointer(PointerArea::Di, number(o.offset * 8 + o.bit, 24));
  const PointerArea area = o.reach == nullptr && o.area == Area::L ? PointerArea::L : PointerArea::V;
  return areaPointer(area, number(o.offset * 8 + o.bit, 24));
}

}  // namespace rungproof
