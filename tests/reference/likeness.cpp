// Copying and comparing the two machines.
#include "likeness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace rungproof::reference {

namespace {

constexpr Area areas[] = {Area::I, Area::Q, Area::V, Area::M, Area::S, Area::SM, Area::L, Area::AQ};

/// Results that the manual leaves to the arithmetic of the CPU: which operands, and which elements of them.
struct Rounded {
  std::size_t operand;
  std::vector<int> elements;
};
std::optional<Rounded> roundedBy(std::string_view name) {
  if (name == "PID") return Rounded{0, {2, 7}};
  if (name == "STR") return Rounded{2, {0}};
  if (name == "SIN" || name == "COS" || name == "TAN" || name == "LN" || name == "EXP" || name.starts_with("ARC"))
    return Rounded{1, {0}};
  return std::nullopt;
}

std::string told(const std::vector<std::pair<Signal, std::uint32_t>>& signals) {
  std::string text;
  for (const auto& [signal, index] : signals) {
    switch (signal) {
      case Signal::EventAttached: text += fmt::format("attach {};", index); break;
      case Signal::EventDetached: text += fmt::format("detach {};", index); break;
      case Signal::EventsCleared: text += fmt::format("clear {};", index); break;
      case Signal::ClockSet: text += fmt::format("clock {};", index); break;
      case Signal::WatchdogRestarted: text += "watchdog;"; break;
      case Signal::Stopped: text += "stop;"; break;
      default: text += "device;"; break;
    }
  }
  return text;
}

std::string registersThatDiffer(const Concrete::Store& s, const naive::Interpreter& plain) {
  const auto differs = [](std::string_view name, std::size_t n, std::uint64_t expected, std::uint64_t actual) {
    return expected == actual ? std::string()
                              : fmt::format("{}[{}]: naive {:x}, engine {:x}", name, n, expected, actual);
  };
  const auto all = [&](std::string_view name, Reg reg, const auto& list) {
    std::string wrong;
    for (std::size_t n = 0; n < list.size() && wrong.empty(); ++n) {
      const std::uint64_t mask = ~0ULL >> (64 - regInfo(reg).width);
      wrong = differs(name, n, static_cast<std::uint64_t>(list[n]) & mask, s.get(reg, static_cast<std::uint32_t>(n)));
    }
    return wrong;
  };
  std::string wrong = all("AC", Reg::Accumulator, plain.accumulator);
  if (wrong.empty()) wrong = all("T", Reg::TimerCurrent, plain.timer);
  if (wrong.empty()) wrong = all("T bit", Reg::TimerBit, plain.timerBit);
  if (wrong.empty()) wrong = all("C", Reg::CounterCurrent, plain.counter);
  if (wrong.empty()) wrong = all("C bit", Reg::CounterBit, plain.counterBit);
  if (wrong.empty()) wrong = all("PID history", Reg::PidHistory, plain.pidHistory);
  if (wrong.empty()) wrong = all("event", Reg::EventRoutine, plain.routine);
  if (wrong.empty()) wrong = all("clock setting", Reg::ClockSetting, plain.clockSetting);
  for (std::uint32_t bit = 0; bit < 128 && wrong.empty(); ++bit)
    wrong = differs("output", bit, plain.outputs[bit / 8] >> bit % 8 & 1, s.get(Reg::PhysicalOutput, bit));
  if (wrong.empty())
    wrong = differs("interrupts", 0, plain.memory.at(Area::SM)[4] >> 4 & 1, s.get(Reg::InterruptsEnabled, 0));
  if (wrong.empty()) wrong = differs("DIAG", 0, plain.diagnosticLed, s.get(Reg::DiagnosticLed, 0));
  return wrong;
}

}  // namespace

bool isClose(std::uint32_t a, std::uint32_t b, double least) {
  const double x = std::bit_cast<float>(a), y = std::bit_cast<float>(b);
  return a == b || std::abs(x - y) <= 1e-6 * std::max({std::abs(x), std::abs(y), least});
}

