// Addresses that people name beside a program, in properties, maps, stimuli and on the command line: whether the CPU
// has them. What a program itself names is rule ADR001's. Tested by tests/property, tests/trace and tests/cli.
#pragma once

#include <optional>
#include <string>

#include "ir/operand.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

/// Why the CPU does not have that address, as a sentence; nothing if it has. Local memory is not looked at.
std::optional<std::string> missingFrom(const Target& target, const Operand& operand);

}  // namespace rungproof
