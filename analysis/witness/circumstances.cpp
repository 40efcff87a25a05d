// Readings in the cone of a question, and trials of a witness under other readings.
#include "analysis/witness/circumstances.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/encoding/device_writes.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/s7200/isa/hsc.hpp"
#include "ir/s7200/special_memory.hpp"
#include "ir/s7300/clock_memory.hpp"

namespace rungproof {

namespace {

bool isScanClock(const Place& place) {
  return place.isRegister && (place.reg == Reg::PhaseSecond || place.reg == Reg::PhaseMinute);
}

std::uint8_t valuesOf(Choice choice) { return choiceInfo(choice).values[2].empty() ? 2 : 3; }

std::string named(Choice choice, std::uint8_t value) {
  return fmt::format("{} = {}", choiceInfo(choice).key, choiceInfo(choice).values[value]);
}

/// One trial: whether the run still shows its goal when `change` has been made to its start.
class Trials {
 public:
  Trials(const Witness& witness, const Program& program, const Choices& choices, const Judge* judge)
      : witness_(witness),
        start_(witness.initial ? *witness.initial : powerUpState(Plan(program), choices)),
        judge_(witness.scanCount <= schedule::triedScans ? judge : nullptr) {}

  const Concrete::Store& start() const { return start_; }
  /// Whether the goal may get lost; `isUsual`: without a judge, that the start is as usual.
  template <class Change>
  bool isNeeded(bool isUsual, Change&& change) const {
    if (judge_ == nullptr) return !isUsual;
    Concrete::Store changed = start_;
    change(changed);
    return !judge_->run(witness_.scans, &changed).shown;
  }