void copyState(const manual::Plant& plant, naive::Interpreter& plain) {
  const Concrete::Store& s = plant.store;
  for (const Area area : areas) {
    const auto& bytes = s.area(area);
    std::copy_n(bytes.begin(), std::min(bytes.size(), plain.memory[area].size()), plain.memory[area].begin());
  }
  std::fill_n(plain.memory[Area::L].begin(), 64, static_cast<std::uint8_t>(plant.freshLocal));
  for (const auto& [source, value] : plant.outside.values) {
    const auto& [kind, index] = source;
    if (kind == External::AnalogInput) {
      plain.memory[Area::AI][index] = static_cast<std::uint8_t>(value >> 8);
      plain.memory[Area::AI][index + 1] = static_cast<std::uint8_t>(value);
    }
    if (kind == External::ImmediateInput && value != 0)
      plain.inputs[index / 8] |= static_cast<std::uint8_t>(1U << index % 8);
    if (kind == External::ClockByte) plain.clock[index] = static_cast<std::uint8_t>(value);
    if (kind == External::IntervalClock) plain.milliseconds = static_cast<std::uint32_t>(value);
    if (kind == External::StationAddress) plain.stationAddress[index] = static_cast<std::uint8_t>(value);
  }
  const auto each = [&](Reg reg, auto& list) {
    for (std::uint32_t n = 0; n < list.size(); ++n)
      list[n] = static_cast<std::remove_reference_t<decltype(list[n])>>(s.get(reg, n));
  };
  each(Reg::Accumulator, plain.accumulator);
  each(Reg::TimerCurrent, plain.timer);
  each(Reg::TimerBit, plain.timerBit);
  each(Reg::CounterCurrent, plain.counter);
  each(Reg::CounterBit, plain.counterBit);
  each(Reg::HscCurrent, plain.highSpeed);
  each(Reg::PidHistory, plain.pidHistory);
  each(Reg::EventRoutine, plain.routine);
  plain.eno = s.get(Reg::Eno, 0) != 0;
  plain.firstScan = s.get(Reg::FirstScan, 0) != 0;
}

std::string difference(manual::Plant& plant, naive::Interpreter& plain, const Instruction* last) {
  std::vector<std::string> met;
  for (const Hazard hazard : plant.outside.hazards()) met.emplace_back(hazardInfo(hazard).code);
  std::sort(met.begin(), met.end());
  std::sort(plain.errors.begin(), plain.errors.end());
  if (met != plain.errors)
    return fmt::format("errors: naive {}, engine {}", fmt::join(plain.errors, " "), fmt::join(met, " "));
  if (const std::string said = fmt::format("{}", fmt::join(plain.told, ";")) + (plain.told.empty() ? "" : ";");
      said != told(plant.outside.signals))
    return fmt::format("told: naive {}, engine {}", said, told(plant.outside.signals));
  if (plain.stopped != plant.halted) return "one of them stopped";
  const auto rounded = last == nullptr || plain.stopped ? std::nullopt : roundedBy(last->desc->stl);
  for (const int element : rounded ? rounded->elements : std::vector<int>{}) {
    naive::Interpreter other = plain;
    for (const Area area : areas)
      std::copy(plant.store.area(area).begin(), plant.store.area(area).end(), other.memory[area].begin());
    for (std::uint32_t n = 0; n < 4; ++n)
      other.accumulator[n] = static_cast<std::uint32_t>(plant.store.get(Reg::Accumulator, n));
    const Operand& o = last->operands[rounded->operand];
    const std::uint32_t actual = other.read(o, 4, element), expected = plain.read(o, 4, element);
    if (!isClose(actual, expected, last->desc->stl == "PID" ? 10 : 1e-30))
      return fmt::format("result: naive {}, engine {}", std::bit_cast<float>(expected), std::bit_cast<float>(actual));
    plain.write(o, 4, actual, element);
  }
  for (const Area area : areas) {
    const auto& actual = plant.store.area(area);
    const auto& expected = plain.memory.at(area);
    const auto at = std::mismatch(actual.begin(), actual.end(), expected.begin()).first - actual.begin();
    if (at != static_cast<std::ptrdiff_t>(actual.size()))
      return fmt::format("{}B{}: naive {:02x}, engine {:02x}", areaName(area), at,
                         expected[static_cast<std::size_t>(at)], actual[static_cast<std::size_t>(at)]);
  }
  if (plain.stack != plant.stack)
    return fmt::format("stack: naive {}, engine {}", fmt::join(plain.stack, ""), fmt::join(plant.stack, ""));
  if (plain.eno != (plant.store.get(Reg::Eno, 0) != 0)) return fmt::format("ENO: naive {}", plain.eno);
  return registersThatDiffer(plant.store, plain);
}

}  // namespace rungproof::reference
