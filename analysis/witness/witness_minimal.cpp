// What nobody chooses is left at rest, and scans of a long run become alike; then greedy removal, larger pieces first;
// then interrupts; then inputs one by one; then trials of all idle inputs together.
#include "analysis/witness/witness_minimal.hpp"

#include <algorithm>
#include <chrono>
#include <random>

#include "analysis/schedule/schedule.hpp"
#include "engine/start_up.hpp"
#include "ir/s7300/clock_memory.hpp"

namespace rungproof {

namespace {

using Clock = std::chrono::steady_clock;

/// Values that nothing in the plant decides: what registers and local data hold by chance, what the manual leaves open.
bool isChance(const ExternalValue& value) {
  switch (value.site.kind) {
    case External::StackBottom:
    case External::LocalMemory:
    case External::UnknownStatus:
    case External::UnknownResult:
    case External::RegisterAtStart:
    case External::CalendarDay:
    case External::TimeOfDay:
    case External::TimerPhase: return true;
    default: return false;
  }
}

class Minimiser {
 public:
  Minimiser(const Judge& judge, Witness witness, std::uint32_t plainMs, double seconds, std::uint64_t seed)
      : judge_(judge),
        best_(std::move(witness)),
        plainMs_(plainMs),
        end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
        random_(seed) {}

  Witness run() {
    dropChance();
    if (best_.scans.size() >= schedule::leastJoined) joinScans();
    dropScans();
    shortenStretches();
    dropOf(&ScanScript::writes);
    dropOf(&ScanScript::events);
    evenLengths();
    dropOf(&ScanScript::events);  // shorter scans have no time for some that they name
    dropStartValues();
    if (findIdle()) store();
    return std::move(best_);
  }
  Witness runForEvents() {
    dropOf(&ScanScript::events);
    return std::move(best_);
  }

 private:
  struct Input {
    std::size_t scan, index;
  };
  bool isLate() const { return Clock::now() >= end_; }
  const Concrete::Store* initial() const { return best_.initial ? &*best_.initial : nullptr; }

  /// Takes the scans if they show the same in less scans.
  bool accept(std::vector<ReplayScan> scans) {
    std::optional<Witness> found = judge_.witness(std::move(scans), best_.initial);
    if (!found || found->scanCount >= best_.scanCount) return false;
    best_ = std::move(*found);
    return true;
  }

  /// Whether the run shows the same without these values.
  template <class Dispensable>
  bool dropExternals(Dispensable isDispensable) {
    std::vector<ReplayScan> scans = best_.scans;
    std::size_t dropped = 0;
    for (ReplayScan& scan : scans) dropped += std::erase_if(scan.externals, isDispensable);
    return dropped > 0 && acceptAsLong(std::move(scans));
  }
  void dropChance() {
    dropExternals(isChance);
    // Where every read of an analog input may find the same, the input says it.
    dropExternals([](const ExternalValue& value) { return value.site.kind == External::AnalogInput; });
  }

  /// Neighbours that can have the inputs of the first of them become one stretch, which lasts as long.
  void joinScans() {
    for (std::size_t piece = best_.scans.size() / 2; piece > 0; piece /= 2) {
      for (std::size_t from = 0; from + piece < best_.scans.size() && !isLate();) {
        std::vector<ReplayScan> scans = best_.scans;
        const auto first = scans.begin() + static_cast<std::ptrdiff_t>(from),
                   behind = first + static_cast<std::ptrdiff_t>(piece) + 1;
        std::uint64_t count = 0, milliseconds = 0;
        for (auto scan = first; scan != behind; ++scan) {
          count += scan->repeats;
          milliseconds += std::uint64_t{scan->repeats} * scan->lengthMs;
        }
        first->repeats = static_cast<std::uint32_t>(count);
        first->lengthMs = static_cast<std::uint32_t>((milliseconds + count - 1) / count);
        first->script = {};
        first->externals.clear();
        scans.erase(first + 1, behind);
        if (!acceptAsLong(std::move(scans))) from += piece;
      }
    }
  }

