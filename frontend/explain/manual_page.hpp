// The page of a place of the manuals: title and chapter of "001:4814", or of the title itself, as findings write it
// ("System Manual 2004, chapter 6, Timers"; without the year the newest edition); and which rules and instructions rest
// on the same section. Tested by tests/golden/explain/manual.test.
#pragma once

#include <optional>
#include <string_view>

#include "frontend/files/json.hpp"
#include "frontend/text/excerpt.hpp"

namespace rungproof {

struct ManualPage {
  std::string text;
  Json json;
};

/// Nothing if the word is no reference to a known document, and no title of a section that something rests on.
std::optional<ManualPage> manualPage(std::string_view word, const Paint& paint);

}  // namespace rungproof
