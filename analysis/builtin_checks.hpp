// The checks that need no declared property (product contract, section 1, prove --builtin): set/reset conflicts, call
// nesting, operands that leave their area at run time, division, reachability of timers and counters, timers of 100 ms
// that do not run exactly once a scan, loops that outlast the analysis. Each is a question about the encoding.
// Covered by tests/prover/builtin_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/obligation.hpp"

namespace rungproof {

enum class BuiltinKind : std::uint8_t { SetReset, Nesting, OperandRange, Division, Overflow, Comparison, LoopBound, TimerReachable, TimerResettable, TimerOncePerScan };

/// Whether the question should be answered with yes (a timer bit can come on) or with no (a fault cannot happen).
constexpr bool isWanted(BuiltinKind kind) { return kind == BuiltinKind::TimerReachable || kind == BuiltinKind::TimerResettable; }

struct BuiltinCheck {
  BuiltinKind kind;
  std::string name;     ///< "set/reset conflict on Q0.1"
  std::string rule;     ///< id of the lint rule that it confirms
  std::string message;  ///< what it means when the answer is the unwanted one
  std::string address;  ///< operand concerned, or empty
  const Instruction* place = nullptr;
  const Instruction* other = nullptr;  ///< the other half of a conflict
  Node bad = noNode;
};

/// All questions that the encoding gives rise to, in program order. Obligations must have been made with
/// recordExecutions.
std::vector<BuiltinCheck> builtinChecks(Obligations& obligations);

}  // namespace rungproof
