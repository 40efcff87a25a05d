// CTL010: the master control relay is in use. Tested by its examples and tests/rules/step7_control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkCtl010(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    for (const FlowStep& step : flow.steps) {
      if (!isOfRelay(statementRole(*step.instruction))) continue;
      Finding& finding =
          sink.report(step.instruction->span, fmt::format("{} uses the master control relay", flow.pou->name));
      finding.help = "state the condition at each output; the relay is no replacement for one that is wired";
      return;
    }
  });
}

}  // namespace

extern constexpr Rule ctl010_master_control_relay = {
    .id = "CTL010",
    .title = "Master control relay used",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects = "MCR(, )MCR, MCRA or MCRD, once for each block",
    .why =
        "while the relay is off = writes 0, S and R do nothing and T writes 0, but timers and counters go on; none of "
        "it can be seen at the statement",
    .manual = "002:2825-2828",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nMCRA;\nA I 0.0;\nMCR(;\nA I 0.1;\n= Q 0.0;\n)MCR;\nMCRD;\n"
        "END_ORGANIZATION_BLOCK\n",
    .good = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nA I 0.1;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .check = checkCtl010,
};

}  // namespace rungproof
