// The program. Everything of it is in cli.cpp, so that tests can reach it.
#include <array>
#include <iostream>

#include "analysis/recheck/z3_check.hpp"
#include "engine/platform/console.hpp"
#include "frontend/assistant/tool.hpp"
#include "frontend/cli/standard_streams.hpp"
#include "frontend/editor/proof.hpp"
#include "frontend/watch.hpp"

namespace {

/// What this program does in processes beside itself.
constexpr std::array<const rungproof::Worker*, 4> workers = {&rungproof::formulaWorker, &rungproof::commandWorker,
                                                             &rungproof::toolWorker, &rungproof::watchedRunWorker};

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  return rungproof::runProgramIn([&] {
    const std::vector<std::string> arguments = rungproof::programArguments(argc, argv);
    if (const std::optional<int> exit = rungproof::workerExit(arguments, workers)) return *exit;
    return rungproof::runProgram(arguments, rungproof::standardStreams());
  });
}
