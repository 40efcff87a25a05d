// Whether a program writes an operand by its direct address; pointers are not followed.
// Tested by tests/ir/written_operand_test.cpp.
#pragma once

#include "ir/program.hpp"

namespace rungproof {

/// What actual parameters of CALL count as: the block called may write them, or only reads them.
enum class Actuals : std::uint8_t { Written, Read };

bool isWritten(const Program& program, const Operand& operand, Actuals actuals);

}  // namespace rungproof
