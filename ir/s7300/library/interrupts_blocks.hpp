// Interrupts: at a time, after a delay, locked (002:1192-1212, 002:2342-2353). One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/interrupt_lock.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/library/cpu_call.hpp"
#include "ir/s7300/organization_block.hpp"

namespace rungproof::s7300::library {

struct Sfc28 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 28,
                                         .name = "SET_TINT",
                                         .parameters = "OB_NR:INT SDT:DT PERIOD:WORD|RET_VAL:INT",
                                         .isContract = true};
};

struct Sfc29 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 29,
                                         .name = "CAN_TINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT",
                                         .isContract = true};
};

struct Sfc30 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 30,
                                         .name = "ACT_TINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT",
                                         .isContract = true};
};

struct Sfc31 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 31,
                                         .name = "QRY_TINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT STATUS:WORD",
                                         .isContract = true};
};

/// Starts the delay of a block where `time` in ms is in the range of the CPU; cancels it where there is no time.
template <class D>
void setDelay(CpuCall<D>& call, typename D::Bits block, std::optional<typename D::Bits> time, typename D::Bits sign) {
  D& d = call.d;
  Machine<D>& m = call.m;
  for (std::uint32_t i = 0; i < delayBlockCount; ++i) {
    if (m.plan.block(blockNumber(BlockType::Ob, firstDelayBlock + static_cast<int>(i))) == nullptr) continue;
    typename D::Bool isMeant = d.equal(block, d.literal(static_cast<std::uint64_t>(firstDelayBlock) + i, 16), 16);
    if (time)
      isMeant = d.land(isMeant, d.land(d.sle(d.literal(1, 32), *time, 32), d.sle(*time, d.literal(60000, 32), 32)));
    const auto event = static_cast<std::uint32_t>(firstDelayEvent) + i;
    m.when(isMeant, [&] {
      m.signal(time ? Signal::EventAttached : Signal::EventsCleared, event);
      m.set(Reg::DelayPeriod, i, time ? d.extract(*time, 15, 0) : d.literal(0, 16));
      m.set(Reg::DelayElapsed, i, d.literal(0, 16));
      if (time) m.set(Reg::DelaySign, i, sign);
    });
  }
}

struct Sfc32 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 32,
                                         .name = "SRT_DINT",
                                         .parameters = "OB_NR:INT DTIME:TIME SIGN:WORD|RET_VAL:INT",
                                         .isContract = true};

  template <class D>
  static void act(CpuCall<D>& call) {
    if (!call.gives(3)) return;
    const typename D::Bits block = call.word(0), time = call.value(1, Width::DWord), sign = call.word(2);
    setDelay<D>(call, block, time, sign);
  }
};

struct Sfc33 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 33,
                                         .name = "CAN_DINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT",
                                         .isContract = true};

  template <class D>
  static void act(CpuCall<D>& call) {
    if (call.gives(1)) setDelay<D>(call, call.word(0), std::nullopt, call.d.literal(0, 16));
  }
};

struct Sfc34 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 34,
                                         .name = "QRY_DINT",
                                         .parameters = "OB_NR:INT|RET_VAL:INT STATUS:WORD",
                                         .isContract = true};
};

/// MODE 0 names all events (OB_NR 0), 1 a class by its first block, 2 a block; with 16#80 more nothing is written into
/// the diagnostic buffer. Calls that say something else may be taken as if they said that, or refused.
template <class D>
void lockEvents(CpuCall<D>& call, bool locks) {
  using Bits = typename D::Bits;
  using Bool = typename D::Bool;
  D& d = call.d;
  Machine<D>& m = call.m;
  const Bits mode = d.extract(call.value(0, Width::Byte), 7, 0), block = call.word(1);
  const auto blockIs = [&](int number) {
    return d.equal(block, d.literal(static_cast<std::uint64_t>(number), 16), 16);
  };
  const auto modeIs = [&](std::uint64_t number) { return d.equal(d.extract(mode, 6, 0), d.literal(number, 7), 7); };
  Bool isClass = d.constant(false);
  for (int first = 10; first <= 80; first += 10) isClass = d.lor(isClass, blockIs(first));
  Bool isPlain = d.lor(d.lnot(modeIs(0)), blockIs(0));
  isPlain = d.land(isPlain, d.lor(d.lnot(modeIs(1)), isClass));
  if (!locks) isPlain = d.land(isPlain, d.lnot(d.bit(mode, 7)));
  constexpr std::uint32_t refusal = 0x30A;  // beside what instructions leave open
  const Bool isTaken =
      d.truth(isPlain) == true ? isPlain : d.lor(isPlain, m.externalBit(External::UnknownResult, refusal));
  for (int event = firstBlockEvent; event < blockEventEnd; ++event) {
    const int number = blockOfEvent(event);
    if (m.plan.block(blockNumber(BlockType::Ob, number)) == nullptr) continue;
    const Bool isOfClass = d.lor(blockIs(lockClassOf(number)), d.land(d.lnot(isClass), blockIs(number)));
    Bool isNamed = d.lor(modeIs(0), d.land(modeIs(1), isOfClass));
    isNamed = d.land(isTaken, d.lor(isNamed, d.land(modeIs(2), blockIs(number))));
    const auto at = static_cast<std::uint32_t>(event);
    m.when(isNamed, [&] {
      if (locks) m.signal(Signal::EventDetached, at);
      const Bits now = m.get(Reg::EventRoutine, at);
      m.set(Reg::EventRoutine, at,
            locks ? d.bor(now, d.literal(lockBit, 8), 8) : d.band(now, d.literal(lockBit - 1, 8), 8));
    });
  }
}

struct Sfc39 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 39,
                                         .name = "DIS_IRT",
                                         .parameters = "MODE:BYTE OB_NR:INT|RET_VAL:INT",
                                         .isContract = true};

  template <class D>
  static void act(CpuCall<D>& call) {
    if (call.gives(2)) lockEvents(call, true);
  }
};

struct Sfc40 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 40,
                                         .name = "EN_IRT",
                                         .parameters = "MODE:BYTE OB_NR:INT|RET_VAL:INT",
                                         .isContract = true};

  template <class D>
  static void act(CpuCall<D>& call) {
    if (call.gives(2)) lockEvents(call, false);
  }
};

/// So many calls of SFC 41 have no SFC 42 yet; interrupts wait while there is one.
template <class D>
void leaveDelayed(CpuCall<D>& call, typename D::Bits delays) {
  call.m.put(call.s.delays, delays, 8);
  call.m.setBit(Reg::InterruptsEnabled, 0, call.d.equal(delays, call.d.literal(0, 8), 8));
}

struct Sfc41 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc, .number = 41, .name = "DIS_AIRT", .parameters = "|RET_VAL:INT", .isContract = true};

  template <class D>
  static void act(CpuCall<D>& call) {
    leaveDelayed(call, call.d.add(call.s.delays, call.d.literal(1, 8), 8));
  }
};

struct Sfc42 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc, .number = 42, .name = "EN_AIRT", .parameters = "|RET_VAL:INT", .isContract = true};

  template <class D>
  static void act(CpuCall<D>& call) {
    D& d = call.d;
    const typename D::Bits none = d.literal(0, 8), delays = call.s.delays;
    leaveDelayed(call, d.select(d.equal(delays, none, 8), none, d.sub(delays, d.literal(1, 8), 8), 8));
  }
};

using InterruptsGroup = isa::Group<Sfc28, Sfc29, Sfc30, Sfc31, Sfc32, Sfc33, Sfc34, Sfc39, Sfc40, Sfc41, Sfc42>;

}  // namespace rungproof::s7300::library
