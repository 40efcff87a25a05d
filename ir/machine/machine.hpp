// Machine<D>: the CPU as instruction meanings see it, over a domain D of values. It offers the logic stack,
// typed operands, guarded writes, hazards and the ENO bit; the state itself lives in D::Store.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "ir/address_limit.hpp"
#include "ir/desc.hpp"
#include "ir/guarded_run.hpp"
#include "ir/machine/frame.hpp"
#include "ir/machine/plan.hpp"
#include "ir/machine/reading.hpp"
#include "ir/machine/statement_registers.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// One target of a pointer: used if `condition` holds.
template <class D>
struct PointerTarget {
  typename D::Bool condition;
  Area area;
  std::uint32_t offset;   ///< byte, or number for T and C
  std::uint32_t bit = 0;  ///< S7-300/400
};

/// Numeric form of a pointer: area tag in the high byte, byte offset below (timers and counters: 2 * number,
/// because the step from one current value to the next is 2, 001:1478). The manual leaves the form open.
namespace pointer {
/// Areas by their tag.
inline constexpr auto areasByTag = [] {
  std::array<std::optional<Area>, 256> areas{};
  for (const AreaInfo& info : areaTable) {
    if (info.tag) areas[*info.tag] = info.area;
  }
  return areas;
}();
constexpr std::optional<Area> areaOf(std::uint32_t value) { return areasByTag[value >> 24]; }
constexpr std::uint32_t encode(Area area, std::uint32_t offset) {
  const std::uint32_t tag = areaInfo(area).tag.value_or(0xFF);
  return tag << 24 | (hasBitAndWord(area) ? 2 * offset : offset);
}
constexpr std::uint32_t offsetOf(std::uint32_t value) {
  const std::uint32_t offset = value & 0xFFFFFF;
  const std::optional<Area> area = areaOf(value);
  return area && hasBitAndWord(*area) ? offset / 2 : offset;
}
/// Pointer to string constant number `index` of Plan::texts, for STRING parameters (001:6804). It can only be read.
constexpr std::uint32_t textTag = 0x0C;
constexpr std::uint32_t encodeText(std::size_t index) { return textTag << 24 | static_cast<std::uint32_t>(index); }
/// Whether the pointer names a whole element of that area on that CPU.
inline bool isLegal(const Target& target, std::uint32_t value, Width width) {
  const std::optional<Area> area = areaOf(value);
  if (!area) return false;
  if (hasBitAndWord(*area) && ((value & 1) != 0 || width != Width::Word)) return false;
  if (isAnalogue(*area) && width != Width::Word) return false;
  return addressExists(target, *area, width, offsetOf(value), 0);
}
}  // namespace pointer

/// An operand made ready for an access: a constant, one place, or the possible targets of a pointer.
template <class D>
struct Ref {
  const Operand* operand = nullptr;
  Area area = Area::V;
  std::uint32_t offset = 0;  ///< byte or number
  std::uint8_t bit = 0;
  const Operand* text = nullptr;  ///< string constant that stands in the operand
  bool mayBeText = false;         ///< pointer that may name a string constant of Plan::texts
  bool isPlace = false;
  bool isUnresolved = false;      ///< pointer whose targets are not known: reads give anything
  bool isComputed = false;        ///< pointer that the domain itself follows, to the address in `value`
  typename D::Bits value{};       ///< constant; mayBeText: the pointer
  typename D::Targets targets{};  ///< a container of PointerTarget<D>; empty unless a pointer with several targets
};

inline constexpr int restBits = 24;  ///< of a time of an S5 timer in ms: holds 999 x 10 s

/// Pou::number of OB121.
inline constexpr int errorBlock = static_cast<int>(BlockType::Ob) << 16 | 121;
inline constexpr int accessErrorBlock = static_cast<int>(BlockType::Ob) << 16 | 122;

/// OB121_SW_FLT of a synchronous error, of a pair for reading and writing the first; 0: one of several. A pointer with
/// a wrong bit part or area may be wrong in two ways.
constexpr std::uint64_t faultCode(Hazard hazard) {
  switch (hazard) {
    case Hazard::S7Bcd: return 0x21;
    case Hazard::S7AreaLength: return 0x22;
    case Hazard::S7TimerNumber: return 0x26;
    case Hazard::S7CounterNumber: return 0x27;
    case Hazard::S7WriteProtected: return 0x30;
    default: return 0;
  }
}

