// Bounded model checking: the engine for violations that need a search; it proves nothing.
#include "analysis/bits/bmc.hpp"

#include "ir/check.hpp"

namespace rungproof {

void BmcSearch::open() {
  opened_ = true;
  for (const Lit constraint : system_.constraints) {
    const Lit l = unrolling_.at(depth_, constraint);
    if (l != trueLit) sat_.add({cnf_.literal(l)});
  }
  bad_ = falseLit;
  for (const Lit bad : system_.bads) bad_ = unrolling_.graph().addOr(bad_, unrolling_.at(depth_, bad));
}

Verdict BmcSearch::search(int scans, const Budget& budget) {
  Verdict verdict;
  verdict.method = "BMC";
  while (depth_ < scans && !budget.isExhausted()) {
    if (!opened_) open();
    if (bad_ != falseLit) {
      const Sat::Outcome outcome = sat_.solve({cnf_.literal(bad_)}, budget);
      if (outcome == Sat::Outcome::Unknown) break;
      if (outcome == Sat::Outcome::Satisfiable) {
        verdict.answer = Answer::Violated;
        verdict.depth = depth_;
        verdict.trace = unrolling_.trace(depth_, cnf_);
        CHECK(isViolation(system_, *verdict.trace), "a BMC run does not violate the property");
        return verdict;
      }
      sat_.add({-cnf_.literal(bad_)});
    }
    opened_ = false;
    ++depth_;
  }
  verdict.depth = depth_;
  return verdict;
}

namespace {

class Bmc final : public Engine {
 public:
  Bmc(const BitSystem& system, const EngineOptions& options) : search_(system), bound_(options.bound) {}
  Verdict advance(const Budget& budget) override { return search_.search(bound_, budget); }
  bool isExhausted() const override { return search_.depth() >= bound_; }

 private:
  BmcSearch search_;
  const int bound_;
};

}  // namespace

std::unique_ptr<Engine> makeBmc(const BitSystem& system, const EngineOptions& options) {
  return std::make_unique<Bmc>(system, options);
}

}  // namespace rungproof
