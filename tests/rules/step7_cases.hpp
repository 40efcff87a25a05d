// Cases of rules on S7-300/400 programs: a reason, whether the rule speaks, and the text.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ir/s7200/cpu.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {

/// Statements as the only network of an OB1.
inline std::string ob1(const std::string& statements) {
  return "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statements + "\nEND_ORGANIZATION_BLOCK\n";
}
inline std::string fc(int number, const std::string& statements, const std::string& declarations = {}) {
  return "FUNCTION FC " + std::to_string(number) + " : VOID\n" + declarations + "BEGIN\nNETWORK\n" + statements +
         "\nEND_FUNCTION\n";
}
inline std::string fb(int number, const std::string& statements, const std::string& declarations) {
  return "FUNCTION_BLOCK FB " + std::to_string(number) + "\n" + declarations + "BEGIN\nNETWORK\n" + statements +
         "\nEND_FUNCTION_BLOCK\n";
}
inline std::string instanceDb(int number, const std::string& of) {
  return "DATA_BLOCK DB " + std::to_string(number) + "\n" + of + "\nBEGIN\nEND_DATA_BLOCK\n";
}
/// A global data block of those declarations.
inline std::string db(int number, const std::string& fields, const std::string& attribute = {}) {
  return "DATA_BLOCK DB " + std::to_string(number) + "\n" + attribute + "STRUCT\n" + fields +
         "\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
}

struct Case7 {
  const char* reason;
  std::size_t findings;
  std::string text;
};

inline void expectFindings(const char* rule, const std::vector<Case7>& cases) {
  const Cpu cpu = *cpuNamed("319-3");
  for (const Case7& each : cases) {
    SCOPED_TRACE(std::string(rule) + ": " + each.reason);
    const Linted linted(each.text, {cpu, usualEdition(cpu)});
    std::string read;
    for (const Finding& finding : linted.program.findings) {
      if (finding.severity == Severity::Error) read += finding.message + "\n";
    }
    EXPECT_EQ(read, "") << each.text;
    std::string told;
    const std::vector<Finding> findings = linted.of(rule);
    for (const Finding& finding : findings) {
      told += finding.message + "\n";
      EXPECT_FALSE(finding.help.empty());
      EXPECT_GT(finding.span.length, 0U);
    }
    EXPECT_EQ(findings.size(), each.findings) << told << each.text;
  }
}

}  // namespace rungproof::testing
