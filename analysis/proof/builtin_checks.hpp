// The checks that need no declared property (prove --builtin): set/reset conflicts, call
// nesting, operands that leave their area at run time, division, reachability of timers and counters, timers of 100 ms
// that do not run exactly once a scan, presets out of range, levels that the logic stack loses, loops that outlast the
// analysis; and the questions of the lint rules that need the prover (lint --prove). Each is a question about the
// encoding. Covered by tests/prover/builtin_test.cpp and tests/prover/rule_questions_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/bit_ranges.hpp"
#include "analysis/encoding/execution_record.hpp"
#include "analysis/encoding/obligation.hpp"

namespace rungproof {

enum class BuiltinKind : std::uint8_t {
  // prove --builtin
  SetReset,
  StackLevels,
  Nesting,
  OperandRange,
  Division,
  Overflow,
  Comparison,
  LoopBound,
  TimerReachable,
  TimerResettable,
  TimerOncePerScan,
  Preset,
  // lint --prove
  FlowOn,
  FlowOff,
  LatchOn,
  LatchDrops,
  ContactMatters,
  DoubleCoil,
  Toggles,
  RunsTwice,  // rung_checks.cpp
  TwoWaysOut,
  StepsTogether,
  StepEntered,
  StepLeft,
  CodeRuns,
  CounterReset,
  CountRises,  // sequence_checks.cpp
  PowerUp,
  Restart  // safety_checks.cpp
};

/// Whether the question should be answered with yes (a timer bit can come on) or with no (a fault cannot happen).
constexpr bool isWanted(BuiltinKind kind) {
  switch (kind) {
    case BuiltinKind::TimerReachable:
    case BuiltinKind::TimerResettable:
    case BuiltinKind::FlowOn:
    case BuiltinKind::FlowOff:
    case BuiltinKind::LatchOn:
    case BuiltinKind::LatchDrops:
    case BuiltinKind::ContactMatters:
    case BuiltinKind::StepEntered:
    case BuiltinKind::StepLeft:
    case BuiltinKind::CodeRuns:
    case BuiltinKind::CounterReset:
    case BuiltinKind::CountRises: return true;
    default: return false;
  }
}
/// Whether it is a question of a lint rule rather than of prove --builtin.
constexpr bool isRuleQuestion(BuiltinKind kind) { return kind >= BuiltinKind::FlowOn; }
/// Whether the answer only settles a finding that the flow analysis has made; without one it says nothing new.
constexpr bool needsCandidate(BuiltinKind kind) {
  return kind == BuiltinKind::DoubleCoil || kind == BuiltinKind::Toggles || kind == BuiltinKind::RunsTwice;
}

/// A further place for which the answer to a check is the same.
struct AlikePlace {
  std::string message, address;
  const Instruction* place;
};

/// Rank of a question by what it costs not to know the answer, 1 the worst: what stops the CPU, two hands on one
/// output, what waits for ever, what is merely odd.
constexpr int costOfIgnoring(BuiltinKind kind) {
  switch (kind) {
    case BuiltinKind::StackLevels:
    case BuiltinKind::Nesting:
    case BuiltinKind::OperandRange:
    case BuiltinKind::Division:
    case BuiltinKind::Comparison:
    case BuiltinKind::LoopBound: return 1;
    case BuiltinKind::SetReset:
    case BuiltinKind::DoubleCoil:
    case BuiltinKind::TwoWaysOut:
    case BuiltinKind::StepsTogether:
    case BuiltinKind::PowerUp:
    case BuiltinKind::Restart: return 2;
    case BuiltinKind::TimerReachable:
    case BuiltinKind::TimerResettable:
    case BuiltinKind::TimerOncePerScan:
    case BuiltinKind::Preset:
    case BuiltinKind::LatchOn:
    case BuiltinKind::LatchDrops:
    case BuiltinKind::StepEntered:
    case BuiltinKind::StepLeft:
    case BuiltinKind::CounterReset:
    case BuiltinKind::CountRises: return 3;
    case BuiltinKind::Overflow:
    case BuiltinKind::Toggles:
    case BuiltinKind::RunsTwice:
    case BuiltinKind::CodeRuns:
    case BuiltinKind::FlowOn:
    case BuiltinKind::FlowOff: return 4;
    case BuiltinKind::ContactMatters: return 5;
  }
  return 5;
}

struct BuiltinCheck {
  BuiltinKind kind;
  std::string name;     ///< "set/reset conflict on Q0.1", "set/reset conflict on Q0.2 to Q0.7"
  std::string rule;     ///< id of the lint rule that it confirms
  std::string message;  ///< what it means when the answer is the unwanted one
  std::string address;  ///< operand concerned, of a range its first bit, or empty
  const Instruction* place = nullptr;
  const Instruction* other = nullptr;  ///< the other half of a conflict
  Node bad = noNode;
  BitRow row{};                     ///< of conflicts and outputs: the bits concerned; empty: none, or one operand
  std::vector<AlikePlace> alike{};  ///< other networks behind the same condition

  /// The direct operands of both places.
  std::vector<Operand> operands() const;
};

/// What several bits have in common that one instruction set and another reset: `last` is what wins, "R"; empty if it
/// is not the same for all of them.
std::string conflictMessage(const BitRow& row, std::string_view last);
/// What retentive memory does to outputs in the first scan.
std::string powerUpMessage(const BitRow& row);

/// Which questions are asked beside the declared properties.
struct CheckGroups {
  bool builtin = false;  ///< those of prove --builtin
  bool rungs = false;    ///< those of lint rules about rungs, steps and declared stops
  bool powerUp = false;  ///< outputs that retentive memory switches on; with PropertySet::initialRetentive
  bool any() const { return builtin || rungs || powerUp; }
};

/// All questions of those groups that the encoding gives rise to, in program order. The record must have listened to
/// it.
std::vector<BuiltinCheck> builtinChecks(const Program& program, const PropertySet& set, const CheckGroups& groups,
                                        Obligations& obligations, const ExecutionRecord& record);

/// Adds the questions of one file: rung_checks.cpp, sequence_checks.cpp, safety_checks.cpp.
void addRungChecks(const Program& program, Obligations& obligations, const ExecutionRecord& record,
                   std::vector<BuiltinCheck>& checks);
void addSequenceChecks(const Program& program, Obligations& obligations, const ExecutionRecord& record,
                       std::vector<BuiltinCheck>& checks);
void addPowerUpChecks(const Program& program, Obligations& obligations, std::vector<BuiltinCheck>& checks);
void addRestartChecks(const PropertySet& set, Obligations& obligations, std::vector<BuiltinCheck>& checks);

}  // namespace rungproof
