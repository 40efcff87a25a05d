// Blocks of the CPU and of the standard libraries (002:2328-2651): their numbers, usual names and parameters. A
// program's own block of the same number is meant before them. Tested by tests/step7/library_test.cpp.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "ir/program.hpp"
#include "ir/s7300/declaration.hpp"

namespace rungproof::s7300 {

struct LibraryBlock {
  BlockType type;  ///< Sfb, Sfc, Fc
  std::uint16_t number;
  std::string_view name;
  /// "IN:BOOL PT:TIME|Q:BOOL ET:TIME||STATE:BYTE": inputs, outputs, in-outs, static data. RET_VAL stands first among
  /// the outputs.
  std::string_view parameters;
};

std::span<const LibraryBlock> libraryBlocks();
const LibraryBlock* libraryBlock(BlockType type, std::uint32_t number);
/// By its usual name, in any case of letters.
const LibraryBlock* libraryBlockNamed(std::string_view name);
/// Numbers of SFCs without a row whose calls change more than the places that they name: process images, outputs, data
/// blocks that are made or deleted, memory of received packets. They cannot be told by their parameters.
std::span<const std::uint16_t> functionsBeyondParameters();
/// The same of SFBs: those that work on inputs and outputs of the CPU themselves.
std::span<const std::uint16_t> blocksBeyondParameters();
/// Whether its meaning stands in ir/s7300/system_block.hpp.
bool isBuiltIn(const LibraryBlock& block);
/// Whether its calls do something to interrupts, errors or the watchdog of the CPU, which ir/s7300/control.hpp states.
bool actsOnCpu(const LibraryBlock& block);
/// Parameters and static data; those of an SFB laid out as its instance.
std::shared_ptr<const Structure> interfaceOf(const LibraryBlock& block);

}  // namespace rungproof::s7300
