// The engine for what needs nothing but repetition, such as the overflow of a word that counts messages: 64 runs at
// once in which the inputs stay as they are, or take turns between two choices. The choices come from the SAT solver:
// with each of them some latch changes, whatever the state. Looks for violations only, in a number of scans that
// depends on the system's size.
// Tested by tests/solver/held_inputs_test.cpp.
#include <algorithm>
#include <array>
#include <bit>
#include <set>

#include "analysis/bits/bit_simulator.hpp"
#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

class HeldInputs final : public Engine {
 public:
  explicit HeldInputs(const BitSystem& system) : system_(system), simulator_(system) {}

  Verdict advance(const Budget& budget) override {
    Verdict verdict;
    verdict.method = "held inputs";
    if (system_.gates.size() > schedule::largestUnrolled || system_.latches.empty()) isExhausted_ = true;
    if (!isExhausted_ && !areChosen_) choose(budget);
    while (!isExhausted_ && areChosen_ && !budget.isExhausted()) {
      const std::size_t turn = static_cast<std::size_t>(scan_) % 2;
      for (std::size_t i = 0; i < system_.inputs.size(); ++i) simulator_.setInput(i, lanes_[turn][i]);
      simulator_.evaluate();
      for (const Lit constraint : system_.constraints) live_ &= simulator_.value(constraint);
      std::uint64_t bad = 0;
      for (const Lit l : system_.bads) bad |= simulator_.value(l);
      if ((bad & live_) != 0) {
        verdict.answer = Answer::Violated;
        verdict.depth = scan_;
        verdict.trace = traceOf(std::countr_zero(bad & live_));
        CHECK(isViolation(system_, *verdict.trace), "a run of held inputs does not violate the property");
        isExhausted_ = true;
        return verdict;
      }
      ++scan_;
      simulator_.step();
      if (scan_ % 2 == 0) endThoseThatComeBack();
      const std::size_t done = static_cast<std::size_t>(scan_) * (system_.gates.size() + system_.latches.size());
      isExhausted_ = live_ == 0 || scan_ >= schedule::longestHeldRun || done > schedule::gatesOfHeldRuns;
    }
    return verdict;
  }
  bool isExhausted() const override { return isExhausted_; }

 private:
  using Choice = std::array<std::vector<bool>, 2>;

  /// Goes on with the next latch when there is time again.
  void choose(const Budget& budget) {
    if (!sat_) prepare();
    const std::size_t questions = 2 * std::min(schedule::latchesTried, system_.latches.size());
    for (; asked_ < questions && !budget.isExhausted(); ++asked_) {
      const std::size_t latch = asked_ / 2;
      const bool isHeld = asked_ % 2 == 0;
      std::set<Choice>& found = isHeld ? held_ : turning_;
      if (found.size() >= schedule::lanesOfOneKind) continue;
      // Held: from one scan to the next. In turns: from a scan to the second one after it.
      const Lit l = positive(system_.latches[latch].variable);
      const Lit changes = unrolling_->graph().addXor(unrolling_->at(isHeld ? 1 : 0, l), unrolling_->at(2, l));
      if (changes == falseLit) continue;
      const int some = cnf_->literal(changes);
      const Sat::Outcome outcome = sat_->solve({some, isHeld ? same_ : -same_}, budget);
      if (outcome == Sat::Outcome::Unknown) return;
      if (outcome != Sat::Outcome::Satisfiable) continue;
      Choice choice;
      for (const std::uint32_t v : system_.inputs) {
        for (std::size_t turn = 0; turn < 2; ++turn)
          choice[turn].push_back(cnf_->value(unrolling_->at(static_cast<int>(turn), positive(v))));
      }
      found.insert(std::move(choice));
    }
    if (asked_ < questions) return;
    areChosen_ = true;
    sat_.reset();
    start();
  }

  void prepare() {
    unrolling_ = std::make_unique<Unrolling>(system_, Unrolling::Start::Any);
    sat_ = std::make_unique<Sat>(Sat::Use::Many);
    cnf_ = std::make_unique<BitCnf>(unrolling_->graph(), *sat_);
    same_ = sat_->newVariable();
    for (const std::uint32_t v : system_.inputs) {
      const int a = cnf_->literal(unrolling_->at(0, positive(v))), b = cnf_->literal(unrolling_->at(1, positive(v)));
      sat_->add({-same_, -a, b});
      sat_->add({-same_, a, -b});
    }
    for (int frame = 0; frame < 2; ++frame) {
      for (const Lit constraint : system_.constraints) sat_->add({cnf_->literal(unrolling_->at(frame, constraint))});
    }
  }

  void start() {
    std::vector<const Choice*> choices;
    for (const std::set<Choice>* found : {&held_, &turning_}) {
      for (const Choice& choice : *found) choices.push_back(&choice);
    }
    isExhausted_ = choices.empty();
    for (std::size_t turn = 0; turn < 2 && !isExhausted_; ++turn) {
      lanes_[turn].assign(system_.inputs.size(), 0);
      for (std::size_t lane = 0; lane < 64; ++lane) {
        const std::vector<bool>& inputs = (*choices[lane % choices.size()])[turn];
        for (std::size_t i = 0; i < inputs.size(); ++i) lanes_[turn][i] |= std::uint64_t{inputs[i]} << lane;
      }
    }
    for (std::size_t i = 0; i < system_.latches.size(); ++i)
      simulator_.setLatch(i, system_.latches[i].init == LatchInit::One ? ~0ULL : 0);
  }

  /// A run that is in a state in which it was in the same turn shows nothing new. The state that is looked for is a
  /// later one each time, twice as late as before, so that it lies on the circle in the end.
  void endThoseThatComeBack() {
    std::uint64_t same = live_;
    for (std::size_t i = 0; i < earlier_.size() && same != 0; ++i) same &= ~(simulator_.latch(i) ^ earlier_[i]);
    if (!earlier_.empty()) live_ &= ~same;
    if (!std::has_single_bit(static_cast<unsigned>(scan_))) return;
    earlier_.resize(system_.latches.size());
    for (std::size_t i = 0; i < earlier_.size(); ++i) earlier_[i] = simulator_.latch(i);
  }

  BitTrace traceOf(int lane) const {
    BitTrace trace;
    for (const Latch& latch : system_.latches) trace.initial.push_back(latch.init == LatchInit::One);
    for (int scan = 0; scan <= scan_; ++scan) {
      std::vector<bool>& inputs = trace.inputs.emplace_back();
      for (const std::uint64_t lanes : lanes_[static_cast<std::size_t>(scan) % 2])
        inputs.push_back((lanes >> lane & 1U) != 0);
    }
    return trace;
  }

  const BitSystem& system_;
  BitSimulator simulator_;
  std::unique_ptr<Unrolling> unrolling_;
  std::unique_ptr<Sat> sat_;
  std::unique_ptr<BitCnf> cnf_;
  int same_ = 0;           ///< the inputs stay as they are
  std::size_t asked_ = 0;  ///< questions: two for each latch
  std::set<Choice> held_, turning_;
  bool areChosen_ = false, isExhausted_ = false;
  std::array<std::vector<std::uint64_t>, 2> lanes_;  ///< by turn, then input
  std::uint64_t live_ = ~0ULL;
  std::vector<std::uint64_t> earlier_;  ///< by latch: the state of all runs some time ago, in the first turn
  int scan_ = 0;
};

}  // namespace

std::unique_ptr<Engine> makeHeldInputs(const BitSystem& system, const EngineOptions&) {
  return std::make_unique<HeldInputs>(system);
}

}  // namespace rungproof
