// Programs as text, proved with properties given as text: what the tests of the prover share.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "analysis/proof/rule_answers.hpp"
#include "frontend/input/program_input.hpp"

namespace rungproof::test {

/// A source without mistakes, with its properties.
inline ProgramInput inputOfSource(std::string source) {
  ProgramInput input;
  input.program = readText("test.awl", std::move(source));
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  for (const Finding& finding : input.program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  return input;
}

/// A main program of these network lines; property lines begin with //@.
inline ProgramInput inputOf(const std::string& properties, const std::string& networks,
                            const std::string& otherBlocks = "") {
  return inputOfSource("ORGANIZATION_BLOCK MAIN:OB1\n" + properties + "BEGIN\n" + networks +
                       "END_ORGANIZATION_BLOCK\n" + otherBlocks);
}

/// Default environment: scans of 1 ms to the watchdog's limit.
inline ProverOptions usualOptions(double timeout = 20) {
  ProverOptions options;
  options.time.high = static_cast<std::uint32_t>(options.choices.watchdogMs());
  options.timeout = timeout;
  return options;
}

inline const ProofResult* resultNamed(const ProofRun& run, const std::string& name) {
  for (const ProofResult& result : run.results) {
    if (result.property.name == name) return &result;
  }
  ADD_FAILURE() << "no result is called " << name;
  return nullptr;
}

inline Outcome outcomeOf(const ProofRun& run, const std::string& name) {
  const ProofResult* result = resultNamed(run, name);
  return result == nullptr ? Outcome::Unknown : result->outcome;
}

/// The rule that tells of the property when a run breaks it.
inline const Rule* ruleOfViolation(const Property& property) {
  ProofResult result;
  result.property = property;
  result.outcome = Outcome::Violated;
  return ruleOf(result);
}

inline bool hasNote(const ProofResult& result, const std::string& part) {
  for (const std::string& note : result.notes) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

}  // namespace rungproof::test
