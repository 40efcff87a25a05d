// What declarations of the S7-300/400 say of a place: the values of a structure that lie in some bits, and the type of
// the one value that an operand names. Tested by tests/rules/step7_number_rules_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

/// A declared value without parts, in bits from the beginning of its structure.
struct DeclaredValue {
  s7300::TypeKind kind;
  std::uint64_t first, end;
  std::string name;
};

struct BitRange {
  std::uint64_t first, end;
};

/// The values that share bits with the range.
std::vector<DeclaredValue> valuesIn(const s7300::Structure& structure, BitRange range);

/// The type of the value at the operand's place: a member of a data block, a parameter or a variable of the block, a
/// part of one, or what a symbol table says of the address. Unknown where no declaration has one value of just that
/// width there.
s7300::TypeKind declaredTypeOf(const Facts& facts, const Flow& flow, const Operand& operand);

}  // namespace rungproof
