// Which compiled form of its meaning an instruction runs with on the reference engine.
#pragma once

#include "engine/concrete.hpp"
#include "ir/machine/dispatch.hpp"

namespace rungproof {

/// The function for this instruction: contacts and coils with a direct address have a form of their meaning that is
/// compiled for their area, all others the general one. nullptr for control instructions (ir/machine/scan.hpp).
Execute<Concrete> executionOf(const Instruction& instruction, StatementForm form);

}  // namespace rungproof
