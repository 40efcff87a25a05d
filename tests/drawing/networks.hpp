// Test support: one network from STL text, drawings and instructions as short texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/drawing/lower.hpp"
#include "analysis/drawing/raise.hpp"
#include "ir/program.hpp"

namespace rungproof::testing {

/// MAIN with these statements (separated by "; ") as its only network, numbered.
Program programOf(std::string_view statements);
inline const Network& onlyNetwork(const Program& program) { return program.pous.at(0).networks.at(0); }

/// "LD I0.0; A I0.1; = Q0.0".
std::string textOf(const std::vector<Instruction>& instructions);
/// The statements as textOf writes them.
inline std::string spelled(std::string_view statements) {
  return textOf(onlyNetwork(programOf(statements)).instructions);
}
/// Elements from 1 on, inputs in parentheses, ~ for a circle: "1 LD I0.0(0); 2 = Q0.0(~1)". Element 0 is the rail.
std::string textOf(const Drawing& drawing);

/// Drawing of the statements, or "refused: " and the reason.
std::string raised(std::string_view statements, Form form);
/// Statements, drawn and lowered again.
std::string roundTrip(std::string_view statements, Form form);

/// An element given by the load form or mnemonic with operands, "LD I0.0", and its inputs ("" for gates).
Element element(Shape shape, std::string_view instruction, std::vector<Wire> inputs);
/// Lowered instructions, or "refused: " and the fault.
std::string lowered(const Drawing& drawing);

}  // namespace rungproof::testing
