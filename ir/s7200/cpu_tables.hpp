// Table 6-2 of both manual editions (001:2674-2717, 000:183-390) as data: highest legal start address of each kind
// of access, misprints resolved. tests/ir/cpu_table_test.cpp compares it with tests/data/operand-ranges.tsv.
// Columns: edition, area, width, highest start byte or number, CPUs, source, misprint or gap that was resolved.
#pragma once

#include <array>
#include <string_view>

#include "ir/s7200/cpu.hpp"

namespace rungproof::cpu_tables {

struct LimitRow {
  Edition edition;
  Area area;
  Width width;
  std::uint32_t last;
  CpuSet cpus;
  std::string_view source;
  std::string_view note;
};

inline constexpr CpuSet c212 = cpuBit(s7200Cpu("212")), c214 = cpuBit(s7200Cpu("214")), c221 = cpuBit(s7200Cpu("221")),
                        c222 = cpuBit(s7200Cpu("222")), c224 = cpuBit(s7200Cpu("224")),
                        c224XP = cpuBit(s7200Cpu("224XP")), c226 = cpuBit(s7200Cpu("226")),
                        c226XM = cpuBit(s7200Cpu("226XM"));
inline constexpr CpuSet all2004 = c221 | c222 | c224 | c224XP | c226;
inline constexpr CpuSet all2003 = c221 | c222 | c224 | c226 | c226XM;
/// The S7-212 and S7-214 are older than both editions; their rows serve whichever edition is chosen.
inline constexpr CpuSet oldCpus = c212 | c214;
inline constexpr Edition oldEdition = Edition::Edition2003;
inline constexpr std::string_view untabled =
    "limit from general knowledge: the application examples give no table for this CPU";

// clang-format off
inline constexpr LimitRow limits[] = {
    {Edition::Edition2004, Area::I, Width::Bit, 15, all2004, "001:2677", ""},
    {Edition::Edition2004, Area::Q, Width::Bit, 15, all2004, "001:2678", ""},
    {Edition::Edition2004, Area::V, Width::Bit, 2047, c221 | c222, "001:2679", ""},
    {Edition::Edition2004, Area::V, Width::Bit, 8191, c224, "001:2679", ""},
    {Edition::Edition2004, Area::V, Width::Bit, 10239, c224XP | c226, "001:2679", ""},
    {Edition::Edition2004, Area::M, Width::Bit, 31, all2004, "001:2680", ""},
    {Edition::Edition2004, Area::SM, Width::Bit, 165, c221, "001:2681", "Table 6-2 ends SM at byte 165, Table 6-1 (001:2652) and G-3 (001:14737) at byte 179; the 2003 Table 6-2 says 179 (000:192). Treat 166-179 as a warning"},
    {Edition::Edition2004, Area::SM, Width::Bit, 299, c222, "001:2681", ""},
    {Edition::Edition2004, Area::SM, Width::Bit, 549, c224 | c224XP | c226, "001:2681", ""},
    {Edition::Edition2004, Area::S, Width::Bit, 31, all2004, "001:2682", ""},
    {Edition::Edition2004, Area::T, Width::Bit, 255, all2004, "001:2683", ""},
    {Edition::Edition2004, Area::C, Width::Bit, 255, all2004, "001:2684", ""},
    {Edition::Edition2004, Area::L, Width::Bit, 63, all2004, "001:2685", ""},
    {Edition::Edition2004, Area::I, Width::Byte, 15, all2004, "001:2686", ""},
    {Edition::Edition2004, Area::Q, Width::Byte, 15, all2004, "001:2687", ""},
    {Edition::Edition2004, Area::V, Width::Byte, 2047, c221 | c222, "001:2688", ""},
    {Edition::Edition2004, Area::V, Width::Byte, 8191, c224, "001:2688", ""},
    {Edition::Edition2004, Area::V, Width::Byte, 10239, c224XP | c226, "001:2688", ""},
    {Edition::Edition2004, Area::M, Width::Byte, 31, all2004, "001:2689", ""},
    {Edition::Edition2004, Area::SM, Width::Byte, 165, c221, "001:2690", "Table 6-2 ends SM at byte 165, Table 6-1 (001:2652) and G-3 (001:14737) at byte 179; the 2003 Table 6-2 says 179 (000:192). Treat 166-179 as a warning"},
    {Edition::Edition2004, Area::SM, Width::Byte, 299, c222, "001:2690", ""},
    {Edition::Edition2004, Area::SM, Width::Byte, 549, c224 | c224XP | c226, "001:2690", ""},
    {Edition::Edition2004, Area::S, Width::Byte, 31, all2004, "001:2691", ""},
    {Edition::Edition2004, Area::L, Width::Byte, 63, all2004, "001:2692", ""},
    {Edition::Edition2004, Area::AC, Width::Byte, 3, c221 | c222 | c224, "001:2693", ""},
    {Edition::Edition2004, Area::AC, Width::Byte, 3, c224XP | c226, "001:2693", "printed 255 is a misprint: AC0-AC3 only (001:2664; same row 0-3 for the other CPUs; 001:2704, 001:2715)"},
    {Edition::Edition2004, Area::I, Width::Word, 14, all2004, "001:2695", ""},
    {Edition::Edition2004, Area::Q, Width::Word, 14, all2004, "001:2696", ""},
    {Edition::Edition2004, Area::V, Width::Word, 2046, c221 | c222, "001:2697", ""},
    {Edition::Edition2004, Area::V, Width::Word, 8190, c224, "001:2697", ""},
    {Edition::Edition2004, Area::V, Width::Word, 10238, c224XP | c226, "001:2697", ""},
    {Edition::Edition2004, Area::M, Width::Word, 30, all2004, "001:2698", ""},
    {Edition::Edition2004, Area::SM, Width::Word, 164, c221, "001:2699", "Table 6-2 ends SM at byte 165, Table 6-1 (001:2652) and G-3 (001:14737) at byte 179; the 2003 Table 6-2 says 179 (000:192). Treat 166-179 as a warning"},
    {Edition::Edition2004, Area::SM, Width::Word, 298, c222, "001:2699", ""},
    {Edition::Edition2004, Area::SM, Width::Word, 548, c224 | c224XP | c226, "001:2699", ""},
    {Edition::Edition2004, Area::S, Width::Word, 30, all2004, "001:2700", ""},
    {Edition::Edition2004, Area::T, Width::Word, 255, all2004, "001:2701", ""},
    {Edition::Edition2004, Area::C, Width::Word, 255, all2004, "001:2702", ""},
    {Edition::Edition2004, Area::L, Width::Word, 62, all2004, "001:2703", ""},
    {Edition::Edition2004, Area::AC, Width::Word, 3, all2004, "001:2704", ""},
    {Edition::Edition2004, Area::AI, Width::Word, 30, c221, "001:2705", "even addresses only (001:1380, 001:1386); contradicts Table A-4 (001:11651: analog image 'none' for CPU 221) and the 2003 table"},
    {Edition::Edition2004, Area::AI, Width::Word, 30, c222, "001:2705", ""},
    {Edition::Edition2004, Area::AI, Width::Word, 62, c224 | c224XP | c226, "001:2705", ""},
    {Edition::Edition2004, Area::AQ, Width::Word, 30, c221, "001:2706", "even addresses only (001:1380, 001:1386); contradicts Table A-4 (001:11651: analog image 'none' for CPU 221) and the 2003 table"},
    {Edition::Edition2004, Area::AQ, Width::Word, 30, c222, "001:2706", ""},
    {Edition::Edition2004, Area::AQ, Width::Word, 62, c224 | c224XP | c226, "001:2706", ""},
    {Edition::Edition2004, Area::I, Width::DWord, 12, all2004, "001:2708", ""},
    {Edition::Edition2004, Area::Q, Width::DWord, 12, all2004, "001:2709", ""},
    {Edition::Edition2004, Area::V, Width::DWord, 2044, c221 | c222, "001:2710", ""},
    {Edition::Edition2004, Area::V, Width::DWord, 8188, c224, "001:2710", ""},
    {Edition::Edition2004, Area::V, Width::DWord, 10236, c224XP | c226, "001:2710", ""},
    {Edition::Edition2004, Area::M, Width::DWord, 28, all2004, "001:2711", ""},
    {Edition::Edition2004, Area::SM, Width::DWord, 162, c221, "001:2712", "Table 6-2 ends SM at byte 165, Table 6-1 (001:2652) and G-3 (001:14737) at byte 179; the 2003 Table 6-2 says 179 (000:192). Treat 166-179 as a warning"},
    {Edition::Edition2004, Area::SM, Width::DWord, 296, c222, "001:2712", ""},
    {Edition::Edition2004, Area::SM, Width::DWord, 546, c224 | c224XP | c226, "001:2712", ""},
    {Edition::Edition2004, Area::S, Width::DWord, 28, all2004, "001:2713", ""},
    {Edition::Edition2004, Area::L, Width::DWord, 60, all2004, "001:2714", ""},
    {Edition::Edition2004, Area::AC, Width::DWord, 3, all2004, "001:2715", ""},
    {Edition::Edition2004, Area::HC, Width::DWord, 5, c221 | c222, "001:2716", "001:4166 says these CPUs lack HSC1 and HSC2; 2003 table lists 0,3,4,5. Effective set {0,3,4,5}"},
    {Edition::Edition2004, Area::HC, Width::DWord, 5, c224 | c224XP | c226, "001:2716", ""},
    {Edition::Edition2003, Area::I, Width::Bit, 15, all2003, "000:188", ""},
    {Edition::Edition2003, Area::Q, Width::Bit, 15, all2003, "000:189", ""},
    {Edition::Edition2003, Area::V, Width::Bit, 2047, c221 | c222, "000:190", ""},
    {Edition::Edition2003, Area::M, Width::Bit, 31, all2003, "000:191", ""},
    {Edition::Edition2003, Area::SM, Width::Bit, 179, c221, "000:192", ""},
    {Edition::Edition2003, Area::S, Width::Bit, 31, all2003, "000:193", ""},
    {Edition::Edition2003, Area::T, Width::Bit, 255, all2003, "000:194", ""},
    {Edition::Edition2003, Area::C, Width::Bit, 255, all2003, "000:195", ""},
    {Edition::Edition2003, Area::L, Width::Bit, 59, all2003, "000:196", ""},
    {Edition::Edition2003, Area::SM, Width::Bit, 299, c222, "000:202", ""},
    {Edition::Edition2003, Area::V, Width::Bit, 5119, c224 | c226, "000:210", ""},
    {Edition::Edition2003, Area::SM, Width::Bit, 549, c224 | c226 | c226XM, "000:212", ""},
    {Edition::Edition2003, Area::V, Width::Bit, 10239, c226XM, "000:220", ""},
    {Edition::Edition2003, Area::I, Width::Byte, 15, all2003, "000:237", ""},
    {Edition::Edition2003, Area::Q, Width::Byte, 15, all2003, "000:238", ""},
    {Edition::Edition2003, Area::V, Width::Byte, 2047, c221 | c222, "000:239", ""},
    {Edition::Edition2003, Area::M, Width::Byte, 31, all2003, "000:240", ""},
    {Edition::Edition2003, Area::SM, Width::Byte, 179, c221, "000:241", ""},
    {Edition::Edition2003, Area::S, Width::Byte, 31, all2003, "000:242", ""},
    {Edition::Edition2003, Area::L, Width::Byte, 63, all2003, "000:243", ""},
    {Edition::Edition2003, Area::AC, Width::Byte, 3, c221 | c222 | c224 | c226, "000:244", ""},
    {Edition::Edition2003, Area::SM, Width::Byte, 299, c222, "000:250", ""},
    {Edition::Edition2003, Area::V, Width::Byte, 5119, c224 | c226, "000:257", ""},
    {Edition::Edition2003, Area::SM, Width::Byte, 549, c224 | c226 | c226XM, "000:259", ""},
    {Edition::Edition2003, Area::V, Width::Byte, 10239, c226XM, "000:266", ""},
    {Edition::Edition2003, Area::AC, Width::Byte, 3, c226XM, "000:271", "printed 255 is a misprint: AC0-AC3 (000:164)"},
    {Edition::Edition2003, Area::I, Width::Word, 14, all2003, "000:286", ""},
    {Edition::Edition2003, Area::Q, Width::Word, 14, all2003, "000:287", ""},
    {Edition::Edition2003, Area::V, Width::Word, 2046, c221 | c222, "000:288", ""},
    {Edition::Edition2003, Area::M, Width::Word, 30, all2003, "000:289", ""},
    {Edition::Edition2003, Area::SM, Width::Word, 178, c221, "000:290", ""},
    {Edition::Edition2003, Area::S, Width::Word, 30, all2003, "000:291", ""},
    {Edition::Edition2003, Area::T, Width::Word, 255, all2003, "000:292", ""},
    {Edition::Edition2003, Area::C, Width::Word, 255, all2003, "000:293", ""},
    {Edition::Edition2003, Area::L, Width::Word, 58, all2003, "000:294", ""},
    {Edition::Edition2003, Area::AC, Width::Word, 3, all2003, "000:295", ""},
    {Edition::Edition2003, Area::SM, Width::Word, 298, c222, "000:303", ""},
    {Edition::Edition2003, Area::AI, Width::Word, 30, c222, "000:309", ""},
    {Edition::Edition2003, Area::AQ, Width::Word, 30, c222, "000:310", ""},
    {Edition::Edition2003, Area::V, Width::Word, 5118, c224 | c226, "000:314", ""},
    {Edition::Edition2003, Area::SM, Width::Word, 548, c224 | c226 | c226XM, "000:316", ""},
    {Edition::Edition2003, Area::AI, Width::Word, 62, c224 | c226 | c226XM, "000:322", ""},
    {Edition::Edition2003, Area::AQ, Width::Word, 62, c224 | c226 | c226XM, "000:323", ""},
    {Edition::Edition2003, Area::V, Width::Word, 10238, c226XM, "000:327", ""},
    {Edition::Edition2003, Area::I, Width::DWord, 12, all2003, "000:348", ""},
    {Edition::Edition2003, Area::Q, Width::DWord, 12, all2003, "000:349", ""},
    {Edition::Edition2003, Area::V, Width::DWord, 2044, c221 | c222, "000:350", ""},
    {Edition::Edition2003, Area::M, Width::DWord, 28, all2003, "000:351", ""},
    {Edition::Edition2003, Area::SM, Width::DWord, 176, c221, "000:352", ""},
    {Edition::Edition2003, Area::S, Width::DWord, 28, all2003, "000:353", ""},
    {Edition::Edition2003, Area::L, Width::DWord, 56, all2003, "000:354", ""},
    {Edition::Edition2003, Area::AC, Width::DWord, 3, all2003, "000:355", ""},
    {Edition::Edition2003, Area::HC, Width::DWord, 0, c221 | c222, "000:356", ""},
    {Edition::Edition2003, Area::HC, Width::DWord, 5, all2003, "000:356", ""},
    {Edition::Edition2003, Area::SM, Width::DWord, 296, c222, "000:362", ""},
    {Edition::Edition2003, Area::V, Width::DWord, 5116, c224 | c226, "000:370", ""},
    {Edition::Edition2003, Area::SM, Width::DWord, 546, c224 | c226 | c226XM, "000:372", ""},
    {Edition::Edition2003, Area::V, Width::DWord, 10236, c226XM, "000:380", ""},
    {oldEdition, Area::I, Width::Bit, 7, c212, "", untabled},
    {oldEdition, Area::I, Width::Byte, 7, c212, "", untabled},
    {oldEdition, Area::I, Width::Word, 6, c212, "", untabled},
    {oldEdition, Area::I, Width::DWord, 4, c212, "", untabled},
    {oldEdition, Area::Q, Width::Bit, 7, c212, "", untabled},
    {oldEdition, Area::Q, Width::Byte, 7, c212, "", untabled},
    {oldEdition, Area::Q, Width::Word, 6, c212, "", untabled},
    {oldEdition, Area::Q, Width::DWord, 4, c212, "", untabled},
    {oldEdition, Area::V, Width::Bit, 1023, c212, "", untabled},
    {oldEdition, Area::V, Width::Byte, 1023, c212, "", untabled},
    {oldEdition, Area::V, Width::Word, 1022, c212, "", untabled},
    {oldEdition, Area::V, Width::DWord, 1020, c212, "", untabled},
    {oldEdition, Area::M, Width::Bit, 15, c212, "", untabled},
    {oldEdition, Area::M, Width::Byte, 15, c212, "", untabled},
    {oldEdition, Area::M, Width::Word, 14, c212, "", untabled},
    {oldEdition, Area::M, Width::DWord, 12, c212, "", untabled},
    {oldEdition, Area::SM, Width::Bit, 45, c212, "", untabled},
    {oldEdition, Area::SM, Width::Byte, 45, c212, "", untabled},
    {oldEdition, Area::SM, Width::Word, 44, c212, "", untabled},
    {oldEdition, Area::SM, Width::DWord, 42, c212, "", untabled},
    {oldEdition, Area::S, Width::Bit, 7, c212, "", untabled},
    {oldEdition, Area::S, Width::Byte, 7, c212, "", untabled},
    {oldEdition, Area::S, Width::Word, 6, c212, "", untabled},
    {oldEdition, Area::S, Width::DWord, 4, c212, "", untabled},
    {oldEdition, Area::T, Width::Bit, 63, c212, "004:4564", ""},
    {oldEdition, Area::T, Width::Word, 63, c212, "004:4564", ""},
    {oldEdition, Area::C, Width::Bit, 63, c212, "", untabled},
    {oldEdition, Area::C, Width::Word, 63, c212, "", untabled},
    {oldEdition, Area::AC, Width::Byte, 3, c212, "", untabled},
    {oldEdition, Area::AC, Width::Word, 3, c212, "", untabled},
    {oldEdition, Area::AC, Width::DWord, 3, c212, "", untabled},
    {oldEdition, Area::AI, Width::Word, 30, c212, "", untabled},
    {oldEdition, Area::AQ, Width::Word, 30, c212, "", untabled},
    {oldEdition, Area::HC, Width::DWord, 0, c212, "", untabled},
    {oldEdition, Area::I, Width::Bit, 7, c214, "", untabled},
    {oldEdition, Area::I, Width::Byte, 7, c214, "", untabled},
    {oldEdition, Area::I, Width::Word, 6, c214, "", untabled},
    {oldEdition, Area::I, Width::DWord, 4, c214, "", untabled},
    {oldEdition, Area::Q, Width::Bit, 7, c214, "", untabled},
    {oldEdition, Area::Q, Width::Byte, 7, c214, "", untabled},
    {oldEdition, Area::Q, Width::Word, 6, c214, "", untabled},
    {oldEdition, Area::Q, Width::DWord, 4, c214, "", untabled},
    {oldEdition, Area::V, Width::Bit, 4095, c214, "004:2605", untabled},
    {oldEdition, Area::V, Width::Byte, 4095, c214, "004:2605", untabled},
    {oldEdition, Area::V, Width::Word, 4094, c214, "004:2605", untabled},
    {oldEdition, Area::V, Width::DWord, 4092, c214, "004:2605", untabled},
    {oldEdition, Area::M, Width::Bit, 31, c214, "", untabled},
    {oldEdition, Area::M, Width::Byte, 31, c214, "", untabled},
    {oldEdition, Area::M, Width::Word, 30, c214, "", untabled},
    {oldEdition, Area::M, Width::DWord, 28, c214, "", untabled},
    {oldEdition, Area::SM, Width::Bit, 85, c214, "", untabled},
    {oldEdition, Area::SM, Width::Byte, 85, c214, "", untabled},
    {oldEdition, Area::SM, Width::Word, 84, c214, "", untabled},
    {oldEdition, Area::SM, Width::DWord, 82, c214, "", untabled},
    {oldEdition, Area::S, Width::Bit, 15, c214, "", untabled},
    {oldEdition, Area::S, Width::Byte, 15, c214, "", untabled},
    {oldEdition, Area::S, Width::Word, 14, c214, "", untabled},
    {oldEdition, Area::S, Width::DWord, 12, c214, "", untabled},
    {oldEdition, Area::T, Width::Bit, 127, c214, "004:4564", ""},
    {oldEdition, Area::T, Width::Word, 127, c214, "004:4564", ""},
    {oldEdition, Area::C, Width::Bit, 127, c214, "", untabled},
    {oldEdition, Area::C, Width::Word, 127, c214, "", untabled},
    {oldEdition, Area::AC, Width::Byte, 3, c214, "", untabled},
    {oldEdition, Area::AC, Width::Word, 3, c214, "", untabled},
    {oldEdition, Area::AC, Width::DWord, 3, c214, "", untabled},
    {oldEdition, Area::AI, Width::Word, 30, c214, "", untabled},
    {oldEdition, Area::AQ, Width::Word, 30, c214, "", untabled},
    {oldEdition, Area::HC, Width::DWord, 2, c214, "", untabled},
};
// clang-format on

/// The process images of the S7-200 SMART end at byte 31; on the standard line PROFINET data follow from byte 128 on.
inline constexpr std::uint32_t localImage = 32, networkImage = 128;

/// Last byte (number) of an area of the S7-200 SMART, for each firmware and line.
struct SmartArea {
  Area area;
  Edition edition;
  CpuSet cpus;
  std::uint32_t last;
};
namespace smart_sets {
inline constexpr CpuSet standard =
    cpusWith([](const CpuRow& row) { return row.series == Series::Smart && row.features.ports == 2; });
inline constexpr CpuSet compact = smartCpus & ~standard;
inline constexpr CpuSet c20 = cpuBit(s7200Cpu("SR20")) | cpuBit(s7200Cpu("ST20")),
                        c30 = cpuBit(s7200Cpu("SR30")) | cpuBit(s7200Cpu("ST30")),
                        c40 = cpuBit(s7200Cpu("SR40")) | cpuBit(s7200Cpu("ST40")),
                        c60 = cpuBit(s7200Cpu("SR60")) | cpuBit(s7200Cpu("ST60"));
}  // namespace smart_sets

inline constexpr auto smartAreas = [] {
  using namespace smart_sets;
  std::array<SmartArea, 40> areas{};
  std::size_t count = 0;
  const auto both = [&](Area area, CpuSet cpus, std::uint32_t last) {
    for (const Edition edition : {Edition::Smart27, Edition::Smart28}) areas[count++] = {area, edition, cpus, last};
  };
  for (const Area area : {Area::I, Area::Q}) {
    both(area, compact, localImage - 1);
    both(area, standard, 1279);
  }
  for (const Area area : {Area::M, Area::S}) both(area, smartCpus, 31);
  both(Area::SM, smartCpus, 2047);
  both(Area::L, smartCpus, 63);
  for (const Area area : {Area::T, Area::C}) both(area, smartCpus, 255);
  both(Area::AC, smartCpus, 3);
  for (const Area area : {Area::AI, Area::AQ}) both(area, standard, 111);
  both(Area::HC, compact, 3);
  both(Area::HC, standard, 5);
  both(Area::V, compact, 8191);
  const CpuSet sizes[] = {c20, c30, c40, c60};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t older = 8192 + 4096 * i;  // V2.8 has 4 KB more
    areas[count++] = {Area::V, Edition::Smart27, sizes[i], older - 1};
    areas[count++] = {Area::V, Edition::Smart28, sizes[i], older + 4095};
  }
  return areas;
}();

