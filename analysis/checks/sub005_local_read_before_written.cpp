// SUB005: local memory that is read before the block has written it. Tested by its examples and
// tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/dataflow_locals.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/flow/step7_locals.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkTemps(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    for (const TempRead& read : unwrittenTemps(facts, block)) {
      const std::string name = read.operand->text.empty() ? toString(*read.operand) : std::string(read.operand->text);
      Finding& finding = sink.report(
          read.operand->span, fmt::format("{} reads {} before {} has written it{}", read.instruction->desc->stl, name,
                                          flow.pou->name, read.isOnEveryPath ? "" : " on every path"));
      if (!read.isOnEveryPath) finding.severity = Severity::Note;
      finding.address = name;
      finding.help = "temporary data is any value when a block starts; write it first, or declare it in VAR";
    }
  });
}

void checkSub005(const Facts& facts, FindingSink& sink) {
  if (facts.form() == StatementForm::Accumulators) return checkTemps(facts, sink);
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    if (facts.program().pous[block].protectedBlock || facts.hasUnreadCode(block)) continue;
    for (const LocalRead& read : localFlow(facts, block).unwritten) {
      const Instruction& instruction = facts.instruction(read.access->instruction);
      const Operand& operand = instruction.operands[read.access->operand];
      Finding& finding =
          sink.report(operand.span, fmt::format("{} reads {} before {} has written it", Facts::text(instruction),
                                                toString(operand), facts.pouOf(instruction.id).name));
      finding.address = toString(operand);
      finding.help =
          "local memory is not initialised and may hold leftovers of other blocks; write it first, or use V or M "
          "memory for values that last";
    }
  }
}

}  // namespace

extern constexpr Rule sub005_local_read_before_written = {
    .id = "SUB005",
    .title = "Local memory read before written",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "L memory or a TEMP variable that some path reads first; S7-300/400: a note where other paths have written it",
    .why = "local memory is not initialised: any value may be read, also one of another block",
    .manual = "001:1371-1373, 002:200-204",
    .bad = "Network 1\nLD I0.0\nINCW LW0\nMOVW LW0, VW0\n",
    .good = "Network 1\nLD SM0.0\nMOVW VW0, LW0\nINCW LW0\nMOVW LW0, VW0\n",
    .peers = "CP3",
    .ofLists = true,
    .check = checkSub005,
};

}  // namespace rungproof
