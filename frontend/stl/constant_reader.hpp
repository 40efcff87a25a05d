// Constants of a statement list: table 4-2 (001:1425-1431), typed prefixes (001:6811), strings with $ escapes.
// Tested by tests/reader/constant_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "frontend/files/encoding.hpp"
#include "ir/operand.hpp"

namespace rungproof {

enum class ConstantFault : std::uint8_t {
  None,
  NotAConstant,
  BadDigits,
  BadBase,
  TooLarge,
  TooLong,
  Empty,
  DoesNotFit
};

struct ConstantResult {
  ConstantFault fault = ConstantFault::NotAConstant;
  Operand operand;  ///< kind Constant or Text; no span
};

/// Reads 12, +12, -12, 16#FF, 2#1010_1010, 1.5, 1E-3, 'AB', "text", B#1, W#16#1F, DW#5, TRUE, OFF. Integers up to 32
/// bits (16# and 2#: up to 64 bits are kept, so that a rule can report the place); reals as IEEE single. NotAConstant:
/// the text begins like something else (an address, a name).
ConstantResult readConstant(std::string_view text, TextEncoding encoding = TextEncoding::Utf8);

/// Characters between quotation marks, escapes undone: $$ $' $" $L $N $P $R $T $hh. Typographic marks count as marks.
/// Nothing if `text` is not enclosed.
std::optional<std::string> unquoted(std::string_view text, TextEncoding encoding = TextEncoding::Utf8);

/// What is wrong, for a message: "has a digit that does not belong to its base".
std::string_view faultText(ConstantFault fault);

}  // namespace rungproof