template <class D>
using LogicStack = std::array<typename D::Bool, mostStackLevels>;

template <class D>
class Machine : public GuardedRun<D> {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;
  using GuardedRun<D>::d;
  using GuardedRun<D>::guard;
  using GuardedRun<D>::externalBit;
  using GuardedRun<D>::external;

  Machine(D& domain, typename D::Store& state, const Plan& programPlan)
      : GuardedRun<D>(domain),
        store(state),
        plan(programPlan),
        target(programPlan.program->target),
        features(programPlan.dialect().run.features(target)),
        stackLevels(static_cast<std::size_t>(features.stackLevels)),
        step7(domain),
        scrActive(domain.constant(true)),
        ticks100(domain.literal(0, 16)),
        passedMs(domain.literal(0, restBits)) {
    stack.fill(domain.constant(false));
    for (int a = 0; a < areaCount; ++a)
      areaSizes_[static_cast<std::size_t>(a)] = rungproof::areaSize(target, static_cast<Area>(a));
  }

  typename D::Store& store;
  const Plan& plan;
  const Target target;
  const CpuFeatures features;
  const std::size_t stackLevels;  ///< of the logic stack of this CPU; what lies behind them has no meaning

  Step7Registers<D> step7;  ///< of an S7-300/400, which has no logic stack

  Bool scrActive;                ///< true outside segments; inside: the SCR stack
  LogicStack<D> stack;           ///< [0] is the top (001:2753)
  std::vector<Bits> evaluation;  ///< IEC 61131-3: values of the statement that runs (ir/iec/isa/iec_group.hpp)
  unsigned frame = 0;            ///< local memory in use (ir/machine/frame.hpp)
  bool inInterrupt = false;
  bool isStartUp = false;  ///< S7-300/400: the start-up block runs, which sees cleared inputs
  Bits ticks100;           ///< 100 ms ticks between the starts of the previous and of this scan, width 16 (001:6611)
  Bits passedMs;           ///< S7-300/400: ms of this scan that have passed, width restBits

  // ---- Logic stack ------------------------------------------------------------------------------

  void push(Bool value) {
    if constexpr (std::same_as<Bool, bool>) {  // what follows, in one move
      if (!guard) return;
      std::memmove(&stack[1], &stack[0], stack.size() - 1);
      stack[0] = value;
      return;
    }
    for (std::size_t i = stackLevels - 1; i > 0; --i) setLevel(i, stack[i - 1]);
    setLevel(0, value);
  }
  Bool pop() {
    const Bool top = stack[0];
    if constexpr (std::same_as<Bool, bool>) {  // what follows, in one move
      const Bool bottom = externalBit(External::StackBottom);
      if (!guard) return top;
      std::memmove(&stack[0], &stack[1], stack.size() - 1);
      stack[stackLevels - 1] = bottom;
      return top;
    }
    for (std::size_t i = 0; i + 1 < stackLevels; ++i) setLevel(i, stack[i + 1]);
    setLevel(stackLevels - 1, externalBit(External::StackBottom));
    return top;
  }
  Bool top() const { return stack[0]; }
  Bool level(std::size_t i) const { return stack[i]; }
  void setTop(Bool value) { setLevel(0, value); }
  void setLevel(std::size_t i, Bool value) { stack[i] = d.select(guard, value, stack[i]); }
  /// What coils, boxes, timers and counters see of a level: gated by the SCR segment they stand in (001:5830).
  Bool powerFlow(std::size_t i = 0) { return d.land(stack[i], scrActive); }

  /// Bits of the I and Q images that stand for terminals; those behind them come and go with PROFINET devices.
  std::uint32_t terminals() const { return std::min(8 * areaSize(Area::I), regInfo(Reg::PhysicalInput).count); }
  /// An output at once, beside its image; the data of PROFINET devices go out at the end of the scan.
  void setTerminal(std::uint32_t bit, Bool value) {
    if (bit < terminals()) setBit(Reg::PhysicalOutput, bit, value);
  }

