// All inputs on, all off; one on alone or on in every other scan, which brings what counts to its end; then random ones
// that stay for 1 to some thousand scans. Runs are sought on the fastest engine; what they show counts once the
// reference engine has repeated it.
#include "analysis/witness/guided_runs.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <random>
#include <span>

#include "analysis/encoding/scan_encoding.hpp"
#include "analysis/encoding/scan_inputs.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/witness/follower.hpp"
#include "analysis/witness/state_pool.hpp"
#include "engine/simulator.hpp"

namespace rungproof {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t longestQueue = 16;  ///< of all CPUs (001:5488)

/// What replay() gives where a script gives nothing.
struct GuidedOutside final : Outside {
  explicit GuidedOutside(bool ones) : areUnknownOnes(ones) {}
  std::uint64_t external(const ExternalSite& site, int) override {
    const bool isUnknown = site.kind == External::StackBottom || site.kind == External::LocalMemory ||
                           site.kind == External::UnknownStatus;
    return isUnknown && areUnknownOnes ? ~0ULL : quietExternal(site);
  }
  void report(Hazard, const Instruction*) override {}

  const bool areUnknownOnes;
};

/// What a program and its properties remember from scan to scan, without what the CPU counts by itself.
class Remembered {
 public:
  /// Whether it is as it was at the call before this one.
  bool isAsBefore(const Concrete::Store& state, std::vector<std::uint64_t> cells) {
    std::vector<std::uint8_t> memory;
    for (const Area area : {Area::Q, Area::V, Area::M, Area::S, Area::DB})
      memory.insert(memory.end(), state.area(area).begin(), state.area(area).end());
    for (std::size_t r = 0; r < static_cast<std::size_t>(Reg::count); ++r) {
      const Reg reg = static_cast<Reg>(r);
      if (Concrete::Store::isTerminal(reg) || std::ranges::find(clocks, reg) != clocks.end()) continue;
      const auto values = state.registers().subspan(state.indexOf(reg, 0), state.count(reg));
      cells.insert(cells.end(), values.begin(), values.end());
    }
    std::swap(cells, cells_);
    std::swap(memory, memory_);
    return cells == cells_ && memory == memory_;
  }

 private:
  static constexpr std::array clocks = {Reg::TimedElapsed, Reg::CyclicElapsed, Reg::PhaseTen,   Reg::PhaseHundred,
                                        Reg::PhaseSecond,  Reg::PhaseMinute,   Reg::ClockPhase, Reg::LastScan};
  std::vector<std::uint64_t> cells_;
  std::vector<std::uint8_t> memory_;
};

/// The scan that follows the one at `at`; their number: none.
std::size_t nextOf(const std::vector<ReplayScan>& scans, std::size_t at, bool comesAgain) {
  return comesAgain ? (at + 1) % scans.size() : at + 1;
}

class GuidedSearch {
 public:
  GuidedSearch(const Program& program, const EncodedScan& encoding, const std::vector<Property>& assumptions,
               const std::vector<const Property*>& goals, std::uint64_t seed, const GuidedLimits& limits)
      : program_(program),
        choices_(encoding.options().choices),
        assumptions_(assumptions),
        goals_(goals),
        random_(seed),
        lengthMs_(encoding.options().time.high),
        begin_(Clock::now()),
        limits_(limits),
        wanted_(goals.size() - limits.alsoWatched),
        found_(goals.size()) {
    for (const ScanInput& input : scanInputsOf(encoding)) inputs_.push_back({input.operand, 0});
    for (const auto& [event, routines] : attachmentsOf(encoding.plan())) events_.push_back(event);
    if (const Flow* main = encoding.plan().main(); main != nullptr && !main->steps.empty())
      first_ = {main->steps.front().instruction->id, 0};
  }

  std::vector<std::optional<GuidedRun>> run() {
    const std::uint64_t most =
        limits_.instructions / std::max<std::uint64_t>(program_.instructionCount(), schedule::leastInstructions);
    const auto goesOn = [&] { return !isDone() && used() < limits_.seconds; };
    for (int kind = 0; kind < schedule::plainRuns && goesOn(); ++kind)
      make(plain(kind == 0), most, schedule::plainShare * (kind + 1));
    std::uint64_t barren = 0;
    for (std::size_t i = 0; i < 2 * steadyInputs() && barren < most && goesOn(); ++i)
      barren += make(steady(i / 2, i % 2 == 0), most - barren, 3 * schedule::plainShare).barren;
    barren = 0;
    while (goesOn() && barren < most) {
      const Made made = make(random(), most, 1);
      barren = (made.hasShown ? 0 : barren) + made.barren + 1;
    }
    return std::move(found_);
  }

