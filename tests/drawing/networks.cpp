// Reads through the STL reader, so that operands are what the reader makes of them.
#include "tests/drawing/networks.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "frontend/input/project.hpp"
#include "ir/desc.hpp"

namespace rungproof::testing {

Program programOf(std::string_view statements) {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\n";
  for (const char c : statements) text += c == ';' ? '\n' : c;
  text +=
      "\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK "
      "SBR_0:SBR0\nVAR_INPUT\na:BOOL;\nb:BOOL;\nEND_VAR\nVAR_OUTPUT\nc:BOOL;\nEND_VAR\nBEGIN\n"
      "Network 1\nLD L0.0\n= L0.2\nEND_SUBROUTINE_BLOCK\n";
  Program program = readText("network.awl", std::move(text), ReadOptions{});
  for (const Finding& finding : program.findings) ADD_FAILURE() << statements << ": " << finding.message;
  program.number();
  return program;
}

namespace {

std::string textOf(const Desc& desc, const Operands& operands) {
  std::string text(desc.stl);
  for (std::size_t i = 0; i < operands.size(); ++i) text += (i == 0 ? " " : ", ") + toString(operands[i]);
  return text;
}

}  // namespace

std::string textOf(const std::vector<Instruction>& instructions) {
  std::string text;
  for (const Instruction& instruction : instructions)
    text += (text.empty() ? "" : "; ") + textOf(*instruction.desc, instruction.operands);
  return text;
}

std::string textOf(const Drawing& drawing) {
  std::string text;
  for (std::size_t i = 1; i < drawing.elements.size(); ++i) {
    const Element& element = drawing.elements[i];
    const std::string name = element.shape == Shape::And  ? "AND"
                             : element.shape == Shape::Or ? "OR"
                             : element.desc == nullptr    ? "RAIL"
                                                          : textOf(*element.desc, element.operands);
    std::string inputs;
    for (const Wire& wire : element.inputs)
      inputs += fmt::format("{}{}{}", inputs.empty() ? "" : ",", wire.negated ? "~" : "", wire.from);
    text += fmt::format("{}{} {}({})", text.empty() ? "" : "; ", i, name, inputs);
  }
  return text;
}

std::string raised(std::string_view statements, Form form) {
  const Program program = programOf(statements);
  const Raised result = raise(onlyNetwork(program), form);
  return result.drawing ? textOf(*result.drawing) : "refused: " + result.reason;
}

std::string roundTrip(std::string_view statements, Form form) {
  const Program program = programOf(statements);
  const Raised result = raise(onlyNetwork(program), form);
  return result.drawing ? lowered(*result.drawing) : "refused: " + result.reason;
}

Element element(Shape shape, std::string_view instruction, std::vector<Wire> inputs) {
  Element result;
  result.shape = shape;
  result.inputs = std::move(inputs);
  if (instruction.empty()) return result;
  const Program program = programOf(instruction);
  result.desc = onlyNetwork(program).instructions.at(0).desc;
  result.operands = onlyNetwork(program).instructions.at(0).operands;
  return result;
}

std::string lowered(const Drawing& drawing) {
  const Lowered result = lower(drawing);
  return result.fault ? "refused: " + result.fault->message : textOf(result.instructions);
}

}  // namespace rungproof::testing
