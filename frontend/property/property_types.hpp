// Types in the property language: how wide a number is, what a comparison compares, and how constants fit what stands
// beside them. Tested by tests/property/language_test.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/property.hpp"

namespace rungproof {

/// Bits of the signed number that holds `value`.
std::uint8_t signedWidth(std::int64_t value);
/// Bits of the signed number that an address stands for, a timer's or counter's current value included.
std::uint8_t signedWidth(const Operand& operand);
/// A timer or counter without `.value`.
bool isTimerBit(const ExprNode& node);
/// Whether a comparison is one of truth values: a timer's bit is one beside another bit, and for = and <> beside 0, 1;
/// beside any other number it means the current value.
bool comparesTruth(const Expr& expr, ExprOp op, std::uint32_t left, std::uint32_t right);
/// A constant beside a word, double word or byte, also one a scan ago: 16#FFFF beside a word is its bit pattern, -1. A
/// number that the other side can never have is remarked upon.
void fitConstant(Expr& expr, std::uint32_t constant, std::uint32_t other, std::vector<std::string>& remarks);
/// Beside a REAL, a double word of which the program does not tell what it holds is a REAL as well, and so is what is
/// computed from it; that is remarked upon.
void asReals(Expr& expr, std::uint32_t left, std::uint32_t right, std::vector<std::string>& remarks);
/// The sum, difference or product of two numbers: a number as wide as it may get, REAL or LREAL where one of them is.
ExprNode arithmeticNode(const Expr& expr, ExprOp op, std::uint32_t left, std::uint32_t right, Span at);
/// The words of the language.
std::span<const std::string_view> propertyKeywords();
/// A word of the language, in small letters.
bool isKeyword(std::string_view word);

}  // namespace rungproof
