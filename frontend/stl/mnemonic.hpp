// Which instruction a word means: exact, in the German set, as a ladder name, with look-alike characters, or with
// its first operand glued on (004:268, 004:687). Tested by tests/reader/every_mnemonic_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "frontend/stl/operand_reader.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {

enum class MnemonicMatch : std::uint8_t { None, Exact, LadderName, LookAlike };

struct MnemonicResult {
  const Desc* desc = nullptr;
  MnemonicMatch match = MnemonicMatch::None;
  std::size_t length = 0;  ///< bytes of the word that are the mnemonic; the rest is its first operand
};

/// `word` up to the next blank or comma; `expected` decides between possible cuts of a glued word.
MnemonicResult findMnemonic(std::string_view word, const OperandContext& context);
/// A comparison whose sign stands apart, "LDW" and ">=" or ">=VW0": the sign's length in `next`; desc null if none.
MnemonicResult findComparison(std::string_view word, std::string_view next, const OperandContext& context);

/// The known mnemonic that is nearest in spelling, or empty.
std::string_view nearestMnemonic(std::string_view word);
/// SBR or INT if the word is one letter away from it, or empty.
std::string_view nearestHeading(std::string_view word);
/// "S7-200 SMART" or "S7-300/400" for instructions of these families that the S7-200 lacks, or empty.
std::string_view familyOfForeignInstruction(std::string_view word);

}  // namespace rungproof
