// A pool of states, each with the way to it. A state is new if its bits have not stood so together before, or if
// some word has a value that it never had. Also kept is the state in front of a change that came
// by itself: whatever happens in the very scan in which a timer ends starts there.
#include "analysis/proof/exploration.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <random>
#include <set>
#include <unordered_set>

#include "analysis/proof/follower.hpp"
#include "engine/simulator.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostStates = 3000;    ///< kept with their memory
constexpr int shortRuns = 32;               ///< of one or two scans, for each one that may be long
constexpr int longestStretch = 14;          ///< a long one keeps its inputs for up to 2^13 scans,
constexpr int patience = 16;                ///< one of so many 16 times as long
constexpr std::uint64_t exactBelow = 64;    ///< words below tell states apart by value, above by size
constexpr std::uint32_t lookAtClock = 64;   ///< scans between two looks at the clock
constexpr std::size_t newest = 8;           ///< states that are chosen more often
constexpr int barrenRuns = 50000;           ///< without a new state, after which the exploration is at its end
constexpr std::size_t mostConstants = 200;  ///< of the program, as values of words
constexpr std::uint32_t noStep = ~std::uint32_t{0};

}  // namespace

class Exploration::Impl {
 public:
  Impl(const Program& program, RunSpace space, const std::vector<Property>& assumptions,
       const std::vector<Property>& goals, std::vector<std::size_t> wanted, std::uint64_t seed)
      : program_(program),
        choices_(space.choices),
        assumptions_(assumptions),
        goals_(goals),
        range_(space.time),
        random_(seed),
        simulator_(program, optionsFor(choices_), &outside_),
        domain_(outside_),
        inputs_(std::move(space.inputs)),
        wanted_(std::move(wanted)),
        found_(goals.size()) {
    collectState(space.state);
    collectConstants();
    State& start = states_.emplace_back();
    start.store = simulator_.store();
    start.inputs.assign(inputs_.size(), 0);
    for (const Property& property : assumptions_) {
      start.assumptions.emplace_back(property);
      notePatience(property);
    }
    for (const std::size_t goal : wanted_) {
      start.goals.emplace_back(goals_[goal]);
      notePatience(goals_[goal]);
    }
    seen_.insert(signatureOf(start.store).bits);
    hasNewWord(start.store);
    isHigher(start.store);
  }

  void withdraw(std::size_t goal) { withdrawn_.insert(goal); }
  const std::optional<Witness>& found(std::size_t goal) const { return found_[goal]; }

  bool search(Clock::time_point deadline, const std::atomic<bool>& cancel, std::optional<std::size_t> goal) {
    const auto isOver = [&] { return cancel.load(std::memory_order_relaxed) || Clock::now() >= deadline; };
    while (!isOver()) {
      if (goal ? found_[*goal].has_value() : isAllFound()) return true;
      if (barren_ > barrenRuns) return false;
      const std::size_t from = choose();
      for (int i = 0; i < shortRuns && !isOver(); ++i) explore(from, 1U + (random_() & 1U), isOver);
      explore(from, (random_() % patience == 0 ? 16U : 1U) << (random_() % longestStretch), isOver);
    }
    return true;
  }

 private:
  /// Scans with the same inputs and length, made from where another step ended.
  struct Step {
    std::uint32_t before = noStep;
    std::uint32_t repeats = 0;
    std::uint32_t lengthMs = 0;
    std::vector<std::uint64_t> inputs;
  };
  struct State {
    Concrete::Store store;
    std::vector<Follower> assumptions, goals;
    std::vector<std::uint64_t> inputs;
    std::uint32_t step = noStep;  ///< that led here; noStep: power-up
    std::uint32_t chosen = 0;
  };
  /// Nothing comes from outside but inputs.
  struct StillOutside final : Outside {
    std::uint64_t external(const ExternalSite& site, int) override { return quietExternal(site); }
    void report(Hazard, const Instruction*) override {}
  };
  struct Word {
    Place place;
    bool isTime = false;
    std::uint64_t highest = 0;
    std::unordered_set<std::uint64_t> sizes{};
  };

  static SimulatorOptions optionsFor(const Choices& choices) {
    SimulatorOptions options;
    options.choices = choices;
    return options;
  }

  // ---- What there is -----------------------------------------------------------------------------------

