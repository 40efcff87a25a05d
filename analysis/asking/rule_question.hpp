// A question that a rule asks the prover, and which of them are asked in a run. prove --builtin asks those that need no
// declared property; lint --prove asks all. What is asked and how it is told stands in the rule's own file
// (analysis/checks); asking.hpp puts the questions, rule_answers.hpp tells the answers. Covered by
// tests/prover/builtin_test.cpp, tests/prover/rule_questions_test.cpp and tests/prover/own_rule_test.cpp.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "analysis/flow/bit_ranges.hpp"
#include "analysis/graph/graph.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

/// A further place for which the answer to a question is the same.
struct AlikePlace {
  std::string message, address;
  const Instruction* place;
};

struct RuleQuestion {
  std::string name{};     ///< "set/reset conflict on Q0.1", "set/reset conflict on Q0.2 to Q0.7"
  std::string message{};  ///< what it means when the answer is the unwanted one; empty: that is never told
  std::string address{};  ///< operand concerned, of a range its first bit, or empty
  const Instruction* place = nullptr;
  Node bad = noNode;
  const Instruction* other = nullptr;  ///< the other half of a conflict
  int aspect = 0;                      ///< which of the rule's kinds of question, by its own count
  BitRow row{};                        ///< of conflicts and outputs: the bits concerned; empty: none, or one operand
  std::vector<AlikePlace> alike{};     ///< other networks behind the same condition
  bool isUsual = false;                ///< worth a note, whatever the severity of the rule
  const Rule* rule = nullptr;          ///< who asks; set by Asking::ask

  Severity severity() const { return isUsual ? Severity::Note : rule->severity; }

  /// The direct operands of both places.
  Operands operands() const;
};

/// Whether prove --builtin asks it too; what only lint asks gets less time and less evidence.
constexpr bool isAskedByProve(const Rule& rule) { return (rule.ask.in & asked::Builtin) != 0; }

class Asking;

/// Which questions are asked beside the declared properties, and whose.
struct CheckGroups {
  bool builtin = false;  ///< asked::Builtin: those of prove --builtin
  bool lint = false;     ///< asked::Lint: those of lint rules about rungs, steps and declared stops
  bool powerUp = false;  ///< asked::PowerUp: with PropertySet::initialRetentive
  std::span<const Rule* const> rules = allRules();
  /// Asks beside the rules, with one of its own (Asking::begin), about what contacts and outputs see too (Visit::bit).
  std::function<void(Asking&)> further{};

  bool any() const { return builtin || lint || powerUp || further; }
  bool has(const Rule& rule) const {
    const AskedIn in = rule.ask.in;
    return (builtin && (in & asked::Builtin) != 0) || (lint && (in & asked::Lint) != 0) ||
           (powerUp && (in & asked::PowerUp) != 0);
  }
};

}  // namespace rungproof
