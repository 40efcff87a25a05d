// --watch: a command runs again whenever a file that it has read changes, until Ctrl-C or SIGTERM. Each run is a child
// process, so that none leaves anything behind for the next. Tested by tests/cli/watch_test.cpp.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "engine/platform/child_process.hpp"
#include "frontend/files/exit.hpp"

namespace rungproof {

inline constexpr std::string_view watchOption = "--watch";
inline constexpr std::string_view watchHelp =
    "run again whenever a file that was read changes, until Ctrl-C; the exit code is that of the last run";

struct WatchedRuns {
  const Worker* worker;              ///< does one run and gives the name of each file that it has read, on a line
  std::string request{};             ///< what it is to do
  std::vector<std::string> given{};  ///< files and folders of the command line, which may not exist yet
  bool clears = false;               ///< a terminal is cleared before each run
};
/// The exit code of the last run that came to its end.
int watchRuns(const WatchedRuns& runs, std::ostream& out, std::ostream& err);

}  // namespace rungproof
