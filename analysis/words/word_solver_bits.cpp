// Words as bits: a node's literal is a gate of the blasted scan.
#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/bit_cnf.hpp"
#include "analysis/words/word_solver.hpp"

namespace rungproof {

namespace {

class BitSolver final : public WordSolver {
 public:
  explicit BitSolver(BitBlast& blast) : blast_(blast), sat_(Sat::Use::Many), cnf_(blast.bits(), sat_) {}

  int literal(Node truth) override {
    if (!blast_.contains(truth)) blast_.add({truth});
    return cnf_.literal(blast_.of(truth)[0]);
  }
  int newLiteral() override { return sat_.newVariable(); }
  void add(std::span<const int> clause) override { sat_.add(clause); }
  Sat::Outcome solve(std::span<const int> assumptions, const Budget& budget, std::span<const int> temporary) override {
    return sat_.solve(assumptions, budget, temporary);
  }
  bool failed(int literal) const override { return sat_.failed(literal); }
  std::uint64_t value(Node variable) override {
    std::uint64_t result = 0;
    int bit = 0;
    for (const Lit l : blast_.of(variable)) result |= static_cast<std::uint64_t>(cnf_.value(l)) << bit++;
    return result;
  }
  void fix(Node variable, std::uint64_t value, std::vector<int>& literals) override {
    int bit = 0;
    for (const Lit l : blast_.of(variable)) {
      // Bits that no clause mentions decide nothing.
      const int known = cnf_.known(l);
      if (known != 0) literals.push_back((value >> bit & 1U) != 0 ? known : -known);
      ++bit;
    }
  }

 private:
  BitBlast& blast_;
  Sat sat_;
  BitCnf cnf_;
};

}  // namespace

std::unique_ptr<WordSolver> makeBitSolver(BitBlast& blast) { return std::make_unique<BitSolver>(blast); }

}  // namespace rungproof
