// Which instruction drives a pulse output: PLS, or a block of the wizard for PTO and PWM. Tested by
// tests/rules/output_rules_test.cpp and the examples of HSP002.
#pragma once

#include <optional>

#include "ir/program.hpp"
#include "ir/s7200/pulse_output.hpp"

namespace rungproof {

inline bool mayPulse(const Desc& desc) { return desc.role == Role::Pls || desc.control == Control::Call; }

/// Index in pulseOutputs; nothing if it is another instruction, or the number is not known.
inline std::optional<std::uint32_t> pulseOutputOf(const Instruction& instruction) {
  if (instruction.operands.empty()) return std::nullopt;
  const Operand& o = instruction.operands[0];
  if (roleOf(instruction) == Role::Pls && o.kind == OperandKind::Constant && o.value >= 0 &&
      o.value < static_cast<std::int64_t>(pulseOutputCount))
    return static_cast<std::uint32_t>(o.value);
  const bool isWizard = instruction.desc->control == Control::Call && o.kind == OperandKind::Symbol &&
                        o.text.size() > 4 && (o.text.starts_with("PTO") || o.text.starts_with("PWM")) &&
                        o.text[3] >= '0' && o.text[3] < '0' + static_cast<int>(pulseOutputCount);
  return isWizard ? std::optional(static_cast<std::uint32_t>(o.text[3] - '0')) : std::nullopt;
}

}  // namespace rungproof
