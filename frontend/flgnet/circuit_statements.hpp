// A circuit as the statements that the editor's compiler writes for it (003:14-130, ir/s7300/fbd_box.hpp; general
// knowledge): logic as strings with parentheses, boxes with JNB around them, what is read in several places kept in
// bits of local memory behind the declared data. Parts that nothing reads from are run in the order of the file; each
// of them runs what it reads from first. Part of frontend/flgnet.
#pragma once

#include <set>

#include "frontend/flgnet/circuit.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::flgnet {

/// Labels that boxes need are numbered over the block.
struct BoxLabels {
  std::set<std::string> taken;  ///< those of the block itself
  int last = 0;
};

/// Appends the statements to the network; false if something was reported.
bool writeStatements(const Circuit& circuit, BoxLabels& labels, SyntaxSink& sink, step7::NetworkSyntax& network);

}  // namespace rungproof::flgnet
