// One run of OB1 on the reference engine's machine, with the registers put in at a mark and taken out at the end.
#pragma once

#include <array>
#include <functional>
#include <set>
#include <utility>

#include "engine/concrete.hpp"
#include "ir/families/run.hpp"
#include "ir/machine/reading.hpp"
#include "ir/s7300/control.hpp"

namespace rungproof::agreement7 {

/// BLD with this number stands where registers are put in, with the other where they are taken out.
inline constexpr std::int64_t putMark = 254, takeMark = 253;
/// BLD with 200 more than the number of an organization block stands where that interrupts.
inline constexpr std::int64_t interruptMark = 200;

/// Gives 0 for whatever the program does not determine, and the modules' values for PI; keeps the errors.
struct Around final : Outside {
  std::set<Hazard> hazards;
  std::function<std::uint64_t(const ExternalSite&, int)> value = [](const ExternalSite&, int) { return 0; };
  std::uint64_t external(const ExternalSite& site, int width) override { return value(site, width); }
  void report(Hazard hazard, const Instruction*) override { hazards.insert(hazard); }
};

/// What the registers hold, on plain numbers.
struct RegisterValues {
  std::array<bool, 9> status{};  ///< BR CC1 CC0 OV OS OR STA RLO /FC
  std::array<std::uint64_t, 4> accu{};
  std::array<std::uint64_t, 2> ar{};
  std::uint64_t db = 0, di = 0;
};
using Registers = std::function<void(RegisterValues&)>;

/// Changes the registers where the mark says so, or shows them. D: a domain of plain numbers.
struct MarkHooks {
  Registers put, take;
  std::int64_t running = 1;  ///< organization block
  template <class S>
  void before(S& scan, const FlowStep& step) {
    auto& machine = scan.machine();
    if constexpr (requires { machine.d.begins(); }) machine.d.begins();
    const Instruction& i = *step.instruction;
    if (i.desc->stl != "BLD" || i.operands.empty()) return;
    const std::int64_t block = i.operands[0].value - interruptMark;
    if ((block == 35 || block == 40) && block > running) {  // OB40 has the higher priority
      const std::int64_t interrupted = std::exchange(running, block);
      scan.interrupt(static_cast<int>(block), machine.d.constant(true));
      running = interrupted;
    }
    const Registers& use = i.operands[0].value == putMark ? put : take;
    if (!use || (i.operands[0].value != putMark && i.operands[0].value != takeMark)) return;
    auto& s = machine.step7;
    bool* const bits[] = {&s.br, &s.cc1, &s.cc0, &s.ov, &s.os, &s.orBit, &s.sta, &s.rlo, &s.firstCheck};
    RegisterValues values;
    for (std::size_t bit = 0; bit < values.status.size(); ++bit) values.status[bit] = *bits[bit];
    values.accu = s.accu;
    values.ar = s.ar;
    values.db = s.db;
    values.di = s.di;
    use(values);
    for (std::size_t bit = 0; bit < values.status.size(); ++bit) *bits[bit] = values.status[bit];
    s.accu = values.accu;
    s.ar = values.ar;
    s.db = values.db;
    s.di = values.di;
  }
  template <class S>
  void callWithoutBody(S&, const Instruction&) {}
  template <class S>
  void freshLocal(S& scan, std::uint32_t base, std::uint32_t byte) {
    auto& m = scan.machine();
    m.store.save(Area::L, (base + byte) * 8, 8, 0, m.guard);
  }
};

/// Lets `ms` pass, then runs OB1 on a machine over a domain of plain numbers. Gives whether the CPU still runs.
template <class D>
bool runOn(Machine<D>& machine, std::uint32_t ms, const Registers& put, const Registers& take) {
  machine.set(Reg::LastScan, 0, ms);
  endScanOfTimers(machine, ms);
  beginScanOfTimers(machine);
  MarkHooks hooks{.put = put, .take = take};
  Scan<D, MarkHooks> scan(machine, hooks, 100000);
  scan.program();
  return !machine.halted && !machine.faulted;
}

/// Lets `ms` pass, then runs OB1 on `store`. Gives whether the CPU still runs.
bool runOnce(const Program& program, Concrete::Store& store, Around& around, std::uint32_t ms, const Registers& put,
             const Registers& take);

}  // namespace rungproof::agreement7
