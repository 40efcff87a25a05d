// All inputs on, all off, then random ones that stay for 1 to some thousand scans.
#include "analysis/witness/guided_runs.hpp"

#include <algorithm>
#include <chrono>
#include <random>

#include "analysis/encoding/scan_encoding.hpp"
#include "analysis/encoding/scan_inputs.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/witness/follower.hpp"

namespace rungproof {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t endless = 1U << 30;
constexpr std::size_t longestQueue = 16;  ///< of all CPUs (001:5488)

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
        found_(goals.size()) {
    for (const ScanInput& input : scanInputsOf(encoding)) inputs_.push_back({input.operand, 0});
    for (const auto& [event, routines] : attachmentsOf(encoding.plan())) events_.push_back(event);
    if (const Flow* main = encoding.plan().main(); main != nullptr && !main->steps.empty())
      first_ = {main->steps.front().instruction->id, 0};
  }

  std::vector<std::optional<Witness>> run() {
    const std::uint64_t most =
        limits_.instructions / std::max<std::uint64_t>(program_.instructionCount(), schedule::leastInstructions);
    std::uint64_t barren = 0;  // random scans
    for (int kind = 0; !isDone() && barren < most && used() < limits_.seconds; ++kind) {
      const double share = kind < schedule::plainRuns ? schedule::plainShare * (kind + 1) : 1;
      const auto [made, hasShown] = follow(phases(kind), most, share * limits_.seconds);
      if (kind >= schedule::plainRuns) barren = (hasShown ? 0 : barren) + made + 1;
    }
    return std::move(found_);
  }

 private:
  double used() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  bool isDone() const {
    return std::all_of(found_.begin(), found_.end(), [](const auto& f) { return f.has_value(); });
  }

  std::vector<ReplayScan> phases(int kind) {
    std::vector<ReplayScan> scans;
    ReplayScan scan;
    scan.lengthMs = lengthMs_;
    scan.inputs = inputs_;
    if (kind < schedule::plainRuns) {
      for (PresetValue& input : scan.inputs) input.value = kind == 0 ? Graph::maskOf(bits(input.operand.width)) : 0;
      scan.repeats = endless;
      return {scan};
    }
    for (int i = 0; i < schedule::guidedPhases; ++i) {
      for (PresetValue& input : scan.inputs) {
        if (i == 0 || random_() % 2 == 0) input.value = random_() & Graph::maskOf(bits(input.operand.width));
      }
      scan.repeats = 1 + static_cast<std::uint32_t>(random_() % (1ULL << (random_() % 12)));
      if (!events_.empty()) interrupt(scan);
      scans.push_back(scan);
    }
    return scans;
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

  struct Course {
    std::uint64_t barren;  ///< scans since the last one that showed a goal
    bool hasShown;
  };
  /// Ends after `most` scans in which nothing is shown, or when the search has lasted `seconds`.
  Course follow(const std::vector<ReplayScan>& scans, std::uint64_t most, double seconds) {
    struct NoOutside final : Outside {
      std::uint64_t external(const ExternalSite&, int) override { return 0; }
      void report(Hazard, const Instruction*) override {}
    } outside;
    Concrete domain(outside);
    std::vector<Follower> assumptions, goals;
    for (const Property& assumption : assumptions_) assumptions.emplace_back(assumption);
    for (const Property* goal : goals_) goals.emplace_back(*goal);
    std::vector<std::optional<std::pair<std::size_t, std::uint32_t>>> hits(
        goals_.size());  // scan and round that showed it
    std::uint64_t count = 0, shown = 0;
    std::size_t step = ~std::size_t{0};
    std::uint32_t round = 0;
    replay(program_, choices_, scans, nullptr, [&](const Concrete::Store& state, std::size_t at) {
      round = at == step ? round + 1 : 0;
      step = at;
      const bool isFirst = count++ == 0;
      if (!hasScanEnd(state)) return false;
      for (Follower& assumption : assumptions) {
        if (!assumption.evaluate(domain, state, scans[at], isFirst)) return false;
      }
      bool isOpen = false;
      for (std::size_t g = 0; g < goals.size(); ++g) {
        if (found_[g] || hits[g]) continue;
        if (!goals[g].evaluate(domain, state, scans[at], isFirst)) {
          isOpen = true;
          continue;
        }
        hits[g] = {at, round};
        shown = count;
      }
      return isOpen && count - shown < most && (count % schedule::guidedScansBetweenLooks != 0 || used() < seconds);
    });
    for (std::size_t g = 0; g < goals_.size(); ++g) {
      if (!hits[g]) continue;
      const auto [at, rounds] = *hits[g];
      std::vector<ReplayScan> way(scans.begin(), scans.begin() + static_cast<std::ptrdiff_t>(at) + 1);
      way.back().repeats = rounds + 1;
      Witness& witness = found_[g].emplace();
      for (const ReplayScan& scan : way) {
        witness.scanCount += scan.repeats;
        witness.milliseconds += static_cast<std::uint64_t>(scan.repeats) * scan.lengthMs;
      }
      witness.scans = std::move(way);
    }
    return {count - shown, shown != 0};
  }

  const Program& program_;
  const Choices& choices_;
  const std::vector<Property>& assumptions_;
  const std::vector<const Property*>& goals_;
  std::mt19937_64 random_;
  const std::uint32_t lengthMs_;
  const Clock::time_point begin_;
  const GuidedLimits limits_;
  std::vector<PresetValue> inputs_;
  std::vector<int> events_;  ///< that the program attaches
  ScanPlace first_;          ///< in front of the program
  std::vector<std::optional<Witness>> found_;
};

}  // namespace

std::vector<std::optional<Witness>> guidedRuns(const Program& program, const EncodedScan& encoding,
                                               const std::vector<Property>& assumptions,
                                               const std::vector<const Property*>& goals, std::uint64_t seed,
                                               const GuidedLimits& limits) {
  return GuidedSearch(program, encoding, assumptions, goals, seed, limits).run();
}

}  // namespace rungproof
