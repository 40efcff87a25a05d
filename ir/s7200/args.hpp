// Args<D>: the operands of the instruction being executed, resolved and typed by its descriptor. Pointers are
// followed once, before the meaning runs; a bad one is error 0006, in a compare contact fatal (001:2347, 001:3384).
#pragma once

#include <algorithm>

#include "ir/check.hpp"
#include "ir/machine/machine.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

template <class D>
class Args {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  Args(Machine<D>& machine, const Instruction& instruction, const Desc& desc)
      : m_(machine), instruction_(instruction), desc_(desc) {}

  /// Follows all operands. Gives the condition that every pointer is legal.
  Bool resolve() {
    Bool legal = m_.d.constant(true);
    const std::size_t count = std::min<std::size_t>(instruction_.operands.size(), desc_.operandCount);
    for (std::size_t i = 0; i < count; ++i)
      legal = m_.d.land(legal, resolveOne(instruction_.operands[i], widthOf(desc_.operands[i].type),
                                          desc_.operands[i].direction, refs_[i]));
    return legal;
  }

  /// Operand i is known to be a direct address in `area`: what resolve() finds, without looking.
  void bind(std::size_t i, Area area) {
    const Operand& o = instruction_.operands[i];
    refs_[i].operand = &o;
    refs_[i].isPlace = true;
    refs_[i].area = area;
    refs_[i].offset = o.offset;
    refs_[i].bit = o.bit;
  }

  const Instruction& instruction() const { return instruction_; }
  const Operand& operand(std::size_t i) const { return instruction_.operands[i]; }
  std::size_t size() const { return instruction_.operands.size(); }
  Ref<D>& ref(std::size_t i) { return placeOf(i); }

  /// Value of operand i in the width of its type.
  Bits value(std::size_t i) { return load(refs_[i], 0, width(i)); }
  Bool bit(std::size_t i) { return m_.d.bit(load(refs_[i], 0, Width::Bit), 0); }
  void store(std::size_t i, Bits value) { save(refs_[i], 0, width(i), value); }
  void storeBit(std::size_t i, Bool value) { save(refs_[i], 0, Width::Bit, m_.d.fromBool(value, 1)); }
  /// Number of a timer, counter, label, event ...: the constant or the T/C number itself.
  std::uint32_t number(std::size_t i) const {
    const Operand& o = instruction_.operands[i];
    return o.kind == OperandKind::Constant ? static_cast<std::uint32_t>(o.value) : o.offset;
  }

