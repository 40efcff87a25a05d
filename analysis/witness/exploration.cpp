// Runs of one program for the pool.
#include "analysis/witness/exploration.hpp"

#include <algorithm>
#include <set>

#include "analysis/witness/follower.hpp"
#include "analysis/witness/state_pool.hpp"
#include "engine/simulator.hpp"

namespace rungproof {

/// A program that is run with its assumptions and goals followed.
class ExploredProgram {
 public:
  struct Snapshot {
    Concrete::Store store;
    std::vector<Follower> assumptions, goals;
    std::size_t engine;
  };

  ExploredProgram(const Program& program, const RunSpace& space, const std::vector<Property>& assumptions,
                  const std::vector<Property>& goals, std::vector<std::size_t> wanted)
      : program_(program),
        choices_(space.choices),
        assumptions_(assumptions),
        goals_(goals),
        inputs_(space.inputs),
        domain_(outside_),
        wanted_(std::move(wanted)),
        found_(goals.size()) {
    addEngine(choices_);
    if (space.otherReadings) addEngine(*space.otherReadings);
    for (const auto& engine : engines_) starts_.push_back(engine->store());
    for (const Property& property : assumptions_) nowAssumed_.emplace_back(property);
    for (const std::size_t goal : wanted_) nowGoals_.emplace_back(goals_[goal]);
  }

  /// Power-up under other readings than the chosen ones.
  void startWithOtherReadings() {
    engine_ = 1;
    engine().setStore(starts_[1]);
  }
  Snapshot snapshot() const { return {engine().store(), nowAssumed_, nowGoals_, engine_}; }
  void restore(const Snapshot& from) {
    engine_ = from.engine;
    engine().setStore(from.store);
    nowAssumed_ = std::vector<Follower>(from.assumptions);
    nowGoals_ = std::vector<Follower>(from.goals);
    shown_.clear();
  }
  const Concrete::Store& store(std::size_t) const { return engine().store(); }

  void begin(const RunStep& step) {
    script_ = scanOf(step);
    for (const PresetValue& input : script_.inputs) engine().write(input.operand, input.value);
  }
  Went scan(bool isFirst) {
    engine().scan({.lengthUs = script_.lengthMs * 1000, .script = &script_.script});
    if (!hasScanEnd(engine().store())) return Went::Ended;
    for (Follower& assumption : nowAssumed_) {
      if (!assumption.evaluate(domain_, engine().store(), script_, isFirst)) return Went::Broken;
    }
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (isOpen(wanted_[i]) && nowGoals_[i].evaluate(domain_, engine().store(), script_, isFirst))
        shown_.push_back(wanted_[i]);
    }
    return engine().isRunning() ? Went::On : Went::Ended;
  }
  bool hasShown() const { return !shown_.empty(); }
  void keepShown(const std::vector<RunStep>& way) {
    std::vector<ReplayScan> scans;
    for (const RunStep& step : way) scans.push_back(scanOf(step));
    const auto start = engine_ == 0 ? std::nullopt : std::optional(starts_[engine_]);
    std::vector<const Property*> shown;
    for (const std::size_t goal : shown_) shown.push_back(&goals_[goal]);
    auto witnesses = witnessesOf(program_, choices_, assumptions_, shown, scans, start);
    for (std::size_t i = 0; i < shown_.size(); ++i) found_[shown_[i]] = std::move(witnesses[i]);
    shown_.clear();
  }

  void withdraw(std::size_t goal) { withdrawn_.insert(goal); }
  const std::optional<Witness>& found(std::size_t goal) const { return found_[goal]; }
  bool isAllFound() const {
    return std::none_of(wanted_.begin(), wanted_.end(), [&](std::size_t g) { return isOpen(g); });
  }

 private:
  void addEngine(const Choices& choices) {
    engines_.push_back(std::make_unique<Simulator>(program_, stillOptions(choices), &outside_));
    engines_.back()->readUnknownAsZero(true);  // as outside_ says
    engines_.back()->expectFreeZero();
  }
  Simulator& engine() { return *engines_[engine_]; }
  const Simulator& engine() const { return *engines_[engine_]; }
  bool isOpen(std::size_t goal) const { return !found_[goal] && !withdrawn_.contains(goal); }
  ReplayScan scanOf(const RunStep& step) const {
    ReplayScan scan;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      for (const ScanInput& input : inputs_[i].operands)
        scan.inputs.push_back({input.operand, input.valueIn(step.inputs[i])});
    }
    scan.lengthMs = step.lengthMs;
    scan.repeats = step.repeats;
    return scan;
  }

  const Program& program_;
  const Choices choices_;
  const std::vector<Property>& assumptions_;
  const std::vector<Property>& goals_;
  const std::vector<RunSpace::Input> inputs_;
  StillOutside outside_;
  std::vector<std::unique_ptr<Simulator>> engines_;  ///< under the chosen readings, then others: code is made for one
  std::vector<Concrete::Store> starts_;
  std::size_t engine_ = 0;
  Concrete domain_;
  const std::vector<std::size_t> wanted_;
  std::set<std::size_t> withdrawn_;
  std::vector<std::optional<Witness>> found_;
  std::vector<Follower> nowAssumed_, nowGoals_;
  std::vector<std::size_t> shown_;
  ReplayScan script_;
};