  /// Timers count by themselves; edge memories follow from the rest.
  void collectState(const std::vector<Place>& state) {
    for (const Place& p : state) {
      const bool isOfProgram = p.isRegister ? p.reg == Reg::TimerBit || p.reg == Reg::CounterBit ||
                                                  p.reg == Reg::CounterCurrent || p.reg == Reg::Accumulator ||
                                                  p.reg == Reg::TimerCurrent || p.reg == Reg::TimerRunning
                                            : p.area != Area::SM && p.area != Area::L;
      if (!isOfProgram) continue;
      const bool isTime = p.isRegister && (p.reg == Reg::TimerCurrent || p.reg == Reg::TimerRunning);
      if (p.width == 1 && !isTime)
        bits_.push_back(p);
      else
        words_.push_back({p, isTime});
    }
  }

  /// A state that does not change any more can still show what is held for a time.
  void notePatience(const Property& property) {
    if (property.kind == PropertyKind::LeadsToScans)
      quietScans_ = std::max(quietScans_, property.bound);
    else
      longestHeld_ = std::max(longestHeld_, property.bound);
    for (const Expr* expr : {&property.first, &property.second}) {
      for (const ExprNode& node : expr->nodes) longestHeld_ = std::max(longestHeld_, node.milliseconds);
    }
  }

