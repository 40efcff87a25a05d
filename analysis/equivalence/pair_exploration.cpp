// Two programs for the pool of an exploration.
#include "analysis/equivalence/pair_exploration.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "analysis/equivalence/shorter_run.hpp"
#include "analysis/witness/follower.hpp"
#include "analysis/witness/state_pool.hpp"
#include "engine/trace.hpp"

namespace rungproof {

namespace {

constexpr std::size_t oldIndex = 0, newIndex = 1;
constexpr std::uint32_t heldScans = 1U << 16;  ///< of a run in which no input changes
constexpr int walkedSteps = 400;               ///< of a random walk
constexpr std::chrono::milliseconds shorteningTime{200};

/// An input of the pair, and what it is in either program.
struct PairedInput {
  int width = 1;
  std::array<std::vector<ScanInput>, 2> operands;
};

/// The inputs of both programs, those that stand for each other as one. A terminal is given to both, whether or not
/// they name it: ranges and pointers reach it too.
class InputPairing {
 public:
  InputPairing(const RunSpace& before, const RunSpace& after, const AddressPairs& pairs) : pairs_(pairs) {
    for (const RunSpace::Input& input : before.inputs) addOld(input);
    for (const RunSpace::Input& input : after.inputs) addNew(input);
    for (const auto& [key, bit] : known_) {
      const std::optional<Address> there = pairs.after({key.first, key.second});
      if (!isTerminal(key.first) && there && pairs.names(*there) && !bit.isPaired) isWhole_ = false;
    }
  }
  /// False if the map pairs an input with what is none.
  bool isWhole() const { return isWhole_; }
  const std::vector<PairedInput>& inputs() const { return inputs_; }

 private:
  struct Bit {
    std::size_t input;
    int shift;
    bool isPaired = false;
  };
  using Key = std::pair<Area, std::uint32_t>;
  static Key keyOf(const Address& address) { return {address.area, address.index}; }
  static bool isTerminal(Area area) { return isInputArea(area) || area == Area::HC; }
  /// Bits of the operand's value from the lowest one; a number as a whole.
  static Address bitAt(const Operand& operand, int i) {
    if (isWholeValue(operand.area)) return addressOf(operand);
    const auto width = static_cast<std::uint32_t>(bits(operand.width));
    return bitOf(memoryPlace(operand.area, operand.offset, operand.width, operand.bit),
                 width - 1 - static_cast<std::uint32_t>(i));
  }
  static int countOf(const Operand& operand) { return isWholeValue(operand.area) ? 1 : bits(operand.width); }
  /// One bit of an input, or a number as wide as `like`.
  static ScanInput partAt(const Address& address, const Operand& like, int shift) {
    const bool isNumber = isWholeValue(address.area);
    const Area area = address.area == Area::AI ? like.area : address.area;  // AI or PI
    return {isNumber ? direct(area, like.width, address.index) : operandAt(address), noNode, shift};
  }

  void addOld(const RunSpace::Input& input) {
    PairedInput& added = inputs_.emplace_back();
    added.width = input.width;
    added.operands[oldIndex] = input.operands;
    for (const ScanInput& part : input.operands) {
      for (int i = 0; i < countOf(part.operand); ++i) {
        const Address before = bitAt(part.operand, i);
        known_[keyOf(before)] = {inputs_.size() - 1, part.shift + i};
        const std::optional<Address> after = pairs_.after(before);
        if (!isTerminal(before.area) || !after) continue;
        if (!isTerminal(after->area) || isWholeValue(before.area) != isWholeValue(after->area)) isWhole_ = false;
        if (isWhole_) added.operands[newIndex].push_back(partAt(*after, part.operand, part.shift + i));
      }
    }
  }
  void addNew(const RunSpace::Input& input) {
    std::optional<std::size_t> own;  // an input for what OLD does not have
    for (const ScanInput& part : input.operands) {
      for (int i = 0; i < countOf(part.operand); ++i) {
        const Address after = bitAt(part.operand, i);
        const std::optional<Address> before = pairs_.before(after);
        const auto found = before ? known_.find(keyOf(*before)) : known_.end();
        if (found != known_.end()) {
          found->second.isPaired = true;
          if (!isTerminal(before->area))
            inputs_[found->second.input].operands[newIndex].push_back(partAt(after, part.operand, found->second.shift));
          continue;
        }
        const bool isShared = before && isTerminal(before->area) && isTerminal(after.area) &&
                              isWholeValue(before->area) == isWholeValue(after.area);
        if (pairs_.names(after) && !isShared) isWhole_ = false;
        if (!own) {
          own = inputs_.size();
          inputs_.emplace_back().width = input.width;
        }
        inputs_[*own].operands[newIndex].push_back(partAt(after, part.operand, part.shift + i));
        if (isShared && isWhole_)
          inputs_[*own].operands[oldIndex].push_back(partAt(*before, part.operand, part.shift + i));
      }
    }
  }

