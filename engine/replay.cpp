// Runs a script of scans and keeps the state after each.
#include "engine/replay.hpp"

#include <algorithm>
#include <tuple>

#include "engine/simulator.hpp"

namespace rungproof {

namespace {

/// Hands out the external values of one scan in the order in which they are asked for.
class Script final : public Outside {
 public:
  explicit Script(const Choices& choices) : unknown_(choices.is(Choice::UnknownBits, "one") ? ~0ULL : 0) {}

  /// The values of the scans to come, until others are loaded.
  void load(const std::vector<ExternalValue>& values) {
    finish();
    sites_.clear();
    next_ = 0;
    for (const ExternalValue& value : values) sites_.push_back({key(value.site), {}, 0});
    std::sort(sites_.begin(), sites_.end(), [](const Site& a, const Site& b) { return a.key < b.key; });
    sites_.erase(std::unique(sites_.begin(), sites_.end(), [](const Site& a, const Site& b) { return a.key == b.key; }),
                 sites_.end());
    for (const ExternalValue& value : values) at(key(value.site))->values.push_back(value.value);
  }
  /// Each scan starts with all of them.
  void begin() {
    finish();
    for (Site& site : sites_) site.next = 0;
    isBegun_ = true;
  }
  /// Whether unknown bits have other values than 0 in the scans to come.
  bool givesUnknownBits() const {
    return unknown_ != 0 || std::ranges::any_of(sites_, [](const Site& site) {
             return isUnknown(std::get<External>(site.key)) || std::get<External>(site.key) == External::UnknownResult;
           });
  }
  std::uint64_t external(const ExternalSite& site, int) override {
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

  const std::uint64_t unknown_;
  std::vector<Site> sites_;  ///< by key
  std::size_t next_ = 0;     ///< where a scan looks next, mostly: it asks in this order
  bool isBegun_ = false;
  std::size_t unused_ = 0;
};

}  // namespace

std::uint64_t quietExternal(const ExternalSite& site) {
  return site.kind == External::ClockByte ? RealTimeClock{}.byteAt(site.index, 0) : 0;
}

ReplayResult replay(const Program& program, const Choices& choices, const std::vector<ReplayScan>& scans,
                    const Concrete::Store* initial, const ReplayObserver& observer, InstructionObserver* watcher) {
  Script script(choices);
  SimulatorOptions options;
  options.choices = choices;
  options.engine = EngineKind::Reference;  // what it repeats shall count
  Simulator simulator(program, options, &script);
  if (initial != nullptr) simulator.setStore(*initial);
  if (watcher != nullptr) simulator.observe(watcher);
  ReplayResult result;
  bool goesOn = true;
  ScanScript scanScript;
  for (std::size_t i = 0; i < scans.size() && goesOn; ++i) {
    const ReplayScan& scan = scans[i];
    scanScript = scan.script;
    scanScript.needsCauses = true;
    for (const PresetValue& input : scan.inputs) simulator.write(input.operand, input.value);
    script.load(scan.externals);
    simulator.readUnknownAsZero(watcher == nullptr && !script.givesUnknownBits());
    for (std::uint32_t round = 0; round < scan.repeats && goesOn; ++round) {
      script.begin();
      simulator.scan({.lengthUs = scan.lengthMs * 1000, .script = &scanScript});
      if (observer)
        goesOn = observer(simulator.store(), i);
      else
        result.states.push_back(simulator.store());
      goesOn = goesOn && simulator.isRunning();
    }
  }
  result.errors = simulator.errors().list();
  result.unusedExternals = script.unused();
  return result;
}

}  // namespace rungproof
