// The pool of an exploration: states, each with the way to it, and the choice of where to go on. A state is new if its
// bits have not stood so together before, or if some word has a value that it never had. Also kept is the state in
// front of a change that came by itself: whatever happens in the very scan in which a timer ends starts there.
// What is run is the World's business: one program (exploration.cpp) or two (equivalence/pair_exploration.cpp).
// Covered by tests/prover/exploration_test.cpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <deque>
#include <random>
#include <set>
#include <unordered_set>
#include <vector>

#include "analysis/schedule/schedule.hpp"
#include "analysis/witness/run_space.hpp"
#include "engine/replay.hpp"
#include "engine/simulator.hpp"

namespace rungproof {

/// Scans with the same inputs and length, made from where another step ended.
struct RunStep {
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  std::uint32_t before = none;
  std::uint32_t repeats = 0;
  std::uint32_t lengthMs = 0;
  std::vector<std::uint64_t> inputs;  ///< by input of the pool
};

/// How a scan went. Broken: an assumption does not hold in it. Ended: nothing comes after it.
enum class Went : std::uint8_t { On, Ended, Broken };

/// Nothing comes from outside but inputs.
struct StillOutside final : Outside {
  std::uint64_t external(const ExternalSite& site, int) override { return quietExternal(site); }
  void report(Hazard, const Instruction*) override {}
};

/// Each read of an analog input in a scan finds the same, which is one way in which a module may answer.
inline SimulatorOptions stillOptions(const Choices& choices) {
  SimulatorOptions options;
  options.choices = choices;
  options.choices.set(choiceInfo(Choice::AnalogSampling).key, "each-scan");
  return options;
}

/// A place of one of the programs that are run.
struct PoolCell {
  Place place;
  std::size_t program = 0;
};

/// What of a program's state tells states apart. Timers count by themselves; edge memories follow from the rest.
inline bool isTimeCell(const Place& p) {
  return p.isRegister && (p.reg == Reg::TimerCurrent || p.reg == Reg::TimerRunning || p.reg == Reg::S5Rest);
}
inline bool tellsStatesApart(const Place& p) {
  if (!p.isRegister) return p.area != Area::SM && p.area != Area::L;
  return isTimeCell(p) || p.reg == Reg::TimerBit || p.reg == Reg::CounterBit || p.reg == Reg::CounterCurrent ||
         p.reg == Reg::Accumulator;
}

/// Constants that stand in a program, and their neighbours, as values of words.
class PoolConstants {
 public:
  void add(std::int64_t value) {
    if (values_.size() >= schedule::explorationConstants) return;
    for (const std::int64_t v : {value - 1, value, value + 1}) values_.insert(static_cast<std::uint64_t>(v));
  }
  void add(const Program& program) {
    for (const Pou& pou : program.pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          for (const Operand& operand : instruction.operands) {
            if (operand.kind == OperandKind::Constant) add(operand.value);
          }
        }
      }
    }
  }
  const std::set<std::uint64_t>& values() const { return values_; }

 private:
  std::set<std::uint64_t> values_{0, 1};
};

/// A World has
///   Snapshot, a value; snapshot() and restore(Snapshot): the state of its programs and of all that follows their runs
///   store(program): memory of a program
///   begin(step): the scans to come are those of the step
///   scan(isFirst): one of them
///   hasShown(): the scans since restore() have shown something; keepShown(way): takes it, with the steps from power-up
template <class World>
class StatePool {
 public:
  /// `widths`: of the inputs.
  StatePool(World& world, const TimeRange& range, std::vector<int> widths, const std::vector<PoolCell>& cells,
            const PoolConstants& constants, std::uint64_t seed)
      : world_(world),
        range_(range),
        random_(seed),
        widths_(std::move(widths)),
        constants_(constants.values().begin(), constants.values().end()) {
    for (const PoolCell& cell : cells) {
      if (!tellsStatesApart(cell.place) || !isIn(world_.store(cell.program), cell.place)) continue;
      if (cell.place.width == 1 && !isTimeCell(cell.place))
        bits_.push_back(cell);
      else
        words_.push_back({cell, isTimeCell(cell.place)});
    }
    states_.push_back({world_.snapshot(), std::vector<std::uint64_t>(widths_.size(), 0)});
    seen_.insert(signature().bits);
    hasNewWord();
    isHigher();
  }

