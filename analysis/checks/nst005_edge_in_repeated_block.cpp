// NST005: an edge bit that several runs of one block within a scan share.
// Tested by its examples and tests/rules/nesting_rules_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Two calls of the FB with one instance that a scan may run both, or nothing.
std::optional<std::pair<const Instruction*, const Instruction*>> sameInstanceTwice(const Facts& facts,
                                                                                   std::uint32_t block) {
  std::multimap<std::string, const Instruction*> calls;
  for (const std::uint32_t site : facts.calls().callsOf(block)) {
    const CallSite& call = facts.calls().sites()[site];
    if (call.instruction->operands.size() < 2 || facts.calls().isStartUpOnly(call.caller) ||
        !facts.calls().reachedFromMain(call.caller))
      continue;
    const std::string key = placeKey(facts, call.caller, call.instruction->operands[1]);
    if (key.empty()) continue;
    const auto [from, to] = calls.equal_range(key);
    for (auto other = from; other != to; ++other) {
      if (mayRunInOneScan(facts, other->second->id, call.instruction->id))
        return std::pair(other->second, call.instruction);
    }
    calls.emplace(key, call.instruction);
  }
  return std::nullopt;
}

void checkNst005(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    if (flow.pou->type == BlockType::Ob) return;
    const Instruction* inMemory = nullptr;
    const Instruction* inInstance = nullptr;
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      if (statementRole(instruction) != StatementRole::Edge || instruction.operands.empty()) continue;
      const Operand& bit = instruction.operands[0];
      const bool isInstance = bit.reach != nullptr && bit.reach->way == Way::Instance;
      if (isInstance && inInstance == nullptr) inInstance = &instruction;
      if (bit.kind == OperandKind::Direct && bit.area != Area::L && inMemory == nullptr) inMemory = &instruction;
    }
    if (inMemory != nullptr && mayRunTwice(facts, block)) {
      Finding& finding =
          sink.report(inMemory->span, fmt::format("{} keeps its edge in one bit for all calls of {} in a scan",
                                                  Facts::text(*inMemory), flow.pou->name));
      finding.address = toString(inMemory->operands[0]);
      for (const std::uint32_t site : facts.calls().callsOf(block)) {
        const Instruction& call = *facts.calls().sites()[site].instruction;
        if (finding.related.size() < 4) finding.related.push_back({call.span, networkText(facts, call.id)});
      }
      finding.help = "keep the edge in static data of an FB with an instance for each use, or hand the bit over";
    }
    if (inInstance == nullptr) return;
    const auto twice = sameInstanceTwice(facts, block);
    if (!twice) return;
    Finding& finding =
        sink.report(twice->second->span,
                    fmt::format("{} runs {} again with the same instance, in which {} keeps its edge",
                                networkText(facts, twice->second->id), flow.pou->name, Facts::text(*inInstance)));
    finding.related.push_back({twice->first->span, "the first call"});
    finding.related.push_back({inInstance->span, "the edge"});
    finding.help = "give each use an instance of its own";
  });
}

}  // namespace

extern constexpr Rule nst005_edge_in_repeated_block = {
    .id = "NST005",
    .title = "Edge memory in a block that runs twice",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "FP or FN with a bit in M or a data block in an FC or FB that runs several times in a scan; with static data "
        "in an FB that one instance runs twice",
    .why = "the second run compares its RLO with that of the first one: edges come every scan, or never",
    .manual = "002:2477, 002:2705-2706",
    .bad =
        "FUNCTION FC 1 : VOID\nVAR_INPUT\nX : BOOL;\nEND_VAR\nBEGIN\nNETWORK\nA #X;\nFP M 1.0;\nS Q 0.0;\n"
        "END_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FC 1 (X := I 0.0);\nCALL FC 1 (X := I 0.1);\n"
        "END_ORGANIZATION_BLOCK\n",
    .good =
        "FUNCTION FC 1 : VOID\nVAR_INPUT\nX : BOOL;\nEND_VAR\nVAR_IN_OUT\nM : BOOL;\nEND_VAR\nBEGIN\nNETWORK\n"
        "A #X;\nFP #M;\nS Q 0.0;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
        "CALL FC 1 (X := I 0.0, M := M 1.0);\nCALL FC 1 (X := I 0.1, M := M 1.1);\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "calls of which the conditions exclude each other without a jump between them",
    .dialects = dialect::S7300,
    .ofLists = true,
    .check = checkNst005,
};

}  // namespace rungproof
