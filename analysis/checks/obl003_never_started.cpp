// OBL003: an organization block that the operating system of the chosen CPU never starts
// (ir/s7300/organization_block.hpp says which start which). Tested by its examples and
// tests/rules/step7_control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/rule.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/organization_block.hpp"

namespace rungproof {

namespace {

void checkObl003(const Facts& facts, FindingSink& sink) {
  const Cpu cpu = facts.target().cpu;
  for (const Pou& pou : facts.program().pous) {
    if (pou.type != BlockType::Ob) continue;
    const s7300::OrganizationBlock* row = s7300::organizationBlock(numberOfBlock(pou.number));
    if (row == nullptr || startsOn(*row, cpu)) continue;
    Finding& finding = sink.report(pou.span, fmt::format("nothing starts {}: a CPU {} has no {} ({})", pou.name,
                                                         cpuName(cpu), row->kind, row->manual));
    finding.help = fmt::format("{} exists on {}: name the CPU by --cpu, or remove the block", pou.name,
                               startedByText(row->startedBy));
  }
}

}  // namespace

extern constexpr Rule obl003_never_started = {
    .id = "OBL003",
    .title = "Organization block that the CPU never starts",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "OB60, OB90 or OB101 on an S7-300, OB102 on an S7-300 other than the 318-2",
    .why = "what the block prepares is never prepared: an S7-300 begins with OB100 whatever OB101 holds",
    .manual = "002:810-813, 002:1355, 002:1391",
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
