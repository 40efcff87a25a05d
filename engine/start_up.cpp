// State at power-up and at the change to RUN.
#include "engine/start_up.hpp"

#include <algorithm>

#include "ir/s7200/special_memory.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

namespace {

void setSm(Concrete::Store& store, std::uint32_t byte, std::uint32_t bit, bool value) {
  store.save(Area::SM, byte * 8 + bit, 1, value ? 1 : 0, true);
}

void fill(Concrete::Store& store, Reg reg, std::uint64_t value) {
  for (std::uint32_t i = 0; i < store.count(reg); ++i) store.set(reg, i, value, true);
}

/// What the first scan after entering RUN finds in SM and in the registers of devices.
void prepareRun(Concrete::Store& store, const Choices& choices) {
  const bool clockStartsOn = choices.is(Choice::ScanClockStart, "on");
  setReadings(store, choices);
  setSm(store, 0, 0, true);
  setSm(store, 0, 1, true);
  for (std::uint32_t bit = 4; bit <= 6; ++bit) setSm(store, 0, bit, clockStartsOn);
  setSm(store, 0, 7, true);  // mode switch in RUN
  for (std::uint32_t bit = 0; bit <= 4; ++bit) setSm(store, 4, bit, false);
  setSm(store, 4, 5, true);
  setSm(store, 4, 6, true);
  for (const std::uint32_t status : {66U, 76U}) {
    setSm(store, status, 6, false);  // 001:4651
    setSm(store, status, 7, true);
  }
  for (const Reg reg :
       {Reg::EdgeMemory,   Reg::EdgeSeen,      Reg::EventRoutine, Reg::InterruptsEnabled, Reg::TimedPeriod,
        Reg::TimedElapsed, Reg::CyclicElapsed, Reg::HscMode,      Reg::HscEnabled,        Reg::PulseBusy,
        Reg::PulsePending, Reg::PortBusy,      Reg::NetActive,    Reg::TimerRunning,      Reg::TimerInput,
        Reg::CounterUp,    Reg::CounterDown,   Reg::PhaseTen,     Reg::PhaseHundred,      Reg::Fault}) {
    fill(store, reg, 0);
  }
  fill(store, Reg::PhaseSecond, clockStartsOn ? 500 : 0);
  fill(store, Reg::PhaseMinute, clockStartsOn ? 30000 : 0);
  fill(store, Reg::PidHistory, 1);  // 001:5295
  fill(store, Reg::FirstScan, 1);
  fill(store, Reg::Running, 1);
}

/// The organization blocks that something beside the program starts are attached for good.
void attachBlocks(const Plan& plan, Concrete::Store& store) {
  if (!plan.dialect().run.startsBlocks) return;
  for (int event = firstBlockEvent; event < blockEventEnd; ++event) {
    const int block = blockOfEvent(event);
    if (plan.block(blockNumber(BlockType::Ob, block)) == nullptr) continue;
    store.set(Reg::EventRoutine, static_cast<std::uint32_t>(event), static_cast<std::uint64_t>(block) + 1, true);
  }
  store.set(Reg::InterruptsEnabled, 0, 1, true);
  for (std::uint32_t i = 0; i < cyclicBlockCount; ++i)
    store.set(Reg::CyclicPeriod, i, plan.program->cyclicPeriods[i], true);
}

void loadDataBlock(const Program& program, Concrete::Store& store) {
  std::vector<std::uint8_t>& memory = store.area(Area::V);
  for (const DataInit& init : program.data) {
    for (std::size_t i = 0; i < init.bytes.size(); ++i) {
      if (init.offset + i < memory.size()) memory[init.offset + i] = init.bytes[i];
    }
  }
  for (const DataBlock& block : program.dataBlocks) {
    const std::uint32_t first = store.blocks().place(dataByte(block.number, 0));
    if (first < store.area(Area::DB).size()) std::ranges::copy(block.bytes, store.area(Area::DB).begin() + first);
  }
}

}  // namespace

std::vector<RetentiveRange> defaultRetentiveRanges(const Target& target) {
  return dialectOf(target).memory.usuallyRetentive(target);
}

