// Attributes in braces of .s7dcl documents: { key := "value"; key := "value" }. Part of frontend/simaticsd.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/step7/cursor.hpp"

namespace rungproof::simaticsd {

struct SdAttribute {
  std::string key, value;
};
using SdAttributes = std::vector<SdAttribute>;

/// The value of a key in any case of letters; empty: it is not there.
std::string_view valueOf(const SdAttributes& attributes, std::string_view key);

/// Reads attributes if the cursor stands at a brace, and all that follow each other; the cursor stands behind them.
SdAttributes readAttributes(step7::Cursor& cursor);

/// "SrcType := Int; DestType := Real": parts as attributes.
SdAttributes partsOf(std::string_view templates);

}  // namespace rungproof::simaticsd
