// ADR004: an analogue output word used as a source. Tested by its examples.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkAdr004(const Facts& facts, FindingSink& sink) {
  for (const Access& access : facts.accesses().all()) {
    if (access.write || access.maybe || access.viaPointer || access.area != Area::AQ ||
        access.operand == impliedOperand)
      continue;
    const Instruction& instruction = facts.instruction(access.instruction);
    const Operand& operand = instruction.operands[access.operand];
    Finding& finding = sink.report(operand.span, fmt::format("{} reads {}, but analogue outputs can only be written",
                                                             Facts::text(instruction), toString(operand)));
    finding.address = toString(operand);
    finding.help = "keep the value in a word of V or M memory and copy it to the output from there";
  }
}

}  // namespace

extern constexpr Rule adr004_read_of_analogue_output = {
    .id = "ADR004",
    .title = "Read of write-only analogue output",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "an AQW word as a source operand",
    .why = "table 6-1 marks the analogue outputs as write-only",
    .manual = "001:2648, 001:1384-1388",
    .bad = "Network 1\nLD SM0.0\nMOVW AQW0, VW0\n",
    .good = "Network 1\nLD SM0.0\nMOVW VW0, AQW0\n",
    .peers = "SA0038 (nearest)",
    .dialects = dialect::S7200,
    .refuses = true,
    .standsAlone = true,
    .check = checkAdr004,
};

}  // namespace rungproof
