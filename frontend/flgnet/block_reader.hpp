// Blocks, data blocks and types of SimaticML (TIA Openness) for an S7-300/400 as the syntax of a source: interfaces
// become declarations, ladder and FBD networks become statements. Networks in other languages, and what cannot be read,
// are reported and incomplete. Tested by tests/step7/drawing_test.cpp.
#pragma once

#include "frontend/step7/syntax.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::flgnet {

struct DrawnSource {
  step7::SourceSyntax source;
  std::vector<step7::SymbolRow> symbols;  ///< names of the blocks that have a number
};

DrawnSource readBlocks(const SourceFile& file, SyntaxSink& sink);

}  // namespace rungproof::flgnet
