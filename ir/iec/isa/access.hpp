// Values from and to variables: one variable, a constant, an element of an array whose index is computed.
#pragma once

#include "ir/iec/isa/iec_group.hpp"
#include "ir/machine/library_effect.hpp"

namespace rungproof::isa::iec {

struct LoadBit {
  static constexpr Desc desc =
      withOperands(described("LOAD.BIT", "push a BOOL variable"), {in("IN", Type::Bool, variable)});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.load(0));
  }
};

struct Load {
  static constexpr Desc desc = withOperands(described("LOAD", "push a variable"), {in("IN", Type::Value, variable)});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.load(0));
  }
};

struct StoreBit {
  static constexpr Desc desc =
      withOperands(described("STORE.BIT", "pop into a BOOL variable", Role::Move), {out("OUT", Type::Bool, variable)});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.save(0, a.pop());
  }
};

struct Store {
  static constexpr Desc desc =
      withOperands(described("STORE", "pop into a variable", Role::Move), {out("OUT", Type::Value, variable)});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.save(0, a.pop());
  }
};

struct Constant {
  static constexpr Desc desc = withOperands(described("CONST", "push a constant"), {part("VALUE"), part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.literal(static_cast<std::uint64_t>(a.number(0)), a.width(1)));
  }
};

/// The index of an array, counted from 0, 32 bits. One outside of it ends the scan, or means the nearest element, by
/// the reading in force.
struct Index {
  static constexpr Desc desc = withOperands(described("INDEX", "check the index of an array"), {part("COUNT")});
  template <class D>
  static void run(IecArgs<D>& a) {
    D& d = a.d;
    const auto index = a.pop();
    const auto count = static_cast<std::uint64_t>(a.number(0));
    const auto inside = d.ult(index, a.literal(count, 32), 32);
    const auto outside = d.lnot(inside);
    a.m.stop(Hazard::IecArrayRange, d.land(outside, a.m.reads({Choice::IecArrayRange, "fault"})));
    const auto nearest = d.select(d.bit(index, 31), a.literal(0, 32), a.literal(count - 1, 32), 32);
    a.push(d.select(inside, index, nearest, 32));
  }
};

/// Ends the scan where what is popped is TRUE: a value lies outside of the range that is declared for it.
struct RangeFault {
  static constexpr Desc desc = described("FAULT", "end the scan for a value outside its range");
  template <class D>
  static void run(IecArgs<D>& a) {
    a.m.stop(Hazard::IecRange, a.popBool());
  }
};

/// The elements that a computed index may reach: operand 0 is the first one, then the bytes of all, the bytes from one
/// to the next, and the width of a value. The index has been checked.
template <class D>
struct Elements {
  explicit Elements(IecArgs<D>& args)
      : a(args),
        stride(static_cast<std::uint32_t>(args.number(2))),
        width(widthOfBits(args.width(3))),
        count((static_cast<std::uint32_t>(args.number(1)) - static_cast<std::uint32_t>(bytes(width))) / stride + 1) {}

  IecArgs<D>& a;
  std::uint32_t stride;
  Width width;
  std::uint32_t count;

  typename D::Bits at(std::uint32_t i) { return a.m.load(a.operand(0).area, a.operand(0).offset + i * stride, width); }
};

struct LoadElement {
  static constexpr Desc desc = withOperands(
      described("LOAD.ELEMENT", "push an element of an array"),
      {in("FIRST", Type::Byte, variable).elements(1, 0).counted(1, 0), part("BYTES"), part("STEP"), part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    Elements<D> elements(a);
    const auto index = a.pop();
    if (const auto known = a.d.known(index)) return a.push(elements.at(static_cast<std::uint32_t>(*known)));
    auto value = elements.at(0);
    for (std::uint32_t i = 1; i < elements.count; ++i)
      value = a.d.select(a.d.equal(index, a.literal(i, 32), 32), elements.at(i), value, bits(elements.width));
    a.push(value);
  }
};

struct StoreElement {
  static constexpr Desc desc = withOperands(
      described("STORE.ELEMENT", "pop into an element of an array", Role::Move),
      {inout("FIRST", Type::Byte, variable).elements(1, 0).counted(1, 0), part("BYTES"), part("STEP"), part("WIDTH")});
  template <class D>
  static void run(IecArgs<D>& a) {
    Elements<D> elements(a);
    const auto value = a.pop();
    const auto index = a.pop();
    const Operand& first = a.operand(0);
    const auto save = [&](std::uint32_t i) {
      a.m.save(first.area, first.offset + i * elements.stride, elements.width, value);
    };
    if (const auto known = a.d.known(index)) return save(static_cast<std::uint32_t>(*known));
    for (std::uint32_t i = 0; i < elements.count; ++i)
      a.m.when(a.d.equal(index, a.literal(i, 32), 32), [&] { save(i); });
  }
};

/// What a block that no file has leaves in a variable.
struct AnyBit {
  static constexpr Desc desc = withOperands(described("ANY.BIT", "a block without text leaves any truth value"),
                                            {out("VARIABLE", Type::Bool, variable)});
  template <class D>
  static void run(IecArgs<D>& a) {
    const LibraryEffect effect{a.operand(0).area, a.operand(0).offset, a.operand(0).bit};
    a.save(0, a.m.external(External::LibraryOutput, effect.index(), 1));
  }
};
struct AnyBytes {
  static constexpr Desc desc =
      withOperands(described("ANY", "a block without text leaves any value"),
                   {out("VARIABLE", Type::Byte, variable).elements(1, 0).counted(1, 0), part("BYTES")});
  template <class D>
  static void run(IecArgs<D>& a) {
    const Operand& first = a.operand(0);
    for (std::uint32_t i = first.offset; i < first.offset + static_cast<std::uint32_t>(a.number(1)); ++i)
      a.m.save(first.area, i, Width::Byte,
               a.m.external(External::LibraryOutput, LibraryEffect{first.area, i}.index(), 8));
  }
};

using AccessGroup =
    Group<LoadBit, Load, StoreBit, Store, Constant, Index, RangeFault, LoadElement, StoreElement, AnyBit, AnyBytes>;

}  // namespace rungproof::isa::iec
