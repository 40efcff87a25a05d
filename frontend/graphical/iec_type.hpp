// Types and literals of IEC 61131-3 as far as the S7-200 can hold them: TIME is a double integer of milliseconds.
// Tested by tests/graphical/iec_type_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "frontend/graphical/drawn_model.hpp"

namespace rungproof {

/// "BOOL", "Int", ... in any case; None for every other name.
IecType iecTypeNamed(std::string_view name);
std::string_view iecTypeName(IecType type);

/// Width in memory; String is not a value and has Byte.
Width widthOf(IecType type);
/// Mnemonic of the move for values of the type: "MOVB", "MOVW", "MOVD", "MOVR".
std::string_view moveOf(IecType type);
bool isSignedInteger(IecType type);
bool isUnsignedInteger(IecType type);
bool isBitString(IecType type);

/// A literal: 12, -3, 16#FF, TRUE, INT#5, 1.5, T#1m30s, TIME#500ms.
struct IecLiteral {
  IecType type = IecType::None;  ///< Bool, Time, Real, or the type of a prefix; None: an integer that takes any type
  std::int64_t value = 0;        ///< Real: IEEE single bits; Time: ms
};
/// Nothing if the text is no literal, or one that the S7-200 cannot hold (times with fractions of a millisecond).
std::optional<IecLiteral> iecLiteral(std::string_view text);

/// Whether the value lies in the range of the type.
bool fits(std::int64_t value, IecType type);

/// "%IX0.0", "%QW4", "%MD8", "%I0.0", "%AIW0": the S7-200's address. The number counts bytes, as on all SIMATIC
/// controllers. Nothing if it cannot be read.
std::optional<Operand> locatedAddress(std::string_view text);

}  // namespace rungproof