  /// Element k of a buffer that starts at operand i: k widths further on (T and C: k numbers).
  Bits element(std::size_t i, int k, Width w) { return load(refs_[i], k, w); }
  void storeElement(std::size_t i, int k, Width w, Bits value) { save(refs_[i], k, w, value); }
  /// Byte k of a string operand: 0 is the length; string constants read the same way.
  Bits byteAt(std::size_t i, int k) { return element(i, k, Width::Byte); }
  /// Bit k counted from a bit operand, over byte borders; T and C: bit of the k-th number further on.
  Bool bitAt(std::size_t i, int k) {
    const Ref<D>& r = placeOf(i);
    if (hasBitAndWord(r.area))
      return m_.d.bit(m_.load(r.area, r.offset + static_cast<std::uint32_t>(k), Width::Bit), 0);
    return m_.loadBit(r.area, r.offset, static_cast<std::uint32_t>(r.bit + k));
  }
  void storeBitAt(std::size_t i, int k, Bool value) {
    const Ref<D>& r = placeOf(i);
    if (hasBitAndWord(r.area))
      return m_.save(r.area, r.offset + static_cast<std::uint32_t>(k), Width::Bit, m_.d.fromBool(value, 1));
    m_.saveBit(r.area, r.offset, static_cast<std::uint32_t>(r.bit + k), value);
  }
  /// How many bits there are from bit operand i to the end of its area, or to a gap in it.
  std::uint32_t bitsLeft(std::size_t i) {
    const Ref<D>& r = placeOf(i);
    const std::uint32_t end = rowEnd(m_.target, r.area, r.offset);
    if (r.offset >= end) return 0;
    return hasBitAndWord(r.area) ? end - r.offset : (end - r.offset) * 8 - r.bit;
  }
  /// Element at a computed index 0..limit-1 (width 16).
  Bits elementAt(std::size_t i, Bits index, int limit, Width w) {
    if (const auto known = m_.d.known(index)) return element(i, static_cast<int>(*known), w);
    Bits result = element(i, 0, w);
    for (int k = 1; k < limit; ++k)
      result = m_.d.select(m_.d.equal(index, m_.d.literal(k, 16), 16), element(i, k, w), result, bits(w));
    return result;
  }
  void storeElementAt(std::size_t i, Bits index, int limit, Width w, Bits value) {
    if (const auto known = m_.d.known(index)) return storeElement(i, static_cast<int>(*known), w, value);
    for (int k = 0; k < limit; ++k)
      m_.when(m_.d.equal(index, m_.d.literal(k, 16), 16), [&] { storeElement(i, k, w, value); });
  }
  /// Actual parameter i of CALL in the width of the formal one (001:6782-6784): a value, an address, or, for
  /// STRING, the address in the pointer itself (001:6836).
  Bits parameter(std::size_t i, DataType type) {
    const Operand& o = instruction_.operands[i];
    if (type == DataType::String && o.kind == OperandKind::Indirect) return m_.load(o.area, o.offset, Width::DWord);
    if (type == DataType::String && o.kind == OperandKind::Text) {
      const auto& texts = m_.plan.texts;
      const auto found = std::find(texts.begin(), texts.end(), &o);
      CHECK(found != texts.end(), "string constant that the plan does not know");
      return m_.d.literal(pointer::encodeText(static_cast<std::size_t>(found - texts.begin())), 32);
    }
    Ref<D> ref;
    const Bool legal = resolveOne(o, widthOf(type), Direction::In, ref);
    m_.hazard(Hazard::BadIndirectAddress, m_.d.lnot(legal));
    return load(ref, 0, widthOf(type));
  }
  void storeParameter(std::size_t i, DataType type, Bits value) {
    const Operand& o = instruction_.operands[i];
    if (type == DataType::String) return;
    Ref<D> ref;
    const Bool legal = resolveOne(o, widthOf(type), Direction::Out, ref);
    m_.hazard(Hazard::BadIndirectAddress, m_.d.lnot(legal));
    m_.when(legal, [&] { save(ref, 0, widthOf(type), value); });
  }
  /// Whether `count` elements (width 16 number) from operand i stay inside the area on this CPU.
  Bool fits(std::size_t i, Bits count, Width w);
  /// False if two operands lie in areas of which one has nothing to do with the other.
  bool mayOverlap(std::size_t i, std::size_t j) const {
    const Ref<D>&a = refs_[i], &b = refs_[j];
    return !(a.isPlace && b.isPlace && a.area != b.area) && a.text == nullptr && b.text == nullptr;
  }
  /// The largest count that can fit, at most `cap`: how far a loop over the buffer has to look.
  int room(std::size_t i, Width w, int cap);
  /// Calls visit(condition, area, offset) for each place that operand i may be.
  template <class Visit>
  void eachPlace(std::size_t i, Visit&& visit) {
    const Ref<D>& ref = placeOf(i);
    if (ref.isPlace) visit(m_.d.constant(true), ref.area, ref.offset);
    for (const PointerTarget<D>& t : ref.targets) visit(t.condition, t.area, t.offset);
  }
  /// Follows an address that stands in no operand (pointer form, width 32); gives whether it is legal.
  Bool follow(Bits address, Width w, Ref<D>& ref);
  /// Element k of what follow() found.
  Bits elementOf(Ref<D>& ref, int k, Width w) { return load(ref, k, w); }
  /// Width of operand i by its type.
  Width width(std::size_t i) const { return widthOf(desc_.operands[i].type); }

