// Look-ups in tables 6-1 and 6-2.
#include "ir/cpu.hpp"

#include <algorithm>
#include <array>

#include "ir/cpu_tables.hpp"

namespace rungproof {

namespace {

constexpr std::array<std::string_view, cpuCount> names = {"212", "214", "221", "222", "224", "224XP", "226", "226XM"};

bool isOld(Cpu cpu) { return cpu == Cpu::Cpu212 || cpu == Cpu::Cpu214; }

/// One cell per edition, CPU, area and width, filled once from the rows.
struct LimitIndex {
  std::array<const cpu_tables::LimitRow*, 2 * cpuCount * areaCount * 4> cell{};

  static std::size_t at(Edition edition, Cpu cpu, Area area, Width width) {
    return ((static_cast<std::size_t>(edition) * cpuCount + static_cast<std::size_t>(cpu)) * areaCount +
            static_cast<std::size_t>(area)) *
               4 +
           static_cast<std::size_t>(width);
  }
  LimitIndex() {
    for (const cpu_tables::LimitRow& row : cpu_tables::limits) {
      for (int c = 0; c < cpuCount; ++c) {
        const Cpu cpu = static_cast<Cpu>(c);
        if ((row.cpus & cpuBit(cpu)) != 0) cell[at(row.edition, cpu, row.area, row.width)] = &row;
      }
    }
  }
};

const cpu_tables::LimitRow* limitRow(const Target& target, Area area, Width width) {
  static const LimitIndex index;
  // A CPU that the chosen edition does not describe keeps the limits of the one that does.
  const Edition other = target.edition == Edition::Edition2003 ? Edition::Edition2004 : Edition::Edition2003;
  const Edition edition = editionCovers(target.edition, target.cpu) && !isOld(target.cpu) ? target.edition
                          : isOld(target.cpu)                                             ? cpu_tables::oldEdition
                                                                                          : other;
  return index.cell[LimitIndex::at(edition, target.cpu, area, width)];
}

}  // namespace

std::optional<Cpu> cpuNamed(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Cpu>(found - names.begin());
}

std::string_view cpuName(Cpu cpu) { return names[static_cast<std::size_t>(cpu)]; }

bool editionCovers(Edition edition, Cpu cpu) {
  if (isOld(cpu)) return true;
  return edition == Edition::Edition2003 ? cpu != Cpu::Cpu224XP : cpu != Cpu::Cpu226XM;
}

std::optional<AddressLimit> addressLimit(const Target& target, Area area, Width width) {
  const cpu_tables::LimitRow* row = limitRow(target, area, width);
  if (row == nullptr) return std::nullopt;
  return AddressLimit{row->last, row->source, row->note};
}

bool addressExists(const Target& target, Area area, Width width, std::uint32_t offset, unsigned bit) {
  const cpu_tables::LimitRow* row = limitRow(target, area, width);
  if (row == nullptr || offset > row->last) return false;
  if (area == Area::HC) return hscExists(target, static_cast<int>(offset));
  if (isAnalogue(area)) return offset % 2 == 0;
  return width != Width::Bit || hasBitAndWord(area) || bit <= 7;
}

CpuFeatures cpuFeatures(const Target& target) {
  CpuFeatures features;
  const bool large = target.cpu == Cpu::Cpu224XP || target.cpu == Cpu::Cpu226 || target.cpu == Cpu::Cpu226XM;
  if (large) {
    features.ports = 2;
    features.queueCommunication = 8;
  }
  // 001:2666 against 001:6751 for the 224XP: the stricter number is kept, the rule names both lines.
  const bool manySubroutines =
      target.cpu == Cpu::Cpu226XM || (target.cpu == Cpu::Cpu226 && target.edition == Edition::Edition2004);
  if (manySubroutines) features.subroutines = 128;
  if (target.cpu == Cpu::Cpu221 || target.cpu == Cpu::Cpu222) features.clockBuiltIn = false;
  // No table of the CPUs before 22x is at hand: general knowledge, except that the 212 lacks pulse outputs and clock
  // (004:345, 004:734).
  if (isOld(target.cpu)) {
    features.pidLoops = 0;
    features.queueTimed = 4;
  }
  if (target.cpu == Cpu::Cpu212) {
    features.subroutines = 16;
    features.interruptRoutines = 32;
    features.labels = 64;
    features.queueIo = 4;
    features.queueTimed = 2;
    features.pulseOutputs = 0;
    features.clockBuiltIn = false;
  }
  return features;
}

bool eventExists(const Target& target, int event) {
  if (event < 0 || event > 33) return false;
  if (target.cpu == Cpu::Cpu212) return event <= 1 || (event >= 8 && event <= 10) || event == 12;
  if (target.cpu == Cpu::Cpu214) return event <= 20;
  if (target.cpu == Cpu::Cpu221 || target.cpu == Cpu::Cpu222)
    return event <= 12 || (event >= 19 && event <= 23) || event >= 27;
  if (target.cpu == Cpu::Cpu224) return event <= 23 || event >= 27;
  return true;
}

bool hscExists(const Target& target, int counter) {
  if (counter < 0 || counter > 5) return false;
  if (target.cpu == Cpu::Cpu212) return counter == 0;
  if (target.cpu == Cpu::Cpu214) return counter <= 2;
  if (target.cpu == Cpu::Cpu221 || target.cpu == Cpu::Cpu222) return counter != 1 && counter != 2;
  return true;
}

namespace {

struct TimerRange {
  int low, high, resolution;
  bool retentive;
};
// Table 6-74 (001:6597-6603).
constexpr TimerRange timerRanges[] = {
    {0, 0, 1, true},     {1, 4, 10, true},     {5, 31, 100, true},   {32, 32, 1, false},
    {33, 36, 10, false}, {37, 63, 100, false}, {64, 64, 1, true},    {65, 68, 10, true},
    {69, 95, 100, true}, {96, 96, 1, false},   {97, 100, 10, false}, {101, 255, 100, false},
};

const TimerRange* timerRange(int number) {
  const auto found = std::find_if(std::begin(timerRanges), std::end(timerRanges),
                                  [&](const TimerRange& range) { return number >= range.low && number <= range.high; });
  return found == std::end(timerRanges) ? nullptr : &*found;
}

}  // namespace

int timerResolution(int number) {
  const TimerRange* range = timerRange(number);
  return range == nullptr ? 0 : range->resolution;
}

bool timerIsRetentive(int number) {
  const TimerRange* range = timerRange(number);
  return range != nullptr && range->retentive;
}

std::uint32_t areaSize(const Target& target, Area area) {
  const Width width = areaInfo(area).width.value_or(Width::Byte);
  const std::optional<AddressLimit> limit = addressLimit(target, area, width);
  if (!limit) return 0;
  return limit->lastByte + static_cast<std::uint32_t>(isAnalogue(area) ? 2 : 1);
}

}  // namespace rungproof
