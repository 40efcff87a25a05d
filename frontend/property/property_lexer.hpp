// Tokens of the property language. Tested by tests/property.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ir/source.hpp"

namespace rungproof {

enum class PropertyToken : std::uint8_t { Word, Number, Real, Duration, Punctuation, End };

struct Token {
  PropertyToken kind = PropertyToken::End;
  std::string_view text;
  std::int64_t value = 0;  ///< Number: value, above 2^63 - 1 its pattern; Real: IEEE single pattern; Duration: ms
  bool isPattern = false;  ///< Number written as 16# or 2#: bits, not an amount
  Span span{};
  bool isTooLarge = false;     ///< Number that 32 bits, signed or not, do not hold; Duration above longestDuration
  bool isHuge = false;         ///< Number that 64 bits do not hold
  std::int64_t longValue = 0;  ///< Real: IEEE double pattern
};

/// In ms: a million hours, more than a hundred years.
inline constexpr std::int64_t longestDuration = 3'600'000'000'000;

/// Splits one statement; `offset` is the place of text[0] in the file. Anything unreadable is one Punctuation token.
std::vector<Token> tokenize(std::string_view text, std::uint32_t file, std::uint32_t offset);

}  // namespace rungproof
