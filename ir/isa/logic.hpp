// Placeholder group, to be filled.
#pragma once

#include "ir/isa/group.hpp"

namespace rungproof::isa {

using LogicGroup = Group<>;

}  // namespace rungproof::isa
