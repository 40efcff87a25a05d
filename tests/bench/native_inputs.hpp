// The inputs of a trace of the benchmark against C: 64 bits that change every so many scans, the same for each side.
#pragma once

#include <cstdint>

namespace rungproof::bench {

constexpr std::uint64_t seed = 2026;
constexpr int scansPerInput = 8;

class Inputs {
 public:
  explicit Inputs(std::uint64_t trace = 0) : state_(seed + trace * 0x9E3779B97F4A7C15ULL) {}
  std::uint64_t next() { return state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL; }

 private:
  std::uint64_t state_;
};

}  // namespace rungproof::bench
