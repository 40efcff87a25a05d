// Many traces of one program, some of them beside reference engines with the same inputs and scan lengths: after every
// scan the same states, and the same errors.
#pragma once

#include <string>

#include "engine/lanes/many_traces.hpp"
#include "tests/differential/random_source.hpp"

namespace rungproof::test {

struct ManyOutcome {
  std::string difference;  ///< empty: none
  std::string hindrance;   ///< why no trace ever ran side by side
  int scans = 0;
  std::size_t traceScans = 0, sideBySide = 0;  ///< of all traces, and those of them that ran side by side
};

struct ManyOptions {
  int scans = 40;
  std::uint32_t leastMs = 10;  ///< of a scan
  bool isTight = false;        ///< scans may be shorter than the program, and are no whole ms
  bool writesMemory = true;    ///< somebody writes into M and these 128 bytes between the scans
  Area words = Area::V;
  std::uint32_t firstByte = 0;
  SimulatorOptions engine{};
  lanes::Vectors most = lanes::Vectors::Bits512;  ///< no other instructions are used
};

ManyOutcome runBeside(const Program& program, RandomSource& random, const ManyOptions& options = {});

}  // namespace rungproof::test
