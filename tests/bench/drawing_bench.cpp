// Drawing networks: raising, layout and SVG. One item is one network; the bar is 1,000 networks in a second, which
// tests/show/scan_test.cpp holds.
#include <benchmark/benchmark.h>

#include "frontend/input/project.hpp"
#include "frontend/picture/network_view.hpp"
#include "tests/bench/long_program.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

void draw(benchmark::State& state, Form form, bool svg) {
  const Program program = readText("long.awl", test::longProgram(5000));
  std::size_t networks = 0;
  for (auto _ : state) {
    std::vector<BlockView> blocks;
    for (const Pou& pou : program.pous) {
      BlockView& block = blocks.emplace_back(BlockView{blockHeading(pou), {}});
      for (const Network& network : pou.networks)
        block.networks.push_back(networkView(program, pou, network, {.form = form}));
      networks += pou.networks.size();
    }
    benchmark::DoNotOptimize(svg ? viewSvg(blocks) : viewText(blocks, {}));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(networks));
}
BENCHMARK_CAPTURE(draw, ladderToSvg, Form::Ladder, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw, ladderToText, Form::Ladder, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw, fbdToSvg, Form::Fbd, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rungproof::testing
