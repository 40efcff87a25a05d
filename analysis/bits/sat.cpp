// CaDiCaL 1.5.3 behind the interface of the engines.
#include "analysis/bits/sat.hpp"

#include <cadical.hpp>
#include <new>

#include "ir/check.hpp"

namespace rungproof {

namespace {

/// CaDiCaL asks at every tenth decision; with long arithmetic these can be milliseconds apart.
class BudgetTerminator final : public CaDiCaL::Terminator {
 public:
  explicit BudgetTerminator(const Budget& budget) : budget_(budget) {}
  bool terminate() override {
    ended_ = ended_ || budget_.isExhausted();
    return ended_;
  }

 private:
  const Budget& budget_;
  bool ended_ = false;
};

}  // namespace

Sat::Sat(Use use) : solver_(std::make_unique<CaDiCaL::Solver>()) {
  solver_->set("quiet", 1);
  CHECK(solver_->set("profile", 0), "CaDiCaL knows the option");  // it asks for the time at each phase of a search
  solver_->set("lucky", 0);
  if (use == Use::Many) {
    for (const char* technique : {"walk", "probe", "elim", "subsume", "vivify", "ternary", "transred", "decompose",
                                  "condition", "cover", "block", "rephase", "compact"}) {
      CHECK(solver_->set(technique, 0), "CaDiCaL knows the option");
    }
  }
}

/// Where memory ends in a call, CaDiCaL is left half changed: it must neither be asked again nor taken down.
Sat::~Sat() {
  if (isBroken_) static_cast<void>(solver_.release());
}

template <class Work>
auto Sat::guarded(Work&& work) {
  if (isBroken_) throw std::bad_alloc();
  try {
    return work();
  } catch (const std::bad_alloc&) {
    isBroken_ = true;
    throw;
  }
}

void Sat::add(std::span<const int> clause) {
  guarded([&] {
    for (const int literal : clause) solver_->add(literal);
    solver_->add(0);
  });
}

Sat::Outcome Sat::solve(std::span<const int> assumptions, const Budget& budget, std::span<const int> temporary) {
  if (budget.isExhausted()) return Outcome::Unknown;
  BudgetTerminator terminator(budget);
  const int result = guarded([&] {
    // An interrupted call leaves both behind.
    solver_->reset_assumptions();
    solver_->reset_constraint();
    for (const int literal : assumptions) solver_->assume(literal);
    if (!temporary.empty()) {
      for (const int literal : temporary) solver_->constrain(literal);
      solver_->constrain(0);
    }
    solver_->connect_terminator(&terminator);
    const int ended = solver_->solve();
    solver_->disconnect_terminator();
    return ended;
  });
  if (result == 10) return Outcome::Satisfiable;
  if (result == 20) return Outcome::Unsatisfiable;
  return Outcome::Unknown;
}

bool Sat::value(int literal) const { return solver_->val(literal) > 0; }

bool Sat::failed(int literal) const { return solver_->failed(literal); }

void Sat::prefer(int literal) {
  guarded([&] { solver_->phase(literal); });
}

}  // namespace rungproof
