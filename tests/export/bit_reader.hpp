// A reader of AIGER 1.9, binary and ascii, written from the definition of the format and not from the printer: counts,
// ranges and order of literals, resets, one definition for each variable, no circle, and a symbol table whose entries
// exist once. Mistakes throw std::runtime_error.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace rungproof::test {

struct AigerShape {
  std::size_t inputs = 0, latches = 0, gates = 0, bads = 0, constraints = 0;
  std::set<std::string> names;  ///< of the symbol table: no two are equal
};

AigerShape readAiger(const std::string& text);

}  // namespace rungproof::test
