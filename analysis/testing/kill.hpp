// Planted faults and the tests that notice them: those of the self-check, and slips of operands, comparisons, constants
// and operators. What no test notices is compared with the program: it may change nothing. Covered by
// tests/tables/generate_command_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/equivalence/equivalence.hpp"
#include "analysis/proof/prover.hpp"
#include "analysis/selfcheck/fault.hpp"
#include "analysis/selfcheck/self_check.hpp"
#include "engine/testing/test_player.hpp"

namespace rungproof {

struct Mutant {
  std::string kind;
  Fault fault;
};

/// The faults of the self-check, then those of this file, in program order.
std::vector<Mutant> mutantsOf(const Program& program);

/// Whether a fault changes what outputs do, and a run on which it does. `prover`: its timeout is for the comparison.
Equivalence compareWithFault(const Program& program, const Program& mutant, const PropertySet& set,
                             const ProverOptions& prover);

struct KillResult {
  Mutant mutant;
  FaultFate fate = FaultFate::Undecided;
  std::string noticedBy;  ///< test
  std::string where;      ///< Unnoticed: an output that differs
};

struct KillOptions {
  TestPlayOptions play;
  ProverOptions prover;
  double seconds = 30;      ///< for all
  double patience = 0.5;    ///< for the comparison of one mutant that no test notices
  std::size_t most = 1000;  ///< mutants; evenly spread ones are taken of more
};

/// `tables`: tests that the program passes.
std::vector<KillResult> killMutants(const Program& program, const PropertySet& set,
                                    const std::vector<TestTable>& tables, const KillOptions& options);

}  // namespace rungproof
