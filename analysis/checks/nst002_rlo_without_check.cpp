// NST002: a statement that works by the RLO although no statement of the block has made one.
// Tested by its examples and tests/rules/nesting_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkNst002(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    const LogicStates states = logicStates(flow);
    Makers told = 0;
    bool isMadeSince = true;  // one finding for a row of statements on the same RLO
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& instruction = *flow.steps[at].instruction;
      const StatementRole role = statementRole(instruction);
      if (!states[at]) continue;
      const auto foreign = static_cast<Makers>(states[at]->rloMaker & ~byBlock);
      if (foreign == 0) {
        isMadeSince = true;
        continue;
      }
      if (!usesRlo(role) || (!isMadeSince && (foreign & ~told) == 0)) continue;
      isMadeSince = false;
      told = foreign;
      const bool onSomePath = (states[at]->rloMaker & byBlock) != 0;
      Finding& finding =
          sink.report(instruction.span,
                      fmt::format("{} takes the RLO{} from {}: no statement of {} has made it",
                                  Facts::text(instruction), onSomePath ? " of some path" : "",
                                  (foreign & byCallee) != 0 ? "the block called before" : "whoever called the block",
                                  flow.pou->name));
      finding.help = "begin with A, O or X of what is meant, or with SET";
    }
  });
}

}  // namespace

extern constexpr Rule nst002_rlo_without_check = {
    .id = "NST002",
    .title = "RLO used that no first check has set",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "an assignment, a conditional jump, a timer or an edge at the beginning of a block or behind a call, with no "
        "scan, comparison or SET before it",
    .why = "the RLO is what the caller or the called block has left there; at the start of an OB it is any value",
    .manual = "003:1292, 003:1378",
    .bad = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .good = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nSET;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "blocks that hand a result on in the RLO by agreement; use BR or an output for it",
    .dialects = dialect::S7300,
    .ofLists = true,
    .check = checkNst002,
};

}  // namespace rungproof
