// IC3 on words, the second proof engine: states are abstracted to the truth of predicates over the words of the
// program, so that a lemma says "VW0 < VW2" where the engines on bits need a clause for every borrow. The scan stays
// exact; an abstract run that no concrete one follows gives new predicates. Constants may be as large as they like.
// Proofs are clauses over comparisons; violations are runs. Tested by tests/words/word_engine_test.cpp.
#pragma once

#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/engine_contract.hpp"

namespace rungproof {

enum class WordSolverKind : std::uint8_t { Fitting, Bits, Terms };  ///< Fitting: bits unless REAL operations matter

class WordEngine : public Engine {
 public:
  /// After Proved: clauses over the given system's graph, each a list of nodes of width 1; they hold initially, are
  /// kept by every scan together with the constraints, and exclude bad. Adds nodes to that graph.
  virtual std::vector<std::vector<Node>> clauses() = 0;
  /// After Violated: a run of the given system; inputs that the question does not depend on are 0.
  virtual const WordTrace& trace() const = 0;
};

/// Reads the system when it first works and again in clauses(); in between the system may not change.
std::unique_ptr<WordEngine> makeWordEngine(const TransitionSystem& system, std::size_t question,
                                           const EngineOptions& options,
                                           WordSolverKind solver = WordSolverKind::Fitting);

}  // namespace rungproof
