// One stated case on the machine that runs programs.
#pragma once

#include <string>

#include "tests/naive7/case_table.hpp"

namespace rungproof::agreement7 {

/// What the run leaves otherwise than stated; empty if nothing.
std::string differences(const naive7::Case& c);

}  // namespace rungproof::agreement7
