// S5 timers (002:2865-2878; time values 003:1016-1043). The behaviour of the five kinds is general knowledge:
//   SP pulse            starts with a rising RLO; 1 while it runs and the RLO is 1
//   SE extended pulse   starts with a rising RLO, again while it runs; 1 while it runs
//   SD on-delay         starts with a rising RLO; 1 when the time is up and the RLO still 1
//   SS retentive        starts with a rising RLO, again while it runs; 1 from the end of the time to R
//   SF off-delay        starts with a falling RLO; 1 while the RLO is 1 or it runs; a rising RLO sets its time back
// The time of a start comes from ACCU1-L as S5TIME; the first unit may be short by up to one base (Choice::S5Time).
#pragma once

#include "ir/s7300/isa/convert.hpp"
#include "ir/s7300/timer.hpp"

namespace rungproof::isa::step7 {

enum class S5Kind : std::uint8_t { Pulse, ExtendedPulse, OnDelay, RetentiveOnDelay, OffDelay };

constexpr Desc timerDesc(std::string_view stl, std::string_view german, std::string_view meaning,
                         std::string_view manual) {
  return withOperands(accuDesc(stl, german, meaning, "timers and counters", manual),
                      {in("timer", Type::Timer, form7::T)});
}

/// ms of a unit by the two bits of the base.
template <class D>
typename D::Bits unitOf(D& d, typename D::Bits base) {
  const auto is = [&](std::uint64_t n) { return d.equal(base, d.literal(n, 2), 2); };
  auto unit = d.literal(10000, restBits);
  unit = d.select(is(2), d.literal(1000, restBits), unit, restBits);
  unit = d.select(is(1), d.literal(100, restBits), unit, restBits);
  return d.select(is(0), d.literal(10, restBits), unit, restBits);
}

inline constexpr int phaseBits = 14;  ///< of ms within a unit: holds 9,999

/// Any ms below the unit, from any bits: as many of them as the unit needs, less the unit where they are more.
template <class D>
typename D::Bits phaseOf(D& d, typename D::Bits base, typename D::Bits any) {
  const auto below = [&](std::uint64_t unit, int bits) {
    const auto part = d.zext(d.extract(any, bits - 1, 0), bits, phaseBits), whole = d.literal(unit, phaseBits);
    return d.select(d.ult(part, whole, phaseBits), part, d.sub(part, whole, phaseBits), phaseBits);
  };
  const auto is = [&](std::uint64_t n) { return d.equal(base, d.literal(n, 2), 2); };
  auto phase = below(10000, 14);
  phase = d.select(is(2), below(1000, 10), phase, phaseBits);
  phase = d.select(is(1), below(100, 7), phase, phaseBits);
  return d.select(is(0), below(10, 4), phase, phaseBits);
}

/// Stops the timer; what is left of its time stays readable.
template <class D>
void stopTimer(Step7Args<D>& a, std::uint32_t number) {
  a.m.when(a.m.getBit(Reg::TimerRunning, number), [&] {
    a.m.set(Reg::S5Rest, number, a.d.sub(a.m.get(Reg::S5Rest, number), passedBefore(a.m), restBits));
    a.m.setBit(Reg::TimerRunning, number, a.no());
  });
}

/// Loads the time of ACCU1-L and lets it run; `atEnd`: the bit when it is up, `now`: until then.
template <class D>
void startTimer(Step7Args<D>& a, std::uint32_t number, typename D::Bool now, bool atEnd) {
  D& d = a.d;
  const Decimal<D> time = fromBcd(d, d.extract(a.accu1(), 11, 0), 3, restBits);
  a.m.error(Hazard::S7Bcd, time.isWrong);
  a.m.when(d.lnot(time.isWrong), [&] {
    const auto base = d.extract(a.accu1(), 13, 12);
    const auto unit = unitOf(d, base);
    const auto length = d.mul(time.value, unit, restBits);
    const auto isZero = d.equal(time.value, a.number(0, restBits), restBits);
    const auto isAny = a.m.reads({Choice::S5Time, "any"});
    auto less = a.number(0, restBits);
    if (const auto known = d.truth(isAny); !known || *known) {
      const auto any = a.m.external(External::TimerPhase, number, phaseBits);
      less =
          d.select(d.land(isAny, d.lnot(isZero)), d.zext(phaseOf(d, base, any), phaseBits, restBits), less, restBits);
    }
    const auto end = d.add(d.sub(length, less, restBits), passedBefore(a.m), restBits);
    a.m.set(Reg::S5Base, number, base);
    a.m.set(Reg::S5Rest, number, d.select(isZero, a.number(0, restBits), end, restBits));
    a.m.setBit(Reg::TimerRunning, number, d.lnot(isZero));
    a.m.setBit(Reg::S5AtEnd, number, d.constant(atEnd));
    a.m.setBit(Reg::TimerBit, number, d.select(isZero, d.constant(atEnd), now));
  });
}

template <S5Kind kind, Name stlName, Name germanName, Name meaning, Name manualLine>
struct StartTimer {
  static constexpr Desc desc = timerDesc(stlName.view(), germanName.view(), meaning.view(), manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    a.places.eachNumber(a.operand(), [&](std::uint32_t number) {
      const auto rlo = a.s.rlo, before = a.m.getBit(Reg::TimerInput, number);
      const auto rises = d.land(rlo, d.lnot(before)), falls = d.land(d.lnot(rlo), before);
      a.m.setBit(Reg::TimerInput, number, rlo);
      if constexpr (kind == S5Kind::OffDelay) {
        a.m.when(rises, [&] {
          a.m.setBit(Reg::TimerRunning, number, a.no());
          a.m.set(Reg::S5Rest, number, a.number(0, restBits));
        });
        a.m.when(rlo, [&] { a.m.setBit(Reg::TimerBit, number, a.yes()); });
        a.m.when(falls, [&] { startTimer(a, number, a.yes(), false); });
      } else {
        constexpr bool isPulse = kind == S5Kind::Pulse || kind == S5Kind::ExtendedPulse;
        const auto now = isPulse                            ? a.yes()
                         : kind == S5Kind::RetentiveOnDelay ? a.m.getBit(Reg::TimerBit, number)
                                                            : a.no();
        a.m.when(rises, [&] { startTimer(a, number, now, !isPulse); });
        if constexpr (kind == S5Kind::Pulse || kind == S5Kind::OnDelay) {
          a.m.when(d.lnot(rlo), [&] {
            stopTimer(a, number);
            a.m.setBit(Reg::TimerBit, number, a.no());
          });
        }
      }
    });
    a.setBit(a.s.orBit, a.no());
    a.setBit(a.s.firstCheck, a.no());
  }
};

/// R T: bit and time are gone while the RLO is 1.
struct ResetTimer {
  static constexpr Desc desc = timerDesc("R T", {}, "reset a timer", "002:2872");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.places.eachNumber(a.operand(), [&](std::uint32_t number) {
      a.m.when(a.s.rlo, [&] {
        a.m.setBit(Reg::TimerBit, number, a.no());
        a.m.setBit(Reg::TimerRunning, number, a.no());
        a.m.set(Reg::S5Rest, number, a.number(0, restBits));
      });
    });
    a.setBit(a.s.orBit, a.no());
    a.setBit(a.s.firstCheck, a.no());
  }
};

