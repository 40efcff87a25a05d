// Programs with interrupt routines, written on one line: statements are separated by semicolons, and every LD begins a
// network. What the tests of interrupts share.
#pragma once

#include <string>
#include <vector>

#include "tests/prover/proved_text.hpp"

namespace rungproof::test {

/// "LD I0.0;= Q0.0" as networks.
inline std::string networksOf(const std::string& statements) {
  std::string text;
  int network = 0;
  for (std::size_t at = 0; at < statements.size();) {
    const std::size_t end = std::min(statements.find(';', at), statements.size());
    const std::string line = statements.substr(at, end - at);
    at = end + 1;
    if (line.starts_with("LD") || network == 0) text += "Network " + std::to_string(++network) + "\n";
    text += line + "\n";
  }
  return text;
}

/// The main program and the interrupt routines INT_0, INT_1, ...; property lines begin with //@.
inline ProgramInput interruptInput(const std::string& properties, const std::string& main,
                                   const std::vector<std::string>& routines) {
  std::string blocks;
  for (std::size_t i = 0; i < routines.size(); ++i) {
    const std::string number = std::to_string(i);
    blocks += "INTERRUPT_BLOCK INT_" + number + ":INT" + number + "\nBEGIN\n" + networksOf(routines[i]) +
              "END_INTERRUPT_BLOCK\n";
  }
  return inputOf(properties, networksOf(main), blocks);
}

/// Verdict of one property; scans last `lengthMs`, 0: anything up to the watchdog's limit.
inline Outcome verdict(const std::string& property, const std::string& main, const std::vector<std::string>& routines,
                       std::uint32_t lengthMs = 0, ProverOptions options = usualOptions()) {
  const ProgramInput input = interruptInput("//@ " + property + "\n", main, routines);
  if (lengthMs != 0) options.time.low = options.time.high = lengthMs;
  const ProofRun run = prove(input.program, input.properties, options);
  EXPECT_TRUE(run.disagreements.empty()) << main;
  EXPECT_EQ(run.results.size(), 1U) << main;
  return run.results.empty() ? Outcome::Unknown : run.results[0].outcome;
}

}  // namespace rungproof::test
