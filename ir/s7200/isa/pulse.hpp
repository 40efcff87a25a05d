// Pulse outputs: PLS for PTO and PWM on Q0.0 and Q0.1 (001:4510-4782). PLS takes cycle time, width
// and count from SM as the update bits of the control byte allow and starts, continues or stops the generator; the
// pulses themselves, their end and a profile's steps are the device's. Tests: tests/manual/pulse_test.cpp.
#pragma once

#include "ir/s7200/isa/group.hpp"
#include "ir/s7200/pulse_output.hpp"

namespace rungproof::isa {

/// PLS Q0.X: X = 0 or 1, on the S7-200 SMART up to 3. Offsets are those of SMB67 or SMB77: status byte before, values
/// behind (001:4656-4680).
struct PulseOutput {
  static constexpr Desc desc = withOperands({.stl = "PLS",
                                             .meaning = "pulse output",
                                             .group = "high-speed",
                                             .role = Role::Pls,
                                             .stack = {1, 0, 0},
                                             .eno = true,
                                             .time = 3100,
                                             .manual = "001:4533"},
                                            {in("Q0.X", Type::Word, form::Const)
                                                 .within({{0, 1, cpusWithPulseOutputs(2) | s7200Cpus},
                                                          {0, 2, cpusWithPulseOutputs(3)},
                                                          {0, 3, cpusWithPulseOutputs(4)}})});

  /// Outputs that PLS knows. The CPU 212 is not refused: what it lacks is only known from examples (004:345).
  static constexpr std::uint32_t most(const Target& target) {
    const auto outputs = static_cast<std::uint32_t>(cpuFeatures(target).pulseOutputs);
    return isSmart(target) ? outputs : std::max(outputs, 2U);
  }
  /// Bits of the status byte.
  static constexpr std::uint32_t abortedByUser = 5, pipelineFull = 6, idle = 7;

  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const std::uint32_t q = a.number(0);
    const bool exists = q < most(m.target);
    m.hazard(Hazard::OutOfRange, m.d.constant(!exists));
    if (!exists) return;
    const std::uint32_t control = pulseControl(q);
    const auto mode = m.sm(control, 6);
    const auto enabled = m.sm(control, 7), isPwm = pulseForm(m.target).bit6IsPwm ? mode : m.d.lnot(mode),
               isMulti = m.sm(control, 5);
    const auto busy = m.getBit(Reg::PulseBusy, q), wasPwm = m.getBit(Reg::PulseIsPwm, q);
    const auto runsProfile = m.d.land(busy, m.d.lnot(m.d.equal(m.get(Reg::PulseSegments, q), m.number(0, 8), 8)));
    // A running generator may only be given more of its own kind; a profile cannot be extended (001:13961).
    const auto sameKind = m.d.lnot(m.d.lxor(isPwm, wasPwm));
    const auto extends = m.d.land(sameKind, m.d.lnot(m.d.lor(runsProfile, m.d.land(isMulti, m.d.lnot(isPwm)))));
    const auto refused = m.d.land(enabled, m.d.land(busy, m.d.lnot(extends)));
    m.hazard(Hazard::PulseOutputBusy, refused);
    m.when(m.d.lnot(enabled), [&] { stop(m, q, control, m.d.land(busy, m.d.lnot(wasPwm))); });
    m.when(m.d.land(enabled, m.d.lnot(refused)), [&] {
      m.when(isPwm, [&] { widthModulation(m, q, control); });
      m.when(m.d.land(m.d.lnot(isPwm), m.d.lnot(isMulti)), [&] { singleTrain(m, q, control, busy); });
      m.when(m.d.land(m.d.lnot(isPwm), isMulti), [&] { profile(m, a, q, control); });
    });
    m.signal(Signal::PulseCommand, q);
  }

 private:
  /// The value in SM where its update bit is set, else the one kept; at least `least` (001:4570-4574, 001:4624).
  template <class D>
  static typename D::Bits loaded(Machine<D>& m, std::uint32_t control, std::uint32_t bit, std::uint32_t at, Reg kept,
                                 std::uint32_t q, int w, std::uint64_t least) {
    const auto fresh = m.load(Area::SM, control + at, w == 32 ? Width::DWord : Width::Word);
    const auto value = m.d.select(m.sm(control, bit), fresh, m.get(kept, q), w);
    return m.d.select(m.d.ult(value, m.number(least, w), w), m.number(least, w), value, w);
  }

