// Time of reading and linting a program of the S7-300/400 of 200 blocks and 100 data blocks. One item is one statement;
// the bar is half a second.
#include <benchmark/benchmark.h>

#include "analysis/lint/lint.hpp"
#include "frontend/input/project.hpp"
#include "tests/bench/step7_program.hpp"

namespace rungproof::testing {
namespace {

void lintStep7(benchmark::State& state) {
  const std::string text = test::step7Program({.unusedBytes = static_cast<int>(state.range(0))});
  std::size_t statements = 0;
  for (auto _ : state) {
    const Program program = readText("plant.awl", text);
    const Facts facts(program);
    benchmark::DoNotOptimize(runRules(facts, RuleSelection(), {}));
    statements += program.instructionCount();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(statements));
}
BENCHMARK(lintStep7)->Arg(0)->Arg(16000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rungproof::testing
