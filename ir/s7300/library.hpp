// Blocks of the CPU and of the standard libraries (002:2328-2651): their numbers, usual names and parameters. A
// program's own block of the same number is meant before them. Each is a struct in a file of ir/s7300/library. Tested
// by tests/step7/library_test.cpp.
#pragma once

#include <memory>
#include <span>
#include <string>
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
  bool isBuiltIn =
      false;  ///< its struct says over any domain what it does (`run`); without `run`: outputs have any value
  bool isContract = false;  ///< what its outputs are is told nowhere: any value after each call
  bool actsOnCpu = false;   ///< its struct says what it does to interrupts, errors or the watchdog (`act`)
  bool readsClock = false;  ///< proofs know no time of day
  bool stopsCpu = false;
  bool masksErrors = false;          ///< from its first call on an error may be masked
  std::string_view head = {};        ///< temporary data and statements in front of `statements`
  std::string_view statements = {};  ///< what it does, as a statement list over its parameters
  /// The same of a contract in front of its outputs; given the bytes of the image of the inputs.
  std::string (*begin)(std::uint32_t imageBytes) = nullptr;
  std::string_view outside = {};  ///< what a proof takes for granted of it, as a sentence
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
/// Parameters and static data; those of an SFB laid out as its instance.
std::shared_ptr<const Structure> interfaceOf(const LibraryBlock& block);

}  // namespace rungproof::s7300