  void collectConstants() {
    std::set<std::uint64_t> values{0, 1};
    const auto add = [&](std::int64_t value) {
      for (const std::int64_t v : {value - 1, value, value + 1}) values.insert(static_cast<std::uint64_t>(v));
    };
    for (const Pou& pou : program_.pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          for (const Operand& operand : instruction.operands) {
            if (operand.kind == OperandKind::Constant && values.size() < mostConstants) add(operand.value);
          }
        }
      }
    }
    for (const std::vector<Property>* properties : {&goals_, &assumptions_}) {
      for (const Property& property : *properties) {
        for (const Expr* expr : {&property.first, &property.second}) {
          for (const ExprNode& node : expr->nodes) {
            if (node.op == ExprOp::Constant && values.size() < mostConstants) add(node.value);
          }
        }
      }
    }
    constants_.assign(values.begin(), values.end());
  }

  // ---- What is new -------------------------------------------------------------------------------------

  static std::uint64_t read(const Concrete::Store& store, const Place& p) {
    if (p.isRegister) return store.get(p.reg, p.at);
    return p.width == 1 ? store.load(p.area, p.byte() * 8 + p.bit(), 1) : store.load(p.area, p.at, p.width);
  }
  static std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
    return hash ^ hash >> 29;
  }

  /// The bits of a state; `all`: everything in which time shows as well, timers up to their presets.
  struct Signature {
    std::uint64_t bits = 0, all = 0;
  };
  Signature signatureOf(const Concrete::Store& store) const {
    Signature s;
    std::uint64_t packed = 0;
    int count = 0;
    for (const Place& p : bits_) {
      packed = packed << 1 | read(store, p);
      if (++count % 64 == 0) s.bits = mix(s.bits, std::exchange(packed, 0));
    }
    s.bits = mix(s.bits, packed);
    s.all = s.bits;
    for (const Word& word : words_) {
      std::uint64_t value = read(store, word.place);
      if (word.place.isRegister && word.place.reg == Reg::TimerCurrent)
        value = std::min(value, store.get(Reg::TimerPreset, word.place.at));
      s.all = mix(s.all, value);
    }
    return s;
  }
  /// Whether some word has a value, or above some size a size, that it has not had before.
  bool hasNewWord(const Concrete::Store& store) {
    bool result = false;
    for (Word& word : words_) {
      if (word.isTime) continue;
      const std::uint64_t value = read(store, word.place);
      const std::uint64_t size =
          value < exactBelow ? value : exactBelow + static_cast<std::uint64_t>(std::bit_width(value));
      result = word.sizes.insert(size).second || result;
    }
    return result;
  }
  bool isHigher(const Concrete::Store& store) {
    bool result = false;
    for (Word& word : words_) {
      if (word.isTime) continue;
      const std::uint64_t value = read(store, word.place);
      result = result || value > word.highest;
      word.highest = std::max(word.highest, value);
    }
    return result;
  }

  // ---- Running -----------------------------------------------------------------------------------------

  bool isAllFound() const {
    return std::none_of(wanted_.begin(), wanted_.end(), [&](std::size_t g) { return isOpen(g); });
  }
  bool isOpen(std::size_t goal) const { return !found_[goal] && !withdrawn_.contains(goal); }

  /// Seldom chosen states first, then those that came last.
  std::size_t choose() {
    if (random_() % 4 == 0) return states_.size() - 1 - random_() % std::min<std::size_t>(states_.size(), newest);
    std::size_t best = random_() % states_.size();
    for (int i = 0; i < 5; ++i) {
      const std::size_t other = random_() % states_.size();
      if (states_[other].chosen < states_[best].chosen ||
          (states_[other].chosen == states_[best].chosen && other > best))
        best = other;
    }
    return best;
  }

  std::uint64_t anyValue(int width) {
    if (width == 1) return random_() & 1U;
    const std::uint64_t value = random_() % 4 == 0 ? random_() : constants_[random_() % constants_.size()];
    return value & Graph::maskOf(width);
  }
  /// Those of that state or of another one, a few of them changed, or any.
  std::vector<std::uint64_t> chosenInputs(std::vector<std::uint64_t> values) {
    if (values.empty()) return values;
    const std::uint64_t kind = random_() % 8;
    if (kind < 2) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = anyValue(inputs_[i].width);
      return values;
    }
    if (kind < 4) values = states_[random_() % states_.size()].inputs;
    for (std::uint64_t i = kind; i < 7; ++i) {
      const std::size_t at = random_() % values.size();
      values[at] = inputs_[at].width == 1 ? values[at] ^ 1U : anyValue(inputs_[at].width);
    }
    return values;
  }
  std::uint32_t chosenLength() {
    const std::uint64_t kind = random_() % 10;
    return kind == 0 ? range_.low : kind < 3 ? std::clamp<std::uint32_t>(10, range_.low, range_.high) : range_.high;
  }

  void restore(const State& from) {
    simulator_.setStore(from.store);
    nowAssumed_ = std::vector<Follower>(from.assumptions);
    nowGoals_ = std::vector<Follower>(from.goals);
  }
  void write(const std::vector<std::uint64_t>& values) {
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      for (const ScanInput& input : inputs_[i].operands) simulator_.write(input.operand, input.valueIn(values[i]));
    }
  }
  ReplayScan scanOf(const Step& step) const {
    ReplayScan scan;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      for (const ScanInput& input : inputs_[i].operands)
        scan.inputs.push_back({input.operand, input.valueIn(step.inputs[i])});
    }
    scan.lengthMs = step.lengthMs;
    scan.repeats = step.repeats;
    return scan;
  }

  enum class Went { On, Ended, Broken };
  /// One scan. Broken: an assumption does not hold in it. Goals that it shows are added to `shown`.
  Went scan(const ReplayScan& script, bool isFirst, std::vector<std::size_t>& shown) {
    simulator_.scan({.lengthUs = script.lengthMs * 1000, .script = &script.script});
    if (!hasScanEnd(simulator_.store())) return Went::Ended;
    for (Follower& assumption : nowAssumed_) {
      if (!assumption.evaluate(domain_, simulator_.store(), script, isFirst)) return Went::Broken;
    }
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (isOpen(wanted_[i]) && nowGoals_[i].evaluate(domain_, simulator_.store(), script, isFirst))
        shown.push_back(wanted_[i]);
    }
    return simulator_.isRunning() ? Went::On : Went::Ended;
  }

  /// One run: inputs stay, time passes. Where something new comes, the run goes on from a kept state.
  template <class IsOver>
  void explore(std::size_t from, std::uint32_t most, const IsOver& isOver) {
    ++states_[from].chosen;
    Step step{states_[from].step, 0, chosenLength(), chosenInputs(states_[from].inputs)};
    restore(states_[from]);
    write(step.inputs);
    const ReplayScan script = scanOf(step);
    std::vector<std::pair<std::size_t, Step>> fronts;
    std::vector<std::size_t> shown;
    std::uint64_t last = signatureOf(simulator_.store()).all;
    bool isHigh = false;
    bool isBarren = true;
    std::int64_t quiet = 0;
    for (std::uint32_t n = 1; n <= most; ++n) {
      const Went went = scan(script, step.before == noStep && step.repeats == 0, shown);
      if (went == Went::Broken) break;
      ++step.repeats;
      if (!shown.empty()) keepWitnesses(step, shown);
      if (went == Went::Ended) break;
      const Signature now = signatureOf(simulator_.store());
      isHigh = isHigher(simulator_.store()) || isHigh;
      if (hasNewWord(simulator_.store()) || seen_.insert(now.bits).second) {
        if (step.repeats > 1) fronts.emplace_back(from, step);
        from = keep(step);
        step.before = states_[from].step;
        step.repeats = 0;
        isBarren = isHigh = false;
      }
      quiet = now.all == last ? quiet + 1 : 0;
      if (quiet > quietScans_ && quiet * step.lengthMs > longestHeld_) break;
      last = now.all;
      if (n % lookAtClock == 0 && isOver()) break;
    }
    if (isHigh && step.repeats > 0 && simulator_.isRunning()) {
      isBarren = false;
      keep(step);
    }
    barren_ = isBarren ? barren_ + 1 : 0;
    for (const auto& [state, ahead] : fronts) keepFront(state, ahead);
  }

  /// The state one scan before that step ends.
  void keepFront(std::size_t from, Step step) {
    if (states_[from].step != step.before) return;  // has gone from the pool
    restore(states_[from]);
    write(step.inputs);
    const ReplayScan script = scanOf(step);
    std::vector<std::size_t> shown;
    --step.repeats;
    for (std::uint32_t n = 0; n < step.repeats; ++n) {
      if (scan(script, step.before == noStep && n == 0, shown) != Went::On) return;
    }
    keep(step);
  }

  /// The state of the simulator, as the end of that step. Where the pool is full one that was chosen often goes.
  std::size_t keep(const Step& step) {
    std::size_t at = states_.size();
    if (at < mostStates) {
      states_.emplace_back();
    } else {
      at = 1 + random_() % (mostStates - 1);
      for (int i = 0; i < 5; ++i) {
        const std::size_t other = 1 + random_() % (mostStates - 1);
        if (states_[other].chosen > states_[at].chosen) at = other;
      }
    }
    State& state = states_[at];
    state.store = simulator_.store();
    state.assumptions = std::vector<Follower>(nowAssumed_);
    state.goals = std::vector<Follower>(nowGoals_);
    state.inputs = step.inputs;
    state.chosen = 0;
    state.step = static_cast<std::uint32_t>(steps_.size());
    steps_.push_back(step);
    return at;
  }

  void keepWitnesses(const Step& last, std::vector<std::size_t>& shown) {
    std::vector<ReplayScan> scans{scanOf(last)};
    for (std::uint32_t at = last.before; at != noStep; at = steps_[at].before) scans.push_back(scanOf(steps_[at]));
    std::reverse(scans.begin(), scans.end());
    for (const std::size_t goal : shown)
      found_[goal] = Judge(program_, choices_, assumptions_, goals_[goal]).witness(scans, std::nullopt);
    shown.clear();
  }

  const Program& program_;
  const Choices choices_;
  const std::vector<Property>& assumptions_;
  const std::vector<Property>& goals_;
  const TimeRange range_;
  std::mt19937_64 random_;
  StillOutside outside_;
  Simulator simulator_;
  Concrete domain_;
  const std::vector<RunSpace::Input> inputs_;
  std::vector<Place> bits_;
  std::vector<Word> words_;
  std::vector<std::uint64_t> constants_;
  const std::vector<std::size_t> wanted_;
  std::set<std::size_t> withdrawn_;
  std::vector<std::optional<Witness>> found_;
  std::deque<State> states_;
  std::deque<Step> steps_;
  std::unordered_set<std::uint64_t> seen_;
  std::vector<Follower> nowAssumed_, nowGoals_;
  std::int64_t quietScans_ = 2;   ///< that some property waits
  std::int64_t longestHeld_ = 0;  ///< ms
  int barren_ = 0;                ///< runs since something new came
};

Exploration::Exploration(const Program& program, RunSpace space, const std::vector<Property>& assumptions,
                         const std::vector<Property>& goals, std::vector<std::size_t> wanted, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(program, std::move(space), assumptions, goals, std::move(wanted), seed)) {}
Exploration::~Exploration() = default;
void Exploration::withdraw(std::size_t goal) { impl_->withdraw(goal); }
bool Exploration::search(Clock::time_point deadline, const std::atomic<bool>& cancel, std::optional<std::size_t> goal) {
  return impl_->search(deadline, cancel, goal);
}
const std::optional<Witness>& Exploration::found(std::size_t goal) const { return impl_->found(goal); }

ExplorationThread::ExplorationThread(Exploration& exploration, std::size_t goal,
                                     Exploration::Clock::time_point deadline, std::function<void()> found)
    : exploration_(exploration), goal_(goal), thread_([this, deadline, found = std::move(found)] {
        exploration_.search(deadline, cancel_, goal_);
        if (exploration_.found(goal_)) found();
      }) {}

bool ExplorationThread::end() {
  cancel_ = true;
  if (thread_.joinable()) thread_.join();
  return exploration_.found(goal_).has_value();
}

}  // namespace rungproof
