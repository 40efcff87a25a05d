// The page of an address on a CPU: what it is, its width and limits, for a timer its resolution and its boxes, what
// else hangs on it (events, pulse outputs). Tested by tests/golden/explain/addresses.test.
#pragma once

#include <optional>
#include <string>

#include "frontend/files/json.hpp"
#include "frontend/text/excerpt.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

struct AddressPage {
  std::string text;
  Json json;
};

/// Nothing if the word is no address; special memory has a page of its own.
std::optional<AddressPage> addressPage(const Target& target, const std::string& word, const Paint& paint);

}  // namespace rungproof
