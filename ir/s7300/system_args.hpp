// What blocks of the CPU and of the libraries work on that have no statements: the parameters of the call that runs, by
// their numbers in the interface (ir/s7300/library), and the memory that an ANY leads to. What the description of a
// block leaves open is any value. Tested by tests/step7/block_transfer_test.cpp.
#pragma once

#include <algorithm>
#include <functional>

#include "ir/s7300/handed_pointer.hpp"

namespace rungproof {

/// A row of bytes in one area, all of which exist.
struct ByteRow {
  Area area = Area::M;
  std::uint32_t offset = 0;  ///< L: from the beginning of all local memory
  std::uint32_t bit = 0;     ///< of a single bit
  std::uint32_t length = 0;  ///< bytes
  bool isWritable = true;
};

/// One of the things that an ANY can be when the block begins.
template <class D>
struct AnyTarget {
  typename D::Bool condition;
  AnyType type = AnyType::Void;
  std::uint32_t count = 0;
  ByteRow row{};
  bool fails = false;   ///< no access may reach all of it: `row` is the part that exists
  bool isOpen = false;  ///< what the block makes of it is not stated
};

template <class D>
class SystemArgs {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  /// The activation of the block runs already.
  explicit SystemArgs(Machine<D>& machine)
      : m(machine), d(machine.d), s(machine.step7), places(machine), pou(*machine.step7.running->pou) {}

  Machine<D>& m;
  D& d;
  Step7Registers<D>& s;
  Step7Places<D> places;
  const Pou& pou;

  Bits number(std::uint64_t value, int width = 32) { return d.literal(value, width); }
  Bool yes() { return d.constant(true); }
  Bool no() { return d.constant(false); }
  /// A value that nothing determines. A run and its repetition ask for it under the same number, whatever else they
  /// skip because it is known to one of them.
  Bits any(int width) { return ask(nextUnknown_++, width); }
  Bool anyBit() { return d.bit(any(1), 0); }
  /// The same for the `index`th of a row of values, of which some may be left out.
  Bits anyOf(std::uint32_t index, int width) { return ask(ofRows | index, width); }
  /// `value` where `isStated` holds, any value elsewhere.
  Bits orAny(Bool isStated, Bits value, int width) { return orElse(nextUnknown_++, isStated, value, width); }
  Bits orAnyOf(std::uint32_t index, Bool isStated, Bits value, int width) {
    return orElse(ofRows | index, isStated, value, width);
  }
  Bool orAny(Bool isStated, Bool value) { return d.bit(orAny(isStated, d.fromBool(value, 1), 1), 0); }

  /// Whether the call hands a place over.
  bool isGiven(std::uint32_t parameter) const {
    const Instruction* call = s.running->call;
    const std::size_t first = hasInstance(pou) ? 2 : 1;
    if (call == nullptr || first + parameter >= call->operands.size()) return false;
    const OperandKind kind = call->operands[first + parameter].kind;
    return kind != OperandKind::Missing && kind != OperandKind::Constant;
  }

  /// An elementary parameter, in the width of its type.
  Bits value(std::uint32_t parameter) {
    const Width width = widthOfParameter(parameter);
    const Bits loaded = places.load(places.find(formal(parameter, 0), width), width);
    return width == Width::DWord ? loaded : d.extract(loaded, bits(width) - 1, 0);
  }
  Bool isSet(std::uint32_t parameter) { return d.bit(value(parameter), 0); }
  void set(std::uint32_t parameter, Bits value) {
    const Width width = widthOfParameter(parameter);
    places.save(places.find(formal(parameter, 0), width), width, value);
  }
  /// A byte of a parameter of complex type.
  Bits byteOf(std::uint32_t parameter, std::uint32_t byte) {
    return d.extract(places.load(places.find(formal(parameter, byte), Width::Byte), Width::Byte), 7, 0);
  }
  void setByte(std::uint32_t parameter, std::uint32_t byte, Bits value) {
    places.save(places.find(formal(parameter, byte), Width::Byte), Width::Byte, value);
  }

  /// What the ANY of the parameter can lead to; nothing if it cannot be told.
  std::optional<std::vector<AnyTarget<D>>> targets(std::uint32_t parameter);
  Bits load(const ByteRow& row, std::uint32_t byte, Width width) {
    return d.extract(places.loadFrom(row.area, row.offset + byte, row.bit, width), bits(width) - 1, 0);
  }
  void save(const ByteRow& row, std::uint32_t byte, Width width, Bits value) {
    places.saveTo(row.area, row.offset + byte, row.bit, width, value);
  }

  /// Any value where an ANY leads, as far as it exists.
  void spoil(const AnyTarget<D>& t) {
    if (!t.row.isWritable) return;
    if (t.type == AnyType::Bool && t.count == 1 && t.row.length == 1)
      return save(t.row, 0, Width::Bit, anyAt(t.row, 0, 1));
    for (std::uint32_t k = 0; k < t.row.length; ++k) save(t.row, k, Width::Byte, anyAt(t.row, k, 8));
  }
  /// Any value for a byte of a row.
  Bits anyAt(const ByteRow& row, std::uint32_t byte, int width) {
    return ask(ofPlaces | (static_cast<std::uint32_t>(row.area) & 3U) << 29 | (row.offset + byte), width);
  }