/// Whether an area can be accessed in that width: T and C by bit and word, AC without bits, HC as double word only.
constexpr bool hasWidth(Area area, Width width) {
  switch (area) {
    case Area::T:
    case Area::C: return width == Width::Bit || width == Width::Word;
    case Area::AC: return width != Width::Bit;
    case Area::AI:
    case Area::AQ: return width == Width::Word;
    case Area::HC: return width == Width::DWord;
    default: return true;
  }
}

inline constexpr auto smartLimits = [] {
  std::array<LimitRow, smartAreas.size() * 4> rows{};
  std::size_t count = 0;
  for (const SmartArea& area : smartAreas) {
    for (const Width width : {Width::Bit, Width::Byte, Width::Word, Width::DWord}) {
      const bool byNumber =
          area.area == Area::T || area.area == Area::C || area.area == Area::AC || area.area == Area::HC;
      const std::uint32_t length = width == Width::Word ? 2 : width == Width::DWord ? 4 : 1;
      const std::uint32_t last = byNumber ? area.last : area.last + 1 - length;
      rows[count++] = {area.edition, area.area, width, last, hasWidth(area.area, width) ? area.cpus : 0,
                       smartManual,  ""};
    }
  }
  return rows;
}();

}  // namespace rungproof::cpu_tables
