// Untouched addresses: what a property names although no instruction, device, panel or data block writes it, usually
// the other end of a slip of the pen. Such a property is told so, and one that holds for any program holds vacuously.
// Covered by tests/prover/untouched_test.cpp.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/proof/prover.hpp"

namespace rungproof {

/// Says which addresses of a property nothing writes. What holds for any program, as `ask` finds, holds vacuously.
/// `broken` takes the rows at which an error of ours comes.
void noteUntouched(
    const Program& program, const PropertySet& set, const ProverOptions& options, std::vector<ProofResult>& rows,
    const std::function<ProofRun(const Program&, const PropertySet&, const ProverOptions&, const ProofProgress&)>& ask,
    const std::function<void(ProofResult&, const std::exception&)>& broken);

}  // namespace rungproof