  /// The end of the block: BR says whether it met no error; the other registers are any value.
  void finish(Bool isWithoutError) {
    m.put(s.br, isWithoutError);
    for (Bool* bit : {&s.cc1, &s.cc0, &s.ov, &s.rlo}) m.put(*bit, anyBit());
    for (Bits& accu : s.accu) m.put(accu, any(32), 32);
    m.put(s.ar[0], any(32), 32);
  }

  /// Called where an interrupt can come while the block works.
  std::function<void()> between;

 private:
  static constexpr std::uint32_t firstUnknown = 0x1000, ofRows = 0x100000, ofPlaces = 0x80000000;

  Bits ask(std::uint32_t index, int width) { return m.external(External::UnknownResult, index, width); }
  Bits orElse(std::uint32_t index, Bool isStated, Bits value, int width) {
    const auto known = d.truth(isStated);
    return known && *known ? value : d.select(isStated, value, ask(index, width), width);
  }
  static constexpr std::size_t mostTargets = 1024;

  Operand formal(std::uint32_t parameter, std::uint32_t byte) const {
    Operand operand = pou.locals[parameter].address;
    operand.offset += byte;
    return operand;
  }
  Width widthOfParameter(std::uint32_t parameter) const {
    switch (pou.locals[parameter].size) {
      case 0: return Width::Bit;
      case 1: return Width::Byte;
      case 2: return Width::Word;
      default: return Width::DWord;
    }
  }
  std::optional<std::vector<std::uint64_t>> valuesOf(Bits bits);

  std::uint32_t nextUnknown_ = firstUnknown;
};

template <class D>
std::optional<std::vector<std::uint64_t>> SystemArgs<D>::valuesOf(Bits bits) {
  if (const auto known = d.known(bits)) return std::vector<std::uint64_t>{*known};
  if constexpr (!std::same_as<Bool, bool>) return d.locations(m, bits);
  return std::nullopt;
}

template <class D>
std::optional<std::vector<AnyTarget<D>>> SystemArgs<D>::targets(std::uint32_t parameter) {
  const HandedPointer<D> pointer = places.loadHanded(parameter);
  const Bits place = places.locationOf(pointer);
  const auto heads = valuesOf(pointer.head), locations = valuesOf(place);
  if (!heads || !locations || heads->size() * locations->size() > mostTargets) return std::nullopt;
  std::vector<AnyTarget<D>> result;
  for (const std::uint64_t head : *heads) {
    for (const std::uint64_t location : *locations) {
      AnyTarget<D> target{
          d.land(d.equal(pointer.head, number(head), 32),
                 d.equal(place, d.literal(location, Step7Places<D>::locationBits), Step7Places<D>::locationBits))};
      target.type = static_cast<AnyType>(head >> 16 & 0xFF);
      target.count = static_cast<std::uint32_t>(head & 0xFFFF);
      const bool isBits = target.type == AnyType::Bool;
      const std::uint32_t length = isBits ? (target.count + 7) / 8 : elementBytes(target.type) * target.count;
      target.isOpen = head >> 24 != 0x10 || length == 0;
      target.fails = !places.rowAt(location, length, isBits, target.row);
      result.push_back(target);
    }
  }
  return result;
}

/// The bytes from a location on that exist, at most `length`; false if they are fewer, or if no block may reach them.
template <class D>
bool Step7Places<D>::rowAt(std::uint64_t location, std::uint32_t length, bool isBits, ByteRow& row) const {
  const auto code = static_cast<std::uint32_t>(location >> 40);
  const auto block = static_cast<std::uint32_t>(location >> 24 & 0xFFFF);
  const auto address = static_cast<std::uint32_t>(location & 0xFFFFFF);
  constexpr Area legal[] = {Area::I, Area::Q, Area::M, Area::L, Area::DB};
  if (code >= areaCount || std::ranges::find(legal, static_cast<Area>(code)) == std::end(legal)) return false;
  row.area = static_cast<Area>(code);
  row.bit = address % 8;
  if (!isBits && row.bit != 0) return false;
  const std::uint32_t size = row.area == Area::DB  ? m_.plan.blocks->length(block)
                             : row.area == Area::L ? m_.plan.localBytes
                                                   : m_.areaSize(row.area);
  const std::uint32_t first = address / 8;
  row.length = first < size ? std::min(length, size - first) : 0;
  row.offset = row.area == Area::DB ? dataByte(block, first) : first;
  if (row.area == Area::DB) row.isWritable = !m_.plan.blocks->isReadOnly(block) && !m_.plan.blocks->isUnlinked(block);
  return row.length == length && length > 0;
}

}  // namespace rungproof
