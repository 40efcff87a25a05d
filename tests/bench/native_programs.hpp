// Programs on which the engine is measured against the same program in C, as statement lists. They are random with a
// fixed seed; the same number gives the same text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rungproof::bench {

struct NativeProgram {
  std::string name;
  std::string text;
  double bar;       ///< least part of the speed of gcc -O2 that the engine shall reach with one trace
  double kept;      ///< the part that it has reached, less what machines scatter: a test asks for that
  double keptMany;  ///< the same of many traces, as often as fast; where the processor has registers of 512 bits
};

std::vector<NativeProgram> nativePrograms(std::uint64_t seed);

}  // namespace rungproof::bench
