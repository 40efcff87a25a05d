// Ladder in the short XML form of some verifiers: rungs with contacts and coils that name their variable as an
// attribute, and blocks whose pins do. Tested by tests/iec/rung_test.cpp.
#pragma once

#include "frontend/iec/iec_plcopen_chart.hpp"

namespace rungproof::iec {

/// Whether the element <LD> holds rungs of that form.
bool holdsRungs(const pugi::xml_node& ladder);
/// Its statements, rung by rung.
Statements rungStatements(PlcopenBodies& bodies, const pugi::xml_node& ladder, BlockSyntax& block);

}  // namespace rungproof::iec
