// What rules ask of a statement beside its role: on which value it jumps, whether it sets or resets, which numbers it
// compares. Tested by tests/ir/step7_role_test.cpp.
#pragma once

#include <cstdint>
#include <optional>

#include "ir/s7300/statement_role.hpp"

namespace rungproof {

/// JC, JCB, JBI: the jump is taken where its bit is 1.
bool jumpsOnOne(const Instruction& jump);
/// S of a bit, no R.
bool setsBit(const Instruction& instruction);
/// SD: a change of its RLO ends the time, and the next one starts it anew.
bool startsOnDelay(const Instruction& instruction);
/// FP, no FN.
bool findsRise(const Instruction& edge);
/// What a comparison asks of ACCU2 and ACCU1.
Relation relationOf(const Instruction& comparison);
/// Bits of the numbers that it compares: 16 of ==I, otherwise 32.
int comparedBits(const Instruction& comparison);
/// ==R and its kind.
bool comparesReals(const Instruction& instruction);
/// SQRT and LN, which a number below 0 gives no result (002:1994, general knowledge).
bool wantsNoNegative(const Instruction& instruction);
/// -R, NEGR, SIN, COS, TAN, LN: statements whose result is below 0 for half of what they may get.
bool givesEitherSign(const Instruction& instruction);
/// A statement that makes one number of the one in ACCU1: DTR takes a whole number and gives a REAL, ABS takes and
/// gives a REAL.
struct NumberStep {
  bool takesReal = false, givesReal = false;
};
std::optional<NumberStep> numberStep(const Instruction& instruction);
/// A sum, difference, product or quotient of whole numbers, of 16 or 32 bits, and what it makes of two constants:
/// `first` stood in ACCU2. Nothing for other statements and for a division by 0.
struct WholeResult {
  std::int64_t value = 0;
  int bits = 16;

  bool fits() const { return value >= -(std::int64_t{1} << (bits - 1)) && value < std::int64_t{1} << (bits - 1); }
};
std::optional<WholeResult> resultOf(const Instruction& instruction, std::int64_t first, std::int64_t second);

}  // namespace rungproof
