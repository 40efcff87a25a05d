// LD and FBD bodies to statements: each coil, variable and function block becomes a statement, in the order of
// execution that the drawing has (frontend/graphical/drawn_circuit.hpp). What is on the way to one result is an
// expression of it; a power flow that several take is computed once. Tested by tests/iec.
#pragma once

#include "frontend/graphical/drawn_model.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

/// Appends the statements to the body of the block, and to its variables the edge memories and flows that they need,
/// and instances that are drawn without a declaration. The statements of a circuit know how it was drawn.
void drawnStatements(Program& program, const DrawnNetwork& network, Form form, BlockSyntax& block, SyntaxSink& sink);

}  // namespace rungproof::iec
