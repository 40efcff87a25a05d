// How a part of a shared run marks its report: which part it is, how it ended, and what its verdicts depend on, by
// which `merge` knows the parts of one run. Tested by tests/cli/merge_test.cpp.
#pragma once

#include "frontend/files/json.hpp"
#include "frontend/report.hpp"

namespace rungproof {

/// {"part", "of", "exit", "programs": [{"name", "cpu", "files": [{"name", "sha256"}], "options": [{"name", "value"}]}]}
/// of a report that is a part.
Json partJson(const Report& report);

}  // namespace rungproof
