// The syntax tree says what goes out; the symbols say where it lies.
#include "ir/iec/variables.hpp"

#include <algorithm>

#include "ir/iec/cpu.hpp"
#include "ir/iec/dialect.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof {

bool coversByte(const Operand& place, const Operand& byte) {
  const auto length = static_cast<std::uint32_t>(std::max(bytes(place.width), 1));
  return place.area == byte.area && place.offset <= byte.offset && byte.offset < place.offset + length;
}

Operand wholeVariable(const Program& program, const Operand& operand) {
  if (!isIec(program.target) || operand.area != Area::V) return operand;
  for (const Symbol& symbol : program.symbols) {
    if (symbol.address.kind == OperandKind::Direct && coversByte(symbol.address, operand)) return symbol.address;
  }
  return operand;
}

ProgramOutputs::ProgramOutputs(const Program& program) : program_(program) {
  if (program.syntax == nullptr) return;
  const auto goesOut = [](const iec::VariableSyntax& variable) {
    const bool isLocated = variable.address.size() > 1 && (variable.address[1] == 'Q' || variable.address[1] == 'q');
    return variable.section == iec::Section::Output || isLocated;
  };
  for (const iec::BlockSyntax& block : program.syntax->blocks) {
    if (block.kind != iec::BlockKind::Program) continue;
    for (const iec::VariableSyntax& variable : block.variables) {
      if (!goesOut(variable)) continue;
      // Each variable of a program has a symbol with the program in front; the bare name may be that of a program too.
      bool isRun = false;
      for (const iec::InstanceSyntax& instance : program.syntax->instances) {
        if (iec::foldedName(instance.type) != iec::foldedName(block.name)) continue;
        isRun = true;
        names_.insert(iec::foldedName(instance.name + "." + variable.name));
      }
      if (!isRun) names_.insert(iec::foldedName(block.name + "." + variable.name));
    }
  }
  for (const iec::VariableSyntax& variable : program.syntax->globals) {
    if (goesOut(variable)) names_.insert(iec::foldedName(variable.name));
  }
}

bool ProgramOutputs::contains(const Operand& place) const {
  return std::ranges::any_of(program_.symbols, [&](const Symbol& symbol) {
    return symbol.address.offset == place.offset && isNamed(iec::foldedName(symbol.name));
  });
}

Operands outputVariables(const Program& program) {
  const ProgramOutputs outputs(program);
  std::set<std::uint32_t> seen;
  Operands found;
  for (const Symbol& symbol : program.symbols) {
    if (!outputs.contains(symbol.address) || !seen.insert(symbol.address.offset).second) continue;
    found.push_back(symbol.address);
    found.back().text = symbol.name;
  }
  return found;
}

bool ProgramOutputs::isNamed(const std::string& foldedName) const {
  return std::ranges::any_of(names_, [&](const std::string& output) {
    return foldedName.starts_with(output) &&
           (foldedName.size() == output.size() || foldedName[output.size()] == '.' || foldedName[output.size()] == '[');
  });
}

}  // namespace rungproof
