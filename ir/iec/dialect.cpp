// What IEC 61131-3 is to those who ask for no particular family.
#include "ir/iec/dialect.hpp"

#include "ir/iec/cpu.hpp"
#include "ir/iec/isa.hpp"
#include "ir/machine/choices.hpp"
#include "ir/program.hpp"

namespace rungproof {

namespace {

constexpr auto machineModels = [] {
  std::array<CpuModel, cpu_rows::iec.size()> models{};
  for (std::size_t i = 0; i < models.size(); ++i)
    models[i] = {static_cast<Cpu>(firstIecCpu + i), cpu_rows::iec[i].name};
  return models;
}();

constexpr EditionModel standardModels[] = {{Edition::Iec, "iec-61131-3", "IEC 61131-3"}};

bool samplesInputs(const Target&) { return false; }

std::optional<AddressLimit> variableLimit(const Target& target, Area area, Width width) {
  return limitWithin(iecAreaSize(iecRow(target.cpu), area), area, width);
}
bool variableExists(const Target& target, Area area, Width width, std::uint32_t offset, unsigned bit) {
  return isWithin(variableLimit(target, area, width), width, offset, bit);
}

CpuFeatures variableFeatures(const Target&) { return noFeatures; }

std::vector<RetentiveRange> usuallyRetentiveVariables(const Target&) { return {}; }

/// VAR RETAIN beside what the project says.
std::vector<RetentiveRange> retentiveVariables(const Program& program, std::vector<RetentiveRange> ranges) {
  for (const auto& [first, last] : program.retained) ranges.push_back({Area::V, first, last});
  return ranges;
}

/// The standard knows no watchdog; with this time the machine looks whether a scan can end at all.
int watchedMs(const Program&, const Choices& choices) { return choices.watchdogMs(); }
int longestIecScanMs(const Target&, const Choices& choices) { return choices.longestScanMs(); }

/// Where no task has an interval a scan may last as long as this.
std::uint32_t intervalMs(const Program& program, const Choices&) {
  constexpr std::uint32_t longest = 500;
  return program.taskMs.value_or(longest);
}

/// The standard states no times: as little as can be counted, so that only endless loops last.
constexpr std::uint32_t shortestTime = 1;

/// Blocks cannot call each other in a circle, and no depth is given.
std::optional<int> nestingOfVariables(const Target&, const Pou&) { return std::nullopt; }

/// Blocks of the standard, the entry of the program, and what runs the actions of a chart.
bool isNotWritten(const Program&, const Pou& pou) {
  return pou.isBuiltIn || pou.kind == PouKind::Main || pou.name.find(".(actions") != std::string::npos;
}

}  // namespace

constinit const Dialect iecDialect{
    .name = "iec",
    .title = "IEC 61131-3",
    .set = dialect::Iec,
    .cpus = machineModels,
    .editions = standardModels,
    .usual = {static_cast<Cpu>(firstIecCpu), Edition::Iec},
    .instructions = iecInstructions,
    .systemBits = {},
    .form = StatementForm::Expressions,
    .memory = {.isOfVariables = true,
               .hasDataBlocks = false,
               .hasSpecialMemory = false,
               .hasTerminals = true,
               .declaresLocals = false,
               .numbersArePointers = false,
               .pointersMayMiss = false,
               .numberBits = 64,
               .samplesAtRead = samplesInputs,
               .analogInputs = Area::AI,
               .addressLimit = variableLimit,
               .addressExists = variableExists,
               .gapBehind = noGapBehind,
               .usuallyRetentive = usuallyRetentiveVariables,
               .retentive = retentiveVariables},
    .run = {.counting = Counting::Instances,
            .startsBlocks = false,
            .ranksEvents = false,
            .runsWithoutMain = false,
            .keepsLastScan = true,
            .restartsWarm = false,
            .hasWatchdog = false,
            .endlessScan = Hazard::IecEndless,
            .listsTimes = false,
            .features = variableFeatures,
            .usualTime = shortestTime,
            .watchdogMs = watchedMs,
            .longestScanMs = longestIecScanMs,
            .scanLimitMs = intervalMs,
            .nesting = nestingOfVariables,
            .tooDeep = {},
            .notAsked = "nothing is asked of a scan that an error cuts off, nor behind it"},
    .text = {.hasProducts = false,
             .quotesSymbols = false,
             .labelsAreNames = true,
             .keepsFaults = false,
             .hasSystemBlocks = false,
             .isForeign = isNotWritten},
};

}  // namespace rungproof
