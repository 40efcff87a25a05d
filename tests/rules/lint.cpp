// Reads the text, with a symbol table through a file of its own, and resolves directives as the commands do.
#include "tests/rules/lint.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "frontend/stl/operand_reader.hpp"

namespace rungproof::testing {

Linted::Linted(std::string text, Target target, std::string_view symbols, Surroundings around) {
  ReadOptions options;
  options.target = target;
  const std::string file = ::testing::TempDir() + "rungproof_symbols_" + std::to_string(::getpid()) + ".txt";
  if (!symbols.empty()) {
    std::ofstream(file) << symbols;
    options.symbolFiles.push_back(file);
  }
  program = readText("test.awl", std::move(text), options);
  if (!symbols.empty()) std::remove(file.c_str());
  properties = readProperties(program, {}, operandLookup(program));
  facts = std::make_unique<Facts>(program, properties.externals, std::move(around));
}

OperandLookup Linted::operandLookup(const Program& program) {
  return [&program](std::string_view text) -> std::optional<Operand> {
    Operand operand;
    if (readAddress(text, Spelling::International, operand)) return operand;
    const Symbol* symbol = program.symbolNamed(text);
    if (symbol == nullptr) return std::nullopt;
    return symbol->address;
  };
}

}  // namespace rungproof::testing
