// Random numbers that are the same on every machine, so that a seed names a program and a run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rungproof::referee {

class Random {
 public:
  /// Neighbouring seeds give unrelated sequences.
  explicit Random(std::uint64_t seed) : state_(mixed(seed + 0x632BE59BD9B4E019U)) {}

  std::uint64_t next() { return mixed(state_ += 0x9E3779B97F4A7C15U); }
  /// 0 to n - 1; n is at least 1.
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool chance(int percent) { return below(100) < percent; }
  template <typename Value>
  const Value& any(const std::vector<Value>& values) {
    return values[static_cast<std::size_t>(below(static_cast<int>(values.size())))];
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace rungproof::referee
