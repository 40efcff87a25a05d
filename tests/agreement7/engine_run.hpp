// One run of OB1 on the reference engine's machine, with the registers put in at a mark and taken out at the end.
#pragma once

#include <functional>
#include <set>

#include "engine/concrete.hpp"
#include "ir/s7200/reading.hpp"
#include "ir/s7200/scan.hpp"
#include "ir/s7200/timer_refresh.hpp"
#include "ir/s7300/control.hpp"

namespace rungproof::agreement7 {

/// BLD with this number stands where registers are put in, with the other where they are taken out.
inline constexpr std::int64_t putMark = 254, takeMark = 253;

/// Gives 0 for whatever the program does not determine, and the modules' values for PI; keeps the errors.
struct Around final : Outside {
  std::set<Hazard> hazards;
  std::function<std::uint64_t(const ExternalSite&, int)> value = [](const ExternalSite&, int) { return 0; };
  std::uint64_t external(const ExternalSite& site, int width) override { return value(site, width); }
  void report(Hazard hazard, const Instruction*) override { hazards.insert(hazard); }
};

using Registers = std::function<void(Machine<Concrete>&)>;

struct MarkHooks {
  Registers put, take;
  template <class S>
  void before(S& scan, const FlowStep& step) {
    const Instruction& i = *step.instruction;
    if (i.desc->stl != "BLD" || i.operands.empty()) return;
    if (i.operands[0].value == putMark && put) put(scan.machine());
    if (i.operands[0].value == takeMark && take) take(scan.machine());
  }
  template <class S>
  void callWithoutBody(S&, const Instruction&) {}
  template <class S>
  void freshLocal(S& scan, std::uint32_t base, std::uint32_t byte) {
    Machine<Concrete>& m = scan.machine();
    m.store.save(Area::L, (base + byte) * 8, 8, 0, m.guard);
  }
};

/// Lets `ms` pass, then runs OB1 on `store`. Gives whether the CPU still runs.
bool runOnce(const Program& program, Concrete::Store& store, Around& around, std::uint32_t ms, const Registers& put,
             const Registers& take);

}  // namespace rungproof::agreement7
