// What an actual parameter of CALL may be, by section and type of the formal one (table 6-78, 001:6751-6757).
// Compared with tests/data/operands-b.tsv by tests/ir/isa_table_test.cpp.
#pragma once

#include "ir/desc.hpp"
#include "ir/program.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

inline constexpr int maxParameters = 16;  ///< 001:6775

/// Lowest SM byte that a parameter of that section may name (001:6757): results must not go to read-only bytes.
constexpr std::uint32_t firstParameterSm(VarSection section) {
  return section == VarSection::Input ? 0 : smReadOnlyLast + 1;
}

/// Forms of the actual parameter. A pointer in an accumulator must be AC1 to AC3 (001:6756), as everywhere. REAL is
/// missing in the table and taken as the double word types without HC and addresses. STRING: a pointer or a text.
constexpr Forms parameterForms(VarSection section, DataType type) {
  const bool input = section == VarSection::Input;
  const bool output = section == VarSection::Output;
  switch (type) {
    case DataType::Bool: return form::bitAny;
    case DataType::Byte: return input ? form::byteIn : form::byteOut;
    case DataType::Word:
    case DataType::Int: return input ? form::wordIn : output ? form::wordOut | form::AQ : form::wordOut;
    case DataType::DWord:
    case DataType::DInt:
    case DataType::Time: return input ? form::dwordIn | form::Address : form::dwordOut;
    case DataType::Real: return input ? form::realIn : form::dwordOut;
    case DataType::String: return input ? form::Pointers | form::Const : form::Pointers;
    default: return 0;  // of the S7-300/400
  }
}

}  // namespace rungproof
