// Findings about blocks whose code is shown to nobody: they name block and network, and say no more of a statement than
// the rule's title. Tested by tests/s7project/protected_test.cpp.
#pragma once

#include <vector>

#include "ir/finding.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Whether the statements of the block are shown to nobody.
bool isCodeHidden(const Program& program, const Pou& pou);
/// Whether the program has such blocks.
bool hasHiddenCode(const Program& program);

/// The program with these blocks empty, for who asks what the others name.
Program withoutHiddenCode(const Program& program);

void hideProtected(const Program& program, std::vector<Finding>& findings);

}  // namespace rungproof
