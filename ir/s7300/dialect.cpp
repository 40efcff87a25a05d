// What the S7-300 and the S7-400 are to those who ask for no particular family.
#include "ir/s7300/dialect.hpp"

#include <algorithm>

#include "ir/block_map.hpp"
#include "ir/machine/choices.hpp"
#include "ir/program.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/cpu.hpp"
#include "ir/s7300/isa.hpp"

namespace rungproof {

namespace {

constexpr std::size_t countOf(bool is400) {
  return static_cast<std::size_t>(
      std::ranges::count_if(cpu_rows::step7, [=](const Step7CpuRow& row) { return row.is400 == is400; }));
}

template <bool is400>
constexpr auto modelsOf() {
  std::array<CpuModel, countOf(is400)> models{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < cpu_rows::step7.size(); ++i) {
    if (cpu_rows::step7[i].is400 == is400)
      models[next++] = {static_cast<Cpu>(firstStep7Cpu + i), cpu_rows::step7[i].name};
  }
  return models;
}

constexpr auto models300 = modelsOf<false>();
constexpr auto models400 = modelsOf<true>();
constexpr EditionModel step7Models[] = {{Edition::Step7, "step7-5.4", "STEP 7 V5.4"}};

/// Each read of PIW asks the module (002:1292).
bool asksModules(const Target&) { return true; }

std::optional<AddressLimit> addressLimit7(const Target& target, Area area, Width width) {
  return limitWithin(step7AreaSize(step7Row(target.cpu), area), area, width);
}
/// Data blocks have lengths of their own.
bool addressExists7(const Target& target, Area area, Width width, std::uint32_t offset, unsigned bit) {
  return area == Area::DB || isWithin(addressLimit7(target, area, width), width, offset, bit);
}

CpuFeatures features7(const Target&) { return noFeatures; }

/// MB0-MB15, C0-C7 (general knowledge).
std::vector<RetentiveRange> usuallyRetentive7(const Target&) { return {{Area::M, 0, 15}, {Area::C, 0, 7}}; }

/// Data blocks keep their values unless they are NON_RETAIN (002:563); where the project names bytes of data blocks,
/// these do and no others.
std::vector<RetentiveRange> retentive7(const Program& program, std::vector<RetentiveRange> ranges) {
  const auto isOfBlock = [](const RetentiveRange& range) { return range.area == Area::DB; };
  if (std::ranges::any_of(ranges, isOfBlock)) return ranges;
  for (const DataBlock& block : program.dataBlocks) {
    if (!block.nonRetain) ranges.push_back({Area::DB, dataByte(block.number, 0), dataByte(block.number, 0xFFFF)});
  }
  return ranges;
}

/// Cycle monitoring, a parameter of the CPU (002:1296).
int cycleMonitoringMs(const Program& program, const Choices&) { return program.cycleMonitoringMs; }
int longestScanMs7(const Target&, const Choices& choices) { return choices.longestScanMs(); }

/// With OB80 the first excess of a scan is no error (002:1314).
std::uint32_t scanLimitMs7(const Program& program, const Choices&) {
  const bool hasTimeErrorBlock =
      std::ranges::any_of(program.pous, [](const Pou& pou) { return pou.number == blockNumber(BlockType::Ob, 80); });
  return program.cycleMonitoringMs * (hasTimeErrorBlock ? 2U : 1U);
}

std::optional<int> nesting7(const Target& target, const Pou& pou) {
  return pou.type == BlockType::Ob ? std::optional(step7Row(target.cpu).nesting) : std::nullopt;
}

/// The source of a library block is a file that has its name.
bool isOfLibrary(const Program& program, const Pou& pou) {
  return pou.type != BlockType::None && program.sources->file(pou.span.file).name() == pou.name;
}

constexpr MemoryModel memory7 = {.isOfVariables = false,
                                 .hasDataBlocks = true,
                                 .hasSpecialMemory = false,
                                 .hasTerminals = false,
                                 .declaresLocals = true,
                                 .numbersArePointers = true,
                                 .pointersMayMiss = true,
                                 .numberBits = 32,
                                 .samplesAtRead = asksModules,
                                 .analogInputs = Area::PI,
                                 .addressLimit = addressLimit7,
                                 .addressExists = addressExists7,
                                 .gapBehind = noGapBehind,
                                 .usuallyRetentive = usuallyRetentive7,
                                 .retentive = retentive7};

/// 0.1 us for any statement, of which the course documents give no times: that of bit logic on a CPU 315 (general
/// knowledge). Loops end by it, and nothing else depends on it.
constexpr std::uint32_t statementTime = 10;

constexpr RunModel run7 = {
    .counting = Counting::Elements,
    .startsBlocks = true,
    .ranksEvents = true,
    .runsWithoutMain = true,
    .keepsLastScan = true,
    .restartsWarm = true,
    .hasWatchdog = true,
    .endlessScan = Hazard::S7CycleTime,
    .listsTimes = false,
    .features = features7,
    .usualTime = statementTime,
    .watchdogMs = cycleMonitoringMs,
    .longestScanMs = longestScanMs7,
    .scanLimitMs = scanLimitMs7,
    .nesting = nesting7,
    .tooDeep = "the CPU goes to STOP",
    .notAsked = "nothing is asked of a scan that an error or SFC 46 cuts off, nor in STOP (002:1278, 002:2343)"};

constexpr TextModel text7 = {.hasProducts = true,
                             .quotesSymbols = true,
                             .labelsAreNames = true,
                             .keepsFaults = true,
                             .hasSystemBlocks = true,
                             .isForeign = isOfLibrary};

}  // namespace

constinit const Dialect s7300Dialect{
    .name = "s7-300",
    .title = "S7-300",
    .set = dialect::S7300,
    .cpus = models300,
    .editions = step7Models,
    .usual = {step7Cpu("319-3"), Edition::Step7},
    .instructions = s7300Instructions,
    .systemBits = {},
    .form = StatementForm::Accumulators,
    .memory = memory7,
    .run = run7,
    .text = text7,
};

constinit const Dialect s7400Dialect{
    .name = "s7-400",
    .title = "S7-400",
    .set = dialect::S7300,
    .cpus = models400,
    .editions = step7Models,
    .usual = {step7Cpu("417"), Edition::Step7},
    .instructions = s7300Instructions,
    .systemBits = {},
    .form = StatementForm::Accumulators,
    .memory = memory7,
    .run = run7,
    .text = text7,
};

}  // namespace rungproof