 private:
  double used() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  bool isDone() const {
    return std::ranges::all_of(std::span(found_).first(wanted_), [](const auto& f) { return f.has_value(); });
  }

  /// Scans from the first to the last, which are made once or, if `comesAgain`, over and over.
  struct Run {
    std::vector<ReplayScan> scans;
    bool comesAgain = false;
  };
  ReplayScan quietScan() const {
    ReplayScan scan;
    scan.lengthMs = lengthMs_;
    scan.inputs = inputs_;
    return scan;
  }
  Run plain(bool isOn) const {
    Run run{{quietScan()}, true};
    for (PresetValue& input : run.scans[0].inputs) input.value = isOn ? Graph::maskOf(bits(input.operand.width)) : 0;
    return run;
  }
  std::size_t steadyInputs() const {
    const auto count =
        std::ranges::count_if(inputs_, [](const PresetValue& i) { return i.operand.width == Width::Bit; });
    return std::min(static_cast<std::size_t>(count), schedule::steadyInputs);
  }
  /// The input on alone: in every other scan, or in all.
  Run steady(std::size_t input, bool alternates) const {
    Run run{{quietScan()}, true};
    for (PresetValue& value : run.scans[0].inputs) {
      if (value.operand.width == Width::Bit && input-- == 0) value.value = 1;
    }
    if (alternates) run.scans.push_back(quietScan());
    return run;
  }
  Run random() {
    Run run;
    ReplayScan scan = quietScan();
    for (int i = 0; i < schedule::guidedPhases; ++i) {
      for (PresetValue& input : scan.inputs) {
        if (i == 0 || random_() % 2 == 0) input.value = random_() & Graph::maskOf(bits(input.operand.width));
      }
      scan.repeats = 1 + static_cast<std::uint32_t>(random_() % (1ULL << (random_() % 12)));
      if (!events_.empty()) interrupt(scan);
      run.scans.push_back(scan);
    }
    return run;
  }

  struct Made {
    std::uint64_t barren;  ///< scans since the last one that showed a goal
    bool hasShown;
  };
  /// Ends after `most` scans in which nothing is shown, or when the search has lasted that share of its time.
  Made make(Run run, std::uint64_t most, double share) {
    const Sought sought = seek(run, most, share * limits_.seconds);
    return {sought.barren, sought.last && confirm(std::move(run), *sought.last)};
  }

  /// Interrupts at one place: none, a few, or more of one event at once than a queue holds.
  void interrupt(ReplayScan& scan) {
    scan.script.events.clear();
    const ScanPlace place = random_() % 2 == 0 ? ScanPlace{} : first_;
    const int one = events_[random_() % events_.size()];
    switch (random_() % 4) {
      case 0: return;
      case 1:
        for (const int event : events_) {
          if (random_() % 2 == 0) scan.script.events.push_back({place, event});
        }
        break;
      case 2: scan.script.events.assign(1 + random_() % 5, {place, one}); break;
      default:
        scan.script.events.assign(longestQueue + 1, {place, one, true});
        scan.script.events.back().isWithNext = false;
    }
    if (random_() % 2 == 0) scan.repeats = 1 + static_cast<std::uint32_t>(random_() % 3);
  }

  /// What is asked, followed along one run.
  class Course {
   public:
    explicit Course(const GuidedSearch& search) : search_(search), domain_(outside_), isShown_(search.goals_.size()) {
      for (const Property& assumption : search.assumptions_) assumptions_.emplace_back(assumption);
      for (const Property* goal : search.goals_) goals_.emplace_back(*goal);
    }

    /// After a scan; false: nothing that comes later counts. `show`: is told of the goals that it shows first.
    template <class Show>
    bool look(const Concrete::Store& state, const ReplayScan& scan, Show&& show) {
      const bool isFirst = count_++ == 0;
      if (!hasScanEnd(state)) return false;
      for (Follower& assumption : assumptions_) {
        if (!assumption.evaluate(domain_, state, scan, isFirst)) return false;
      }
      bool isOpen = false;
      for (std::size_t g = 0; g < goals_.size(); ++g) {
        if (search_.found_[g] || isShown_[g]) continue;
        isShown_[g] = goals_[g].evaluate(domain_, state, scan, isFirst);
        isOpen = isOpen || (!isShown_[g] && g < search_.wanted_);
        if (isShown_[g]) show(g);
      }
      return isOpen;
    }
    std::uint64_t count() const { return count_; }
    std::vector<std::uint64_t> cells() const {
      std::vector<std::uint64_t> all;
      for (const std::vector<Follower>* followers : {&assumptions_, &goals_}) {
        for (const Follower& follower : *followers)
          all.insert(all.end(), follower.cells().begin(), follower.cells().end());
      }
      return all;
    }

