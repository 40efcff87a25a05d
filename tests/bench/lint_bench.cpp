// Time of reading, building the facts and running every rule that needs no solver, on 10,000 to 1,000,000 instructions,
// and of the command over two files with one and with two jobs. One item is one instruction. The bars are in
// tests/rules/scale_test.cpp and tests/timing/long_lint_test.cpp.
#include <benchmark/benchmark.h>

#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/bench/long_program.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::testing {
namespace {

void lint(benchmark::State& state) {
  const std::string text = longProgram(static_cast<int>(state.range(0)));
  std::size_t instructions = 0;
  for (auto _ : state) {
    instructions += readAndLint(text);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(instructions));
}
BENCHMARK(lint)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

void lintTwoFiles(benchmark::State& state) {
  constexpr int count = 50000;
  const test::TemporaryFolder folder;
  const std::vector<std::string> arguments{"lint",
                                           "--isolated",
                                           "--quiet",
                                           "--jobs",
                                           std::to_string(state.range(0)),
                                           "--format",
                                           "concise=" + folder.path("findings"),
                                           folder.file("a.awl", longProgram(count)),
                                           folder.file("b.awl", longProgram(count))};
  for (auto _ : state) {
    std::istringstream in;
    std::ostringstream out, err;
    runProgram(arguments, {in, out, err});
  }
  state.SetItemsProcessed(state.iterations() * 2 * count);
}
BENCHMARK(lintTwoFiles)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rungproof::testing
