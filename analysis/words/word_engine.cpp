// The strategy: block bad states at the top frame with all their predecessors; where a cube holds a state that is known
// to be reached, follow the run from there, which ends in a violation or in a refinement.
#include "analysis/words/word_engine.hpp"

#include <algorithm>
#include <deque>
#include <queue>
#include <set>

#include "analysis/bits/simulation_runs.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/words/linear_form.hpp"
#include "analysis/words/refinement.hpp"
#include "analysis/words/terms.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// States met in random runs, the first ones excepted.
std::vector<WordState> sampleStates(const WordCone& cone, const BitBlast& blast, std::uint64_t seed) {
  SimulationRuns runs(blast.bits(), seed);
  std::set<WordState> states;
  const std::size_t scans =
      std::min(schedule::wordEngineScans, schedule::wordEngineGates / (blast.bits().gates.size() + 1));
  for (std::size_t scan = 0; scan < scans && states.size() < schedule::wordEngineSamples && runs.choose(); ++scan) {
    const std::uint64_t live = runs.live();
    runs.step();
    if (scan > 4 && scan % 8 != 0) continue;
    for (int lane = 0; lane < 64 && states.size() < schedule::wordEngineSamples; ++lane) {
      if ((live >> lane & 1U) == 0) continue;
      WordState state(cone.system().states.size(), 0);
      for (std::uint32_t latch = 0; latch < blast.bits().latches.size(); ++latch) {
        const auto [word, bit] = blast.stateBit(latch);
        state[word] |= (runs.simulator().latch(latch) >> lane & 1U) << bit;
      }
      states.insert(std::move(state));
    }
  }
  return {states.begin(), states.end()};
}

/// Runs the cone on numbers.
class ConcreteScan {
 public:
  explicit ConcreteScan(const WordCone& cone) : cone_(cone), evaluator_(*cone.system().graph, rootsOf(cone)) {}
  /// False if a constraint is broken.
  bool run(const WordState& state, const std::vector<std::uint64_t>& inputs) {
    const TransitionSystem& system = cone_.system();
    for (std::size_t i = 0; i < state.size(); ++i) evaluator_.set(system.states[i].node, state[i]);
    for (std::size_t i = 0; i < inputs.size(); ++i) evaluator_.set(system.inputs[i], inputs[i]);
    evaluator_.run();
    return std::ranges::all_of(system.constraints, [&](Node n) { return evaluator_[n] != 0; });
  }
  bool isBad() const { return evaluator_[cone_.bad()] != 0; }
  WordState next() const {
    WordState state;
    for (const StateVariable& variable : cone_.system().states) state.push_back(evaluator_[variable.next]);
    return state;
  }

 private:
  static std::vector<Node> rootsOf(const WordCone& cone) {
    std::vector<Node> roots = cone.system().constraints;
    roots.push_back(cone.bad());
    for (const StateVariable& state : cone.system().states) {
      roots.push_back(state.node);
      roots.push_back(state.next);
    }
    roots.insert(roots.end(), cone.system().inputs.begin(), cone.system().inputs.end());
    return roots;
  }
  const WordCone& cone_;
  Evaluator evaluator_;
};

struct WordObligation {
  WordStep step;
  int successor = -1;  ///< obligation it leads to; -1: bad in this very scan
  int distance = 0;
};

class Ic3OnWords final : public WordEngine {
 public:
  Ic3OnWords(const TransitionSystem& given, std::size_t question, const EngineOptions& options, WordSolverKind solver)
      : given_(given), question_(question), options_(options), solver_(solver) {}

  Verdict advance(const Budget& budget) override {
    Verdict verdict;
    verdict.method = "IC3 on words";
    if (!cone_) build();
    if (isExhausted_) return verdict;
    frames_->setBudget(budget);
    try {
      while (!run(verdict)) {
        mostQueries_ *= 2;
        ++restarts_;
        build();
        frames_->setBudget(budget);
      }
    } catch (const Ic3Interrupted&) {
      verdict.depth = frames_->top();
    }
    return verdict;
  }
  bool isExhausted() const override { return isExhausted_; }

  std::vector<std::vector<Node>> clauses() override {
    std::vector<std::vector<Node>> result;
    for (const WordCube& cube : invariant_) {
      std::vector<Node>& clause = result.emplace_back();
      for (const Lit l : cube) clause.push_back(cone_->onGivenSystem(given_, predicates_->now(negate(l))));
    }
    return result;
  }
  const WordTrace& trace() const override { return trace_; }

