// What a panel or a network writes, as settings name it: "VW100", "VB100..VB199", "V10.0". The same as an `external`
// line among the properties. Tested by tests/cli/tags_test.cpp.
#pragma once

#include <optional>
#include <string_view>

#include "analysis/property.hpp"

namespace rungproof {

/// Whether what lies there can be written from outside: V, M, S, SM and Q.
constexpr bool mayBeExternal(Area area) { return isMemoryArea(area) || area == Area::SM || area == Area::Q; }
/// Nothing if the text names no such place, or its ends do not fit together.
std::optional<ExternalRange> externalRangeNamed(std::string_view text);

}  // namespace rungproof