namespace {

std::vector<PoolCell> cellsOf(const RunSpace& space) {
  std::vector<PoolCell> cells;
  for (const Place& place : space.state) cells.push_back({place});
  return cells;
}

std::vector<int> widthsOf(const RunSpace& space) {
  std::vector<int> widths;
  for (const RunSpace::Input& input : space.inputs) widths.push_back(input.width);
  return widths;
}

PoolConstants constantsOf(const Program& program, const std::vector<Property>& goals,
                          const std::vector<Property>& assumptions) {
  PoolConstants constants;
  constants.add(program);
  for (const std::vector<Property>* properties : {&goals, &assumptions}) {
    for (const Property& property : *properties) {
      for (const Expr* expr : {&property.first, &property.second}) {
        for (const ExprNode& node : expr->nodes) {
          if (node.op == ExprOp::Constant) constants.add(node.value);
        }
      }
    }
  }
  return constants;
}

}  // namespace

class Exploration::Impl {
 public:
  Impl(const Program& program, const RunSpace& space, const std::vector<Property>& assumptions,
       const std::vector<Property>& goals, const std::vector<std::size_t>& wanted, std::uint64_t seed)
      : world_(program, space, assumptions, goals, wanted),
        constants_(constantsOf(program, goals, assumptions)),
        chosen_(poolOf(space, seed)) {
    if (space.otherReadings) {
      world_.startWithOtherReadings();
      others_.emplace(poolOf(space, seed));
    }
    for (const Property& property : assumptions) notePatience(property);
    for (const std::size_t goal : wanted) notePatience(goals[goal]);
  }

  void withdraw(std::size_t goal) { world_.withdraw(goal); }
  const std::optional<Witness>& found(std::size_t goal) const { return world_.found(goal); }
  /// The readings that are chosen have most of the time; where all goals are looked for together, the others have the
  /// rest.
  bool search(Clock::time_point deadline, const std::atomic<bool>& cancel, std::optional<std::size_t> goal) {
    bool isBarren = true;
    const auto explore = [&](StatePool<ExploredProgram>& pool, Clock::time_point end) {
      isBarren = !pool.search([&] { return cancel.load(std::memory_order_relaxed) || Clock::now() >= end; },
                              [&] { return isDone(goal); }) &&
                 isBarren;
    };
    if (goal || !others_) {
      explore(chosen_, deadline);
    } else {
      const auto rest =
          std::chrono::duration_cast<Clock::duration>((deadline - Clock::now()) * schedule::otherReadingsShare);
      explore(chosen_, deadline - rest);
      if (!isDone(goal)) explore(*others_, Clock::now() + rest);
    }
    return !isBarren;
  }

 private:
  bool isDone(std::optional<std::size_t> goal) const {
    return goal ? world_.found(*goal).has_value() : world_.isAllFound();
  }
  void notePatience(const Property& property) {
    const bool isScans = property.kind == PropertyKind::LeadsToScans;
    const auto note = [&](StatePool<ExploredProgram>& pool) {
      pool.notePatience(isScans ? property.bound : 0, isScans ? 0 : property.bound);
      for (const Expr* expr : {&property.first, &property.second}) {
        for (const ExprNode& node : expr->nodes) pool.notePatience(0, node.milliseconds);
      }
    };
    note(chosen_);
    if (others_) note(*others_);
  }
  StatePool<ExploredProgram> poolOf(const RunSpace& space, std::uint64_t seed) {
    StatePool<ExploredProgram> pool(world_, space.time, widthsOf(space), cellsOf(space), constants_, seed);
    pool.notePatience(0, space.clockMs);
    return pool;
  }

  ExploredProgram world_;
  const PoolConstants constants_;
  StatePool<ExploredProgram> chosen_;
  std::optional<StatePool<ExploredProgram>> others_;  ///< of runs under other readings
};

Exploration::Exploration(const Program& program, const RunSpace& space, const std::vector<Property>& assumptions,
                         const std::vector<Property>& goals, const std::vector<std::size_t>& wanted, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(program, space, assumptions, goals, wanted, seed)) {}
Exploration::~Exploration() = default;
void Exploration::withdraw(std::size_t goal) { impl_->withdraw(goal); }
bool Exploration::search(Clock::time_point deadline, const std::atomic<bool>& cancel, std::optional<std::size_t> goal) {
  return impl_->search(deadline, cancel, goal);
}
const std::optional<Witness>& Exploration::found(std::size_t goal) const { return impl_->found(goal); }

ExplorationThread::ExplorationThread(Exploration& exploration, std::size_t goal,
                                     Exploration::Clock::time_point deadline, double pause, std::function<void()> found)
    : exploration_(exploration), goal_(goal), thread_([this, deadline, pause, found = std::move(found)] {
        {
          std::unique_lock lock(mutex_);
          ended_.wait_for(lock, std::chrono::duration<double>(pause), [this] { return cancel_.load(); });
        }
        const auto begin = Exploration::Clock::now();
        try {
          exploration_.search(deadline, cancel_, goal_);
        } catch (const std::exception&) {  // a broken CHECK has said so; the question has other ways to its answer
          return;
        }
        seconds_ = std::chrono::duration<double>(Exploration::Clock::now() - begin).count();
        if (exploration_.found(goal_)) found();
      }) {}

bool ExplorationThread::end() {
  {
    const std::lock_guard lock(mutex_);
    cancel_ = true;
  }
  ended_.notify_all();
  if (thread_.joinable()) thread_.join();
  return exploration_.found(goal_).has_value();
}

}  // namespace rungproof