   private:
    const GuidedSearch& search_;
    StillOutside outside_;
    Concrete domain_;
    std::vector<Follower> assumptions_, goals_;
    std::vector<bool> isShown_;
    std::uint64_t count_ = 0;
  };

  struct Sought {
    std::uint64_t barren;               ///< scans since the last one that showed a goal
    std::optional<std::uint64_t> last;  ///< the number of that scan, from 1
  };
  /// On the fastest engine.
  Sought seek(const Run& run, std::uint64_t most, double seconds) const {
    GuidedOutside outside(choices_.is(Choice::UnknownBits, "one"));
    Simulator simulator(program_, stillOptions(choices_), &outside);
    simulator.readUnknownAsZero(!outside.areUnknownOnes);
    simulator.expectFreeZero();
    Course course(*this);
    std::uint64_t shown = 0;
    Remembered remembered;
    const auto isAtRest = [&] {
      return run.comesAgain && course.count() % schedule::scansUntilRest == 0 &&
             remembered.isAsBefore(simulator.store(), course.cells());
    };
    const auto goesOn = [&] {
      const std::uint64_t count = course.count();
      return count - shown < most && (count % schedule::guidedScansBetweenLooks != 0 || used() < seconds) &&
             simulator.isRunning() && !isAtRest();
    };
    for (std::size_t at = 0; at < run.scans.size(); at = nextOf(run.scans, at, run.comesAgain)) {
      const ReplayScan& scan = run.scans[at];
      ScanScript script = scan.script;
      script.needsCauses = true;
      for (const PresetValue& input : scan.inputs) simulator.write(input.operand, input.value);
      for (std::uint32_t round = 0; round < scan.repeats; ++round) {
        simulator.scan({.lengthUs = scan.lengthMs * 1000, .script = &script});
        const bool isOpen = course.look(simulator.store(), scan, [&](std::size_t) { shown = course.count(); });
        if (!isOpen || !goesOn()) return {course.count() - shown, shown == 0 ? std::nullopt : std::optional(shown)};
      }
    }
    return {course.count() - shown, shown == 0 ? std::nullopt : std::optional(shown)};
  }

  /// What the reference engine shows in the first `last` scans; false: nothing.
  bool confirm(Run run, std::uint64_t last) {
    const auto scans = std::make_shared<const std::vector<ReplayScan>>(std::move(run.scans));
    ReplayRun replayed(program_, choices_);
    Course course(*this);
    bool hasShown = false;
    std::size_t at = 0;
    for (bool goesOn = true; goesOn && at < scans->size(); at = nextOf(*scans, at, run.comesAgain)) {
      const ReplayScan& scan = (*scans)[at];
      replayed.load(scan);
      for (std::uint32_t round = 0; round < scan.repeats && goesOn; ++round) {
        const bool isOpen = course.look(replayed.scan(), scan, [&](std::size_t goal) {
          found_[goal] = {scans, run.comesAgain, course.count()};
          hasShown = true;
        });
        goesOn = isOpen && course.count() < last && replayed.isRunning();
      }
    }
    return hasShown;
  }

  const Program& program_;
  const Choices& choices_;
  const std::vector<Property>& assumptions_;
  const std::vector<const Property*>& goals_;
  std::mt19937_64 random_;
  const std::uint32_t lengthMs_;
  const Clock::time_point begin_;
  const GuidedLimits limits_;
  const std::size_t wanted_;  ///< the first goals
  std::vector<PresetValue> inputs_;
  std::vector<int> events_;  ///< that the program attaches
  ScanPlace first_;          ///< in front of the program
  std::vector<std::optional<GuidedRun>> found_;
};

}  // namespace

Witness GuidedRun::witness() const {
  Witness witness;
  witness.scanCount = count;
  const bool isOneScan = comesAgain && scans->size() == 1;
  if (comesAgain && !isOneScan) witness.scans.reserve(count);
  std::uint64_t left = count;
  for (std::size_t at = 0; left > 0; at = nextOf(*scans, at, comesAgain)) {
    ReplayScan& scan = witness.scans.emplace_back((*scans)[at]);
    scan.repeats = static_cast<std::uint32_t>(isOneScan ? left : std::min<std::uint64_t>(scan.repeats, left));
    left -= scan.repeats;
    witness.milliseconds += static_cast<std::uint64_t>(scan.repeats) * scan.lengthMs;
  }
  return witness;
}

std::vector<std::optional<GuidedRun>> guidedRuns(const Program& program, const EncodedScan& encoding,
                                                 const std::vector<Property>& assumptions,
                                                 const std::vector<const Property*>& goals, std::uint64_t seed,
                                                 const GuidedLimits& limits) {
  return GuidedSearch(program, encoding, assumptions, goals, seed, limits).run();
}

}  // namespace rungproof
