// The program. Everything of it is in cli.cpp, so that tests can reach it.
#include <array>
#include <iostream>

#include "engine/platform/console.hpp"
#include "frontend/cli/last_words.hpp"
#include "frontend/cli/standard_streams.hpp"
#include "frontend/cli/watched_run.hpp"

namespace rungproof {

// Of rooms that stand above this one: main() alone knows all of them.
extern const Worker formulaWorker;  // analysis/recheck/z3_check.hpp
extern const Worker commandWorker;  // frontend/editor/proof.hpp
extern const Worker toolWorker;     // frontend/assistant/tool.hpp

}  // namespace rungproof

namespace {

/// What this program does in processes beside itself.
constexpr std::array<const rungproof::Worker*, 4> workers = {&rungproof::formulaWorker, &rungproof::commandWorker,
                                                             &rungproof::toolWorker, &rungproof::watchedRunWorker};

}  // namespace

int main(int argc, char** argv) {
  rungproof::prepareLastWords();
  std::ios::sync_with_stdio(false);
  return rungproof::runProgramIn([&] {
    const std::vector<std::string> arguments = rungproof::programArguments(argc, argv);
    if (const std::optional<int> exit = rungproof::workerExit(arguments, workers)) return *exit;
    return rungproof::runProgram(arguments, rungproof::standardStreams());
  });
}
