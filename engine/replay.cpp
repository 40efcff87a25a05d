// Runs a script of scans and keeps the state after each.
#include "engine/replay.hpp"

#include <deque>
#include <map>
#include <tuple>

#include "engine/simulator.hpp"

namespace rungproof {

namespace {

/// Hands out the external values of one scan in the order in which they are asked for.
class Script final : public Outside {
 public:
  explicit Script(const Choices& choices) : choices_(choices) {}

  void load(const std::vector<ExternalValue>& values) {
    unused_ += waiting();
    values_.clear();
    for (const ExternalValue& value : values) values_[key(value.site)].push_back(value.value);
  }
  std::uint64_t external(const ExternalSite& site, int) override {
    const auto found = values_.find(key(site));
    if (found != values_.end() && !found->second.empty()) {
      const std::uint64_t value = found->second.front();
      found->second.pop_front();
      return value;
    }
    const bool isUnknown = site.kind == External::StackBottom || site.kind == External::LocalMemory || site.kind == External::UnknownStatus;
    return isUnknown && choices_.is(Choice::UnknownBits, "one") ? ~0ULL : 0;
  }
  void report(Hazard, const Instruction*) override {}
  std::size_t unused() const { return unused_ + waiting(); }

 private:
  using Key = std::tuple<External, std::uint32_t, std::uint32_t>;
  static Key key(const ExternalSite& site) { return {site.kind, site.index, site.instruction}; }
  std::size_t waiting() const {
    std::size_t count = 0;
    for (const auto& [site, queue] : values_) count += queue.size();
    return count;
  }

  const Choices& choices_;
  std::map<Key, std::deque<std::uint64_t>> values_;
  std::size_t unused_ = 0;
};

}  // namespace

ReplayResult replay(const Program& program, const Choices& choices, const std::vector<ReplayScan>& scans, const Concrete::Store* initial,
                    const ReplayObserver& observer, InstructionObserver* watcher) {
  Script script(choices);
  SimulatorOptions options;
  options.choices = choices;
  Simulator simulator(program, options, &script);
  if (initial != nullptr) simulator.setStore(*initial);
  if (watcher != nullptr) simulator.observe(watcher);
  ReplayResult result;
  bool goesOn = true;
  for (std::size_t i = 0; i < scans.size() && goesOn; ++i) {
    const ReplayScan& scan = scans[i];
    for (const PresetValue& input : scan.inputs) simulator.write(input.operand, input.value);
    for (std::uint32_t round = 0; round < scan.repeats && goesOn; ++round) {
      script.load(scan.externals);
      simulator.scan({.lengthUs = scan.lengthMs * 1000, .script = &scan.script});
      if (observer) goesOn = observer(simulator.store(), i);
      else result.states.push_back(simulator.store());
      goesOn = goesOn && simulator.isRunning();
    }
  }
  result.errors = simulator.errors().list();
  result.unusedExternals = script.unused();
  return result;
}

}  // namespace rungproof
