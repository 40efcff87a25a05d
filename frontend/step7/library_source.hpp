// What blocks of the CPU and of the standard libraries do, as statement lists over their own interface
// (ir/s7300/library.hpp): they are read, run, encoded and proved like blocks of the program.
// Tested by tests/step7/library_source_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "ir/s7300/library.hpp"

namespace rungproof::step7 {

/// The text of a block whose meaning is no list of statements.
inline constexpr std::string_view emptyBody = "BEGIN\nNETWORK\n";

/// Whether calls of the block are modelled: by its statements, by its struct in ir/s7300/library, by its contract, or
/// as SFC 46, which stops the CPU.
bool isModelled(const s7300::LibraryBlock& block);
/// What follows the interface of a block in a source: temporary data where it needs some, BEGIN, the statements; empty:
/// calls of it are not covered. `imageBytes`: inputs of the CPU's image.
std::string librarySource(const s7300::LibraryBlock& block, std::uint32_t imageBytes);

}  // namespace rungproof::step7
