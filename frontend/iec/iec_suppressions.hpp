// Comments `rungproof: ...` of IEC 61131-3 texts, which analysis/lint/suppress.hpp reads. Tested by
// tests/editor/suppression_edit_test.cpp.
#pragma once

#include "ir/iec/syntax.hpp"
#include "ir/program.hpp"

namespace rungproof::iec {

/// Adds them to the comments of the first block. Their place in the text says for what they speak: a block is lowered
/// once for each instance, and its declarations are no instructions.
void addSuppressions(Program& program, const ProjectSyntax& project);

}  // namespace rungproof::iec
