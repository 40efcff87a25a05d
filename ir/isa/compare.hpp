// Placeholder group, to be filled.
#pragma once

#include "ir/isa/group.hpp"

namespace rungproof::isa {

using CompareGroup = Group<>;

}  // namespace rungproof::isa