  /// Size of an area in bytes on this CPU (T, C, AC, HC: count).
  std::uint32_t areaSize(Area area) const { return areaSizes_[static_cast<std::size_t>(area)]; }

  // ---- State --------------------------------------------------------------------------------------

  Bits get(Reg reg, std::uint32_t index = 0) { return store.get(reg, index); }
  Bool getBit(Reg reg, std::uint32_t index = 0) { return d.bit(store.get(reg, index), 0); }
  void set(Reg reg, std::uint32_t index, Bits value) { store.set(reg, index, value, guard); }
  void setBit(Reg reg, std::uint32_t index, Bool value) { store.set(reg, index, d.fromBool(value, 1), guard); }

  /// One bit of a memory area; `bit` may exceed 7 and then reaches into the following bytes.
  Bool loadBit(Area area, std::uint32_t byte, std::uint32_t bit = 0) {
    return d.bit(store.load(area, addressBits(area, byte) + bit, 1), 0);
  }
  void saveBit(Area area, std::uint32_t byte, std::uint32_t bit, Bool value) {
    store.save(area, addressBits(area, byte) + bit, 1, d.fromBool(value, 1), guard);
  }
  Bool sm(std::uint32_t byte, std::uint32_t bit) { return loadBit(Area::SM, byte, bit); }
  void setSm(std::uint32_t byte, std::uint32_t bit, Bool value) { saveBit(Area::SM, byte, bit, value); }
  /// SM1.0-SM1.7 by status bit (status::Zero ...).
  void flag(StatusBits which, Bool value) {
    for (std::uint32_t bit = 0; bit < 8; ++bit) {
      if ((which >> bit & 1) != 0) setSm(1, bit, value);
    }
  }

  /// Value of `width` at byte `offset` of an area (T, C, AC, HC: number). AC uses its low bits (001:1344).
  Bits load(Area area, std::uint32_t offset, Width width, std::uint32_t bit = 0);
  void save(Area area, std::uint32_t offset, Width width, Bits value, std::uint32_t bit = 0);

  /// Whether that is the reading of an open point that is in force.
  Bool reads(NamedReading reading) { return readsValue(reading.choice, reading.value); }
  /// The same by the number of the value in its row.
  Bool readsValue(Choice choice, std::uint8_t value) {
    const auto bit = [&](std::uint8_t which) { return getBit(Reg::Reading, readingIndex(choice, which)); };
    const bool hasThird = !choiceInfo(choice).values[2].empty();
    if (value == 1) return bit(1);
    const Bool notSecond = d.lnot(bit(1));
    if (!hasThird) return notSecond;
    return d.land(notSecond, value == 2 ? bit(2) : d.lnot(bit(2)));
  }

  // ---- Errors --------------------------------------------------------------------------------------

  /// Reports that `condition` means that error here: SM4.3 for non-fatal ones, end of the program for fatal
  /// ones, nothing but the report for status-only ones (the meaning itself sets the SM1 bit). ENO drops in all cases.
  void hazard(Hazard which, Bool condition) {
    this->meet(which, condition, [&] {
      setBit(Reg::Eno, 0, d.constant(false));
      if (hazardInfo(which).kind == HazardClass::NonFatal) setSm(4, 3, d.constant(true));
    });
  }
  /// S7-300/400: a synchronous error. Without OB121 the CPU goes to STOP (002:1278); with it, that is due. One that is
  /// masked does neither (002:2352). How deep errors of the error blocks nest is not stated: the first ends the run.
  void error(Hazard which, Bool condition) {
    if (const std::optional<bool> known = d.truth(condition); known && !*known) return;
    const Bool happens = d.land(guard, condition);
    if (handlesErrors_ || plan.masksErrors) step7.failed = d.lor(step7.failed, happens);
    const Bool isTaken = d.land(condition, d.lnot(isMasked()));
    if (step7.isErrorBlock) return stop(Hazard::S7ErrorTwice, isTaken);
    if (!handlesErrors_) return stop(which, isTaken);
    const Bool isDue = d.land(guard, isTaken);
    step7.syncError = d.lor(step7.syncError, isDue);
    step7.fault = d.select(isDue, d.literal(faultCode(which), 8), step7.fault, 8);
  }
  /// S7-300/400: a module has not answered, which is due for OB122 (002:1292).
  void accessError(Bool condition) {
    const Bool isTaken = d.land(condition, d.lnot(isMasked()));
    step7.failed = d.lor(step7.failed, d.land(guard, condition));
    if (step7.isErrorBlock) return stop(Hazard::S7ErrorTwice, isTaken);
    step7.accessError = d.lor(step7.accessError, d.land(guard, isTaken));
  }
  /// S7-300/400: the CPU stops, whatever blocks it has.
  void stop(Hazard which, Bool condition) {
    this->meet(which, condition, [] {});
  }
  /// S7-300/400: what the CPU does not notice, and the program goes on with.
  void note(Hazard which, Bool condition) {
    this->meet(which, condition, [] {});
  }
  /// Whether the program may go on behind a synchronous error.
  bool survivesErrors() const { return handlesErrors_ || plan.masksErrors; }
  /// Writes a register of the S7-300/400 where the guard holds.
  void put(Bool& to, Bool value) { to = this->isEveryRun() ? value : d.select(guard, value, to); }
  void put(Bits& to, Bits value, int width) { to = this->isEveryRun() ? value : d.select(guard, value, to, width); }

