// Blocks, data blocks and types of SimaticML (TIA Openness) for an S7-300/400 as the syntax of a source: interfaces
// become declarations; ladder, FBD and statement list networks become statements. Networks in other languages, and what
// cannot be read, are reported and incomplete. Tested by tests/step7/drawing_test.cpp, statement_list_xml_test.cpp.
#pragma once

#include "frontend/flgnet/circuit.hpp"
#include "frontend/step7/drawn_instances.hpp"
#include "frontend/step7/syntax.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::flgnet {

struct DrawnSource {
  step7::SourceSyntax source;
  std::vector<step7::SymbolRow> symbols;        ///< names of the blocks that have a number
  std::vector<step7::DrawnInstance> instances;  ///< data blocks that calls name
};

/// What the instances of a network's calls are instances of: exports hold few of the data blocks, and IEC_TIMER alone
/// does not say which timer it is of.
void noteInstances(const Circuit& circuit, step7::BlockSyntax& block, std::vector<step7::DrawnInstance>& instances);

DrawnSource readBlocks(const SourceFile& file, SyntaxSink& sink);

}  // namespace rungproof::flgnet