  const AddressPairs& pairs_;
  std::vector<PairedInput> inputs_;
  std::map<Key, Bit> known_;  ///< by addresses of OLD
  bool isWhole_ = true;
};

std::vector<Follower> assumptionsOf(const PropertySet& set) {
  std::vector<Follower> followers;
  for (const Property& property : set.properties) {
    if (!property.isGoal()) followers.emplace_back(property);
  }
  return followers;
}

/// Both programs, run with the same inputs in steps of one scan.
class ExploredPair {
 public:
  struct Snapshot {
    std::array<Concrete::Store, 2> stores;
    std::array<std::vector<Follower>, 2> assumptions;
    OutputWatch watch;
  };

  ExploredPair(const Side& before, const Side& after, const BothRuns& runs, std::vector<PairedInput> inputs)
      : runs_(runs),
        inputs_(std::move(inputs)),
        domain_(outside_),
        simulators_{Simulator(*before.program, stillOptions(runs.options.prover.choices), &outside_),
                    Simulator(*after.program, stillOptions(runs.options.prover.choices), &outside_)},
        assumptions_{assumptionsOf(before.set), assumptionsOf(after.set)},
        watch_(runs) {}

  Snapshot snapshot() const {
    return {{simulators_[oldIndex].store(), simulators_[newIndex].store()}, assumptions_, watch_};
  }
  void restore(const Snapshot& from) {
    for (const std::size_t i : {oldIndex, newIndex}) {
      simulators_[i].setStore(from.stores[i]);
      assumptions_[i] = std::vector<Follower>(from.assumptions[i]);
    }
    watch_ = from.watch;
    hasShown_ = false;
  }
  const Concrete::Store& store(std::size_t program) const { return simulators_[program].store(); }

  void begin(const RunStep& step) {
    for (const std::size_t i : {oldIndex, newIndex}) {
      scans_[i] = scanOf(step, i);
      for (const PresetValue& input : scans_[i].inputs) simulators_[i].write(input.operand, input.value);
    }
  }
  Went scan(bool isFirst) {
    bool goesOn = true;
    for (const std::size_t i : {oldIndex, newIndex}) {
      Simulator& simulator = simulators_[i];
      simulator.scan({.lengthUs = scans_[i].lengthMs * 1000, .script = &scans_[i].script});
      goesOn = goesOn && simulator.isRunning() && hasScanEnd(simulator.store());
      for (Follower& assumption : assumptions_[i]) {
        const bool isKept =
            !hasScanEnd(simulator.store()) || assumption.evaluate(domain_, simulator.store(), scans_[i], isFirst);
        if (!isKept) return Went::Broken;
      }
    }
    const auto ends = [&](std::size_t i) { return runs_.outputsOf(simulators_[i].store(), i == oldIndex); };
    if (watch_.next(ends(oldIndex), ends(newIndex), scans_[newIndex].lengthMs)) hasShown_ = true;
    return goesOn ? Went::On : Went::Ended;
  }
  bool hasShown() const { return hasShown_; }
  void keepShown(const std::vector<RunStep>& way) {
    hasShown_ = false;
    EquivalenceRun run;
    for (const RunStep& step : way) {
      run.before.push_back(scanOf(step, oldIndex));
      run.after.push_back(scanOf(step, newIndex));
    }
    auto judged = runs_.judged(std::move(run));
    if (judged && (!found_ || judged->scan < found_->scan)) found_ = std::move(judged);
  }
  const std::optional<EquivalenceRun>& found() const { return found_; }