  /// ENO at the start of a box: 1 if it runs (its hazards clear it), otherwise as Choice::SkippedEno says.
  void enoAfter(Bool runs) {
    const Bool skipped = d.land(reads({Choice::SkippedEno, "kept"}), getBit(Reg::Eno));
    setBit(Reg::Eno, 0, d.select(runs, d.constant(true), skipped));
  }

 private:
  /// Which bit of a mask stands for which error, and how long it holds, is not stated: once SFC 36 has been called, any
  /// error may be masked or not. Without another word those of the run of the organization block that called it are.
  Bool isMasked() {
    if (!plan.masksErrors) return d.constant(false);
    constexpr std::uint32_t index = 0x304;  // beside what instructions leave open
    return d.land(getBit(Reg::ErrorsMasked), d.lxor(step7.isMasking, externalBit(External::UnknownResult, index)));
  }

  bool handlesErrors_ = plan.block(errorBlock) != nullptr;
  std::array<std::uint32_t, areaCount> areaSizes_{};

  std::uint32_t addressBits(Area area, std::uint32_t byte) const {
    return (area == Area::L ? frame * frameBytes + byte : byte) * 8;
  }
};

template <class D>
typename D::Bits Machine<D>::load(Area area, std::uint32_t offset, Width width, std::uint32_t bit) {
  switch (area) {
    case Area::T: return get(width == Width::Bit ? Reg::TimerBit : Reg::TimerCurrent, offset);
    case Area::C: return get(width == Width::Bit ? Reg::CounterBit : Reg::CounterCurrent, offset);
    case Area::HC: return get(Reg::HscCurrent, offset);
    case Area::AC: {
      const Bits all = get(Reg::Accumulator, offset);
      return width == Width::DWord ? all : d.extract(all, bits(width) - 1, 0);
    }
    case Area::AI: return external(External::AnalogInput, offset, 16);
    default: return store.load(area, addressBits(area, offset) + (width == Width::Bit ? bit : 0), bits(width));
  }
}

template <class D>
void Machine<D>::save(Area area, std::uint32_t offset, Width width, Bits value, std::uint32_t bit) {
  switch (area) {
    case Area::T: set(width == Width::Bit ? Reg::TimerBit : Reg::TimerCurrent, offset, value); return;
    case Area::C: set(width == Width::Bit ? Reg::CounterBit : Reg::CounterCurrent, offset, value); return;
    case Area::HC: return;  // write-protected (001:1336); ADR003 reports it
    case Area::AC: {
      const int w = bits(width);
      const Bits high = get(Reg::Accumulator, offset);
      set(Reg::Accumulator, offset, w == 32 ? value : d.concat(d.extract(high, 31, w), 32 - w, value, w));
      return;
    }
    default:
      store.save(area, addressBits(area, offset) + (width == Width::Bit ? bit : 0), bits(width), value, guard);
      return;
  }
}

}  // namespace rungproof
