// Replays both, then compares scan end by scan end.
#include "analysis/equivalence/both_runs.hpp"

#include <algorithm>

#include "analysis/witness/state_pool.hpp"
#include "analysis/witness/witness.hpp"
#include "ir/machine/reading.hpp"
#include "ir/s7300/clock_memory.hpp"

namespace rungproof {

namespace {

struct ScanEnd {
  std::uint64_t milliseconds = 0;
  std::uint32_t lengthMs = 0;
  std::size_t step = 0;  ///< index of its ReplayScan
  std::uint32_t round = 0;
  ScanOutputs outputs;
};

std::uint64_t valueIn(const Concrete::Store& state, const std::optional<Address>& address, std::uint32_t bits) {
  if (!address) return 0;
  if (address->area == Area::T) return state.get(Reg::TimerBit, address->index);
  if (address->area == Area::C) return state.get(Reg::CounterBit, address->index);
  return state.load(address->area, address->index, static_cast<int>(bits));
}

std::uint64_t pulseNumberIn(const Concrete::Store& state, const PulseSignal& signal, const PulseForm& form) {
  StillOutside outside;
  Concrete domain(outside);
  return pulseNumber(domain, signal.number, form,
                     [&](Reg reg) { return state.get(reg, reg == Reg::Running ? 0 : signal.output); });
}

std::vector<ScanEnd> scanEnds(const BothRuns& runs, const EquivalenceRun& run, bool isOld) {
  const std::vector<ReplayScan>& scans = isOld ? run.before : run.after;
  const std::optional<Concrete::Store>& initial = isOld ? run.initialBefore : run.initialAfter;
  std::vector<ScanEnd> ends;
  std::uint64_t now = 0;
  replay(isOld ? runs.before : runs.after, runs.options.prover.choices, scans, initial ? &*initial : nullptr,
         [&](const Concrete::Store& state, std::size_t at) {
           const bool isSame = !ends.empty() && ends.back().step == at;
           const std::uint32_t round = isSame ? ends.back().round + 1 : 0;
           now += scans[at].lengthMs;
           ends.push_back({now, scans[at].lengthMs, at, round, runs.outputsOf(state, isOld)});
           return ends.back().outputs.runs;
         });
  return ends;
}

void cut(std::vector<ReplayScan>& scans, const ScanEnd& end) {
  scans.resize(end.step + 1);
  scans.back().repeats = end.round + 1;
}

}  // namespace

std::optional<OutputWatch::Difference> OutputWatch::next(ScanOutputs before, const ScanOutputs& after,
                                                         std::uint32_t lengthMs) {
  if (comparesStops_ && before.runs != after.runs) return Difference{lasted_.size(), before.runs, after.runs};
  old_.push_back(std::move(before));
  if (old_.size() <= latency_) return std::nullopt;
  const ScanOutputs then = std::move(old_.front());
  old_.pop_front();
  for (std::size_t i = 0; i < lasted_.size(); ++i) {
    if (isAlike(i, then.values[i], after.values[i])) {
      lasted_[i].reset();
      continue;
    }
    lasted_[i] = lasted_[i] ? *lasted_[i] + lengthMs : 0;
    if (*lasted_[i] >= settleMs_) return Difference{i, then.values[i], after.values[i]};
  }
  return std::nullopt;
}

bool OutputWatch::isAlike(std::size_t output, std::uint64_t before, std::uint64_t after) const {
  if (!pulses_[output]) return before == after;
  StillOutside outside;
  Concrete domain(outside);
  return !pulsesDiffer(domain, pulses_[output]->number, before, after);
}

ScanOutputs BothRuns::outputsOf(const Concrete::Store& state, bool isOld) const {
  ScanOutputs result{state.get(Reg::Running, 0) != 0, {}};
  const PulseForm form = pulseForm((isOld ? before : after).target);
  for (const ObservedBit& bit : observed) {
    result.values.push_back(bit.pulses ? pulseNumberIn(state, *bit.pulses, form)
                                       : valueIn(state, isOld ? bit.before : bit.after, bit.bits));
  }
  return result;
}

std::optional<EquivalenceRun> BothRuns::judged(EquivalenceRun run) const {
  const std::vector<ScanEnd> left = scanEnds(*this, run, true), right = scanEnds(*this, run, false);
  OutputWatch watch(*this);
  for (std::size_t k = 0; k < std::min(left.size(), right.size()); ++k) {
    const auto found = watch.next(left[k].outputs, right[k].outputs, right[k].lengthMs);
    if (!found) continue;
    const bool isStop = found->output == observed.size();
    run.scan = k + 1;
    run.milliseconds = left[k].milliseconds;
    run.signal = isStop ? "RUN" : observed[found->output].name;
    run.valueBefore = found->before;
    run.valueAfter = found->after;
    if (!isStop) {
      run.addressBefore = observed[found->output].before;
      run.addressAfter = observed[found->output].after;
    }
    cut(run.before, left[k]);
    cut(run.after, right[k]);
    return run;
  }
  return std::nullopt;
}

EquivalenceRun BothRuns::plain(EquivalenceRun run) const {
  if (!run.initialBefore || !run.initialAfter) return run;
  const auto tryWith = [&](const auto& change) {
    EquivalenceRun other = run;
    change(*other.initialBefore);
    change(*other.initialAfter);
    std::optional<EquivalenceRun> found = judged(std::move(other));
    if (!found) return false;
    run = std::move(*found);
    return true;
  };
  for (const Reg phase : {Reg::PhaseTen, Reg::PhaseHundred, Reg::PhaseSecond, Reg::PhaseMinute}) {
    if (run.initialBefore->get(phase, 0) != 0) tryWith([&](Concrete::Store& state) { state.set(phase, 0, 0, true); });
  }
  for (std::uint32_t bit = 0; bit < clockPeriods.size(); ++bit) {
    if (run.initialBefore->get(Reg::ClockPhase, bit) != 0)
      tryWith([&](Concrete::Store& state) { state.set(Reg::ClockPhase, bit, 0, true); });
  }
  for (const ChoiceInfo& info : choiceTable) {
    const std::uint8_t usual = options.prover.choices[info.choice], now = readingIn(*run.initialBefore, info.choice);
    if (info.kind != ChoiceKind::Reading || now == usual) continue;
    if (!tryWith([&](Concrete::Store& state) { setReading(state, info.choice, usual); }))
      run.readings.emplace_back(info.choice, now);
  }
  return run;
}

}  // namespace rungproof
