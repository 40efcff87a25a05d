// Look-ups in tables 6-1 and 6-2.
#include "ir/s7200/cpu.hpp"

#include <algorithm>
#include <array>

#include "ir/machine/frame.hpp"
#include "ir/s7200/cpu_tables.hpp"

namespace rungproof {

namespace {

constexpr int mostOf(int CpuFeatures::*number) {
  int most = 0;
  for (const CpuRow& row : cpu_rows::rows) most = std::max(most, row.features.*number);
  return most;
}
static_assert(mostOf(&CpuFeatures::interruptNesting) == static_cast<int>(mostInterruptNesting));
static_assert(mostOf(&CpuFeatures::stackLevels) == static_cast<int>(mostStackLevels));

/// One cell per edition, CPU, area and width, filled once from the rows.
struct LimitIndex {
  std::array<const cpu_tables::LimitRow*, editionCount * cpuCount * areaCount * 4> cell{};

  static std::size_t at(Edition edition, Cpu cpu, Area area, Width width) {
    return ((static_cast<std::size_t>(edition) * cpuCount + static_cast<std::size_t>(cpu)) * areaCount +
            static_cast<std::size_t>(area)) *
               4 +
           static_cast<std::size_t>(width);
  }
  LimitIndex() {
    for (const cpu_tables::LimitRow& row : cpu_tables::limits) enter(row);
    for (const cpu_tables::LimitRow& row : cpu_tables::smartLimits) enter(row);
  }
  void enter(const cpu_tables::LimitRow& row) {
    for (std::size_t i = 0; i < cpuCount; ++i) {
      const Cpu cpu{static_cast<std::uint8_t>(i)};
      if ((row.cpus & cpuBit(cpu)) != 0) cell[at(row.edition, cpu, row.area, row.width)] = &row;
    }
  }
};

const cpu_tables::LimitRow* limitRow(const Target& target, Area area, Width width) {
  static const LimitIndex index;
  // A CPU that the chosen edition does not describe keeps the limits of the one that does.
  const bool isOld = (cpuBit(target.cpu) & cpu_tables::oldCpus) != 0;
  const Edition edition = isOld                                       ? cpu_tables::oldEdition
                          : editionCovers(target.edition, target.cpu) ? target.edition
                                                                      : usualEdition(target.cpu);
  return index.cell[LimitIndex::at(edition, target.cpu, area, width)];
}

/// Between the image of the modules and that of PROFINET.
bool hasImageGap(const cpu_tables::LimitRow& row, Area area) {
  return row.last > cpu_tables::localImage && (area == Area::I || area == Area::Q);
}

}  // namespace

std::uint32_t s7200GapBehind(const Target& target, Area area, std::uint32_t offset) {
  const cpu_tables::LimitRow* row = limitRow(target, area, Width::Byte);
  const bool isInFront = row != nullptr && hasImageGap(*row, area) && offset < cpu_tables::localImage;
  return isInFront ? cpu_tables::localImage : 0;
}

std::optional<AddressLimit> s7200AddressLimit(const Target& target, Area area, Width width) {
  const cpu_tables::LimitRow* row = limitRow(target, area, width);
  if (row == nullptr) return std::nullopt;
  return AddressLimit{row->last, row->source, row->note};
}

bool s7200AddressExists(const Target& target, Area area, Width width, std::uint32_t offset, unsigned bit) {
  const cpu_tables::LimitRow* row = limitRow(target, area, width);
  if (row == nullptr || offset > row->last) return false;
  if (area == Area::HC) return hscExists(target, static_cast<int>(offset));
  if (hasImageGap(*row, area) && offset + static_cast<std::uint32_t>(bits(width) + 7) / 8 > cpu_tables::localImage &&
      offset < cpu_tables::networkImage)
    return false;
  if (isAnalogue(area)) return offset % 2 == 0;
  return width != Width::Bit || hasBitAndWord(area) || bit <= 7;
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

}  // namespace rungproof
