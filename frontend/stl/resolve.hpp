// Names to addresses, once all files are read: locals of the block, symbols of the tables, routines, system names.
// What stays OperandKind::Symbol is for rule SYM001. Tested by tests/reader/resolve_test.cpp.
#pragma once

#include "ir/program.hpp"

namespace rungproof {

/// Resolves every symbolic operand of the program. A resolved operand keeps the name in Operand::text. Numbers of
/// routines become constants. Names that no table knows but that read as an address with look-alike characters, or
/// as a ladder constant K9, are mended with a finding.
void resolveNames(Program& program);

}  // namespace rungproof
