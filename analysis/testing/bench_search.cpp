// States are told apart by what the contacts see, by the outputs and by the numbers that the program keeps; numbers
// that move while nothing else does are clocks and do not count.
#include "analysis/testing/bench_search.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <unordered_map>

#include "analysis/witness/state_pool.hpp"
#include "engine/simulator.hpp"
#include "engine/testing/test_player.hpp"
#include "ir/dialect.hpp"
#include "ir/iec/expression_role.hpp"

namespace rungproof {

namespace {

constexpr std::uint64_t shortWait = 6;  ///< scans: two early and two late leave two
constexpr std::uint64_t skewScans = 4;  ///< of the wait, that skews may take away
constexpr std::uint64_t mostSettling = 40;
constexpr std::uint64_t longestWaitScans = 40000;
constexpr std::uint64_t leastStretch = 100;  ///< scans
constexpr std::size_t enoughNodes = 3000;    ///< to draw walks from
constexpr unsigned scansOfClock = 3;
constexpr unsigned scansAtRest = 12;  ///< longer than half a period of SM0.5

}  // namespace

class BenchSearch::Impl {
  /// Where one of the two runs stands.
  struct BenchState {
    Concrete::Store store;
    Simulator::Moment moment;
  };

 public:
  Impl(const Program& program, const TestSignals& signals, const CoverageMap& map,
       const std::vector<const Property*>& assumptions, const BenchOptions& options)
      : program_(program),
        signals_(signals),
        options_(options),
        recorder_(map),
        shortRecorder_(map),
        assumptions_(assumptions),
        isTimed_(dependsOnTime(program)),
        replays_(hasEventsOrDevices(program)),
        end_(Clock::now() +
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds))) {
    Node root;
    for (std::size_t i = 0; i < signals.inputs.size(); ++i) root.inputs.push_back(0);
    nodes_.push_back(std::move(root));
    for (const std::uint32_t us : {options.longestUs, options.shortUs})
      runs_.push_back(std::make_unique<Run>(program, options.engine, us));
    states_.push_back({stateOf(0), stateOf(1)});
    for (const Property* assumption : assumptions_) firstFollowers_.emplace_back(*assumption);
    followers_.push_back(firstFollowers_);
    tried_.push_back(0);
    const std::size_t size = std::max<std::size_t>(sizeOf(states_[0].first.store), 1);
    mostNodes_ = std::clamp<std::size_t>(options.memory / (2 * size), 16, 20000);
    for (std::size_t i = 0; i < map.leaves().size(); ++i) {
      const Instruction* contact = map.leaves()[i].instruction;
      const bool isOfClock =
          contact == nullptr || (!contact->operands.empty() && contact->operands[0].kind == OperandKind::Direct &&
                                 contact->operands[0].area == Area::SM);
      if (!isOfClock && map.leaves()[i].kind == LeafKind::Contact) watched_.push_back(i);
    }
    findUnreadClocks();
    queue_.push({0, 0});
  }

  bool search(const std::function<bool()>& isDone) {
    while (!queue_.empty() || goOnQuickly()) {
      if (isDone() || Clock::now() > end_) return true;
      const std::size_t from = queue_.top().second;
      const std::vector<BenchStep> steps = stepsFrom(from);
      if (tried_[from] >= steps.size()) {
        queue_.pop();
        continue;
      }
      const BenchStep& step = steps[tried_[from]++];
      tryStep(from, step);
    }
    return false;
  }

  void explore(Clock::time_point end) {
    end_ = end;
    search([&] { return nodes_.size() >= enoughNodes; });
  }

  bool follow(const std::vector<BenchStep>& steps) {
    const std::size_t before = recorder_.news();
    std::size_t at = 0;
    for (const BenchStep& step : steps) {
      const std::optional<std::size_t> next = tryStep(at, step);
      if (!next) break;
      at = *next;
    }
    return recorder_.news() > before;
  }

  CoverageRecorder& recorder() { return recorder_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Edge>& edges() const { return edges_; }

 private:
  struct Run {
    Run(const Program& program, const SimulatorOptions& engine, std::uint32_t us)
        : simulator(std::make_unique<Simulator>(program, engine)), scanUs(us) {}
    std::unique_ptr<Simulator> simulator;
    std::uint32_t scanUs;
    std::uint64_t clockMs = 0;
  };
  /// What tells states apart while a step runs.
  struct Look {
    std::vector<char> leaves;
    std::vector<std::optional<TraceNumber>> outputs;
    friend bool operator==(const Look&, const Look&) = default;
  };

  static std::size_t sizeOf(const Concrete::Store& store) {
    std::size_t size = store.registers().size() * 4;
    for (int area = 0; area < areaCount; ++area) size += store.area(static_cast<Area>(area)).size();
    return size;
  }
  BenchState stateOf(std::size_t run) const {
    const Simulator& simulator = *runs_[run]->simulator;
    // Scans begin with a tick of the clock where their length is whole milliseconds.
    return {simulator.store(),
            {simulator.scanCount(), simulator.timeUs(), simulator.timeUs() / 1000,
             static_cast<std::uint32_t>(simulator.timeUs() % 1000 * 100)}};
  }

  std::vector<BenchStep> stepsFrom(std::size_t from) const {
    std::vector<BenchStep> steps;
    if (from == 0) steps.push_back({{}, {shortWait, 0}});
    for (std::size_t i = 0; i < signals_.inputs.size(); ++i) {
      for (const TraceNumber value : signals_.inputs[i].values) {
        if (value != nodes_[from].inputs[i]) steps.push_back({{{i, value}}, {shortWait, 0}});
      }
    }
    if (isTimed_ && from != 0) steps.push_back({{}, untilRest});
    if (!isQuick_ || !isTimed_) return steps;
    for (std::size_t i = 0; i < signals_.inputs.size(); ++i) {
      for (const TraceNumber value : signals_.inputs[i].values) {
        if (value != nodes_[from].inputs[i]) steps.push_back({{{i, value}}, {1, 0}});
      }
    }
    return steps;
  }

  /// Where everything has been tried with time to settle, one scan may be enough, before time has come.
  bool goOnQuickly() {
    if (isQuick_ || !isTimed_) return false;
    isQuick_ = true;
    for (std::size_t i = 0; i < nodes_.size(); ++i) queue_.push({nodes_[i].depth * 4, i});
    return true;
  }

  void restore(std::size_t run, std::size_t node) {
    Run& one = *runs_[run];
    if (!replays_) {
      const BenchState& state = run == 0 ? states_[node].first : states_[node].second;
      if (node == 0) one.simulator = std::make_unique<Simulator>(program_, options_.engine);
      if (node != 0) one.simulator->goOnFrom(state.store, state.moment);
      return;
    }
    // A run with interrupts or devices goes on from power-on only.
    one.simulator = std::make_unique<Simulator>(program_, options_.engine);
    std::vector<std::size_t> way;
    for (std::size_t at = node; at != 0; at = nodes_[at].parent) way.push_back(at);
    for (std::size_t i = way.size(); i-- > 0;) {
      apply(run, nodes_[way[i]].step);
      const std::uint64_t scans = scansOf(nodes_[way[i]].step.wait, one.scanUs);
      for (std::uint64_t k = 0; k < scans; ++k) one.simulator->scan({.lengthUs = one.scanUs});
    }
  }

  void apply(std::size_t run, const BenchStep& step) {
    for (const auto& [input, value] : step.changes) {
      const TraceSignal& signal = signals_.inputs[input].signal;
      runs_[run]->simulator->write(signal.operand, valueOf(value, signal.type, signal.width()));
    }
  }
  static std::uint64_t scansOf(const TestWait& wait, std::uint32_t us) {
    return wait.isTime() ? (wait.timeUs + us - 1) / us : wait.scans;
  }

  Look lookAt(const CoverageRecorder& recorder, const Simulator& simulator) const {
    Look look;
    for (const std::size_t leaf : watched_) {
      const std::optional<bool> value = recorder.lastValue(leaf);
      look.leaves.push_back(!value ? 2 : *value ? 1 : 0);
    }
    look.outputs = sampleValues(simulator.store(), signals_.outputs);
    return look;
  }
  Look look() { return lookAt(observing(), *runs_[0]->simulator); }
  /// What a step shows counts once no assumption has been broken on the way.
  CoverageRecorder& observing() { return trial_ ? *trial_ : recorder_; }

  /// One observed scan of the first run. False: an assumption is broken, or the CPU has stopped.
  bool scanObserved() {
    Run& run = *runs_[0];
    const bool isFirst = run.simulator->scanCount() == 0;
    observing().beginScan();
    run.simulator->scan({.lengthUs = run.scanUs});
    if (!run.simulator->isRunning()) return false;
    ReplayScan scan;
    scan.lengthMs = std::max<std::uint32_t>(run.scanUs / 1000, 1);
    for (Follower& follower : *current_) {
      if (!follower.evaluate(domain_, run.simulator->store(), scan, isFirst)) return false;
    }
    return true;
  }

  /// Runs a step from a state and gives the state that it leads to; nothing: it is no run.
  std::optional<std::size_t> tryStep(std::size_t from, const BenchStep& given) {
    BenchStep step = given;
    restore(0, from);
    if (!assumptions_.empty()) trial_.emplace(recorder_.map());
    runs_[0]->simulator->observe(&observing());
    current_.emplace(followers_[from]);
    const std::size_t news = recorder_.news();
    apply(0, step);
    const bool waits = step.wait.scans == 0 && !step.wait.isTime();
    if (waits ? !runUntilRest(step) : !runSettled(step)) return std::nullopt;
    if (trial_) recorder_.add(*trial_);
    const Look now = look();
    const std::vector<std::optional<TraceNumber>> numbers = sampleValues(runs_[0]->simulator->store(), signals_.memory);
    bool differs = lookOfShort(from, step) != now;
    if (differs && isTimed_ && !step.wait.isTime() && step.wait.scans > 1) {
      // Time has come in between: the wait is one of time, so that it has come with short scans too.
      step.wait = {1, step.wait.scans * runs_[0]->scanUs};
      differs = lookOfShort(from, step) != now;
    }
    const bool isFragile = nodes_[from].isFragile || differs;

    std::vector<TraceNumber> inputs = nodes_[from].inputs;
    for (const auto& [input, value] : step.changes) inputs[input] = value;
    std::string key(now.leaves.begin(), now.leaves.end());
    const auto addNumber = [&](TraceNumber value) {
      const auto most = static_cast<double>(value);
      for (const double part : {most, static_cast<double>(value - most)})
        key.append(reinterpret_cast<const char*>(&part), sizeof part);
    };
    for (const TraceNumber value : inputs) addNumber(value);
    for (const auto& value : now.outputs) addNumber(value.value_or(-1));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!clocks_.contains(i)) addNumber(numbers[i].value_or(-1));
    }
    const bool isUseful = recorder_.news() > news;
    const auto [place, isNew] = known_.try_emplace(std::move(key), nodes_.size());
    if (isNew && nodes_.size() < mostNodes_) {
      nodes_.push_back({from, step, std::move(inputs), nodes_[from].depth + 1, isFragile});
      states_.push_back(replays_ ? states_[0] : std::pair(stateOf(0), stateOf(1)));
      followers_.push_back(*current_);
      tried_.push_back(0);
      // What is fragile comes last; what covered something new comes early.
      const std::size_t cost = nodes_.back().depth * 4 + (isFragile ? 400 : 0) - (isUseful ? 3 : 0);
      queue_.push({cost, nodes_.size() - 1});
    } else if (isNew) {
      known_.erase(place);
      return std::nullopt;
    }
    edges_.push_back({from, place->second, step, isUseful, isFragile});
    return place->second;
  }

  /// What the run with short scans shows behind the step.
  Look lookOfShort(std::size_t from, const BenchStep& step) {
    restore(1, from);
    apply(1, step);
    Simulator& simulator = *runs_[1]->simulator;
    const std::uint64_t scans = scansOf(step.wait, runs_[1]->scanUs);
    for (std::uint64_t i = 0; i < scans; ++i) {
      simulator.observe(i + 1 == scans ? &shortRecorder_ : nullptr);
      shortRecorder_.beginScan();
      simulator.scan({.lengthUs = runs_[1]->scanUs});
    }
    return lookAt(shortRecorder_, simulator);
  }

  /// Scans until the contacts have been at rest for as long as skews may take, `shortWait` at least.
  bool runSettled(BenchStep& step) {
    std::uint64_t changed = 0, scans = 0;
    Look last;
    std::vector<std::optional<TraceNumber>> numbers;
    const std::uint64_t asked = scansOf(step.wait, runs_[0]->scanUs);
    const auto needed = [&] {
      return asked == 1 ? asked : std::max(asked, std::min(changed + skewScans, mostSettling));
    };
    for (; scans < needed(); ++scans) {
      if (!scanObserved()) return false;
      Look now = look();
      std::vector<std::optional<TraceNumber>> next = sampleValues(runs_[0]->simulator->store(), signals_.memory);
      if (now != last)
        changed = scans + 1;
      else if (scans > changed)
        noteClocks(numbers, next);
      last = std::move(now);
      numbers = std::move(next);
    }
    if (!step.wait.isTime()) step.wait.scans = scans;
    return true;
  }

  /// Scans until something that time brings has come and all is at rest again, then as long as skews may take.
  bool runUntilRest(BenchStep& step) {
    Look last = look();
    const std::uint64_t us = runs_[0]->scanUs;
    std::uint64_t scans = 0, changed = 0;
    const std::uint64_t margin = skewScans + 2;
    restingScans_ = 0;
    for (; scans < longestWaitScans && (changed == 0 || scans < changed + margin); ++scans) {
      if (!scanObserved() || (scans % 256 == 255 && Clock::now() > end_)) return false;
      Look now = look();
      if (now != last && scans > 0 && changed == 0) changed = scans + 1;
      last = std::move(now);
      if (changed == 0 && (scans > restScans_ || !isMoving())) break;
    }
    if (changed == 0) return false;
    if (!replays_) {
      const std::uint64_t middle = middleOfStretch(scans, changed);
      if (middle > scans) {
        for (; scans < middle; ++scans) {
          if (!scanObserved()) return false;
        }
      } else if (dialectOf(program_.target).run.counting == Counting::Instances) {
        scans = longerRest(last, scans, 2 * changed + margin);
      }
    }
    step.wait = {1, scans * us};
    restScans_ = std::max(restScans_, 2 * changed + 20);
    return true;
  }

  /// Where time alone moves outputs on and on: the middle between the change and the next one, which scans of other
  /// lengths shift the least. `scans` where nothing comes for as long again.
  std::uint64_t middleOfStretch(std::uint64_t scans, std::uint64_t changed) {
    Simulator& simulator = *runs_[0]->simulator;
    const BenchState kept = stateOf(0);
    const std::vector<std::optional<TraceNumber>> outputs = sampleValues(simulator.store(), signals_.outputs);
    simulator.observe(nullptr);
    std::uint64_t next = 0;
    for (std::uint64_t i = scans; next == 0 && i < scans + changed + leastStretch; ++i) {
      simulator.scan({.lengthUs = runs_[0]->scanUs});
      if (sampleValues(simulator.store(), signals_.outputs) != outputs) next = i + 1;
    }
    simulator.goOnFrom(kept.store, kept.moment);
    simulator.observe(&observing());
    return std::max(scans, (changed + next) / 2);
  }

  /// Whether memory or a timer has changed in the last scans: where nothing moves, waiting is no use.
  bool isMoving() {
    const Concrete::Store& store = runs_[0]->simulator->store();
    std::vector<std::uint32_t>& now = movingParts_;
    now.clear();
    for (const Area area : {Area::V, Area::M, Area::DB, Area::S, Area::Q}) {
      const std::vector<std::uint8_t>& bytes = store.area(area);
      for (std::uint32_t i = 0; i < bytes.size(); ++i) now.push_back(isUnread(area, i) ? 0 : bytes[i]);
    }
    for (const Reg reg : {Reg::TimerCurrent, Reg::S5Rest, Reg::CounterCurrent}) {
      for (std::uint32_t i = 0; i < store.count(reg); ++i) now.push_back(static_cast<std::uint32_t>(store.get(reg, i)));
    }
    restingScans_ = now == lastParts_ ? restingScans_ + 1 : 0;
    std::swap(now, lastParts_);
    return restingScans_ < scansAtRest;
  }
  /// Of instances: a byte of a clock that always runs and that nothing reads.
  bool isUnread(Area area, std::uint32_t byte) const { return area == Area::V && unread_.contains(byte); }

  void findUnreadClocks() {
    if (dialectOf(program_.target).run.counting != Counting::Instances) return;
    std::set<std::uint32_t> loaded;
    const auto each = [&](const auto& visit) {
      for (const Pou& pou : program_.pous) {
        for (const Network& network : pou.networks) {
          for (const Instruction& i : network.instructions) visit(i);
        }
      }
    };
    each([&](const Instruction& i) {
      if (expressionRole(i) == ExpressionRole::Load) loaded.insert(i.operands[0].offset);
    });
    each([&](const Instruction& i) {
      if (expressionRole(i) != ExpressionRole::PassTime || loaded.contains(i.operands[1].offset)) return;
      for (std::uint32_t k = 0; k < 4; ++k) unread_.insert(i.operands[1].offset + k);
    });
  }

  /// Clocks of IEC 61131-3 count whole milliseconds of each scan: with scans of fractions they take up to twice the
  /// time. So the wait is twice as long where nothing else comes in it. Gives the scans that it has.
  std::uint64_t longerRest(const Look& last, std::uint64_t scans, std::uint64_t wanted) {
    const BenchState kept = stateOf(0);
    for (std::uint64_t i = scans; i < wanted; ++i) {
      if (scanObserved() && look() == last) continue;
      runs_[0]->simulator->goOnFrom(kept.store, kept.moment);
      return scans;
    }
    return std::max(scans, wanted);
  }

  /// A number that moves in scan after scan while nothing else does is a clock.
  void noteClocks(const std::vector<std::optional<TraceNumber>>& before,
                  const std::vector<std::optional<TraceNumber>>& now) {
    moving_.resize(now.size(), 0);
    for (std::size_t i = 0; i < before.size(); ++i) {
      moving_[i] = before[i] != now[i] ? moving_[i] + 1 : 0;
      if (moving_[i] >= scansOfClock) clocks_.insert(i);
    }
  }

  const Program& program_;
  const TestSignals& signals_;
  const BenchOptions options_;
  CoverageRecorder recorder_;
  std::optional<CoverageRecorder> trial_;  ///< of the step that is tried, where runs are assumed to be as they should
  CoverageRecorder shortRecorder_;         ///< only for what contacts see at the end of steps
  const std::vector<const Property*> assumptions_;
  const bool isTimed_, replays_;
  Clock::time_point end_;
  StillOutside outside_;
  Concrete domain_{outside_};
  std::vector<std::unique_ptr<Run>> runs_;
  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
  std::vector<std::pair<BenchState, BenchState>> states_;
  std::vector<Follower> firstFollowers_;
  std::optional<std::vector<Follower>> current_;  ///< of the run that goes on
  std::vector<std::vector<Follower>> followers_;
  std::vector<std::size_t> tried_;
  std::vector<std::size_t> watched_;
  std::set<std::size_t> clocks_;  ///< of TestSignals::memory
  std::vector<unsigned> moving_;  ///< by number: scans in a row in which it has moved
  bool isQuick_ = false;          ///< steps of one scan are tried too
  std::unordered_map<std::string, std::size_t> known_;
  using Entry = std::pair<std::size_t, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::size_t mostNodes_ = 0;
  std::set<std::uint32_t> unread_;  ///< bytes of V that isUnread()
  std::vector<std::uint32_t> movingParts_, lastParts_;
  unsigned restingScans_ = 0;
  std::uint64_t restScans_ = 700;  ///< without a change after which a wait is given up
};

BenchSearch::BenchSearch(const Program& program, const TestSignals& signals, const CoverageMap& map,
                         const std::vector<const Property*>& assumptions, const BenchOptions& options)
    : impl_(std::make_unique<Impl>(program, signals, map, assumptions, options)) {}
BenchSearch::~BenchSearch() = default;
bool BenchSearch::search(const std::function<bool()>& isDone) { return impl_->search(isDone); }
void BenchSearch::explore(Clock::time_point end) { impl_->explore(end); }
bool BenchSearch::follow(const std::vector<BenchStep>& steps) { return impl_->follow(steps); }
const CoverageRecorder& BenchSearch::recorder() const { return impl_->recorder(); }
const std::vector<BenchSearch::Node>& BenchSearch::nodes() const { return impl_->nodes(); }
const std::vector<BenchSearch::Edge>& BenchSearch::edges() const { return impl_->edges(); }

}  // namespace rungproof
