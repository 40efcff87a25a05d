// Shorthand of these tests: a program of IEC 61131-3 scan by scan on the engine, its variables by their names.
#pragma once

#include <gtest/gtest.h>

#include "engine/simulator.hpp"
#include "engine/trace.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project.hpp"

namespace rungproof {

/// Messages of the readers, one behind the other.
inline std::string findingsIec(const Program& program) {
  std::string text;
  for (const Finding& finding : program.findings) text += std::string(finding.message.view()) + "\n";
  return text;
}

inline Program readIecText(const std::string& text) { return readText("test.st", text); }

/// Readings of open points by their names; all others are the default.
using IecChoices = std::vector<std::pair<std::string_view, std::string_view>>;

/// The only errors of the text, one of which has that message at that place.
inline void expectErrorAt(const Program& program, std::string_view message, std::uint32_t line, std::uint32_t column) {
  bool isTold = false;
  for (const Finding& finding : program.findings) {
    EXPECT_EQ(finding.severity, Severity::Error);
    if (finding.message.view().find(message) == std::string_view::npos) continue;
    isTold = true;
    EXPECT_EQ(program.sources->position(finding.span).line, line) << finding.message.view();
    EXPECT_EQ(program.sources->position(finding.span).column, column) << finding.message.view();
  }
  EXPECT_TRUE(isTold) << findingsIec(program);
}

struct IecRun {
  explicit IecRun(const std::string& text, std::uint32_t scanMs = 10, const IecChoices& choices = {})
      : program(readIecText(text)), lookup(lookupIn(program)), simulator(program, options(scanMs, choices)) {
    EXPECT_EQ(findingsIec(program), "");
  }

  Operand place(const std::string& name) const {
    const std::optional<Operand> operand = lookup(name);
    EXPECT_TRUE(operand.has_value()) << name;
    return operand.value_or(direct(Area::V, Width::Bit, 0));
  }
  void set(const std::string& name, double value) {
    const Operand at = place(name);
    simulator.write(at, valueOf(value, signalOf(program, at).type, signalOf(program, at).width()));
  }
  double get(const std::string& name) const {
    const Operand at = place(name);
    return numberOf(simulator.read(at), signalOf(program, at).type, signalOf(program, at).width());
  }
  void scan(std::uint32_t ms = 0) { simulator.scan({ms * 1000}); }

  /// The values of a variable at the ends of scans in which the inputs have these values.
  std::vector<double> follow(const std::string& name,
                             const std::vector<std::pair<std::string, std::vector<double>>>& inputs) {
    std::vector<double> seen;
    for (std::size_t i = 0; i < inputs[0].second.size(); ++i) {
      for (const auto& [input, values] : inputs) set(input, values[i]);
      scan();
      seen.push_back(get(name));
    }
    return seen;
  }

  Program program;
  OperandLookup lookup;
  Simulator simulator;

 private:
  static SimulatorOptions options(std::uint32_t scanMs, const IecChoices& choices) {
    SimulatorOptions made;
    made.scanUs = scanMs * 1000;
    for (const auto& [key, reading] : choices) EXPECT_TRUE(made.choices.set(key, reading)) << key << "=" << reading;
    return made;
  }
};

/// A program with these declarations and statements.
inline std::string iecProgram(const std::string& declarations, const std::string& statements) {
  return "PROGRAM main\n" + declarations + "\n" + statements + "\nEND_PROGRAM\n";
}

using Row = std::vector<double>;

}  // namespace rungproof
