// The checks that need no declared property (prove --builtin): set/reset conflicts, call
// nesting, operands that leave their area at run time, division, reachability of timers and counters, timers of 100 ms
// that do not run exactly once a scan, presets out of range, levels that the logic stack loses, loops that outlast the
// analysis; and the questions of the lint rules that need the prover (lint --prove). Each is a question about the
// encoding. Covered by tests/prover/builtin_test.cpp and tests/prover/rule_questions_test.cpp.
#pragma once

#include <string>
#include <vector>

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

struct BuiltinCheck {
  BuiltinKind kind;
  std::string name;     ///< "set/reset conflict on Q0.1"
  std::string rule;     ///< id of the lint rule that it confirms
  std::string message;  ///< what it means when the answer is the unwanted one
  std::string address;  ///< operand concerned, or empty
  const Instruction* place = nullptr;
  const Instruction* other = nullptr;  ///< the other half of a conflict
  Node bad = noNode;

  /// The direct operands of both places.
  std::vector<Operand> operands() const;
};

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
