// Blocks that libraries and wizards add to a project: USS, Modbus, PTO/PWM, positioning, modem, recipe, data log, PID,
// axes, open communication (001:8048-11169, and the libraries of the S7-200 SMART). Their bodies are hidden (001:10077,
// 001:10693), so a listing only calls them; their parameters are known, what their outputs say comes from outside. `x`
// in a name stands for the number of the output or module. What a call of one may write: ir/s7200/call_contract.hpp.
// Tested by tests/rules/facts_test.cpp and tests/engine/library_test.cpp.
#pragma once

#include <span>
#include <string_view>

#include "ir/desc.hpp"
#include "ir/program.hpp"

namespace rungproof {

struct LibraryParameter {
  std::string_view name;
  Direction direction;
  DataType type;
  bool mayBeReal = false;  ///< DINT or REAL, as the wizard's units were set: the width is the same
};

/// What a USS block works on behind DB_Ptr (001:10256).
inline constexpr std::uint32_t ussScratchBytes = 16;

/// What a block writes beside its outputs.
enum class LibraryReach : std::uint8_t {
  Nothing,
  Message,   ///< DataPtr: Count words or bits, unless RW says that they are sent
  Holding,   ///< the holding registers and outputs that its own parameters give to the master
  Slave,     ///< the same, of MBUS_INIT
  Scratch,   ///< DB_Ptr: ussScratchBytes
  Received,  ///< what its addresses point to, at most 1,024 bytes
  Record     ///< V memory that the wizard has placed: the text does not say where (001:11016, 001:9515)
};

struct LibraryBlock {
  std::string_view name;                         ///< "PTOx_RUN"
  std::span<const LibraryParameter> parameters;  ///< in the order of CALL
  std::string_view manual;                       ///< empty: a library of the S7-200 SMART, or not in the manual text
  LibraryReach reach = LibraryReach::Nothing;
  std::uint32_t ownBytes = 0;  ///< of V memory that the library keeps for itself; 0: none or not known
  bool isOpen = false;         ///< further parameters depend on the wizard or are not known
};

/// The block that a CALL names, whatever its digit and case; nullptr if it is none of the manual's.
const LibraryBlock* libraryBlockNamed(std::string_view name);
std::span<const LibraryBlock> libraryBlocks();
/// The block of that name whose parameters are as many as the call gives; nullptr: there is none, or they are not
/// known. Some blocks have more parameters on the S7-200 SMART.
const LibraryBlock* libraryBlockWith(std::string_view name, std::size_t parameters);
/// Whether the number of parameters of that name is told by the manual (chapters 7 to 15), so that another is a
/// mistake.
bool hasFixedParameters(const Target& target, std::string_view name);

/// The output at a place in the operand list of CALL, parameters from 1; nullptr if there is none.
const LibraryParameter* libraryOutput(const LibraryBlock& block, std::size_t place);
/// Place of an output by its name; 0: the block has none of that name.
std::uint32_t libraryOutputNamed(const LibraryBlock& block, std::string_view name);

}  // namespace rungproof
