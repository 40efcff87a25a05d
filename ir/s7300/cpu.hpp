// CPUs of the S7-300 and S7-400: one row each. The two course documents give only a few of the numbers (002:202,
// 002:495, 002:502-508, 002:1424); the sizes of the areas are general knowledge of the families. Where no CPU is named
// the largest of the family is meant, so that nothing legal is refused. Tested by tests/ir/step7_cpu_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "ir/area.hpp"
#include "ir/target.hpp"

namespace rungproof {

struct Step7CpuRow {
  std::string_view name;
  bool is400;
  std::uint32_t bitMemory;     ///< bytes of M
  std::uint32_t timers;        ///< and as many counters
  std::uint32_t lastBlock;     ///< highest number of a data block
  std::uint32_t longestBlock;  ///< bytes of a data block
  std::uint32_t localBytes;    ///< L stack of a priority class
  std::uint32_t image;         ///< bytes of I and of Q
  int accumulators;            ///< 002:1424-1426
  bool hidesStatus;            ///< L STW reads /FC, STA and OR as 0 (002:1603)
  int nesting;                 ///< blocks that call each other in one priority class
};

namespace cpu_rows {
// clang-format off
inline constexpr auto step7 = std::to_array<Step7CpuRow>({
    // name    400?   M      T,C   DB     bytes  L      image  accu hides nesting
    {"312",   false, 256,   256,  16000, 32768, 2048,  1024,  2, true,  8},
    {"313C",  false, 256,   256,  16000, 32768, 2048,  1024,  2, true,  8},
    {"314",   false, 256,   256,  16000, 32768, 2048,  1024,  2, true,  8},
    {"315-2", false, 2048,  256,  16000, 65535, 2048,  2048,  2, true,  8},
    {"317-2", false, 4096,  512,  16000, 65535, 2048,  2048,  2, true,  8},
    {"318-2", false, 8192,  512,  2047,  65535, 4096,  2048,  4, false, 16},
    {"319-3", false, 8192,  2048, 16000, 65535, 2048,  4096,  2, true,  8},
    {"412",   true,  4096,  2048, 3000,  65535, 8192,  4096,  4, false, 24},
    {"414",   true,  8192,  2048, 6000,  65535, 16384, 8192,  4, false, 24},
    {"416",   true,  16384, 2048, 10000, 65535, 32768, 16384, 4, false, 24},
    {"417",   true,  16384, 2048, 16000, 65535, 65535, 16384, 4, false, 24},
});
// clang-format on
}  // namespace cpu_rows

/// Number of the first of these CPUs among all (ir/target.hpp).
inline constexpr std::size_t firstStep7Cpu = 32;
constexpr bool isStep7(Cpu cpu) { return static_cast<std::size_t>(cpu) >= firstStep7Cpu; }
constexpr bool isStep7(const Target& target) { return isStep7(target.cpu); }
constexpr const Step7CpuRow& step7Row(Cpu cpu) {
  return cpu_rows::step7[static_cast<std::size_t>(cpu) - firstStep7Cpu];
}
/// The CPU of that name, which must stand in the rows.
consteval Cpu step7Cpu(std::string_view name) {
  for (std::size_t i = 0; i < cpu_rows::step7.size(); ++i) {
    if (cpu_rows::step7[i].name == name) return static_cast<Cpu>(firstStep7Cpu + i);
  }
  throw std::invalid_argument("no such CPU");
}

/// Size of an area in bytes (T, C: count) on that CPU; DB: 0, each block has its own length (ir/block_map.hpp).
constexpr std::uint32_t step7AreaSize(const Step7CpuRow& row, Area area) {
  switch (area) {
    case Area::I:
    case Area::Q: return row.image;
    case Area::AI:  // the words of PI as samples
    case Area::PI:
    case Area::PQ: return row.is400 ? 16384 : 8192;
    case Area::M: return row.bitMemory;
    case Area::L: return row.localBytes;
    case Area::T:
    case Area::C: return row.timers;
    default: return 0;
  }
}

}  // namespace rungproof
