// CTL007: a subroutine that nothing calls, an interrupt routine that nothing attaches. Empty blocks, which Micro/WIN
// puts into every project, and libraries without a main program are left out. Tested by its examples.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// S7-300/400: UC FC[MW10] may call any block.
bool callsByNumber(const Facts& facts) {
  return std::ranges::any_of(facts.calls().sites(), [](const CallSite& site) {
    return !site.instruction->operands.empty() && site.instruction->operands[0].kind == OperandKind::Indirect;
  });
}

void checkCtl007(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode() || facts.program().main() == nullptr || callsByNumber(facts)) return;
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    const Pou& pou = facts.program().pous[block];
    const Flow& flow = facts.plan().flows[block];
    if (pou.kind == PouKind::Main || pou.type == BlockType::Ob || flow.steps.empty()) continue;
    const bool isInterrupt = pou.kind == PouKind::Interrupt;
    const std::span<const std::uint32_t> calls = facts.calls().callsOf(block);
    const bool isCalled = std::any_of(calls.begin(), calls.end(),
                                      [&](std::uint32_t s) { return facts.calls().sites()[s].caller != block; });
    if (isInterrupt ? facts.calls().isAttached(block) : isCalled) continue;
    Finding& finding = sink.report(flow.steps.front().instruction->span,
                                   fmt::format("nothing {} {}", isInterrupt ? "attaches" : "calls", pou.name));
    finding.help = isInterrupt ? "attach it to its event by ATCH, or remove it" : "call it, or remove it";
  }
}

}  // namespace

extern constexpr Rule ctl007_routine_never_used = {
    .id = "CTL007",
    .title = "Routine never used",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects = "a subroutine, FC or FB without a call, an interrupt routine without an ATCH",
    .why = "a dead routine, or a forgotten call",
    .manual = "001:2062, 001:2078",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\n= Q0.1\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD SM0.0\nCALL "
        "SBR0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\n= Q0.1\nEND_SUBROUTINE_BLOCK\n",
    .falsePositives = "routines kept for another variant of the machine",
    .peers = "SA0031; CP2; plceye S0003/S0004",
    .check = checkCtl007,
};

}  // namespace rungproof
