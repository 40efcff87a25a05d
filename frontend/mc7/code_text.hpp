// Instructions of machine code as statements in international mnemonics, which the reader of sources and encode() read.
// Tested by tests/mc7/code_test.cpp.
#pragma once

#include <functional>

#include "frontend/mc7/code.hpp"

namespace rungproof::mc7 {

/// How the block calls what its code names by a place. Each may be empty: then labels are M001 and the like, parameters
/// #P1, and local data stay addresses.
struct CodeNames {
  std::function<std::string(std::uint32_t target)> label;
  std::function<std::string(unsigned number)> parameter;  ///< 1 is the first
  /// The name of data of the block itself: L, or DI by AR2 of a block with an instance.
  std::function<std::optional<std::string>(step7::Place place, Size size, std::uint32_t byte, unsigned bit)> local;
};

/// "A     M 10.0", "JU    M001", "UC    FC 5 {P#I 0.0}", without label and semicolon.
std::string textOf(const CodeItem& item, const CodeNames& names);
/// The operand alone, empty if there is none.
std::string operandText(const CodeItem& item, const CodeNames& names);
/// One entry of a list: "P#I 0.0"; a number in the upper half as DW#16#50000.
std::string listEntryText(std::uint32_t entry);

}  // namespace rungproof::mc7