 private:
  enum class Blocking : std::uint8_t { Done, Violated, Refined };

  void build() {
    concrete_.reset();
    frames_.reset();
    refinement_.reset();
    predicates_.reset();
    usesSamples_ = true;
    cone_ = std::make_unique<WordCone>(given_, question_);
    isExhausted_ = cone_->hasOpaque();
    if (isExhausted_) return;
    cone_->writeBadAs(linearForms(cone_->graph(), cone_->bad()));
    std::vector<Node> variables = cone_->system().inputs;
    for (const StateVariable& state : cone_->system().states) variables.push_back(state.node);
    blast_ = std::make_unique<BitBlast>(cone_->system(), std::vector<std::size_t>{0}, variables);
    const bool onBits = solver_ == WordSolverKind::Bits || (solver_ == WordSolverKind::Fitting && !cone_->hasReals());
    std::vector<WordState> samples;
    if (!cone_->hasReals()) samples = sampleStates(*cone_, *blast_, options_.seed + restarts_);
    predicates_ = std::make_unique<Predicates>(*cone_, std::move(samples));
    for (const Node n : syntacticPredicates(*cone_)) predicates_->add(n);
    refinement_ = std::make_unique<Refinement>(*cone_, *predicates_);
    frames_ = std::make_unique<WordFrames>(*cone_, *predicates_, onBits ? blast_.get() : nullptr);
    concrete_ = std::make_unique<ConcreteScan>(*cone_);
  }

  /// False if the search is to begin anew.
  bool run(Verdict& verdict) {
    for (;;) {
      while (std::optional<WordStep> bad = frames_->findBad(frames_->top())) {
        if (frames_->queries() > mostQueries_) return false;
        if (block(std::move(*bad)) != Blocking::Violated) continue;
        verdict.answer = Answer::Violated;
        verdict.depth = static_cast<int>(trace_.inputs.size()) - 1;
        return true;
      }
      frames_->addFrame();
      if (const std::optional<int> level = frames_->propagate()) {
        invariant_ = frames_->lemmas().above(*level);
        verdict.answer = Answer::Proved;
        return true;
      }
    }
  }

  /// Blocks the bad state at the top frame, with all its predecessors.
  Blocking block(WordStep bad) {
    obligations_.clear();
    using Entry = std::pair<std::pair<int, int>, int>;  // (level, distance), obligation
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto oblige = [&](WordStep step, int level, int successor) {
      const int distance = successor < 0 ? 0 : obligations_[static_cast<std::size_t>(successor)].distance + 1;
      obligations_.push_back({std::move(step), successor, distance});
      const int index = static_cast<int>(obligations_.size()) - 1;
      queue.push({{level, distance}, index});
      return meetsReached(index, level);
    };
    if (const Blocking result = oblige(std::move(bad), frames_->top(), -1); result != Blocking::Done) return result;
    while (!queue.empty()) {
      const auto [key, index] = queue.top();
      const int level = key.first;
      const WordCube cube = obligations_[static_cast<std::size_t>(index)].step.cube;
      if (frames_->lemmas().isBlocked(cube, level)) {
        queue.pop();
        if (level < frames_->top()) queue.push({{level + 1, key.second}, index});
        continue;
      }
      WordCube core;
      if (frames_->isInductive(cube, level - 1, true, &core)) {
        queue.pop();
        generalise(core, level - 1);
        int high = level;
        while (high < frames_->top() && frames_->isInductive(core, high, true, nullptr)) ++high;
        frames_->addLemma(core, high);
        if (high < frames_->top()) queue.push({{high + 1, key.second}, index});
      } else if (const Blocking result = oblige(frames_->step(cube), level - 1, index); result != Blocking::Done) {
        return result;
      }
    }
    return Blocking::Done;
  }

  /// Follows the run from a state of the obligation's cube that is initial or sampled, if there is one.
  Blocking meetsReached(int index, int level) {
    const WordStep& step = obligations_[static_cast<std::size_t>(index)].step;
    if (level == 0) return follow(step.state, index, true);
    if (const std::optional<WordState> initial = frames_->initialIn(step.cube)) return follow(*initial, index, true);
    if (!usesSamples_) return Blocking::Done;
    const std::optional<std::size_t> sample = predicates_->sampleIn(step.cube);
    return sample ? follow(predicates_->samples()[*sample], index, false) : Blocking::Done;
  }

