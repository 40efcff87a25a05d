// What blocks of the CPU and of the standard libraries do, as statement lists over their own interface
// (ir/s7300/library.hpp): they are read, run, encoded and proved like blocks of the program.
// Tested by tests/step7/library_source_test.cpp.
#pragma once

#include <string>

#include "ir/s7300/library.hpp"

namespace rungproof::step7 {

/// What follows the interface of a block in a source: temporary data where it needs some, BEGIN, the statements; empty:
/// only its contract is known, its outputs are any value. Whether calls of the block are modelled: by its statements,
/// or as SFC 46, which stops the CPU.
bool isModelled(const s7300::LibraryBlock& block);
std::string librarySource(const s7300::LibraryBlock& block);

}  // namespace rungproof::step7
