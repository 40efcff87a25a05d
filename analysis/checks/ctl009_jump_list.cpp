// CTL009: a list of JL with a hole: something else than JU before its label.
// Tested by its examples and tests/rules/step7_control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkCtl009(const Facts& facts, FindingSink& sink) {
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& list = *flow.steps[at].instruction;
      if (statementRole(list) != StatementRole::Distributor || flow.steps[at].partner == noPartner) continue;
      std::uint32_t end = at + 1;
      while (end < flow.steps.size() && statementRole(*flow.steps[end].instruction) == StatementRole::JumpAlways) ++end;
      if (end == flow.steps[at].partner && end > at + 1) continue;
      const bool isEmpty = end == at + 1;
      const Instruction& breaks = *flow.steps[std::min<std::size_t>(end, flow.steps.size() - 1)].instruction;
      Finding& finding =
          sink.report(isEmpty ? list.span : breaks.span,
                      isEmpty ? fmt::format("no JU stands behind {}: every value goes to its label", Facts::text(list))
                              : fmt::format("the list of {} ends after {} {}, before its label", Facts::text(list),
                                            end - at - 1, end - at == 2 ? "entry" : "entries"));
      if (!isEmpty) finding.related.push_back({list.span, "the list"});
      // Every value goes to the label. Of a list with a hole no text says where the values behind it go.
      finding.refused = !isEmpty || end != flow.steps[at].partner;
      finding.help = "write one JU for each value from 0 on, nothing between them, and the label right behind the last";
    }
  });
}

}  // namespace

extern constexpr Rule ctl009_jump_list = {
    .id = "CTL009",
    .title = "Jump list with a hole",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "JL whose list is empty, or has another statement or a label between its JU before its own label",
    .why = "the list ends at the first statement that is no JU; higher values go where nobody meant them to",
    .manual = "002:2793",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MB 0;\nJL e;\nJU a;\nNOP 0;\nJU b;\ne: BEU;\na: SET;\n= Q 0.0;\n"
        "BEU;\nb: SET;\n= Q 0.1;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MB 0;\nJL e;\nJU a;\nJU b;\ne: BEU;\na: SET;\n= Q 0.0;\n"
        "BEU;\nb: SET;\n= Q 0.1;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .refuses = true,
    .check = checkCtl009,
};

}  // namespace rungproof
