// Faults in the text of a program, planted without its instruction tables: an address for another one, a contact
// normally open for normally closed, AND for OR, other numbers, other comparisons, neighbouring lines exchanged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rungproof::tables {

struct TextMutant {
  std::string what;  ///< "line 12: LDN I0.0 for LD I0.0"
  std::string text;
};

/// `count` of them, drawn with the seed among all that the text has. XML has none.
std::vector<TextMutant> textMutantsOf(const std::string& text, std::size_t count, std::uint64_t seed);

}  // namespace rungproof::tables