 private:
  ReplayScan scanOf(const RunStep& step, std::size_t program) const {
    ReplayScan scan;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      for (const ScanInput& input : inputs_[i].operands[program])
        scan.inputs.push_back({input.operand, input.valueIn(step.inputs[i])});
    }
    scan.lengthMs = step.lengthMs;
    scan.repeats = step.repeats;
    return scan;
  }

  const BothRuns& runs_;
  const std::vector<PairedInput> inputs_;
  StillOutside outside_;
  Concrete domain_;
  std::array<Simulator, 2> simulators_;
  std::array<std::vector<Follower>, 2> assumptions_;
  OutputWatch watch_;
  std::array<ReplayScan, 2> scans_;
  bool hasShown_ = false;
  std::optional<EquivalenceRun> found_;
};

/// Walks from power-up: in each of them every input stays off, stays on, or changes now and then.
class RandomWalks {
 public:
  RandomWalks(ExploredPair& pair, const TimeRange& range, const std::vector<int>& widths,
              const PoolConstants& constants, std::uint64_t seed)
      : pair_(pair),
        range_(range),
        widths_(widths),
        constants_(constants.values().begin(), constants.values().end()),
        random_(seed),
        start_(pair.snapshot()) {}

  /// Ends with the first difference.
  template <class IsOver>
  void walk(const IsOver& isOver) {
    choose();
    pair_.restore(start_);
    std::vector<RunStep> way;
    for (int k = 0; k < walkedSteps && !isOver(); ++k) {
      way.push_back(nextStep(k == 0));
      pair_.begin(way.back());
      const std::uint32_t most = random_() % 32 == 0 ? 256 : 1 + static_cast<std::uint32_t>(random_() % 3);
      for (std::uint32_t& n = way.back().repeats; n < most;) {
        const Went went = pair_.scan(k == 0 && n == 0);
        if (went == Went::Broken) return;
        ++n;
        if (pair_.hasShown()) return pair_.keepShown(way);
        if (went == Went::Ended) return;
      }
    }
  }

 private:
  enum class Course : std::uint8_t { Off, On, Changing };

  void choose() {
    courses_.clear();
    values_.assign(widths_.size(), 0);
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      courses_.push_back(static_cast<Course>(random_() % 3));
      if (courses_[i] == Course::On) values_[i] = widths_[i] == 1 ? 1 : anyWord();
    }
    isSlow_ = random_() % 2 == 0;
  }
  std::uint64_t anyWord() { return random_() % 2 == 0 ? random_() : constants_[random_() % constants_.size()]; }
  RunStep nextStep(bool isFirst) {
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      const bool changes = courses_[i] == Course::Changing && !isFirst && random_() % 2 == 0;
      if (changes) values_[i] = widths_[i] == 1 ? values_[i] ^ 1U : anyWord();
    }
    const std::uint32_t length =
        isSlow_ ? range_.high : range_.low + static_cast<std::uint32_t>(random_() % (range_.high - range_.low + 1));
    return {RunStep::none, 0, length, values_};
  }

  ExploredPair& pair_;
  const TimeRange range_;
  const std::vector<int>& widths_;
  const std::vector<std::uint64_t> constants_;
  std::mt19937_64 random_;
  const ExploredPair::Snapshot start_;
  std::vector<Course> courses_;
  std::vector<std::uint64_t> values_;
  bool isSlow_ = true;
};

}  // namespace

