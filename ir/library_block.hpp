// Blocks that libraries and wizards add to a project: USS, Modbus slave, PTO/PWM, positioning, modem, recipe, data
// log (001:8048-11169). Their bodies are hidden (001:10077, 001:10693), so a listing only calls them; their parameters
// are known from the manual, what their outputs say comes from outside. `x` in a name stands for the number of the
// output or module. Tested by tests/rules/facts_test.cpp and tests/engine/library_test.cpp.
#pragma once

#include <span>
#include <string_view>

#include "ir/args.hpp"
#include "ir/desc.hpp"

namespace rungproof {

struct LibraryParameter {
  std::string_view name;
  Direction direction;
  DataType type;
  bool mayBeReal = false;  ///< DINT or REAL, as the wizard's units were set: the width is the same
};

struct LibraryBlock {
  std::string_view name;                         ///< "PTOx_RUN"
  std::span<const LibraryParameter> parameters;  ///< in the order of CALL
  std::string_view manual;
};

/// The block that a CALL names, whatever its digit and case; nullptr if it is none of the manual's.
const LibraryBlock* libraryBlockNamed(std::string_view name);
std::span<const LibraryBlock> libraryBlocks();

/// The output at a place in the operand list of CALL, parameters from 1; nullptr if there is none.
const LibraryParameter* libraryOutput(const LibraryBlock& block, std::size_t place);
/// Place of an output by its name; 0: the block has none of that name.
std::uint32_t libraryOutputNamed(const LibraryBlock& block, std::string_view name);

/// A call of such a block with power flow: every output parameter gets a value from outside (External::LibraryOutput,
/// index = place in the operand list).
template <class D>
void callLibraryBlock(Machine<D>& m, const Instruction& instruction, const LibraryBlock& block) {
  for (std::uint32_t place = 1; place < instruction.operands.size(); ++place) {
    const LibraryParameter* output = libraryOutput(block, place);
    if (output == nullptr) continue;
    const auto value = m.external(External::LibraryOutput, place, bits(widthOf(output->type)));
    Args<D> args(m, instruction, *instruction.desc);
    args.storeParameter(place, output->type, value);
  }
}

}  // namespace rungproof
