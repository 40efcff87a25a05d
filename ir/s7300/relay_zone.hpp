// Which statement ends a zone of the master control relay. MCR( has a role of its own (statement_role.hpp). Tested by
// tests/rules/nesting_rules_test.cpp.
#pragma once

#include "ir/s7300/statement_role.hpp"

namespace rungproof {

/// )MCR, no MCRA and no MCRD.
inline bool closesRelay(const Instruction& instruction) {
  return statementRole(instruction) == StatementRole::Relay && instruction.desc->stl == ")MCR";
}

}  // namespace rungproof
