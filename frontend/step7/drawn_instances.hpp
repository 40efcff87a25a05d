// Data blocks that calls in exports of TIA Portal name as their instance, where the export lacks the block or says no
// more of it than IEC_TIMER. The call says what they are instances of. Tested by tests/step7/tia_instance_test.cpp.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "frontend/step7/syntax.hpp"

namespace rungproof::step7 {

/// A call with a data block as its instance.
struct DrawnInstance {
  BlockName of;      ///< the block that is called
  Operand instance;  ///< Symbol
  Span span;
};

/// Gives the data that `path` names the type of the called block if it is declared as IEC_TIMER or IEC_COUNTER, which
/// stand for any timer or counter. The first call decides.
void settleGeneric(std::vector<DeclarationSyntax>& declarations, std::span<const PathStep> path, const BlockName& of);

/// Does that for data blocks, and appends a block to the sources for each name that neither a source nor a symbol has.
/// The names of those, in their order.
std::vector<std::string> settleInstances(std::vector<SourceSyntax>& sources, std::span<const SymbolRow> symbols,
                                         std::span<const DrawnInstance> instances);

}  // namespace rungproof::step7
