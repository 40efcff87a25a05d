// Questions about one scan in words, asked of a solver that keeps what it learnt: nodes of width 1 become literals,
// clauses over literals are added for good, a question is a list of assumptions. Two solvers stand behind it: CaDiCaL
// on the blasted scan, and Z3 on bit-vectors and IEEE numbers, which alone knows REAL operations. Tested by
// tests/words/word_solver_test.cpp.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "analysis/bits/sat.hpp"
#include "analysis/graph/transition_system.hpp"

namespace rungproof {

class WordSolver {
 public:
  virtual ~WordSolver() = default;
  /// A literal, +v or -v, that is true exactly when the node (width 1, over states and inputs) is 1.
  virtual int literal(Node truth) = 0;
  virtual int newLiteral() = 0;
  virtual void add(std::span<const int> clause) = 0;
  /// `temporary` (if not empty) is a clause for this call only. Unknown when the budget is used up.
  virtual Sat::Outcome solve(std::span<const int> assumptions, const Budget& budget,
                             std::span<const int> temporary = {}) = 0;
  virtual bool failed(int literal) const = 0;      ///< after Unsatisfiable: the assumption belongs to the core
  virtual std::uint64_t value(Node variable) = 0;  ///< after Satisfiable
  /// Appends literals that say together that the variable has that value.
  virtual void fix(Node variable, std::uint64_t value, std::vector<int>& literals) = 0;
};

class BitBlast;

/// `blast` covers all variables that nodes will speak of; solvers may share it.
std::unique_ptr<WordSolver> makeBitSolver(BitBlast& blast);
std::unique_ptr<WordSolver> makeTermSolver(const Graph& graph);

}  // namespace rungproof