/// FR T: with its own rising RLO, a start instruction that still sees 1 starts again.
struct FreeTimer {
  static constexpr Desc desc = timerDesc("FR T", {}, "enable a timer", "002:2869");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.places.eachNumber(a.operand(), [&](std::uint32_t number) {
      const auto rises = a.d.land(a.s.rlo, a.d.lnot(a.m.getBit(Reg::S5Free, number)));
      a.m.setBit(Reg::S5Free, number, a.s.rlo);
      a.m.when(rises, [&] { a.m.setBit(Reg::TimerInput, number, a.no()); });
    });
    a.setBit(a.s.orBit, a.no());
    a.setBit(a.s.firstCheck, a.no());
  }
};

/// L T: the units that are left; LC T: in BCD, with the base.
template <bool bcd, Name stlName, Name germanName, Name manualLine>
struct LoadTimer {
  static constexpr Desc desc =
      timerDesc(stlName.view(), germanName.view(), "load the time that is left", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    auto value = a.number(0);
    a.places.eachNumber(a.operand(), [&](std::uint32_t number) {
      const auto base = a.m.get(Reg::S5Base, number);
      const auto unit = unitOf(d, base);
      const auto running = a.m.getBit(Reg::TimerRunning, number);
      const auto passed = d.select(running, passedBefore(a.m), a.number(0, restBits), restBits);
      const auto rest = d.sub(a.m.get(Reg::S5Rest, number), passed, restBits);
      const auto up = d.add(rest, d.sub(unit, a.number(1, restBits), restBits), restBits);
      const auto units = d.udiv(up, unit, restBits);
      const auto shown =
          bcd ? d.zext(d.concat(base, 2, toBcd(d, units, 3, restBits), 12), 14, 32) : d.zext(units, restBits, 32);
      value = d.select(a.m.guard, shown, value, 32);
    });
    a.push(value);
  }
};

using Step7TimerGroup =
    Group<StartTimer<S5Kind::OnDelay, "SD", "SE", "on-delay timer", "002:2874">,
          StartTimer<S5Kind::RetentiveOnDelay, "SS", "SS", "retentive on-delay timer", "002:2875">,
          StartTimer<S5Kind::Pulse, "SP", "SI", "pulse timer", "002:2876">,
          StartTimer<S5Kind::OffDelay, "SF", "SA", "off-delay timer", "002:2877">,
          StartTimer<S5Kind::ExtendedPulse, "SE", "SV", "extended pulse timer", "002:2878">, ResetTimer, FreeTimer,
          LoadTimer<false, "L T", "L T", "002:2870">, LoadTimer<true, "LC T", "LC T", "002:2871">>;

}  // namespace rungproof::isa::step7
