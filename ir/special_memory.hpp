// Special memory: where the value of each SM bit comes from, by the tables of appendix D (001:14041-14400). The engine,
// the encoder, the stimulus and the rules take it from here. A bit that stands in no table, or that the manual
// reserves in a control byte, keeps what the program writes; reserved status bits have any value.
// Covered by tests/environment/special_memory_test.cpp, row by row of the manual's tables.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "ir/cpu.hpp"

namespace rungproof {

enum class SmSource : std::uint8_t {
  Constant,   ///< one value for ever
  Computed,   ///< by the CPU from the run: instructions, clocks, scan times
  FirstScan,  ///< any value in the first scan, 0 in all others
  Free,       ///< any value in every scan: switches, modules, faults, received characters
  Device,     ///< written by a device that the program has set going (analysis/encoding/device_writes.cpp)
  Program     ///< what the program has written
};

/// Bytes `first` to `last`, of each the bits `low` to `high`.
struct SmRow {
  std::uint16_t first, last;
  std::uint8_t low, high;
  SmSource source;
  std::string_view text;
  std::string_view manual;

  constexpr bool holds(std::uint32_t byte, std::uint32_t bit) const {
    return first <= byte && byte <= last && low <= bit && bit <= high;
  }
  constexpr bool isWritable() const { return first > smReadOnlyLast; }  // 001:2652
};

// clang-format off
inline constexpr std::array smTable = {
    SmRow{0, 0, 0, 0, SmSource::Constant, "always 1", "001:14050"},
    SmRow{0, 0, 1, 1, SmSource::Computed, "first scan", "001:14051"},
    SmRow{0, 0, 2, 2, SmSource::FirstScan, "retentive data were lost", "001:14052"},
    SmRow{0, 0, 3, 3, SmSource::FirstScan, "RUN was entered by switching the power on", "001:14053"},
    SmRow{0, 0, 4, 4, SmSource::Computed, "clock of 1 min", "001:14054"},
    SmRow{0, 0, 5, 5, SmSource::Computed, "clock of 1 s", "001:14055"},
    SmRow{0, 0, 6, 6, SmSource::Computed, "scan clock", "001:14056"},
    SmRow{0, 0, 7, 7, SmSource::Free, "mode switch: RUN, not TERM", "001:14057"},
    SmRow{1, 1, 0, 7, SmSource::Computed, "status of instructions", "001:14061"},
    SmRow{2, 2, 0, 7, SmSource::Free, "received character", "001:14085"},
    SmRow{3, 3, 0, 0, SmSource::Free, "parity error of the received character", "001:14094"},
    SmRow{3, 3, 1, 7, SmSource::Free, "reserved", "001:14095"},
    SmRow{4, 4, 0, 2, SmSource::Computed, "interrupt queue overflow", "001:14104-14106"},
    SmRow{4, 4, 3, 3, SmSource::Computed, "run-time error", "001:14107"},
    SmRow{4, 4, 4, 4, SmSource::Computed, "interrupts are enabled", "001:14108"},
    SmRow{4, 4, 5, 6, SmSource::Device, "transmitter of port 0, 1 is idle", "001:14109-14110"},
    SmRow{4, 4, 7, 7, SmSource::Computed, "values are forced", "001:14111"},
    SmRow{5, 5, 0, 7, SmSource::Free, "I/O errors", "001:14118-14126"},
    SmRow{6, 6, 0, 3, SmSource::Free, "reserved", "001:14137"},
    SmRow{6, 6, 4, 7, SmSource::Constant, "CPU identifier", "001:14138"},
    SmRow{7, 7, 0, 7, SmSource::Free, "reserved", "001:14142"},
    SmRow{8, 21, 0, 7, SmSource::Free, "identification and errors of expansion modules", "001:14027"},
    SmRow{22, 27, 0, 7, SmSource::Computed, "scan times", "001:14151-14153"},
    SmRow{28, 29, 0, 7, SmSource::Free, "analog potentiometers", "001:14162-14163"},
    SmRow{30, 30, 0, 7, SmSource::Program, "control of port 0", "001:14167"},
    SmRow{31, 31, 0, 6, SmSource::Program, "size of the value to save", "001:1648"},
    SmRow{31, 31, 7, 7, SmSource::Device, "save to permanent memory; cleared when done", "001:1649-1651"},
    SmRow{32, 35, 0, 7, SmSource::Program, "address of the value to save; timed interrupts", "001:1643, 001:5470"},
    SmRow{36, 36, 0, 4, SmSource::Program, "not used", "001:14188"},
    SmRow{36, 36, 5, 7, SmSource::Device, "status of HSC0", "001:14189-14191"},
    SmRow{37, 45, 0, 7, SmSource::Program, "control of HSC0", "001:14192-14201"},
    SmRow{46, 46, 0, 4, SmSource::Program, "not used", "001:14202"},
    SmRow{46, 46, 5, 7, SmSource::Device, "status of HSC1", "001:14203-14205"},
    SmRow{47, 55, 0, 7, SmSource::Program, "control of HSC1", "001:14206-14215"},
    SmRow{56, 56, 0, 4, SmSource::Program, "not used", "001:14220"},
    SmRow{56, 56, 5, 7, SmSource::Device, "status of HSC2", "001:14221-14223"},
    SmRow{57, 65, 0, 7, SmSource::Program, "control of HSC2", "001:14224-14233"},
    SmRow{66, 66, 0, 3, SmSource::Program, "reserved", "001:14242"},
    SmRow{66, 66, 4, 7, SmSource::Device, "status of PTO0", "001:14243-14246"},
    SmRow{67, 75, 0, 7, SmSource::Program, "control of PTO0 and PWM0", "001:14247-14261"},
    SmRow{76, 76, 0, 3, SmSource::Program, "reserved", "001:14262"},
    SmRow{76, 76, 4, 7, SmSource::Device, "status of PTO1", "001:14263-14266"},
    SmRow{77, 85, 0, 7, SmSource::Program, "control of PTO1 and PWM1", "001:14267-14277"},
    SmRow{86, 86, 0, 7, SmSource::Device, "status of RCV at port 0", "001:14286"},
    SmRow{87, 97, 0, 7, SmSource::Program, "control of RCV at port 0", "001:14288-14294"},
    SmRow{98, 99, 0, 7, SmSource::Free, "errors of the expansion bus", "001:14303"},
    SmRow{100, 129, 0, 7, SmSource::Program, "in no table", "001:14041"},
    SmRow{130, 130, 0, 7, SmSource::Program, "control of port 1", "001:14167"},
    SmRow{131, 135, 0, 7, SmSource::Program, "reserved", "001:14316"},
    SmRow{136, 136, 0, 4, SmSource::Program, "not used", "001:14317"},
    SmRow{136, 136, 5, 7, SmSource::Device, "status of HSC3", "001:14318-14320"},
    SmRow{137, 145, 0, 7, SmSource::Program, "control of HSC3", "001:14321-14328"},
    SmRow{146, 146, 0, 4, SmSource::Program, "not used", "001:14329"},
    SmRow{146, 146, 5, 7, SmSource::Device, "status of HSC4", "001:14330-14332"},
    SmRow{147, 155, 0, 7, SmSource::Program, "control of HSC4", "001:14333-14346"},
    SmRow{156, 156, 0, 4, SmSource::Program, "not used", "001:14347"},
    SmRow{156, 156, 5, 7, SmSource::Device, "status of HSC5", "001:14348-14350"},
    SmRow{157, 165, 0, 7, SmSource::Program, "control of HSC5", "001:14351-14358"},
    SmRow{166, 166, 0, 7, SmSource::Device, "active segment of PTO0", "001:14367"},
    SmRow{167, 169, 0, 7, SmSource::Program, "reserved; profile of PTO0", "001:14368-14369"},
    SmRow{170, 171, 0, 7, SmSource::Free, "status and result of the linear PTO0", "001:14370-14371"},
    SmRow{172, 175, 0, 7, SmSource::Program, "frequency of the linear PTO0; profile of PTO0", "001:14369, 001:14372"},
    SmRow{176, 176, 0, 7, SmSource::Device, "active segment of PTO1", "001:14373"},
    SmRow{177, 179, 0, 7, SmSource::Program, "reserved; profile of PTO1", "001:14374-14375"},
    SmRow{180, 181, 0, 7, SmSource::Free, "status and result of the linear PTO1", "001:14376-14377"},
    SmRow{182, 185, 0, 7, SmSource::Program, "frequency of the linear PTO1; profile of PTO1", "001:14375, 001:14378"},
    SmRow{186, 186, 0, 7, SmSource::Device, "status of RCV at port 1", "001:14286"},
    SmRow{187, 199, 0, 7, SmSource::Program, "control of RCV at port 1", "001:14288-14294"},
    SmRow{200, 549, 0, 7, SmSource::Free, "intelligent modules", "001:14394-14397"}};
// clang-format on

/// The row of a bit; bytes behind the table, which no CPU has, count as its last row.
constexpr const SmRow& smRow(std::uint32_t byte, std::uint32_t bit) {
  for (const SmRow& row : smTable) {
    if (row.holds(byte, bit)) return row;
  }
  return smTable.back();
}

/// SM6.4 to SM6.7 as the high half of the byte (001:14138); nothing: the manual has no code for the CPU.
constexpr std::optional<std::uint8_t> cpuIdentifier(Cpu cpu) {
  switch (cpu) {
    case Cpu::Cpu222: return 0x00;
    case Cpu::Cpu224: return 0x20;
    case Cpu::Cpu221: return 0x60;
    case Cpu::Cpu226:
    case Cpu::Cpu226XM: return 0x90;
    default: return std::nullopt;
  }
}

/// The source of a bit on that CPU.
constexpr SmSource smSource(const Target& target, std::uint32_t byte, std::uint32_t bit) {
  const SmSource source = smRow(byte, bit).source;
  const bool isUnknownCpu = byte == 6 && source == SmSource::Constant && !cpuIdentifier(target.cpu);
  return isUnknownCpu ? SmSource::Free : source;
}

namespace detail {
/// Every bit up to the last stands in exactly one row, and the rows are in order.
constexpr bool smTableIsComplete() {
  std::size_t at = 0;
  for (std::uint32_t byte = 0; byte <= smTable.back().last; ++byte) {
    for (std::uint32_t bit = 0; bit < 8; ++bit) {
      while (at < smTable.size() && !smTable[at].holds(byte, bit)) {
        const bool isOver = smTable[at].last < byte || (smTable[at].last == byte && smTable[at].high < bit);
        if (!isOver) return false;
        ++at;
      }
      if (at == smTable.size()) return false;
    }
  }
  return at + 1 == smTable.size();
}
static_assert(smTableIsComplete(), "smTable must cover the special memory in order");
}  // namespace detail

}  // namespace rungproof
