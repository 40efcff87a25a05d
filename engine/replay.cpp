// The engine asks the script for what is not in its memory; scans that are alike ask the same one.
#include "engine/replay.hpp"

#include <algorithm>
#include <tuple>

#include "engine/simulator.hpp"

namespace rungproof {

/// Hands out the external values of one scan in the order in which they are asked for.
class ReplayRun::Script final : public Outside {
 public:
  explicit Script(const Choices& choices) : unknown_(choices.is(Choice::UnknownBits, "one") ? ~0ULL : 0) {}

  /// Where reads of analog inputs that are not given look.
  void setState(const Concrete::Store& state) { state_ = &state; }

  /// The values of the scans to come, until others are loaded. Unknown bits that are all 0 need not be given.
  void load(const std::vector<ExternalValue>& values) {
    finish();
    sites_.clear();
    next_ = 0;
    givesUnknownBits_ = unknown_ != 0 || std::ranges::any_of(values, [](const ExternalValue& value) {
                          return isOpen(value.site.kind) && value.value != 0;
                        });
    const auto isGiven = [&](const ExternalValue& value) { return givesUnknownBits_ || !isOpen(value.site.kind); };
    for (const ExternalValue& value : values) {
      if (isGiven(value)) sites_.push_back({key(value.site), {}, 0});
    }
    std::sort(sites_.begin(), sites_.end(), [](const Site& a, const Site& b) { return a.key < b.key; });
    sites_.erase(std::unique(sites_.begin(), sites_.end(), [](const Site& a, const Site& b) { return a.key == b.key; }),
                 sites_.end());
    for (const ExternalValue& value : values) {
      if (isGiven(value)) at(key(value.site))->values.push_back(value.value);
    }
  }
  /// Each scan starts with all of them.
  void begin() {
    finish();
    for (Site& site : sites_) site.next = 0;
    isBegun_ = true;
  }
  /// Whether unknown bits have other values than 0 in the scans to come.
  bool givesUnknownBits() const { return givesUnknownBits_; }
  std::uint64_t external(const ExternalSite& site, int width) override {
    const Key wanted = key(site);
    const bool isNext =
        (next_ == 0 || sites_[next_ - 1].key < wanted) && (next_ == sites_.size() || sites_[next_].key >= wanted);
    if (!isNext) next_ = static_cast<std::size_t>(at(wanted) - sites_.begin());
    if (next_ < sites_.size() && sites_[next_].key == wanted) {
      Site& found = sites_[next_++];
      if (found.next < found.values.size()) return found.values[found.next++];
      // A loop that the prover follows for so many rounds reads an input that stays as it is.
      if (site.kind == External::ImmediateInput && !found.values.empty()) return found.values.back();
    }
    if (site.kind == External::AnalogInput) return state_->load(Area::AI, site.index * 8, width);
    return isUnknown(site.kind) ? unknown_ : quietExternal(site);
  }
  void report(Hazard, const Instruction*) override {}
  std::size_t unused() {
    finish();
    return unused_;
  }

 private:
  static bool isUnknown(External kind) {
    return kind == External::StackBottom || kind == External::LocalMemory || kind == External::UnknownStatus;
  }
  /// Where the engine reads 0 without a question as long as nothing else is given.
  static bool isOpen(External kind) { return isUnknown(kind) || kind == External::UnknownResult; }
  using Key = std::tuple<External, std::uint32_t, std::uint32_t>;
  static Key key(const ExternalSite& site) { return {site.kind, site.index, site.instruction}; }
  struct Site {
    Key key;
    std::vector<std::uint64_t> values;  ///< in the order in which they are asked for
    std::size_t next;
  };
  std::vector<Site>::iterator at(const Key& key) {
    return std::lower_bound(sites_.begin(), sites_.end(), key,
                            [](const Site& site, const Key& k) { return site.key < k; });
  }
  /// Counts what the scan left.
  void finish() {
    for (const Site& site : sites_) unused_ += isBegun_ ? site.values.size() - site.next : 0;
    isBegun_ = false;
  }

  const Concrete::Store* state_ = nullptr;
  const std::uint64_t unknown_;
  std::vector<Site> sites_;  ///< by key
  std::size_t next_ = 0;     ///< where a scan looks next, mostly: it asks in this order
  bool isBegun_ = false;
  bool givesUnknownBits_ = false;
  std::size_t unused_ = 0;
};

std::uint64_t quietExternal(const ExternalSite& site) {
  return site.kind == External::ClockByte ? RealTimeClock{}.byteAt(site.index, 0) : 0;
}

struct ReplayRun::Parts {
  Script script;
  Simulator simulator;
  ScanScript scanScript{};
  std::uint32_t lengthUs = 0;
  bool isWatched;

  Parts(const Program& program, const Choices& choices, bool hasWatcher)
      : script(choices), simulator(program, optionsOf(choices), &script), isWatched(hasWatcher) {
    script.setState(simulator.store());
  }
  static SimulatorOptions optionsOf(const Choices& choices) {
    SimulatorOptions options;
    options.choices = choices;
    options.engine = EngineKind::Reference;  // what it repeats shall count
    return options;
  }
};

ReplayRun::ReplayRun(const Program& program, const Choices& choices, const Concrete::Store* initial,
                     InstructionObserver* watcher)
    : parts_(std::make_unique<Parts>(program, choices, watcher != nullptr)) {
  if (initial != nullptr) parts_->simulator.setStore(*initial);
  if (watcher != nullptr) parts_->simulator.observe(watcher);
}

ReplayRun::~ReplayRun() = default;

void ReplayRun::load(const ReplayScan& scan) {
  Parts& parts = *parts_;
  parts.scanScript = scan.script;
  parts.scanScript.needsCauses = true;
  parts.lengthUs = scan.lengthMs * 1000;
  for (const PresetValue& input : scan.inputs) parts.simulator.write(input.operand, input.value);
  parts.script.load(scan.externals);
  parts.simulator.readUnknownAsZero(!parts.isWatched && !parts.script.givesUnknownBits());
}

const Concrete::Store& ReplayRun::scan() {
  parts_->script.begin();
  parts_->simulator.scan({.lengthUs = parts_->lengthUs, .script = &parts_->scanScript});
  return parts_->simulator.store();
}

bool ReplayRun::isRunning() const { return parts_->simulator.isRunning(); }
const std::vector<RunTimeError>& ReplayRun::errors() const { return parts_->simulator.errors().list(); }
std::size_t ReplayRun::unusedExternals() const { return parts_->script.unused(); }

ReplayResult replay(const Program& program, const Choices& choices, const std::vector<ReplayScan>& scans,
                    const Concrete::Store* initial, const ReplayObserver& observer, InstructionObserver* watcher) {
  ReplayRun run(program, choices, initial, watcher);
  ReplayResult result;
  bool goesOn = true;
  for (std::size_t i = 0; i < scans.size() && goesOn; ++i) {
    run.load(scans[i]);
    for (std::uint32_t round = 0; round < scans[i].repeats && goesOn; ++round) {
      const Concrete::Store& state = run.scan();
      if (observer)
        goesOn = observer(state, i);
      else
        result.states.push_back(state);
      goesOn = goesOn && run.isRunning();
    }
  }
  result.errors = run.errors();
  result.unusedExternals = run.unusedExternals();
  return result;
}

}  // namespace rungproof
