// Counters of an S7-300/400 (002:2869-2880, 003:769): 0 to 999; CU, CD and S act on a rising RLO of their own, R while
// the RLO is 1. Limits, preset in BCD and the memory of the RLO: general knowledge.
#pragma once

#include "ir/s7300/isa/convert.hpp"

namespace rungproof::isa::step7 {

constexpr Desc counterDesc(std::string_view stl, std::string_view german, std::string_view meaning,
                           std::string_view manual) {
  return withOperands(accuDesc(stl, german, meaning, "timers and counters", manual),
                      {in("counter", Type::Counter, form7::C)});
}

template <class D>
void setCounter(Step7Args<D>& a, std::uint32_t number, typename D::Bits value) {
  a.m.set(Reg::CounterCurrent, number, value);
  a.m.setBit(Reg::CounterBit, number, a.d.lnot(a.d.equal(value, a.number(0, 16), 16)));
}
template <class D>
void endCounter(Step7Args<D>& a) {
  a.setBit(a.s.orBit, a.no());
  a.setBit(a.s.firstCheck, a.no());
}
/// Whether the RLO rises at an instruction that remembers it in `memory`; remembers it.
template <class D>
typename D::Bool risesAt(Step7Args<D>& a, Reg memory, std::uint32_t number) {
  const auto rises = a.d.land(a.s.rlo, a.d.lnot(a.m.getBit(memory, number)));
  a.m.setBit(memory, number, a.s.rlo);
  return rises;
}

template <bool up, Name stlName, Name germanName, Name manualLine>
struct Count {
  static constexpr Desc desc =
      counterDesc(stlName.view(), germanName.view(), up ? "count up" : "count down", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    a.places.eachNumber(a.operand(), [&](std::uint32_t number) {
      const auto value = a.m.get(Reg::CounterCurrent, number), one = a.number(1, 16);
      const auto isAtEnd = a.d.equal(value, a.number(up ? 999 : 0, 16), 16);
      const auto rises = risesAt(a, up ? Reg::CounterUp : Reg::CounterDown, number);
      a.m.when(a.d.land(rises, a.d.lnot(isAtEnd)),
               [&] { setCounter(a, number, up ? a.d.add(value, one, 16) : a.d.sub(value, one, 16)); });
    });
    endCounter(a);
  }
};

struct SetCounter {
  static constexpr Desc desc = counterDesc("S C", {}, "set a counter", "002:2873");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.places.eachNumber(a.operand(), [&](std::uint32_t number) {
      a.m.when(risesAt(a, Reg::S7Set, number), [&] {
        const Decimal<D> value = fromBcd(a.d, a.d.extract(a.accu1(), 11, 0), 3, 16);
        a.m.error(Hazard::S7Bcd, value.isWrong);
        a.m.when(a.d.lnot(value.isWrong), [&] { setCounter(a, number, value.value); });
      });
    });
    endCounter(a);
  }
};

struct ResetCounter {
  static constexpr Desc desc = counterDesc("R C", {}, "reset a counter", "002:2872");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.places.eachNumber(
        a.operand(), [&](std::uint32_t number) { a.m.when(a.s.rlo, [&] { setCounter(a, number, a.number(0, 16)); }); });
    endCounter(a);
  }
};

/// FR C: with its own rising RLO, CU, CD and S that still see 1 act again.
struct FreeCounter {
  static constexpr Desc desc = counterDesc("FR C", {}, "enable a counter", "002:2869");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.places.eachNumber(a.operand(), [&](std::uint32_t number) {
      a.m.when(risesAt(a, Reg::S7Free, number), [&] {
        for (const Reg memory : {Reg::CounterUp, Reg::CounterDown, Reg::S7Set}) a.m.setBit(memory, number, a.no());
      });
    });
    endCounter(a);
  }
};

template <bool bcd, Name stlName, Name manualLine>
struct LoadCounter {
  static constexpr Desc desc = counterDesc(stlName.view(), {}, "load the count", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    auto value = a.number(0);
    a.places.eachNumber(a.operand(), [&](std::uint32_t number) {
      const auto count = a.m.get(Reg::CounterCurrent, number);
      const auto shown = bcd ? a.d.zext(toBcd(a.d, count, 3, 16), 12, 32) : a.d.zext(count, 16, 32);
      value = a.d.select(a.m.guard, shown, value, 32);
    });
    a.push(value);
  }
};

using Step7CounterGroup =
    Group<Count<false, "CD", "ZR", "002:2879">, Count<true, "CU", "ZV", "002:2880">, SetCounter, ResetCounter,
          FreeCounter, LoadCounter<false, "L C", "002:2870">, LoadCounter<true, "LC C", "002:2871">>;

}  // namespace rungproof::isa::step7
