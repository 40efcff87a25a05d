// What the S7-200 is to those who ask for no particular family.
#include "ir/s7200/dialect.hpp"

#include <algorithm>

#include "ir/machine/choices.hpp"
#include "ir/machine/frame.hpp"
#include "ir/program.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

constexpr auto cpuModels = [] {
  std::array<CpuModel, cpuCount> models{};
  for (std::size_t i = 0; i < cpuCount; ++i) models[i] = {static_cast<Cpu>(i), cpu_rows::rows[i].name};
  return models;
}();

constexpr EditionModel editionModels[] = {
    {Edition::Edition2003, "2003", "2003 edition of the manual"},
    {Edition::Edition2004, "2004", "2004 edition of the manual"},
    {Edition::Smart27, "smart-2.7", "S7-200 SMART, firmware up to V2.7", true},
    {Edition::Smart28, "smart-2.8", "S7-200 SMART, firmware from V2.8 on", true},
};

/// The S7-200 SMART has no input filter for analog inputs.
bool isWithoutFilter(const Target& target) { return isSmart(target); }

/// The manual gives no default for V, T and C; taken are those that the programming software sets: all of V, MB14-MB31,
/// the TONR timers, all counters. MB0-MB13 are not retentive (001:1619). An S7-200 SMART keeps nothing unless its
/// system block says otherwise.
std::vector<RetentiveRange> usuallyRetentive(const Target& target) {
  if (isSmart(target)) return {};
  return {{Area::V, 0, 0xFFFFFFFF}, {Area::M, 14, 31}, {Area::T, 0, 31}, {Area::T, 64, 95}, {Area::C, 0, 255}};
}

/// Of the timers only TONR (001:6556).
std::vector<RetentiveRange> retentive(const Program&, std::vector<RetentiveRange> ranges) {
  std::vector<RetentiveRange> kept;
  for (const RetentiveRange& range : ranges) {
    if (range.area != Area::T) kept.push_back(range);
    for (std::uint32_t timer = range.first; range.area == Area::T && timer <= std::min(range.last, 255U); ++timer) {
      if (timerIsRetentive(static_cast<int>(timer))) kept.push_back({Area::T, timer, timer});
    }
  }
  return kept;
}

int watchdogMs(const Program&, const Choices& choices) { return choices.watchdogMs(); }

/// WDR restarts the watchdog; an S7-200 SMART ends the scan after 5 s all the same, an S7-200 as Choice::LongestScan
/// says.
int longestScanMs(const Target& target, const Choices& choices) {
  constexpr int ofSmart = 5000;
  return isSmart(target) ? ofSmart : choices.longestScanMs();
}

std::uint32_t scanLimitMs(const Program&, const Choices& choices) {
  return static_cast<std::uint32_t>(choices.watchdogMs());
}

/// Main 8, interrupt routines 1, of an S7-200 SMART 4 (001:5444).
std::optional<int> nesting(const Target& target, const Pou& pou) {
  if (pou.kind == PouKind::Main) return static_cast<int>(mainNesting);
  return pou.kind == PouKind::Interrupt ? std::optional(cpuFeatures(target).interruptNesting) : std::nullopt;
}

/// 1 us, for instructions whose time the text has lost.
constexpr std::uint32_t unlistedTime = 100;

/// A library block has no text.
bool isForeign(const Program&, const Pou&) { return false; }

}  // namespace

constinit const Dialect s7200Dialect{
    .name = "s7-200",
    .title = "S7-200",
    .set = dialect::S7200,
    .cpus = cpuModels,
    .editions = editionModels,
    .usual = {s7200Cpu("226"), Edition::Edition2004},
    .instructions = s7200Instructions,
    .systemBits = s7200SystemBits,
    .form = StatementForm::Rungs,
    .memory = {.isOfVariables = false,
               .hasDataBlocks = false,
               .hasSpecialMemory = true,
               .hasTerminals = true,
               .declaresLocals = false,
               .numbersArePointers = false,
               .pointersMayMiss = false,
               .numberBits = 32,
               .samplesAtRead = isWithoutFilter,
               .analogInputs = Area::AI,
               .addressLimit = s7200AddressLimit,
               .addressExists = s7200AddressExists,
               .gapBehind = s7200GapBehind,
               .usuallyRetentive = usuallyRetentive,
               .retentive = retentive},
    .run = {.counting = Counting::Boxes,
            .startsBlocks = false,
            .ranksEvents = false,
            .runsWithoutMain = false,
            .keepsLastScan = false,
            .restartsWarm = false,
            .hasWatchdog = true,
            .endlessScan = Hazard::FatalWatchdog,
            .listsTimes = true,
            .features = cpuFeatures,
            .usualTime = unlistedTime,
            .watchdogMs = watchdogMs,
            .longestScanMs = longestScanMs,
            .scanLimitMs = scanLimitMs,
            .nesting = nesting,
            .tooDeep = "the call ends with error 0008 (001:13956)",
            .notAsked =
                "nothing is asked of a scan that a fatal error cuts off, nor in STOP, where all outputs are off "
                "(001:1753)"},
    .text = {.hasProducts = true,
             .quotesSymbols = false,
             .labelsAreNames = false,
             .keepsFaults = true,
             .hasSystemBlocks = false,
             .isForeign = isForeign},
};

}  // namespace rungproof
