// Replays both, then compares scan end by scan end.
#include "analysis/equivalence/both_runs.hpp"

#include <algorithm>

#include "analysis/proof/witness.hpp"
#include "ir/reading.hpp"

namespace rungproof {

namespace {

struct ScanEnd {
  std::uint64_t milliseconds = 0;
  std::uint32_t lengthMs = 0;
  std::size_t step = 0;  ///< index of its ReplayScan
  std::uint32_t round = 0;
  bool runs = false;
  std::vector<bool> outputs;
};

bool bitIn(const Concrete::Store& state, const std::optional<Address>& address) {
  if (!address) return false;
  if (address->area == Area::T) return state.get(Reg::TimerBit, address->index) != 0;
  if (address->area == Area::C) return state.get(Reg::CounterBit, address->index) != 0;
  return state.load(address->area, address->index, 1) != 0;
}

std::vector<ScanEnd> scanEnds(const Program& program, const Choices& choices, const std::vector<ReplayScan>& scans,
                              const std::optional<Concrete::Store>& initial, const std::vector<ObservedBit>& observed,
                              bool isOld) {
  std::vector<ScanEnd> ends;
  std::uint64_t now = 0;
  replay(program, choices, scans, initial ? &*initial : nullptr, [&](const Concrete::Store& state, std::size_t at) {
    const bool isSame = !ends.empty() && ends.back().step == at;
    const std::uint32_t round = isSame ? ends.back().round + 1 : 0;
    now += scans[at].lengthMs;
    ScanEnd& end = ends.emplace_back();
    end = {now, scans[at].lengthMs, at, round, state.get(Reg::Running, 0) != 0, {}};
    for (const ObservedBit& bit : observed) end.outputs.push_back(bitIn(state, isOld ? bit.before : bit.after));
    return end.runs;
  });
  return ends;
}

void cut(std::vector<ReplayScan>& scans, const ScanEnd& end) {
  scans.resize(end.step + 1);
  scans.back().repeats = end.round + 1;
}

}  // namespace

std::optional<EquivalenceRun> BothRuns::judged(EquivalenceRun run) const {
  const Choices& choices = options.prover.choices;
  const std::vector<ScanEnd> left = scanEnds(before, choices, run.before, run.initialBefore, observed, true);
  const std::vector<ScanEnd> right = scanEnds(after, choices, run.after, run.initialAfter, observed, false);
  std::vector<std::optional<std::uint64_t>> lasted(observed.size());  // ms since the first scan end with a difference
  const std::size_t count = std::max(left.size(), right.size());
  for (std::size_t k = 0; k < count && k < left.size() && k < right.size(); ++k) {
    const auto show = [&](std::string signal, bool a, bool b, const ObservedBit* bit) {
      run.scan = k + 1;
      run.milliseconds = left[k].milliseconds;
      run.signal = std::move(signal);
      run.valueBefore = a;
      run.valueAfter = b;
      if (bit != nullptr) {
        run.addressBefore = bit->before;
        run.addressAfter = bit->after;
      }
      cut(run.before, left[k]);
      cut(run.after, right[k]);
      return run;
    };
    if (comparesStops && left[k].runs != right[k].runs) return show("RUN", left[k].runs, right[k].runs, nullptr);
    if (k < options.latency) continue;
    const ScanEnd& then = left[k - options.latency];
    for (std::size_t i = 0; i < observed.size(); ++i) {
      const bool a = then.outputs[i], b = right[k].outputs[i];
      if (a == b) {
        lasted[i].reset();
        continue;
      }
      lasted[i] = lasted[i] ? *lasted[i] + right[k].lengthMs : 0;
      if (*lasted[i] >= options.settleMs) return show(observed[i].name, a, b, &observed[i]);
    }
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
  for (const ChoiceInfo& info : choiceTable) {
    const std::uint8_t usual = options.prover.choices[info.choice], now = readingIn(*run.initialBefore, info.choice);
    if (info.kind != ChoiceKind::Reading || now == usual) continue;
    if (!tryWith([&](Concrete::Store& state) { setReading(state, info.choice, usual); }))
      run.readings.emplace_back(info.choice, now);
  }
  return run;
}

}  // namespace rungproof