  template <class D>
  static void stop(Machine<D>& m, std::uint32_t q, std::uint32_t control, typename D::Bool train) {
    m.when(train, [&] {
      m.setSm(control - 1, abortedByUser, m.d.constant(true));
      m.setSm(control - 1, idle, m.d.constant(true));
    });
    m.setBit(Reg::PulseBusy, q, m.d.constant(false));
    m.setBit(Reg::PulsePending, q, m.d.constant(false));
    m.set(Reg::PulseSegments, q, m.number(0, 8));
  }

  template <class D>
  static void widthModulation(Machine<D>& m, std::uint32_t q, std::uint32_t control) {
    m.set(Reg::PulseCycle, q, loaded(m, control, 0, 1, Reg::PulseCycle, q, 16, 2));
    m.set(Reg::PulseWidth, q, loaded(m, control, 1, 3, Reg::PulseWidth, q, 16, 0));
    m.setBit(Reg::PulseIsMs, q, m.sm(control, 3));
    m.setBit(Reg::PulseIsPwm, q, m.d.constant(true));
    m.setBit(Reg::PulseBusy, q, m.d.constant(true));
  }

  template <class D>
  static void begin(Machine<D>& m, std::uint32_t q, std::uint32_t control) {
    m.setBit(Reg::PulseIsMs, q, m.sm(control, 3));
    m.setBit(Reg::PulseIsPwm, q, m.d.constant(false));
    m.setBit(Reg::PulseBusy, q, m.d.constant(true));
    m.setSm(control - 1, idle, m.d.constant(false));
  }

  /// One train; while one runs, the next waits in a pipeline of one entry (001:4584).
  template <class D>
  static void singleTrain(Machine<D>& m, std::uint32_t q, std::uint32_t control, typename D::Bool busy) {
    const auto cycle = loaded(m, control, 0, 1, Reg::PulseCycle, q, 16, pulseForm(m.target).hasFrequency ? 1 : 2);
    auto count = loaded(m, control, 2, 5, Reg::PulseCount, q, 32, 1);
    if (isSmart(m.target)) {  // a number above the most counts as that
      const auto most = m.number(0x7FFFFFFF, 32);
      count = m.d.select(m.d.ult(most, count, 32), most, count, 32);
    }
    const auto full = m.getBit(Reg::PulsePending, q);
    m.when(m.d.lnot(busy), [&] {
      m.set(Reg::PulseCycle, q, cycle);
      m.set(Reg::PulseCount, q, count);
      m.set(Reg::PulseSegments, q, m.number(0, 8));
      begin(m, q, control);
    });
    m.when(m.d.land(busy, m.d.lnot(full)), [&] {
      m.setBit(Reg::PulsePending, q, m.d.constant(true));
      m.set(Reg::PulseNextCycle, q, cycle);
      m.set(Reg::PulseNextCount, q, count);
      m.setBit(Reg::PulseNextIsMs, q, m.sm(control, 3));
    });
    m.when(m.d.land(busy, full), [&] { m.setSm(control - 1, pipelineFull, m.d.constant(true)); });
  }

  /// Profile table in V from the byte in SMW168 or SMW178: number of segments, then 8 or 12 bytes each (001:4596-4608).
  template <class D>
  static void profile(Machine<D>& m, Args<D>& a, std::uint32_t q, std::uint32_t control) {
    D& d = m.d;
    const auto at = m.load(Area::SM, profileWord(q), Width::Word);
    const auto offset = d.zext(at, 16, 32);
    Ref<D> table;
    const auto inside = a.follow(d.add(m.number(pointer::encode(Area::V, 0), 32), offset, 32), Width::Byte, table);
    const auto none = m.number(0, 8);
    const bool leadsNowhere = d.truth(inside) == std::optional(false);
    const auto segments = leadsNowhere ? none : d.select(inside, a.elementOf(table, 0, Width::Byte), none, 8);
    const auto empty = d.land(inside, d.equal(segments, m.number(0, 8), 8));
    const auto end = d.add(
        offset,
        d.add(d.mul(d.zext(segments, 8, 32), m.number(pulseForm(m.target).segmentBytes, 32), 32), m.number(1, 32), 32),
        32);
    const auto fits = d.land(inside, d.ule(end, m.number(areaSize(m.target, Area::V), 32), 32));
    m.hazard(Hazard::PulseProfile, d.lnot(fits));
    m.hazard(Hazard::NoSegments, empty);
    m.when(d.land(fits, d.lnot(empty)), [&] {
      m.set(Reg::PulseTable, q, at);
      m.set(Reg::PulseSegments, q, segments);
      m.save(Area::SM, segmentByte(q), Width::Byte, m.number(1, 8));
      begin(m, q, control);
    });
  }
};

using PulseGroup = Group<PulseOutput>;

}  // namespace rungproof::isa
