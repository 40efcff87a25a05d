// Test support: a text to findings of one rule or of all, and facts of a text that live together with their program.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "frontend/input/project.hpp"
#include "frontend/property/property_reader.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof::testing {

/// A program, its directives and its facts.
struct Linted {
  explicit Linted(std::string text, Target target = {}, std::string_view symbols = {}, Surroundings around = {});
  Linted(const Linted&) = delete;  // the facts refer to the program
  /// An example of a rule on its CPU with its symbol table.
  static Linted example(const Rule& rule, std::string_view text) {
    const Cpu cpu = *cpuNamed(rule.exampleCpu);
    return Linted(std::string(text), {cpu, usualEdition(cpu)}, rule.exampleSymbols);
  }

  /// Findings of one rule, in the order in which it reports.
  std::vector<Finding> of(std::string_view id) const {
    const Rule* rule = ruleNamed(id);
    if (rule == nullptr || rule->check == nullptr) return {};
    const RuleSettings settings;
    FindingSink sink(program, settings);
    sink.begin(*rule);
    rule->check(*facts, sink);
    return sink.take();
  }
  /// Messages of one rule.
  std::vector<std::string> messages(std::string_view id) const {
    std::vector<std::string> result;
    for (const Finding& finding : of(id)) result.push_back(finding.message);
    return result;
  }
  /// Findings of all rules that are on by default and know the dialect, as "ADR001 line: message".
  std::vector<std::string> all(Severity atLeast = Severity::Note) const {
    std::vector<std::string> result;
    for (const Rule* rule : allRules()) {
      if (rule->check == nullptr || !rule->enabledByDefault || !knows(*rule, program.target)) continue;
      for (const Finding& finding : of(rule->id)) {
        if (finding.severity < atLeast) continue;
        result.push_back(finding.rule + " " + std::to_string(program.sources->position(finding.span).line) + ": " +
                         finding.message);
      }
    }
    return result;
  }
  /// Lines of the findings of one rule.
  std::vector<std::uint32_t> lines(std::string_view id) const {
    std::vector<std::uint32_t> result;
    for (const Finding& finding : of(id)) result.push_back(program.sources->position(finding.span).line);
    return result;
  }

  static OperandLookup operandLookup(const Program& program);

  Program program;
  PropertySet properties;
  std::unique_ptr<Facts> facts;
};

using Lines = std::vector<std::uint32_t>;
/// Lines, from 1, of the findings of a rule on a text.
inline Lines lines(const char* rule, const char* text) { return Linted(text).lines(rule); }

}  // namespace rungproof::testing