std::vector<RetentiveRange> retentiveRanges(const Program& program,
                                            const std::optional<std::vector<RetentiveRange>>& given) {
  if (program.coldStart) return {};
  return dialectOf(program.target).memory.retentive(program, given ? *given : defaultRetentiveRanges(program.target));
}

bool isRetentive(const std::vector<RetentiveRange>& ranges, Area area, std::uint32_t index) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const RetentiveRange& range) {
    return range.area == area && range.first <= index && index <= range.last;
  });
}

std::span<const Reg> retainedRegisters(Area area, Counting counting) {
  static constexpr Reg current[] = {Reg::TimerCurrent}, counted[] = {Reg::CounterCurrent, Reg::CounterBit};
  static constexpr Reg s5[] = {Reg::TimerBit, Reg::TimerRunning, Reg::S5Rest, Reg::S5Base, Reg::S5AtEnd};
  const bool areElements = counting == Counting::Elements;
  if (area == Area::T) return areElements ? std::span<const Reg>(s5) : std::span<const Reg>(current);
  return std::span<const Reg>(counted).first(areElements ? 2 : 1);
}

void setTickPhase(Concrete::Store& store, std::uint32_t phase) {
  store.set(Reg::PhaseTen, 0, phase % 10, true);
  store.set(Reg::PhaseHundred, 0, phase % 100, true);
}

Concrete::Store powerUpState(const Plan& plan, const Choices& choices, bool dataLost) {
  Concrete::Store store(plan);
  loadDataBlock(*plan.program, store);
  prepareRun(store, choices);
  setSm(store, 0, 2, dataLost);
  setSm(store, 0, 3, true);
  attachBlocks(plan, store);
  if (!plan.dialect().memory.hasSpecialMemory) return store;
  store.area(Area::SM)[6] = cpuRow(plan.program->target.cpu).identifier.value_or(0x20);  // 224XP: that of the 224
  return store;
}

Concrete::Store powerCycledState(const Plan& plan, const Choices& choices, const Concrete::Store& before,
                                 const std::vector<RetentiveRange>& ranges) {
  Concrete::Store store = powerUpState(plan, choices);
  for (const AreaInfo& info : areaTable) {
    if (!info.mayRetain || info.addressing != Addressing::Bytes) continue;
    const Area area = info.area;
    const std::vector<std::uint8_t>& old = before.area(area);
    for (std::uint32_t i = 0; i < old.size(); ++i) {
      const std::uint32_t byte = area == Area::DB ? store.blocks().dataByteAt(i) : i;
      if (isRetentive(ranges, area, byte)) store.area(area)[i] = old[i];
    }
  }
  for (const auto& [area, count] : {std::pair{Area::T, plan.timerCount}, std::pair{Area::C, plan.counterCount}}) {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!isRetentive(ranges, area, i)) continue;
      for (const Reg reg : retainedRegisters(area, plan.counting())) store.set(reg, i, before.get(reg, i), true);
    }
  }
  return store;
}

void enterRun(const Plan& plan, Concrete::Store& store, const Choices& choices,
              const std::vector<RetentiveRange>& ranges) {
  if (plan.dialect().run.restartsWarm) {
    const Concrete::Store before = store;
    store = powerCycledState(plan, choices, before, ranges);
    for (const Reg clock : {Reg::PhaseTen, Reg::PhaseHundred, Reg::ClockPhase}) {
      for (std::uint32_t i = 0; i < store.count(clock); ++i) store.set(clock, i, before.get(clock, i), true);
    }
    return;
  }
  for (std::uint32_t i = 0; i < store.count(Reg::TimerBit); ++i) {
    store.set(Reg::TimerBit, i, 0, true);
    if (!isRetentive(ranges, Area::T, i)) store.set(Reg::TimerCurrent, i, 0, true);
  }
  for (std::uint32_t i = 0; i < store.count(Reg::CounterBit); ++i) {
    store.set(Reg::CounterBit, i, 0, true);
    if (!isRetentive(ranges, Area::C, i)) store.set(Reg::CounterCurrent, i, 0, true);
  }
  const auto phase = static_cast<std::uint32_t>(store.get(Reg::PhaseHundred, 0));
  prepareRun(store, choices);
  attachBlocks(plan, store);
  setTickPhase(store, phase);
  setSm(store, 0, 2, false);
  setSm(store, 0, 3, false);
}

}  // namespace rungproof
