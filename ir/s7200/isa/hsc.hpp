// High-speed counters: HDEF and HSC (001:4121-4508). HDEF fixes the mode once per RUN; HSC takes
// what its control byte in SM allows. Counting, reset and events are the device's and lie outside the instructions.
// HDEF reads bits 0-2 of the control byte, HSC bits 3-7. Tests: tests/manual/hsc_test.cpp.
#pragma once

#include "ir/s7200/event.hpp"
#include "ir/s7200/hsc_inputs.hpp"
#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

inline constexpr std::uint32_t hscCount = 6;
/// Control byte of each counter; the status byte stands before it, new current value and new preset 1 and 5 behind
/// (001:4272-4356).
inline constexpr std::array<std::uint32_t, hscCount> hscControl = {37, 47, 57, 137, 147, 157};

/// Numbers of counters: HSC1 and HSC2 are missing on CPU 221 and 222 (001:4166), HSC4 and HSC5 on the compact SMART.
constexpr OperandDesc counterNumber(std::string_view name, Type type) {
  constexpr auto with = [](NumberSet counters) {
    return cpusWith([=](const CpuRow& row) { return row.features.counters == counters; });
  };
  constexpr CpuSet gap = with(numbers(0, 0) | numbers(3, 5));
  return in(name, type, form::Const)
      .within({{0, 0, gap | with(numbers(0, 0))},
               {3, 5, gap},
               {0, 5, with(numbers(0, 5))},
               {0, 2, with(numbers(0, 2))},
               {0, 3, with(numbers(0, 3))}});
}

/// HDEF HSC, MODE: 0003 if an input of that mode is taken, 0004 in an interrupt routine, 000A the second time.
struct DefineHsc {
  static constexpr Desc desc = withOperands(
      {.stl = "HDEF",
       .meaning = "define the high-speed counter mode",
       .group = "high-speed",
       .role = Role::Hdef,
       .stack = {1, 0, 0},
       .eno = true,
       .notInInterrupt = true,
       .time = 1800,
       .manual = "001:4151"},
      {counterNumber("HSC", Type::Byte),
       in("MODE", Type::Byte, form::Const)
           .within({{0, 12, s7200Cpus}, {0, 1, smartCpus}, {3, 4, smartCpus}, {6, 7, smartCpus}, {9, 10, smartCpus}})});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const std::uint32_t counter = a.number(0);
    const int mode = static_cast<int>(a.number(1));
    const bool exists =
        hscExists(m.target, static_cast<int>(counter)) && hscHasMode(m.target, static_cast<int>(counter), mode);
    m.hazard(Hazard::OutOfRange, d.constant(!exists));
    m.hazard(Hazard::NotInInterrupt, d.constant(m.inInterrupt));
    if (!exists || m.inInterrupt) return;
    const auto again = d.lnot(d.equal(m.get(Reg::HscMode, counter), m.number(0, 8), 8));
    const auto conflict = inputTaken(m, counter, mode);
    m.hazard(Hazard::HdefTwice, again);
    m.hazard(Hazard::HscInputConflict, d.land(d.lnot(again), conflict));
    m.when(d.lnot(d.lor(again, conflict)), [&] {
      m.set(Reg::HscMode, counter, m.number(static_cast<std::uint64_t>(mode) + 1, 8));
      m.set(Reg::HscSetup, counter, d.extract(m.load(Area::SM, hscControl[counter], Width::Byte), 2, 0));
    });
  }

 private:
  /// Whether an input of that mode serves another defined counter or an attached edge event (events 0-7: rising and
  /// falling edges of I0.0 to I0.3).
  template <class D>
  static typename D::Bool inputTaken(Machine<D>& m, std::uint32_t counter, int mode) {
    D& d = m.d;
    auto taken = d.constant(false);
    for (const int input : hscInputs(m.target, static_cast<int>(counter))) {
      if (input < 0 || !hscUsesInput(m.target, static_cast<int>(counter), mode, input)) continue;
      for (std::uint32_t other = 0; other < hscCount; ++other) {
        if (other == counter) continue;
        const auto defined = m.get(Reg::HscMode, other);
        for (int k = 0; k <= 12; ++k) {
          if (hscUsesInput(m.target, static_cast<int>(other), k, input))
            taken = d.lor(taken, d.equal(defined, m.number(static_cast<std::uint64_t>(k) + 1, 8), 8));
        }
      }
      for (const EdgeInput& edge : edgeInputs) {
        if (static_cast<int>(edge.bit) != input) continue;
        for (const int event : {edge.rising, edge.rising + 1})
          taken = d.lor(
              taken, d.lnot(d.equal(m.get(Reg::EventRoutine, static_cast<std::uint32_t>(event)), m.number(0, 8), 8)));
      }
    }
    return taken;
  }
};

/// HSC N: 0001 before HDEF; otherwise takes direction, current value, preset and enable as the control byte says. In
/// modes with an external direction input the direction is only the first one (001:4289).
struct ActivateHsc {
  static constexpr Desc desc = withOperands({.stl = "HSC",
                                             .meaning = "activate the high-speed counter",
                                             .group = "high-speed",
                                             .role = Role::Hsc,
                                             .stack = {1, 0, 0},
                                             .eno = true,
                                             .time = 3000,
                                             .manual = "001:4152"},
                                            {counterNumber("N", Type::Word)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const std::uint32_t counter = a.number(0);
    const bool exists = hscExists(m.target, static_cast<int>(counter));
    m.hazard(Hazard::OutOfRange, d.constant(!exists));
    if (!exists) return;
    const auto undefined = d.equal(m.get(Reg::HscMode, counter), m.number(0, 8), 8);
    m.hazard(Hazard::HscWithoutHdef, undefined);
    m.when(d.lnot(undefined), [&] {
      const std::uint32_t control = hscControl[counter];
      m.when(m.sm(control, 4), [&] { m.setBit(Reg::HscUp, counter, m.sm(control, 3)); });
      m.when(m.sm(control, 6), [&] { m.set(Reg::HscCurrent, counter, m.load(Area::SM, control + 1, Width::DWord)); });
      m.when(m.sm(control, 5), [&] { m.set(Reg::HscPreset, counter, m.load(Area::SM, control + 5, Width::DWord)); });
      m.setBit(Reg::HscEnabled, counter, m.sm(control, 7));
      m.signal(Signal::HscLoaded, counter);
    });
  }
};

using HscGroup = Group<DefineHsc, ActivateHsc>;

}  // namespace rungproof::isa
