// One operand from its text: direct addresses (001:1267-1395), pointers *VD10 and &VB10 (001:1459-1478), constants,
// local names #name and direct addresses %I0.0 (001:2226), open operands ????. Tested by tests/reader/operand_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "frontend/stl/constant_reader.hpp"
#include "ir/desc.hpp"

namespace rungproof {

/// How the areas are spelled: I Q C AI AQ, or E A Z AE AA.
enum class Spelling : std::uint8_t { International, German };

enum class OperandFault : std::uint8_t { None, Unreadable, Constant, Pointer, AddressOf, Number };

struct OperandResult {
  OperandFault fault = OperandFault::Unreadable;
  ConstantFault constantFault = ConstantFault::None;
  Operand operand;
};

struct OperandContext {
  Spelling spelling = Spelling::International;
  TextEncoding encoding = TextEncoding::Utf8;
};

/// Between a name and an address that are written together: Start:I0.0.
inline constexpr char namedAddressMark = ':';
/// Reads one operand; names become OperandKind::Symbol (value -1) for the resolver, with * & # kept in the text, and so
/// do names with an address behind them.
OperandResult readOperand(std::string_view text, const OperandContext& context);

/// Reads an address such as I0.0, VW10, T37, AC1, HC2, AIW4; nothing if `text` is none.
bool readAddress(std::string_view text, Spelling spelling, Operand& operand);
/// Whether `text` is an address that lacks its size letter or its bit: V10, M3.
bool isPartOfAddress(std::string_view text, Spelling spelling);
/// Letters, digits, underscores and characters beyond ASCII, not beginning with a digit (001:2395-2416).
bool isName(std::string_view text);
/// Whether an area may be spelled so, with or without a size letter: "VB", "SM", "AIW".
bool isAreaPrefix(std::string_view letters, Spelling spelling);

/// The text with characters replaced that only look right (O for 0, 1 or l for I, Cyrillic and full-width
/// letters), if that makes a readable address or constant; otherwise nothing. `bitOnly`: no constant may stand here.
std::string mendedOperand(std::string_view text, Spelling spelling, bool bitOnly);
/// The ASCII letters and digits that Cyrillic, Greek or full-width characters imitate; other text unchanged.
std::string plainCharacters(std::string_view text);

}  // namespace rungproof
