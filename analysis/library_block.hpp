// Blocks that libraries and wizards add to a project: USS, Modbus slave, PTO/PWM, positioning, modem, recipe, data
// log (001:8048-11169). Their bodies are hidden, so a listing only calls them; their parameters are known from the
// manual. `x` in a name stands for the number of the output or module. Tested by tests/rules/facts_test.cpp.
#pragma once

#include <span>
#include <string_view>

#include "ir/desc.hpp"
#include "ir/operand.hpp"

namespace rungproof {

struct LibraryParameter {
  std::string_view name;
  Direction direction;
  DataType type;
  bool mayBeReal = false;  ///< DINT or REAL, as the wizard's units were set
};

struct LibraryBlock {
  std::string_view name;  ///< "PTOx_RUN"
  std::span<const LibraryParameter> parameters;
  std::string_view manual;
};

/// The block that a CALL names, whatever its digit and case; nullptr if it is none of the manual's.
const LibraryBlock* libraryBlockNamed(std::string_view name);
std::span<const LibraryBlock> libraryBlocks();

}  // namespace rungproof
