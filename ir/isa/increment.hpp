// Placeholder group, to be filled.
#pragma once

#include "ir/isa/group.hpp"

namespace rungproof::isa {

using IncrementGroup = Group<>;

}  // namespace rungproof::isa
