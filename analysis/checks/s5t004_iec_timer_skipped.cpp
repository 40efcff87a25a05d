// S5T004: an IEC timer whose call a scan may leave out. Tested by its examples and
// tests/rules/step7_timer_rules_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

namespace {

bool isIecTimerCall(const Instruction& instruction) {
  if (statementRole(instruction) != StatementRole::Call || instruction.operands.size() < 2) return false;
  const int number = static_cast<int>(instruction.operands[0].value);
  return blockTypeOf(number) == BlockType::Sfb && numberOfBlock(number) >= 3 && numberOfBlock(number) <= 5;
}

/// Why a scan may leave the call out, or empty.
std::string reasonSkipped(const Facts& facts, const Instruction& call, const Instruction*& cause) {
  const std::uint32_t block = facts.blockOf(call.id);
  const ExecutionPoint& point = facts.execution().at(call.id);
  if (!point.isReachable || facts.calls().isStartUpOnly(block) || facts.execution().runs(block) == Runs::Never)
    return {};
  if (point.isSkipped) {
    cause = facts.skippedBy(call.id);
    return fmt::format("{} may leave it out", Facts::text(*cause));
  }
  if (facts.execution().runs(block) != Runs::AtMostOnce) return {};
  for (const std::uint32_t site : facts.calls().callsOf(block)) {
    const CallSite& caller = facts.calls().sites()[site];
    const Instruction* skipper = facts.skippedBy(caller.instruction->id);
    if (skipper == nullptr && statementRole(*caller.instruction) != StatementRole::CallByRlo) continue;
    cause = skipper != nullptr ? skipper : caller.instruction;
    return fmt::format("{} is not called in every scan", facts.program().pous[block].name);
  }
  return {};
}

void checkS5t004(const Facts& facts, FindingSink& sink) {
  std::map<std::string, std::vector<const Instruction*>> calls;  // by instance
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    for (const FlowStep& step : flow.steps) {
      if (isIecTimerCall(*step.instruction))
        calls[placeKey(facts, block, step.instruction->operands[1])].push_back(step.instruction);
    }
  });
  for (const auto& [instance, list] : calls) {
    if (list.size() != 1 || instance.empty()) continue;  // several calls may make up for each other
    const Instruction& call = *list.front();
    const Instruction* cause = nullptr;
    const std::string reason = reasonSkipped(facts, call, cause);
    if (reason.empty()) continue;
    Finding& finding = sink.report(
        call.span, fmt::format("the IEC timer {} is not called in every scan: {}", call.operands[0].text, reason));
    if (cause != nullptr) finding.related.push_back({cause->span, "here"});
    finding.help = "call it in every scan and put the condition at IN";
  }
}

}  // namespace

extern constexpr Rule s5t004_iec_timer_skipped = {
    .id = "S5T004",
    .title = "IEC timer not called in every scan",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "the only call of a TP, TON or TOF instance behind a jump, or in a block that is not always called",
    .why =
        "these timers look at the clock and at IN only when they are called; Q and ET stand still until the next call",
    .manual = "002:2516-2532",
    .bad =
        "DATA_BLOCK DB 1\nSFB 4\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nJCN m;\n"
        "CALL SFB 4, DB 1 (IN := I 0.1, PT := T#1S, Q := Q 0.0);\nm: NOP 0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "DATA_BLOCK DB 1\nSFB 4\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
        "CALL SFB 4, DB 1 (IN := I 0.1, PT := T#1S, Q := Q 0.0);\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "steps that start their timer anew whenever they are entered",
    .dialects = dialect::S7300,
    .check = checkS5t004,
};

}  // namespace rungproof
