// What a program is checked against and run on: a CPU, and the edition of the manual or the firmware that describes it.
// The CPUs and editions themselves are rows of their dialect's tables (ir/dialect.hpp); here they are numbers that no
// two dialects share, so that a set of CPUs is a set of bits.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rungproof {

/// A CPU: the number of its row.
enum class Cpu : std::uint8_t {};
/// Editions of manuals and firmware; rows: Dialect::editions. Of the S7-200 SMART: up to V2.7, and from V2.8 on. The
/// S7-300/400 has one: STEP 7 V5.4 (002).
enum class Edition : std::uint8_t { Edition2003, Edition2004, Smart27, Smart28, Step7, Iec };
inline constexpr int editionCount = 6;

/// A set of CPUs, one bit each.
using CpuSet = std::uint64_t;
constexpr CpuSet cpuBit(Cpu cpu) { return CpuSet{1} << static_cast<unsigned>(cpu); }
/// All CPUs of the dialect that the question is about.
inline constexpr CpuSet everyCpu = ~CpuSet{0};

struct Target {
  Cpu cpu;
  Edition edition;

  /// The CPU that is meant where none is named.
  Target();
  constexpr Target(Cpu theCpu, Edition theEdition) : cpu(theCpu), edition(theEdition) {}
};

/// "221" ... "ST60", in any case of letters and with "CPU" before it ("CPU 224"), or nothing.
std::optional<Cpu> cpuNamed(std::string_view name);
std::string_view cpuName(Cpu cpu);
/// "2003", "2004", "smart-2.7", "smart-2.8", as --edition takes it.
std::string_view editionName(Edition edition);
std::optional<Edition> editionNamed(std::string_view name);
/// As a sentence names it: "2004 edition of the manual", "firmware from V2.8 on".
std::string_view editionText(Edition edition);

}  // namespace rungproof
