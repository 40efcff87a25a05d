// Random numbers of the differential tests: a seed from the environment (RUNGPROOF_SEED) or a fixed one, printed with
// every failure, and values that favour the edges of a width.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <random>

namespace rungproof {

inline std::uint64_t testSeed() {
  const char* given = std::getenv("RUNGPROOF_SEED");
  return given == nullptr ? 20040601 : std::strtoull(given, nullptr, 10);
}

class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /// 0 .. limit - 1.
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(engine_() % limit); }
  bool chance(std::uint32_t percent) { return below(100) < percent; }
  /// A value of `width` bits; often 0, 1, the highest, the sign bit, or a neighbour of those.
  std::uint64_t value(int width) {
    const std::uint64_t mask = width >= 64 ? ~0ULL : (1ULL << width) - 1;
    const std::uint64_t sign = mask ^ mask >> 1;
    switch (below(10)) {
      case 0: return 0;
      case 1: return 1 & mask;
      case 2: return mask;
      case 3: return sign;
      case 4: return sign - 1;
      case 5: return below(16) & mask;
      default: return engine_() & mask;
    }
  }
  template <class T>
  const T& oneOf(const std::vector<T>& list) {
    return list[below(static_cast<std::uint32_t>(list.size()))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace rungproof
