// Blocks of the CPU and of the libraries of which nothing but the contract is known: every output is any value after
// each call. What some of them do besides - start, delay or end interrupts, mask errors - is ir/s7300/control.hpp's.
// Tested by tests/step7/library_source_test.cpp and tests/step7/contract_only_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "ir/program.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::s7300 {

bool isContractOnly(const LibraryBlock& block);
/// The same of a block of a program, which stands in for one of the CPU or of a library; a program's own block is none.
bool isContractOnly(const Pou& pou);
/// The name that the stand-in of a block has in a program: "SFC41 DIS_AIRT".
std::string standInName(const LibraryBlock& block);
/// What a call of the block does besides that properties do not see; empty: nothing.
std::string_view effectOutside(BlockType type, int number);

}  // namespace rungproof::s7300