  Blocking follow(WordState state, int index, bool isInitial) {
    WordState first = state;
    std::vector<std::vector<std::uint64_t>> inputs;
    for (; index >= 0; index = obligations_[static_cast<std::size_t>(index)].successor) {
      const WordObligation& obligation = obligations_[static_cast<std::size_t>(index)];
      const WordCube* goal =
          obligation.successor < 0 ? nullptr : &obligations_[static_cast<std::size_t>(obligation.successor)].step.cube;
      const auto leads = [&](const std::vector<std::uint64_t>& chosen) {
        return concrete_->run(state, chosen) &&
               (goal == nullptr ? concrete_->isBad() : predicates_->contains(*goal, concrete_->next()));
      };
      std::vector<std::uint64_t> chosen = obligation.step.inputs;
      if (!leads(chosen)) {
        const std::optional<std::vector<std::uint64_t>> others = frames_->inputsBetween(state, goal);
        if (!others) return refine(state, obligation.step, goal);
        chosen = *others;
        CHECK(leads(chosen), "the solver and the evaluation of a scan disagree");
      }
      inputs.push_back(std::move(chosen));
      state = concrete_->next();
    }
    if (!isInitial) {
      // A violation, but its beginning is not known: the search from the initial states will find it.
      usesSamples_ = false;
      return Blocking::Done;
    }
    record(first, inputs);
    return Blocking::Violated;
  }

  Blocking refine(const WordState& reached, const WordStep& step, const WordCube* goal) {
    Node node = goal == nullptr ? cone_->bad() : cone_->graph().constantNode(1, 1);
    if (goal != nullptr) {
      for (const Lit l : *goal) node = cone_->graph().make(Op::And, 1, node, predicates_->next(l));
    }
    for (const Node n : cone_->system().constraints) node = cone_->graph().make(Op::And, 1, node, n);
    if (!refinement_->refine(reached, step, node)) frames_->takeWholeCubes();
    return Blocking::Refined;
  }

  /// Shrinks a cube that is inductive relative to F_level to one with fewer literals.
  void generalise(WordCube& cube, int level) {
    WordCube order = cube;
    std::ranges::stable_sort(
        order, [&](Lit a, Lit b) { return frames_->lemmas().activity(a) < frames_->lemmas().activity(b); });
    for (const Lit drop : order) {
      if (cube.size() <= 1) break;
      if (!std::ranges::binary_search(cube, drop)) continue;
      WordCube smaller;
      std::ranges::copy_if(cube, std::back_inserter(smaller), [&](Lit l) { return l != drop; });
      WordCube core;
      if (predicates_->sampleIn(smaller) || frames_->initialIn(smaller) ||
          !frames_->isInductive(smaller, level, true, &core))
        continue;
      cube = std::move(core);
    }
  }

  void record(const WordState& first, const std::vector<std::vector<std::uint64_t>>& inputs) {
    for (const StateVariable& state : given_.states)
      trace_.initial.push_back(state.init == noNode ? 0 : (*given_.graph)[state.init].value);
    for (std::size_t i = 0; i < first.size(); ++i) trace_.initial[cone_->states()[i]] = first[i];
    for (const std::vector<std::uint64_t>& scan : inputs) {
      std::vector<std::uint64_t>& values = trace_.inputs.emplace_back(given_.inputs.size(), 0);
      for (std::size_t i = 0; i < scan.size(); ++i) values[cone_->inputs()[i]] = scan[i];
    }
  }

  const TransitionSystem& given_;
  const std::size_t question_;
  const EngineOptions options_;
  const WordSolverKind solver_;
  std::unique_ptr<WordCone> cone_;
  std::unique_ptr<BitBlast> blast_;
  std::unique_ptr<Predicates> predicates_;
  std::unique_ptr<Refinement> refinement_;
  std::unique_ptr<WordFrames> frames_;
  std::unique_ptr<ConcreteScan> concrete_;
  std::deque<WordObligation> obligations_;
  std::vector<WordCube> invariant_;
  WordTrace trace_;
  std::size_t mostQueries_ = schedule::firstRestart;
  std::uint64_t restarts_ = 0;
  bool usesSamples_ = true;
  bool isExhausted_ = false;
};

}  // namespace

std::unique_ptr<WordEngine> makeWordEngine(const TransitionSystem& system, std::size_t question,
                                           const EngineOptions& options, WordSolverKind solver) {
  return std::make_unique<Ic3OnWords>(system, question, options, solver);
}

}  // namespace rungproof
