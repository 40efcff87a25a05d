// Time of reading, building the facts and running every rule that needs no solver, on 10,000 and 100,000 instructions.
// One item is one instruction; the bar is half a second and 200 MiB for 100,000.
#include <benchmark/benchmark.h>

#include "tests/bench/long_program.hpp"
#include "tests/bench/read_and_lint.hpp"

namespace rungproof::testing {
namespace {

void lint(benchmark::State& state) {
  const std::string text = test::longProgram(static_cast<int>(state.range(0)));
  std::size_t instructions = 0;
  for (auto _ : state) {
    instructions += readAndLint(text);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(instructions));
}
BENCHMARK(lint)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rungproof::testing
