// What a statement of the property language was meant to say: signs of other languages for its words, addresses with a
// letter for a digit, misspelt symbols and words of the language. Tested by tests/property/meant_test.cpp.
#pragma once

#include "frontend/property/property_reader.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Gives findings of the property reader, from number `first` of program.findings on, the help "did you mean ...?" and
/// a fix that is not safe, where one reading suggests itself.
void suggestMeant(Program& program, std::size_t first, const OperandLookup& lookup);

}  // namespace rungproof