  void dropScans() {
    for (std::size_t piece = std::max<std::size_t>(best_.scans.size() / 2, 1); piece > 0; piece /= 2) {
      for (std::size_t from = 0; from + piece < best_.scans.size() && !isLate();) {
        std::vector<ReplayScan> scans = best_.scans;
        const auto first = scans.begin() + static_cast<std::ptrdiff_t>(from);
        scans.erase(first, first + static_cast<std::ptrdiff_t>(piece));
        if (!accept(std::move(scans))) from += piece;
      }
    }
  }

  void shortenStretches() {
    for (std::size_t i = 0; i < best_.scans.size(); ++i) {
      std::uint32_t low = 0;  // more repeats than that are needed
      while (i < best_.scans.size() && best_.scans[i].repeats > low + 1 && !isLate()) {
        std::vector<ReplayScan> scans = best_.scans;
        const std::uint32_t middle = low + (scans[i].repeats - low) / 2;
        scans[i].repeats = middle;
        if (!accept(std::move(scans))) low = middle;
      }
    }
  }

  /// Scans of the everyday length: all of them, or else as many as can have it.
  void evenLengths() {
    std::vector<ReplayScan> scans = best_.scans;
    for (ReplayScan& scan : scans) scan.lengthMs = plainMs_;
    if (acceptAsLong(scans)) return;
    for (std::size_t i = 0; i < best_.scans.size() && !isLate(); ++i) {
      if (best_.scans[i].lengthMs == plainMs_) continue;
      scans = best_.scans;
      scans[i].lengthMs = plainMs_;
      acceptAsLong(std::move(scans));
    }
  }

  /// What a scan's script holds in a list and is not needed: all of a scan at once, or one after the other from the
  /// last.
  template <class Entry>
  void dropOf(std::vector<Entry> ScanScript::*list) {
    for (std::size_t i = best_.scans.size(); i-- > 0;) {
      if (i >= best_.scans.size() || (best_.scans[i].script.*list).empty() || isLate()) continue;
      std::vector<ReplayScan> scans = best_.scans;
      (scans[i].script.*list).clear();
      if (acceptAsLong(scans)) continue;
      for (std::size_t k = (best_.scans[i].script.*list).size(); k-- > 0 && !isLate();) {
        if (i >= best_.scans.size() || k >= (best_.scans[i].script.*list).size()) continue;
        scans = best_.scans;
        std::vector<Entry>& entries = scans[i].script.*list;
        entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(k));
        acceptAsLong(std::move(scans));
      }
    }
  }

  bool acceptAsLong(std::vector<ReplayScan> scans) {
    std::optional<Witness> found = judge_.witness(std::move(scans), best_.initial);
    if (!found || found->scanCount > best_.scanCount) return false;
    best_ = std::move(*found);
    return true;
  }

  /// Memory at the start as after a loss of power, as far as the same is shown.
  void dropStartValues() {
    if (!best_.initial) return;
    const Concrete::Store powerUp = powerUpState(Plan(judge_.program()), judge_.choices());
    if (judge_.run(best_.scans, nullptr).shown) {
      best_.initial.reset();
      return;
    }
    for (const StartCell& cell : startCells(judge_.program(), judge_.choices(), *best_.initial)) {
      if (isLate()) return;
      const Concrete::Store before = *best_.initial;
      Concrete::Store& initial = *best_.initial;
      switch (cell.area) {
        case Area::T:
        case Area::C:
          for (const Reg reg : retainedRegisters(cell.area, dialectOf(judge_.program().target).run.counting))
            initial.set(reg, cell.index, powerUp.get(reg, cell.index), true);
          break;
        default: initial.area(cell.area)[cell.index] = powerUp.area(cell.area)[cell.index];
      }
      if (!isShown(best_.scans)) *best_.initial = before;
    }
    dropCircumstances();
  }

