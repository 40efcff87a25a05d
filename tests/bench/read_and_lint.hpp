// The work whose cost is measured on a long program: reading, building the facts, every rule. Used by
// tests/timing/lint_growth_test.cpp and the benchmark.
#pragma once

#include <string>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {

/// Reads the text and runs every rule that needs no solver; number of instructions.
inline std::size_t readAndLint(const std::string& text) {
  const Program program = readText("long.awl", text);
  const Facts facts(program);
  const RuleSettings settings;
  FindingSink sink(program, settings);
  for (const Rule* rule : allRules()) {
    if (rule->check == nullptr || !knows(*rule, program.target)) continue;
    sink.begin(*rule);
    rule->check(facts, sink);
  }
  return program.instructionCount();
}

}  // namespace rungproof::testing
