// Whether an operand fits its descriptor on a CPU: form, width, kind of constant, limits. Everything derives from
// ir/desc.hpp and ir/s7200/cpu.hpp; rules ADR001, ADR002, ADR006 and ADR009 turn the answers into findings.
// Tested by tests/rules/operand_rules_test.cpp against tests/data/*.tsv.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ir/desc.hpp"
#include "ir/program.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

/// Whether the way of writing (area, pointer, constant, address) is in the operand's list.
bool formIsAllowed(const OperandDesc& desc, const Operand& operand);
/// Whether the written width is the one that the type asks for; T, C, AC and HC take any.
bool widthIsAllowed(const OperandDesc& desc, const Operand& operand);
/// Whether a constant of that notation makes sense for the type: no real number for an integer and the reverse.
bool notationIsAllowed(const OperandDesc& desc, const Operand& operand);
/// Whether the pointer stands in V, L or AC1 to AC3 (001:1459).
bool pointerMayStandThere(const Operand& operand);
/// "IW, QW, VW, T, C, AC, *VD, *LD, *AC or a constant": what may stand there.
std::string allowedForms(const OperandDesc& desc);
/// "a word", "a bit".
std::string_view widthName(Width width);

/// Width at which the operand of that descriptor is accessed.
Width accessWidth(const OperandDesc& desc, const Operand& operand);
/// Whether a value lies in a range of the descriptor that holds for the CPU; true if there are no ranges.
bool valueIsInRange(const OperandDesc& desc, std::int64_t value, CpuSet cpus);
/// "0 to 12, 19 to 23": the ranges of the CPU.
std::string rangesText(const OperandDesc& desc, Cpu cpu);
/// Lowest and highest constant that the type holds, signed and unsigned spellings together.
struct TypeLimits {
  std::int64_t low;
  std::int64_t high;
};
std::optional<TypeLimits> typeLimits(Type type);
/// Value of a constant as a signed number of the operand's width where the type is signed or N of SHRB is meant.
std::int64_t signedByteValue(std::int64_t value);

}  // namespace rungproof