  /// The usual readings, and clocks that start at a tick.
  void dropCircumstances() {
    const auto tryStart = [&](auto&& change) {
      const Concrete::Store before = *best_.initial;
      change(*best_.initial);
      if (!(before == *best_.initial) && !isShown(best_.scans)) *best_.initial = before;
    };
    for (const ChoiceInfo& info : choiceTable) {
      if (isLate()) return;
      tryStart([&](Concrete::Store& s) { setReading(s, info.choice, judge_.choices()[info.choice]); });
    }
    tryStart([](Concrete::Store& s) { setTickPhase(s, 0); });
    for (const auto& [reg, period] : {std::pair{Reg::PhaseSecond, 1000U}, std::pair{Reg::PhaseMinute, 60000U}}) {
      for (const std::uint32_t phase : {period / 2, 0U}) {
        if (!isLate()) tryStart([&](Concrete::Store& s) { s.set(reg, 0, phase, true); });
      }
    }
    for (std::uint32_t bit = 0; bit < clockPeriods.size(); ++bit) {
      for (const std::uint32_t phase : {clockPeriods[bit] / 2U, 0U}) {
        if (!isLate()) tryStart([&](Concrete::Store& s) { s.set(Reg::ClockPhase, bit, phase, true); });
      }
    }
  }

  bool isShown(const std::vector<ReplayScan>& scans) const { return judge_.run(scans, initial()).shown; }
  static std::uint64_t highest(const PresetValue& input) { return Graph::maskOf(bits(input.operand.width)); }

  /// Collects what may have any value. False if there was no time to try it.
  bool findIdle() {
    const std::vector<ReplayScan> given = best_.scans;
    std::vector<ReplayScan> scans = best_.scans;
    for (std::size_t s = scans.size(); s-- > 0;) {
      for (std::size_t i = 0; i < scans[s].inputs.size(); ++i) {
        if (isLate()) return false;
        PresetValue& input = scans[s].inputs[i];
        const std::uint64_t old = input.value;
        input.value = old == 0 ? highest(input) : 0;
        const bool isIdle = isShown(scans);
        input.value = isIdle ? 0 : old;
        if (isIdle) idle_.push_back({s, i});
      }
    }
    for (int trial = 0; trial < schedule::minimisingTrials; ++trial) {
      if (isLate()) return false;
      std::vector<ReplayScan> tried = scans;
      for (const Input& input : idle_) {
        PresetValue& value = tried[input.scan].inputs[input.index];
        value.value = trial == 0 ? highest(value) : random_() & highest(value);
      }
      if (!isShown(tried) && !keepCulprits(scans, std::move(tried))) return false;
    }
    best_.scans = std::move(scans);
    return isShown(best_.scans);
  }

  /// Returns inputs of a failing trial to 0 until it shows the same; the one that turned it is not idle.
  bool keepCulprits(const std::vector<ReplayScan>& scans, std::vector<ReplayScan> tried) {
    for (std::size_t k = 0; k < idle_.size(); ++k) {
      if (isLate()) return false;
      const Input input = idle_[k];
      tried[input.scan].inputs[input.index].value = scans[input.scan].inputs[input.index].value;
      if (!isShown(tried)) continue;
      idle_.erase(idle_.begin() + static_cast<std::ptrdiff_t>(k));
      return true;
    }
    return false;
  }

  void store() {
    best_.matters.clear();
    for (const ReplayScan& scan : best_.scans) best_.matters.emplace_back(scan.inputs.size(), true);
    for (const Input& input : idle_) best_.matters[input.scan][input.index] = false;
    if (std::optional<Witness> cut = judge_.witness(best_.scans, best_.initial)) {
      cut->matters = std::move(best_.matters);
      cut->matters.resize(cut->scans.size());
      best_ = std::move(*cut);
    }
  }

  const Judge& judge_;
  Witness best_;
  const std::uint32_t plainMs_;
  const Clock::time_point end_;
  std::mt19937_64 random_;
  std::vector<Input> idle_;
};

}  // namespace

Witness minimised(const Judge& judge, Witness witness, std::uint32_t plainMs, double seconds, std::uint64_t seed) {
  return Minimiser(judge, std::move(witness), plainMs, seconds, seed).run();
}

Witness withoutIdleEvents(const Judge& judge, Witness witness, double seconds) {
  return Minimiser(judge, std::move(witness), 1, seconds, 1).runForEvents();
}

}  // namespace rungproof