 private:
  const Witness& witness_;
  const Concrete::Store start_;
  const Judge* judge_;
};

/// "under scan-clock-start = on", or where in its period the clock bit starts.
std::string clockText(std::uint64_t phase, std::uint64_t period, const std::string& bit) {
  if (phase == 0 || phase == period / 2)
    return "under " + named(Choice::ScanClockStart, phase == 0 ? std::uint8_t{0} : std::uint8_t{1});
  return fmt::format("{} starts {} ms into its period of {} ms, first off, then on", bit, phase, period);
}

/// Devices whose values the encoding leaves open although the machine narrows them; nothing for what is an input
/// anyway.
std::string_view anyValueOf(External kind) {
  switch (kind) {
    case External::IntervalClock:
      return "interval clock = any value at each read: how much time has passed is not followed";
    case External::ClockByte: return "clock = any time at each read: how much time has passed is not followed";
    case External::CalendarDay:
    case External::TimeOfDay: return "date and time = any value at each read: how much time has passed is not followed";
    default: return {};
  }
}

std::vector<std::string> anyValuesOf(const EncodedScan& scan, const std::unordered_set<std::uint32_t>& variables) {
  std::vector<std::string> texts;
  const auto add = [&](std::string text) {
    if (!text.empty() && std::ranges::find(texts, text) == texts.end()) texts.push_back(std::move(text));
  };
  for (std::uint32_t counter = 0; counter < regInfo(Reg::HscCurrent).count; ++counter) {
    const auto counted = scan.deviceInputs().find(DeviceWrites::countName(counter));
    if (counted == scan.deviceInputs().end() || !variables.contains(indexOf(counted->second))) continue;
    add(fmt::format(
        "HC{} = any value in each scan while HSC {} has let it count (SM{}.7), the same for the whole scan: "
        "pulses are not followed",
        counter, counter, isa::hscControl[counter]));
  }
  for (const ExternalInput& e : scan.externals()) {
    if (e.node != noNode && variables.contains(indexOf(e.node))) add(std::string(anyValueOf(e.site.kind)));
  }
  return texts;
}

}  // namespace

Circumstances circumstancesOf(const EncodedScan& scan, const std::unordered_set<std::uint32_t>& variables) {
  const Choices& choices = scan.options().choices;
  Circumstances result;
  const auto add = [&](Choice choice) {
    std::vector<Choice>& list = choices.isFixed(choice) ? result.fixed : result.open;
    if (std::ranges::find(list, choice) == list.end()) list.push_back(choice);
  };
  for (const Cell& cell : scan.cells()) {
    if (cell.kind != CellKind::State || !variables.contains(indexOf(cell.start))) continue;
    if (isScanClock(cell.place)) add(Choice::ScanClockStart);
    if (cell.place.isRegister && cell.place.reg == Reg::Reading) add(choiceOfReading(cell.place.at));
  }
  const bool readsAnalog = std::ranges::any_of(
      scan.analogInputs(), [&](const auto& input) { return variables.contains(indexOf(input.second)); });
  if (readsAnalog) add(Choice::AnalogSampling);
  result.anyValues = anyValuesOf(scan, variables);
  result.mayStop = scan.graph().truth({scan.halted()}) != std::optional(false);
  return result;
}

bool hasAnyValues(const EncodedScan& scan) {
  const auto isOf = [](const ExternalInput& e) { return e.node != noNode && !anyValueOf(e.site.kind).empty(); };
  return !scan.deviceInputs().empty() || std::ranges::any_of(scan.externals(), isOf);
}

std::vector<Choice> fixedReadingsOf(const EncodedScan& scan) {
  std::vector<Choice> result;
  for (const Cell& cell : scan.cells()) {
    const bool isReading = cell.place.isRegister && cell.place.reg == Reg::Reading && cell.kind == CellKind::Constant;
    if (isReading && std::ranges::find(result, choiceOfReading(cell.place.at)) == result.end())
      result.push_back(choiceOfReading(cell.place.at));
  }
  return result;
}

std::vector<std::string> assumptionsOf(const Circumstances& circumstances, const Choices& choices,
                                       const Target& target) {
  std::vector<std::string> texts;
  for (const Choice choice : circumstances.fixed) texts.push_back(named(choice, choices[choice]));
  texts.insert(texts.end(), circumstances.anyValues.begin(), circumstances.anyValues.end());
  if (circumstances.mayStop) texts.emplace_back(dialectOf(target).run.notAsked);
  return texts;
}

std::vector<std::string> conditionsOf(const Circumstances& circumstances, const Witness& witness,
                                      const Program& program, const Choices& choices, const Judge* judge) {
  const Trials trials(witness, program, choices, judge);
  const Concrete::Store& start = trials.start();
  std::vector<std::string> texts;
  const auto add = [&](std::string text) {
    if (std::ranges::find(texts, text) == texts.end()) texts.push_back(std::move(text));
  };
  for (const Choice choice : circumstances.open) {
    const std::uint8_t value = readingIn(start, choice);
    bool isNeeded = false;
    for (std::uint8_t other = 0; other < valuesOf(choice) && !isNeeded; ++other) {
      if (other != value)
        isNeeded = trials.isNeeded(value == 0, [&](Concrete::Store& s) { setReading(s, choice, other); });
    }
    if (isNeeded) add("under " + named(choice, value));
    if (choice != Choice::ScanClockStart) continue;
    for (const auto& [reg, bit] : {std::pair{Reg::PhaseSecond, s7200SystemBits.secondClock},
                                   std::pair{Reg::PhaseMinute, s7200SystemBits.minuteClock}}) {
      const std::uint64_t period = reg == Reg::PhaseSecond ? 1000 : 60000, phase = start.get(reg, 0);
      bool decides = false;
      for (const std::uint64_t other : {std::uint64_t{0}, period / 2}) {
        if (other != phase)
          decides = decides || trials.isNeeded(phase == 0, [&](Concrete::Store& s) { s.set(reg, 0, other, true); });
      }
      if (decides) add(clockText(phase, period, toString(bit.operand())));
    }
  }
  for (std::uint32_t bit = 0; program.clockMemory && bit < clockPeriods.size(); ++bit) {
    const std::uint64_t phase = start.get(Reg::ClockPhase, bit), half = clockPeriods[bit] / 2U;
    const auto decides = [&](std::uint64_t other) {
      return other != phase &&
             trials.isNeeded(phase == 0, [&](Concrete::Store& s) { s.set(Reg::ClockPhase, bit, other, true); });
    };
    if (decides(0) || decides(half))
      add(fmt::format("{} starts {} ms into its period of {} ms, first off, then on",
                      addressName(Area::M, Width::Bit, *program.clockMemory, bit), phase, clockPeriods[bit]));
  }
  if (const std::uint64_t phase = start.get(Reg::PhaseHundred, 0); phase != 0)
    add(fmt::format("RUN begins {} ms after a tick of the 100 ms time base (sim: --phase {}ms)", phase, phase));
  return texts;
}

}  // namespace rungproof