 private:
  /// Operand i, of which not only values are wanted: a domain that follows pointers itself has no answer there.
  Ref<D>& placeOf(std::size_t i) {
    if constexpr (requires { m_.d.cannotFollow(1); }) {
      if (refs_[i].isComputed) m_.d.cannotFollow(1);
    }
    return refs_[i];
  }
  Bool resolveOne(const Operand& o, Width w, Direction direction, Ref<D>& ref);
  Bool followText(Bits address, Ref<D>& ref);
  Bits loadText(const Ref<D>& ref, int element, Width w, Bits otherwise);
  std::uint32_t left(Area area, std::uint32_t offset, Width w) const {
    const bool byNumber = hasBitAndWord(area);
    const std::uint32_t end = rowEnd(m_.target, area, offset);
    return offset >= end ? 0 : (end - offset) / static_cast<std::uint32_t>(byNumber ? 1 : bytes(w));
  }
  Bits load(Ref<D>& ref, int element, Width w);
  void save(Ref<D>& ref, int element, Width w, Bits value);
  static std::uint32_t advance(Area area, std::uint32_t offset, int element, Width w) {
    const bool byNumber = addressedByNumber(area);
    return offset + static_cast<std::uint32_t>(element * (byNumber ? 1 : bytes(w)));
  }

  Machine<D>& m_;
  const Instruction& instruction_;
  const Desc& desc_;
  std::array<Ref<D>, maxOperands> refs_;
};

template <class D>
typename D::Bool Args<D>::resolveOne(const Operand& o, Width w, Direction direction, Ref<D>& ref) {
  ref.operand = &o;
  switch (o.kind) {
    case OperandKind::Constant:
      ref.value = m_.d.literal(static_cast<std::uint64_t>(o.value) & (~0ULL >> (64 - bits(w))), bits(w));
      break;
    case OperandKind::Address: ref.value = m_.d.literal(pointer::encode(o.area, o.offset), 32); break;
    case OperandKind::Direct:
      ref.isPlace = true;
      ref.area = o.area;
      ref.offset = o.offset;
      ref.bit = o.bit;
      break;
    case OperandKind::Indirect: {
      const Bits address = m_.load(o.area, o.offset, Width::DWord);
      const Bool legal = follow(address, w, ref);
      if (direction != Direction::In || w != Width::Byte || m_.plan.texts.empty()) return legal;
      return m_.d.lor(legal, followText(address, ref));
    }
    case OperandKind::Text: ref.text = &o; break;
    default: break;
  }
  return m_.d.constant(true);
}

/// Lets ref name the string constants that the address may be; gives whether it is one of them.
template <class D>
typename D::Bool Args<D>::followText(Bits address, Ref<D>& ref) {
  Bool isText = m_.d.constant(false);
  for (std::size_t i = 0; i < m_.plan.texts.size(); ++i)
    isText = m_.d.lor(isText, m_.d.equal(address, m_.d.literal(pointer::encodeText(i), 32), 32));
  const auto known = m_.d.truth(isText);
  ref.mayBeText = !known || *known;
  if (ref.mayBeText) ref.value = address;
  return isText;
}

template <class D>
typename D::Bits Args<D>::loadText(const Ref<D>& ref, int element, Width w, Bits otherwise) {
  const auto byteOf = [&](const std::string& text) {
    const auto at = static_cast<std::size_t>(element);
    return m_.d.literal(at == 0             ? text.size()
                        : at <= text.size() ? static_cast<unsigned char>(text[at - 1])
                                            : 0,
                        bits(w));
  };
  if (ref.text != nullptr) return byteOf(ref.text->text);
  Bits result = otherwise;
  for (std::size_t i = 0; i < m_.plan.texts.size(); ++i) {
    const Bool isThis = m_.d.equal(ref.value, m_.d.literal(pointer::encodeText(i), 32), 32);
    result = m_.d.select(isThis, byteOf(m_.plan.texts[i]->text), result, bits(w));
  }
  return result;
}

template <class D>
typename D::Bool Args<D>::follow(Bits address, Width w, Ref<D>& ref) {
  const auto known = m_.d.known(address);
  // A proof keeps where requests have their tables, so that it is asked for those that are known as well.
  constexpr bool isProof = !std::same_as<Bool, bool>;
  if (!known || (isProof && desc_.group == "communication")) return m_.d.targets(m_, address, w, ref);
  const auto value = static_cast<std::uint32_t>(*known);
  if (!pointer::isLegal(m_.target, value, w)) return m_.d.constant(false);
  ref.isPlace = true;
  ref.area = *pointer::areaOf(value);
  ref.offset = pointer::offsetOf(value);
  return m_.d.constant(true);
}