  /// A state that does not change any more can still show something after so many scans, after so many ms.
  void notePatience(std::int64_t scans, std::int64_t milliseconds) {
    quietScans_ = std::max(quietScans_, scans);
    longestHeld_ = std::max(longestHeld_, milliseconds);
  }

  /// A run from power-up in long scans in which these inputs stay.
  template <class IsOver>
  void hold(std::vector<std::uint64_t> inputs, std::uint32_t scans, const IsOver& isOver) {
    explore(0, {RunStep::none, 0, range_.high, std::move(inputs)}, scans, isOver);
  }

  /// Until `isOver` or `isDone`; false when nothing new has come for long.
  template <class IsOver, class IsDone>
  bool search(const IsOver& isOver, const IsDone& isDone) {
    while (!isOver()) {
      if (isDone()) return true;
      if (barren_ > schedule::barrenRuns) return false;
      const std::size_t from = choose();
      for (int i = 0; i < schedule::shortRuns && !isOver(); ++i) vary(from, 1U + (random_() & 1U), isOver);
      vary(from, (random_() % schedule::longerStretch == 0 ? 16U : 1U) << (random_() % schedule::longestStretch),
           isOver);
    }
    return true;
  }

 private:
  struct State {
    typename World::Snapshot snapshot;
    std::vector<std::uint64_t> inputs;
    std::uint32_t step = RunStep::none;  ///< that led here; none: power-up
    std::uint32_t chosen = 0;
  };
  struct Word {
    PoolCell cell;
    bool isTime = false;
    std::uint64_t highest = 0;
    std::unordered_set<std::uint64_t> sizes{};
  };

  // ---- What is new -------------------------------------------------------------------------------------

  static bool isIn(const Concrete::Store& store, const Place& p) { return !p.isRegister || p.at < store.count(p.reg); }
  std::uint64_t read(const PoolCell& cell) const {
    const Concrete::Store& store = world_.store(cell.program);
    const Place& p = cell.place;
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
  Signature signature() const {
    Signature s;
    std::uint64_t packed = 0;
    int count = 0;
    for (const PoolCell& cell : bits_) {
      packed = packed << 1 | read(cell);
      if (++count % 64 == 0) s.bits = mix(s.bits, std::exchange(packed, 0));
    }
    s.bits = mix(s.bits, packed);
    s.all = s.bits;
    for (const Word& word : words_) {
      std::uint64_t value = read(word.cell);
      const Place& place = word.cell.place;
      if (place.isRegister && place.reg == Reg::TimerCurrent)
        value = std::min(value, world_.store(word.cell.program).get(Reg::TimerPreset, place.at));
      s.all = mix(s.all, value);
    }
    return s;
  }
  /// Whether some word has a value, or above some size a size, that it has not had before.
  bool hasNewWord() {
    bool result = false;
    for (Word& word : words_) {
      if (word.isTime) continue;
      const std::uint64_t value = read(word.cell);
      const std::uint64_t size = value < schedule::exactBelow
                                     ? value
                                     : schedule::exactBelow + static_cast<std::uint64_t>(std::bit_width(value));
      result = word.sizes.insert(size).second || result;
    }
    return result;
  }
  bool isHigher() {
    bool result = false;
    for (Word& word : words_) {
      if (word.isTime) continue;
      const std::uint64_t value = read(word.cell);
      result = result || value > word.highest;
      word.highest = std::max(word.highest, value);
    }
    return result;
  }

  // ---- Running -----------------------------------------------------------------------------------------

  /// Seldom chosen states first, then those that came last.
  std::size_t choose() {
    if (random_() % 4 == 0)
      return states_.size() - 1 - random_() % std::min<std::size_t>(states_.size(), schedule::newestStates);
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
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = anyValue(widths_[i]);
      return values;
    }
    if (kind < 4) values = states_[random_() % states_.size()].inputs;
    for (std::uint64_t i = kind; i < 7; ++i) {
      const std::size_t at = random_() % values.size();
      values[at] = widths_[at] == 1 ? values[at] ^ 1U : anyValue(widths_[at]);
    }
    return values;
  }
  std::uint32_t chosenLength() {
    const std::uint64_t kind = random_() % 10;
    return kind == 0 ? range_.low : kind < 3 ? std::clamp<std::uint32_t>(10, range_.low, range_.high) : range_.high;
  }

