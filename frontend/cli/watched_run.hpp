// One run of a command under --watch, in a process of its own. Tested by tests/cli/watch_test.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/platform/child_process.hpp"
#include "frontend/cli/cli.hpp"

namespace rungproof {

/// A copy of this process prints on `streams`, which outlive it; this program, started again, on its standard streams.
extern const Worker watchedRunWorker;
std::string watchedRunRequest(std::string_view command, const std::vector<std::string>& arguments,
                              const Streams& streams);

}  // namespace rungproof
