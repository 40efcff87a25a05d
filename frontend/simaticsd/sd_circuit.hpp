// A NETWORK of a .s7dcl document as a circuit: rungs of items in series, wires that join them. What flows into a wire
// is ORed. Part of frontend/simaticsd. Tested by tests/step7/simatic_sd_test.cpp.
#pragma once

#include <optional>

#include "frontend/flgnet/circuit.hpp"
#include "frontend/simaticsd/sd_lexer.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::simaticsd {

/// Reads from behind the word NETWORK to END_NETWORK. Nothing if something was reported. `block`: its declarations give
/// types that no template names.
std::optional<flgnet::Circuit> readSdNetwork(step7::Cursor& cursor, const step7::BlockSyntax& block, SyntaxSink& sink);

}  // namespace rungproof::simaticsd
