// OBL003: an organization block that the operating system of the chosen CPU never starts
// (ir/s7300/organization_block.hpp says which start which). Tested by its examples and
// tests/rules/step7_control_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/rule.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/organization_block.hpp"

namespace rungproof {

namespace {

/// "no background", "OB35 as its only cyclic interrupt", "OB32 and OB35 as its only cyclic interrupts".
std::string ownOf(const s7300::OrganizationBlock& row, Cpu cpu) {
  if (row.of300 == 0) return fmt::format("no {}", row.kind);
  const bool hasTwo = s7300::startsOn(row.of318, cpu);
  const auto [low, high] = std::minmax(row.of300, row.of318);
  return hasTwo ? fmt::format("OB{} and OB{} as its only {}s", low, high, row.kind)
                : fmt::format("OB{} as its only {}", row.of300, row.kind);
}

void checkObl003(const Facts& facts, FindingSink& sink) {
  const Cpu cpu = facts.target().cpu;
  for (const Pou& pou : facts.program().pous) {
    const int number = numberOfBlock(pou.number);
    if (pou.type != BlockType::Ob || s7300::startsOn(number, cpu)) continue;
    const s7300::OrganizationBlock& row = *s7300::organizationBlock(number);
    Finding& finding = sink.report(pou.span, fmt::format("nothing starts {}: a CPU {} has {} ({})", pou.name,
                                                         cpuName(cpu), ownOf(row, cpu), startersManual(row, number)));
    finding.help = fmt::format("{} exists on {}: name the CPU by --cpu, or remove the block", pou.name,
                               startedByText(startersOf(row, number)));
  }
}

}  // namespace

extern constexpr Rule obl003_never_started = {
    .id = "OBL003",
    .title = "Organization block that the CPU never starts",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "an organization block that the CPU never starts: OB60, OB90 or OB101 on an S7-300, OB102 on an S7-300 other "
        "than the 318-2, and on an S7-300 any interrupt block other than OB10, OB20, OB35 and OB40 (on the 318-2 also "
        "OB11, OB21, OB32 and OB41)",
    .why =
        "the block never runs: an S7-300 starts with OB100 and takes no notice of OB101, and it has one block for each "
        "kind of interrupt",
    .manual = "002:787, 002:810-813, 002:1096, 002:1202, 002:1222, 002:1355, 002:1391",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nNOP 0;\nEND_ORGANIZATION_BLOCK\nORGANIZATION_BLOCK OB "
        "101\nBEGIN\nNETWORK\nCLR;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nNOP 0;\nEND_ORGANIZATION_BLOCK\nORGANIZATION_BLOCK OB "
        "100\nBEGIN\nNETWORK\nCLR;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "315-2",
    .falsePositives = "a source that is kept for CPUs of both families",
    .dialects = dialect::S7300,
    .check = checkObl003,
};

}  // namespace rungproof
