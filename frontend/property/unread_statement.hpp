// A statement that could not be read.
#pragma once

#include <string_view>

namespace rungproof {

/// Whether an unread line may be an assumption or a statement about the surroundings: any but those that certainly ask.
bool maySayOfTheWorld(std::string_view line);

}  // namespace rungproof
