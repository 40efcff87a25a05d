// What the reader of properties can say: one row per message, with id, title and help for `explain`.
#pragma once

#include <array>
#include <string_view>

namespace rungproof {

struct PropertyMessage {
  std::string_view id;
  std::string_view title;
  std::string_view help;
};

inline constexpr std::array propertyMessages = {
    PropertyMessage{"PRP001", "Statement cannot be read",
                    "'rungproof prove --help' shows how each kind of property is written"},
    PropertyMessage{"PRP002", "Unknown address or symbol",
                    "write an address such as Q0.0, VW10 or T37.value, or a name of the symbol table"},
    PropertyMessage{"PRP003", "Truth value and number mixed up",
                    "conditions join truth values; comparisons and arithmetic take numbers"},
    PropertyMessage{"PRP004", "Name used twice", "every property needs a name of its own"},
};

}  // namespace rungproof
