// CPU models and their limits: tables 6-1 and 6-2 of both manual editions (001:2640-2717, 000:30-390).
// The only place with limits; everything else asks here.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "ir/operand.hpp"

namespace rungproof {

enum class Cpu : std::uint8_t { Cpu212, Cpu214, Cpu221, Cpu222, Cpu224, Cpu224XP, Cpu226, Cpu226XM };
inline constexpr int cpuCount = 8;
enum class Edition : std::uint8_t { Edition2003, Edition2004 };

/// A set of CPU models, one bit each.
using CpuSet = std::uint16_t;
constexpr CpuSet cpuBit(Cpu cpu) { return static_cast<CpuSet>(1U << static_cast<unsigned>(cpu)); }
inline constexpr CpuSet everyCpu = (1U << cpuCount) - 1;

/// What a program is checked against and run on.
struct Target {
  Cpu cpu = Cpu::Cpu226;
  Edition edition = Edition::Edition2004;
};

/// "221" ... "226XM", or nothing.
std::optional<Cpu> cpuNamed(std::string_view name);
std::string_view cpuName(Cpu cpu);
/// Whether the manual edition describes that CPU at all (224XP: 2004 only; 226XM: 2003 only; 212/214: seed 004).
bool editionCovers(Edition edition, Cpu cpu);

/// Highest legal start address of an access (table 6-2). Areas without such access give nothing.
struct AddressLimit {
  std::uint32_t lastByte = 0;  ///< highest start byte, or highest number for T, C, AC, HC
  std::string_view source;     ///< "001:2679"
  std::string_view note;       ///< the misprint that was resolved, or empty
};
std::optional<AddressLimit> addressLimit(const Target& target, Area area, Width width);
/// Whether the address exists; knows the gaps (HC1/HC2 on 221/222, odd AI/AQ).
bool addressExists(const Target& target, Area area, Width width, std::uint32_t offset, unsigned bit);

/// Numbers that tables 6-1, 6-45 and 6-48 give per CPU.
struct CpuFeatures {
  int subroutines = 64;         ///< count; numbers are 0..subroutines-1 (001:2666)
  int interruptRoutines = 128;  ///< 001:2667
  int labels = 256;             ///< 001:2665
  int edges = 256;              ///< EU plus ED (001:2668)
  int pidLoops = 8;             ///< 001:2669
  int ports = 1;                ///< 001:2670
  int queueCommunication = 4;   ///< 001:5487
  int queueIo = 16;             ///< 001:5488
  int queueTimed = 8;           ///< 001:5489
  int pulseOutputs = 2;
  bool clockBuiltIn = true;  ///< 001:565; without, TODR gives error 000C
};
CpuFeatures cpuFeatures(const Target& target);
/// Whether the CPU has that interrupt event (001:5366).
bool eventExists(const Target& target, int event);
bool hscExists(const Target& target, int counter);
/// SM0..smReadOnlyLast are read only (001:2652).
inline constexpr std::uint32_t smReadOnlyLast = 29;

/// Resolution in ms of a timer number, 1, 10 or 100 (table 6-74, 001:6597-6603), or 0 if there is no such timer.
int timerResolution(int number);
/// Whether the number belongs to TONR (true) or to TON/TOF.
bool timerIsRetentive(int number);

/// Size of an area in bytes on that CPU (T, C, AC, HC: count).
std::uint32_t areaSize(const Target& target, Area area);

}  // namespace rungproof
