// One property asked of a program given as lines: verdict, notes and assumptions. What the tests of the program's
// surroundings share.
#pragma once

#include <algorithm>
#include <string>

#include "tests/prover/proved_text.hpp"

namespace rungproof::test {

struct Asked {
  std::string program;         ///< network lines of MAIN, separated by ';'
  std::string property;        ///< "never Q0.0", or "reach MB2 = 2"
  std::uint32_t lowMs = 0;     ///< 0: any length up to the watchdog limit
  std::uint32_t highMs = 0;    ///< 0: as lowMs
  std::string choices{};       ///< "inactive-scr=skipped first-edge=..."
  std::string otherBlocks{};   ///< lines separated by ';'
  std::string declarations{};  ///< further property lines, separated by ';'
  Target target{};
};

inline std::string linesOf(std::string text, const std::string& before = "") {
  std::string lines = before;
  for (const char c : text) lines += c == ';' ? "\n" + before : std::string(1, c);
  return lines + "\n";
}

inline ProofResult asked(const Asked& a) {
  const bool isReach = a.property.starts_with("reach ");
  const std::string statement = isReach ? "reach p: " + a.property.substr(6) : "prove p: " + a.property;
  std::string properties = "//@ " + statement + "\n";
  if (!a.declarations.empty()) properties += linesOf(a.declarations, "//@ ");
  ProgramInput input;
  input.program = readText("test.awl",
                           "ORGANIZATION_BLOCK MAIN:OB1\n" + properties + "BEGIN\n" + "Network 1\n" +
                               linesOf(a.program) + "END_ORGANIZATION_BLOCK\n" + linesOf(a.otherBlocks),
                           {.target = a.target});
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  for (const Finding& finding : input.program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  ProverOptions options = usualOptions();
  if (a.lowMs != 0) options.time = {a.lowMs, a.highMs == 0 ? a.lowMs : a.highMs};
  for (std::size_t at = 0; at < a.choices.size();) {
    const std::size_t end = std::min(a.choices.find(' ', at), a.choices.size());
    const std::string choice = a.choices.substr(at, end - at);
    const std::size_t equal = choice.find('=');
    EXPECT_TRUE(options.choices.set(choice.substr(0, equal), choice.substr(equal + 1))) << choice;
    at = end + 1;
  }
  const ProofRun run = prove(input.program, input.properties, options);
  for (const Disagreement& d : run.disagreements) ADD_FAILURE() << d.name << ": " << d.explanation << "\n" << a.program;
  const ProofResult* result = resultNamed(run, "p");
  return result == nullptr ? ProofResult{} : *result;
}

inline Outcome verdict(const Asked& a) { return asked(a).outcome; }

inline bool assumes(const ProofResult& result, const std::string& text) {
  return std::ranges::find(result.assumptions, text) != result.assumptions.end();
}

}  // namespace rungproof::test
