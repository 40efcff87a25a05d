// The self-check: faults are planted one by one, and the declared properties are asked again. A fault that changes the
// outputs and that no property notices shows what the properties do not say. Published base rate for properties of
// practice: 44 % noticed. Covered by tests/selfcheck.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/proof/prover.hpp"
#include "analysis/selfcheck/fault.hpp"

namespace rungproof {

enum class FaultFate : std::uint8_t {
  Noticed,    ///< a property has a worse verdict
  Unnoticed,  ///< the outputs differ in some run, and in the time no property was seen to have a worse verdict
  NoEffect,   ///< proved: the outputs are the same in every run
  Undecided,  ///< whether it matters was not found out in the time
};

struct FaultResult {
  Fault fault;
  FaultFate fate = FaultFate::Undecided;
  std::string noticedBy;  ///< name of the first property that has a worse verdict
  std::string where;      ///< Unnoticed: an output that differs, "Q0.1 in scan 3"
};

struct SelfCheck {
  std::vector<FaultResult> results;  ///< of the faults that were tried
  std::size_t untried = 0;           ///< because of an interruption

  std::size_t count(FaultFate fate) const;
  /// Noticed ones among those that change the outputs, in percent; 100 if there are none.
  double share() const;
};

struct SelfCheckOptions {
  ProverOptions prover;
  double seconds = 0.5;  ///< for the properties of one fault, and for the comparison of its outputs
  double patience = 0;   ///< more than `seconds`: the same, once more, for a fault that was left undecided
  /// Which faults to plant; empty: all.
  std::vector<FaultKind> kinds{};
  std::function<void(std::size_t done, std::size_t total)> progress{};
};

/// `before`: the verdicts without a fault, in the order of the declared goals. Faults are tried on prover.jobs threads.
SelfCheck selfCheck(const Program& program, const PropertySet& set, const std::vector<ProofResult>& before,
                    const SelfCheckOptions& options);

}  // namespace rungproof