template <class D>
typename D::Bits Args<D>::load(Ref<D>& ref, int element, Width w) {
  if (ref.isPlace) return m_.load(ref.area, advance(ref.area, ref.offset, element, w), w, ref.bit);
  if constexpr (requires { m_.d.loadAt(ref, element, w); }) {
    if (ref.isComputed) return m_.d.loadAt(ref, element, w);
  }
  if (ref.isUnresolved) return m_.d.unresolved(m_, bits(w));
  if (ref.text != nullptr) return loadText(ref, element, w, {});
  if (ref.targets.empty() && !ref.mayBeText) return ref.value;
  Bits result = m_.d.literal(0, bits(w));
  for (const PointerTarget<D>& t : ref.targets) {
    const std::uint32_t at = advance(t.area, t.offset, element, w);
    if (at < areaSize(m_.target, t.area)) result = m_.d.select(t.condition, m_.load(t.area, at, w), result, bits(w));
  }
  return ref.mayBeText ? loadText(ref, element, w, result) : result;
}

template <class D>
void Args<D>::save(Ref<D>& ref, int element, Width w, Bits value) {
  if (ref.isPlace) return m_.save(ref.area, advance(ref.area, ref.offset, element, w), w, value, ref.bit);
  if constexpr (requires { m_.d.saveAt(ref, element, w, value); }) {
    if (ref.isComputed) return m_.d.saveAt(ref, element, w, value);
  }
  if (ref.isUnresolved) return m_.d.havoc(m_);
  for (const PointerTarget<D>& t : ref.targets) {
    const std::uint32_t at = advance(t.area, t.offset, element, w);
    if (at < areaSize(m_.target, t.area)) m_.when(t.condition, [&] { m_.save(t.area, at, w, value); });
  }
}

template <class D>
typename D::Bool Args<D>::fits(std::size_t i, Bits count, Width w) {
  const Ref<D>& ref = placeOf(i);
  const auto enough = [&](Area area, std::uint32_t offset) {
    return m_.d.ule(count, m_.d.literal(std::min<std::uint32_t>(left(area, offset, w), 0xFFFF), 16), 16);
  };
  if (ref.isPlace) return enough(ref.area, ref.offset);
  Bool result = m_.d.constant(true);
  for (const PointerTarget<D>& t : ref.targets) result = m_.d.select(t.condition, enough(t.area, t.offset), result);
  return result;  // a string constant is as long as its length byte says
}

template <class D>
int Args<D>::room(std::size_t i, Width w, int cap) {
  const Ref<D>& ref = placeOf(i);
  if (ref.isUnresolved) return cap;
  std::size_t longest = ref.text == nullptr ? 0 : ref.text->text.size() + 1;
  for (const Operand* text : m_.plan.texts) longest = std::max(longest, ref.mayBeText ? text->text.size() + 1 : 0);
  std::uint32_t most = ref.isPlace ? left(ref.area, ref.offset, w) : static_cast<std::uint32_t>(longest);
  for (const PointerTarget<D>& t : ref.targets) most = std::max(most, left(t.area, t.offset, w));
  return std::min(cap, static_cast<int>(most));
}

/// Runs one instruction of type Op: the frame that its class of execution prescribes, around its meaning.
template <class Op, class D>
void execute(Machine<D>& m, const Instruction& instruction) {
  constexpr const Desc& desc = Op::desc;
  const auto body = [&] {
    Args<D> args(m, instruction, desc);
    const typename D::Bool legal = args.resolve();
    if constexpr (desc.eno) m.enoAfter(desc.execution == Execution::Sampled ? m.powerFlow() : m.d.constant(true));
    const bool isFatal = desc.execution == Execution::Compare && m.features.stopsInCompare;
    m.hazard(isFatal ? Hazard::FatalIndirectAddress : Hazard::BadIndirectAddress, m.d.lnot(legal));
    m.when(legal, [&] { Op::run(m, args); });
    if constexpr (desc.execution == Execution::Compare) {
      if (!isFatal) m.when(m.d.lnot(legal), [&] { Op::fails(m); });
    }
  };
  if constexpr (desc.execution == Execution::Conditional) {
    const typename D::Bool runs = m.powerFlow();
    if constexpr (desc.eno) m.when(m.d.lnot(runs), [&] { m.enoAfter(m.d.constant(false)); });
    m.when(runs, body);
  } else {
    body();
  }
}

}  // namespace rungproof
