// The networks of a program with what tests have seen of each contact, for a page: a contact has two colours, one for
// its bit as 1 and one as 0. Tested by tests/tables/test_command_test.cpp.
#pragma once

#include <string>

#include "engine/coverage/coverage_recorder.hpp"

namespace rungproof {

/// HTML elements; each network has its anchor.
std::string coverageDrawings(const CoverageRecorder& recorder);
std::string networkAnchor(CoveragePlace place);

}  // namespace rungproof
