// What each test of a table shows, in words: "Motor (Q0.0) comes when Start (I0.0) is switched on", "Start (I0.0) is
// refused while Guard (I0.2) is off". Tested by tests/tables/generate_command_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "engine/testing/test_table.hpp"

namespace rungproof {

/// By test. What an earlier test has shown is said again only where a test shows nothing else.
std::vector<std::string> purposesOf(const TestTable& table);

}  // namespace rungproof
