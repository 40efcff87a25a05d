// Placeholder group, to be filled.
#pragma once

#include "ir/isa/group.hpp"

namespace rungproof::isa {

using RealGroup = Group<>;

}  // namespace rungproof::isa
