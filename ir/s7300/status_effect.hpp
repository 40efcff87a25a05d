// What an instruction of the S7-300/400 leaves in the nine bits of the status word, for people: the meanings in
// ir/s7300/isa decide. General knowledge but where the meanings name a line.
// Compared with the stated cases of every instruction by tests/step7/explain_test.cpp.
#pragma once

#include <string_view>

#include "ir/desc.hpp"

namespace rungproof::s7300 {

/// Names of the bits in the order of a row.
inline constexpr std::string_view statusBitNames[] = {"BR", "CC1", "CC0", "OV", "OS", "OR", "STA", "RLO", "/FC"};

/// "--- xx1" without blanks, in that order: - unchanged, 0 and 1 forced, x by the result. Empty: a label.
std::string_view statusEffect(const Desc& desc);

}  // namespace rungproof::s7300
