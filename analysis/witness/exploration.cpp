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
  };

  ExploredProgram(const Program& program, const RunSpace& space, const std::vector<Property>& assumptions,
                  const std::vector<Property>& goals, std::vector<std::size_t> wanted)
      : program_(program),
        choices_(space.choices),
        assumptions_(assumptions),
        goals_(goals),
        inputs_(space.inputs),
        simulator_(program, stillOptions(choices_), &outside_),
        domain_(outside_),
        wanted_(std::move(wanted)),
        found_(goals.size()) {
    simulator_.readUnknownAsZero(true);  // as outside_ says
    simulator_.expectFreeZero();
    for (const Property& property : assumptions_) nowAssumed_.emplace_back(property);
    for (const std::size_t goal : wanted_) nowGoals_.emplace_back(goals_[goal]);
  }

  Snapshot snapshot() const { return {simulator_.store(), nowAssumed_, nowGoals_}; }
  void restore(const Snapshot& from) {
    simulator_.setStore(from.store);
    nowAssumed_ = std::vector<Follower>(from.assumptions);
    nowGoals_ = std::vector<Follower>(from.goals);
    shown_.clear();
  }
  const Concrete::Store& store(std::size_t) const { return simulator_.store(); }

  void begin(const RunStep& step) {
    script_ = scanOf(step);
    for (const PresetValue& input : script_.inputs) simulator_.write(input.operand, input.value);
  }
  Went scan(bool isFirst) {
    simulator_.scan({.lengthUs = script_.lengthMs * 1000, .script = &script_.script});
    if (!hasScanEnd(simulator_.store())) return Went::Ended;
    for (Follower& assumption : nowAssumed_) {
      if (!assumption.evaluate(domain_, simulator_.store(), script_, isFirst)) return Went::Broken;
    }
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (isOpen(wanted_[i]) && nowGoals_[i].evaluate(domain_, simulator_.store(), script_, isFirst))
        shown_.push_back(wanted_[i]);
    }
    return simulator_.isRunning() ? Went::On : Went::Ended;
  }
  bool hasShown() const { return !shown_.empty(); }
  void keepShown(const std::vector<RunStep>& way) {
    std::vector<ReplayScan> scans;
    for (const RunStep& step : way) scans.push_back(scanOf(step));
    for (const std::size_t goal : shown_)
      found_[goal] = Judge(program_, choices_, assumptions_, goals_[goal]).witness(scans, std::nullopt);
    shown_.clear();
  }

  void withdraw(std::size_t goal) { withdrawn_.insert(goal); }
  const std::optional<Witness>& found(std::size_t goal) const { return found_[goal]; }
  bool isAllFound() const {
    return std::none_of(wanted_.begin(), wanted_.end(), [&](std::size_t g) { return isOpen(g); });
  }

 private:
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
  Simulator simulator_;
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
        pool_(world_, space.time, widthsOf(space), cellsOf(space), constantsOf(program, goals, assumptions), seed) {
    for (const Property& property : assumptions) notePatience(property);
    for (const std::size_t goal : wanted) notePatience(goals[goal]);
  }

  void withdraw(std::size_t goal) { world_.withdraw(goal); }
  const std::optional<Witness>& found(std::size_t goal) const { return world_.found(goal); }
  bool search(Clock::time_point deadline, const std::atomic<bool>& cancel, std::optional<std::size_t> goal) {
    return pool_.search([&] { return cancel.load(std::memory_order_relaxed) || Clock::now() >= deadline; },
                        [&] { return goal ? world_.found(*goal).has_value() : world_.isAllFound(); });
  }

 private:
  void notePatience(const Property& property) {
    const bool isScans = property.kind == PropertyKind::LeadsToScans;
    pool_.notePatience(isScans ? property.bound : 0, isScans ? 0 : property.bound);
    for (const Expr* expr : {&property.first, &property.second}) {
      for (const ExprNode& node : expr->nodes) pool_.notePatience(0, node.milliseconds);
    }
  }

  ExploredProgram world_;
  StatePool<ExploredProgram> pool_;
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
        exploration_.search(deadline, cancel_, goal_);
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