  template <class IsOver>
  void vary(std::size_t from, std::uint32_t most, const IsOver& isOver) {
    const std::uint32_t lengthMs = chosenLength();
    explore(from, {states_[from].step, 0, lengthMs, chosenInputs(states_[from].inputs)}, most, isOver);
  }

  /// One run: inputs stay, time passes. Where something new comes, the run goes on from a kept state.
  template <class IsOver>
  void explore(std::size_t from, RunStep step, std::uint32_t most, const IsOver& isOver) {
    ++states_[from].chosen;
    world_.restore(states_[from].snapshot);
    world_.begin(step);
    std::vector<std::pair<std::size_t, RunStep>> fronts;
    std::uint64_t last = signature().all;
    bool isHigh = false;
    bool isBarren = true;
    std::int64_t quiet = 0;
    bool isOn = true;
    for (std::uint32_t n = 1; n <= most; ++n) {
      const Went went = world_.scan(step.before == RunStep::none && step.repeats == 0);
      isOn = went == Went::On;
      if (went == Went::Broken) break;
      ++step.repeats;
      if (world_.hasShown()) world_.keepShown(wayTo(step));
      if (went == Went::Ended) break;
      const Signature now = signature();
      isHigh = isHigher() || isHigh;
      if (hasNewWord() || seen_.insert(now.bits).second) {
        if (step.repeats > 1) fronts.emplace_back(from, step);
        from = keep(step);
        step.before = states_[from].step;
        step.repeats = 0;
        isBarren = isHigh = false;
      }
      quiet = now.all == last ? quiet + 1 : 0;
      if (quiet > quietScans_ && quiet * step.lengthMs > longestHeld_) break;
      last = now.all;
      if (n % schedule::exploredScansBetweenLooks == 0 && isOver()) break;
    }
    if (isHigh && step.repeats > 0 && isOn) {
      isBarren = false;
      keep(step);
    }
    barren_ = isBarren ? barren_ + 1 : 0;
    for (const auto& [state, ahead] : fronts) keepFront(state, ahead);
  }

  /// The state one scan before that step ends.
  void keepFront(std::size_t from, RunStep step) {
    if (states_[from].step != step.before) return;  // has gone from the pool
    world_.restore(states_[from].snapshot);
    world_.begin(step);
    --step.repeats;
    for (std::uint32_t n = 0; n < step.repeats; ++n) {
      if (world_.scan(step.before == RunStep::none && n == 0) != Went::On) return;
    }
    keep(step);
  }

  /// The state of the world, as the end of that step. Where the pool is full one that was chosen often goes.
  std::size_t keep(const RunStep& step) {
    State state{world_.snapshot(), step.inputs, static_cast<std::uint32_t>(steps_.size()), 0};
    steps_.push_back(step);
    if (states_.size() < schedule::exploredStates) {
      states_.push_back(std::move(state));
      return states_.size() - 1;
    }
    std::size_t at = 1 + random_() % (schedule::exploredStates - 1);
    for (int i = 0; i < 5; ++i) {
      const std::size_t other = 1 + random_() % (schedule::exploredStates - 1);
      if (states_[other].chosen > states_[at].chosen) at = other;
    }
    states_[at] = std::move(state);
    return at;
  }

  /// The steps from power-up to the end of that one.
  std::vector<RunStep> wayTo(const RunStep& last) const {
    std::vector<RunStep> way{last};
    for (std::uint32_t at = last.before; at != RunStep::none; at = steps_[at].before) way.push_back(steps_[at]);
    std::reverse(way.begin(), way.end());
    return way;
  }

  World& world_;
  const TimeRange range_;
  std::mt19937_64 random_;
  const std::vector<int> widths_;
  const std::vector<std::uint64_t> constants_;
  std::vector<PoolCell> bits_;
  std::vector<Word> words_;
  std::deque<State> states_;
  std::deque<RunStep> steps_;
  std::unordered_set<std::uint64_t> seen_;
  std::int64_t quietScans_ = 2;
  std::int64_t longestHeld_ = 0;  ///< ms
  int barren_ = 0;                ///< runs since something new came
};

}  // namespace rungproof