std::vector<ObservedBit> namedOutputs(const Program& before, const Program& after, const EquivalenceOptions& options) {
  std::vector<ObservedBit> outputs;
  Operands operands = options.observed;
  const auto isOutput = [](const TraceSignal& signal) { return isOutputArea(signal.operand.area); };
  const auto add = [&](const std::optional<Address>& before, const std::optional<Address>& after) {
    const ComparedRange range = before ? options.pairs.comparedFrom(*before) : options.pairs.comparedAlone(*after);
    const std::optional<Address> old = before ? std::optional(range.first) : std::nullopt;
    const std::optional<Address> now = before ? options.pairs.after(range.first) : std::optional(range.first);
    const auto isSame = [&](const ObservedBit& bit) { return bit.before == old && bit.after == now; };
    if (std::ranges::none_of(outputs, isSame))
      outputs.push_back({nameOfBit(range.first), old, now, noNode, {}, range.bits});
  };
  const auto eachBit = [](const Operand& operand, const auto& use) {
    const Address first = addressOf(operand);
    for (std::uint32_t i = 0; i < extentOf(operand); ++i) use(Address{first.area, first.index + i});
  };
  if (operands.empty()) {
    for (const ComparedRange& range : options.pairs.comparedToo()) {
      for (std::uint32_t i = 0; i < range.bits; ++i) {
        const Address old{range.first.area, range.first.index + i};
        add(old, options.pairs.after(old));
      }
    }
    for (const TraceSignal& signal : touchedSignals(before)) {
      if (isOutput(signal)) operands.push_back(signal.operand);
    }
    for (const TraceSignal& signal : touchedSignals(after)) {
      if (!isOutput(signal)) continue;
      eachBit(signal.operand, [&](const Address& now) { add(options.pairs.before(now), now); });
    }
  }
  for (const Operand& operand : operands)
    eachBit(operand, [&](const Address& old) { add(old, options.pairs.after(old)); });
  UsedPulses isUsed = pulseOutputsOf(before);
  const UsedPulses ofNew = pulseOutputsOf(after);
  for (std::size_t i = 0; i < isUsed.size(); ++i) isUsed[i] = isUsed[i] || ofNew[i];
  const std::array<PulseForm, 2> forms = {pulseForm(before.target), pulseForm(after.target)};
  for (const PulseSignal& signal : comparedPulses(options.observed, options.pairs, options.latency, isUsed, forms))
    outputs.push_back({nameOf(signal), {}, {}, noNode, signal});
  return outputs;
}

std::optional<EquivalenceRun> exploredRun(const Side& before, const Side& after, const BothRuns& runs,
                                          std::chrono::steady_clock::time_point deadline,
                                          const std::atomic<bool>& cancel) {
  const ProverOptions& options = runs.options.prover;
  const std::array spaces{runSpaceOf(*before.program, before.set, options.choices, options.time),
                          runSpaceOf(*after.program, after.set, options.choices, options.time)};
  const InputPairing pairing(spaces[oldIndex], spaces[newIndex], runs.options.pairs);
  if (!pairing.isWhole() || runs.options.steadyInputs || !runs.options.assumptions.empty()) return std::nullopt;
  std::vector<int> widths;
  for (const PairedInput& input : pairing.inputs()) widths.push_back(input.width);
  std::vector<PoolCell> cells;
  for (const std::size_t i : {oldIndex, newIndex}) {
    for (const Place& place : spaces[i].state) cells.push_back({place, i});
  }
  PoolConstants constants;
  constants.add(*before.program);
  constants.add(*after.program);
  ExploredPair pair(before, after, runs, pairing.inputs());
  StatePool<ExploredPair> pool(pair, options.time, widths, cells, constants, options.seed);
  RandomWalks walks(pair, options.time, widths, constants, options.seed);
  pool.notePatience(runs.options.latency, runs.options.settleMs);
  for (const RunSpace& space : spaces) pool.notePatience(0, space.clockMs);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const auto isStopped = [&] { return cancel.load(std::memory_order_relaxed) || pair.found().has_value(); };
  // All inputs off, all on, one of them on; random walks; then the pool's own choices in what is left of the time.
  const Clock::time_point held = begin + (deadline - begin) / 3, walked = held + (deadline - begin) / 3;
  for (std::size_t kind = 0; kind < widths.size() + 2 && !isStopped() && Clock::now() < held; ++kind) {
    std::vector<std::uint64_t> values(widths.size(), kind == 1 ? ~0ULL : 0);
    if (kind > 1) values[kind - 2] = ~0ULL;
    pool.hold(values, heldScans, [&] { return isStopped() || Clock::now() >= held; });
  }
  while (!isStopped() && Clock::now() < walked) walks.walk([&] { return isStopped() || Clock::now() >= walked; });
  pool.search([&] { return isStopped() || Clock::now() >= deadline; }, [&] { return pair.found().has_value(); });
  const auto isAssumption = [](const Property& property) { return !property.isGoal(); };
  const bool isConstrained = std::ranges::any_of(before.set.properties, isAssumption) ||
                             std::ranges::any_of(after.set.properties, isAssumption);
  if (!pair.found() || isConstrained) return pair.found();
  return shorterRun(runs, *pair.found(), Clock::now() + shorteningTime);
}

}  // namespace rungproof
