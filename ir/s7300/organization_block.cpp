// One row for each kind.
#include "ir/s7300/organization_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ir/block_event.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/coverage.hpp"

namespace rungproof::s7300 {

namespace {

constexpr auto organizationRows = std::to_array<OrganizationBlock>({
    {1, 1, "main program", "the free cycle, over and over", "002:799", true},
    {10,
     17,
     "time-of-day interrupt",
     "a date and time, once or periodically; SFC 28 to 31",
     "002:1154",
     true,
     StartedBy::S7400,
     {},
     10,
     11,
     "002:787, 002:1154"},
    {20,
     23,
     "time-delay interrupt",
     "the end of a delay of 1 to 60000 ms that SFC 32 has started",
     "002:1190",
     true,
     StartedBy::S7400,
     {},
     20,
     21,
     "002:1202"},
    {30, 38, "cyclic interrupt", "its period", "002:1102", true, StartedBy::S7400, {}, 35, 32, "002:1096"},
    {40, 47, "hardware interrupt", "a signal of a module", "002:1220", true, StartedBy::S7400, {}, 40, 41, "002:1222"},
    {60, 60, "multicomputing interrupt", "SFC 35 in one of the CPUs", "002:812", false, StartedBy::S7400},
    {80, 80, "time error", "the cycle monitoring, or a clock set past a time-of-day interrupt", "002:1296", true},
    {81, 81, "power supply error", "a fault of a power supply or battery", "002:1299", true},
    {82, 82, "diagnostic interrupt", "a module that reports a fault or its end", "002:1330", true},
    {83, 83, "insert or remove module", "a module that is pulled or plugged", "002:1301", true},
    {84, 84, "CPU hardware fault", "a fault of an interface of the CPU", "002:1302", true},
    {85, 85, "program execution error", "a missing OB, or an access error while the images are moved", "002:1338",
     true},
    {86, 86, "rack failure", "the loss of a rack, subnet or station", "002:1347", true},
    {87, 87, "communication error", "a fault of the communication", "002:1305", true},
    {90, 90, "background", "the time that the minimum cycle leaves over", "002:813", false, StartedBy::S7400},
    {100, 100, "warm restart", "the start of the CPU, once before OB1", "002:1367", true},
    {101, 101, "hot restart", "the start of an S7-400 at the place where it was interrupted", "002:1389", false,
     StartedBy::S7400,
     "what a hot restart leaves of images and outputs, and whether timers run on meanwhile, is not stated "
     "(002:1389-1415)"},
    {102, 102, "cold restart", "the start of the CPU with all memory as loaded", "002:1383", true,
     StartedBy::S7400And318},
    {121, 121, "programming error", "a synchronous error of an instruction; without it the CPU stops", "002:1282",
     true},
    {122, 122, "I/O access error", "a direct access to a module that is not there", "002:1292", true},
});
static_assert(std::ranges::all_of(organizationRows,
                                  [](const OrganizationBlock& row) {
                                    const bool hasEvent = eventOfBlock(row.first) >= 0 && eventOfBlock(row.last) >= 0;
                                    const bool isOfRun = row.first == 1 || row.first == 100 || row.first == 102 ||
                                                         row.first == 121 || row.first == 122;
                                    return row.isModelled == (hasEvent || isOfRun);
                                  }),
              "engine and prover start OB1, OB100, OB102, OB121, OB122 and the blocks of events");

}  // namespace

std::span<const OrganizationBlock> organizationBlocks() { return organizationRows; }

const OrganizationBlock* organizationBlock(int number) {
  const auto row = std::ranges::find_if(
      organizationRows, [&](const OrganizationBlock& each) { return each.first <= number && number <= each.last; });
  return row == organizationRows.end() ? nullptr : &*row;
}

StartedBy startersOf(const OrganizationBlock& row, int number) {
  if (row.of300 == 0) return row.startedBy;
  return number == row.of300 ? StartedBy::Every : number == row.of318 ? StartedBy::S7400And318 : StartedBy::S7400;
}

bool startsOn(int number, Cpu cpu) {
  const OrganizationBlock* row = organizationBlock(number);
  if (row == nullptr || step7Row(cpu).is400) return true;
  const StartedBy starters = startersOf(*row, number);
  return starters == StartedBy::Every || (starters == StartedBy::S7400And318 && cpu == step7Cpu("318-2"));
}

bool mayStart(const Program& program, const Pou& pou) {
  const int number = numberOfBlock(pou.number);
  if (pou.type != BlockType::Ob || (number == 102 && program.coldStart)) return true;
  return startsOn(number, program.target.cpu);
}

bool isStartUpBlock(const Pou& pou) {
  const int number = numberOfBlock(pou.number);
  return pou.type == BlockType::Ob && number >= 100 && number <= 102;
}

std::vector<std::string> startTexts(const Program& program) {
  std::vector<std::string> texts;
  for (const Pou& pou : program.pous) {
    const int number = numberOfBlock(pou.number);
    const OrganizationBlock* row = pou.type == BlockType::Ob ? organizationBlock(number) : nullptr;
    if (row == nullptr || number == 102 || startersOf(*row, number) == StartedBy::Every) continue;  // 102: --start
    const std::string_view cpu = cpuName(program.target.cpu), manual = startersManual(*row, number);
    if (!mayStart(program, pou))
      texts.push_back(fmt::format("OB{} never runs: a CPU {} does not start it ({})", number, cpu, manual));
    else if (row->isModelled)
      texts.push_back(fmt::format("OB{} runs: a CPU {} starts it, others do not ({})", number, cpu, manual));
  }
  return texts;
}

std::string_view startersManual(const OrganizationBlock& row, int number) {
  return startersOf(row, number) == StartedBy::Every || row.manual300.empty() ? row.manual : row.manual300;
}

std::string_view startedByText(StartedBy cpus) {
  static constexpr std::string_view texts[] = {"every CPU", "S7-400", "S7-400 and CPU 318-2"};
  return texts[static_cast<std::size_t>(cpus)];
}

std::string_view gapReasonOf(const OrganizationBlock& block) {
  return block.gap.empty() ? gapReason(Gap::OrganizationBlock) : block.gap;
}

}  // namespace rungproof::s7300
