// Many traces of a program of the benchmark against C, side by side, each with the inputs of its number.
#pragma once

#include <array>
#include <vector>

#include "engine/lanes/many_traces.hpp"
#include "tests/bench/native_inputs.hpp"

namespace rungproof::bench {

class ManySide {
 public:
  explicit ManySide(const Program& program);
  void run(int scans);
  const ManyTraces& traces() const { return traces_; }
  static constexpr std::size_t count = 256;

 private:
  ManyTraces traces_;
  std::vector<Inputs> inputs_;
  std::array<ManyTraces::TraceSet, 64> sets_;  ///< by input: where it is on
  int count_ = 0;
};

}  // namespace rungproof::bench
