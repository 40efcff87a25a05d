// SUB002: more than eight levels of calls below the main program, more than one below an interrupt routine.
// Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/machine/frame.hpp"

namespace rungproof {

namespace {

void checkFrom(const Facts& facts, FindingSink& sink, std::uint32_t root, int allowed,
               std::vector<std::uint8_t>& reported) {
  if (facts.calls().depthBelow(root) <= allowed) return;
  std::string names = facts.program().pous[root].name;
  std::uint32_t block = root;
  const CallSite* call = nullptr;
  for (int level = 0; level <= allowed; ++level) {
    const std::optional<std::uint32_t> deepest = facts.calls().deepestCall(block);
    if (!deepest) return;
    call = &facts.calls().sites()[*deepest];
    if (call->callee == noBlock) break;
    block = call->callee;
    names += " -> " + facts.program().pous[block].name;
  }
  if (call == nullptr || reported[call->caller] != 0) return;
  reported[call->caller] = 1;
  Finding& finding = sink.report(
      call->instruction->span,
      fmt::format("{} is call level {} below {}; {} {} allowed: {}", Facts::text(*call->instruction), allowed + 1,
                  facts.program().pous[root].name, allowed, allowed == 1 ? "is" : "are", names));
  finding.help = fmt::format("call from a higher level; at run time {}", facts.dialect().run.tooDeep);
}

void checkSub002(const Facts& facts, FindingSink& sink) {
  std::vector<std::uint8_t> reported(facts.program().pous.size(), 0);
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    const std::optional<int> allowed = facts.dialect().run.nesting(facts.target(), facts.program().pous[block]);
    if (allowed) checkFrom(facts, sink, block, *allowed, reported);
  }
}

constexpr Hazard sub002Hazards[] = {Hazard::NestingTooDeep, Hazard::S7Nesting};

}  // namespace

extern constexpr Rule sub002_nesting_too_deep = {
    .id = "SUB002",
    .title = "Nesting too deep",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "calls nested more than 8 levels below the main program, or more than 1 (S7-200 SMART: 4) below an interrupt "
        "routine; S7-300/400: more blocks in a row than the CPU allows for one OB",
    .why = "the ninth call is not executed and gives run-time error 0008; an S7-300/400 goes to STOP",
    .manual = "001:5444, 001:6744-6746, 001:13956",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nENI\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR1\nEND_SUBROUTINE_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_1:SBR1\nBEGIN\nNetwork 1\nLD I0.1\n= Q0.1\nEND_SUBROUTINE_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0\nEND_INTERRUPT_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nENI\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.1\n= Q0.1\nEND_SUBROUTINE_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0\nEND_INTERRUPT_BLOCK\n",
    .falsePositives = "a chain of conditional calls that never runs to its end",
    .peers = "Omron illegal nesting",
    .check = checkSub002,
    .ask = {.in = asked::Builtin,
            .turn = 30,
            .cost = 1,
            .whenNone = "calls nest no deeper than the CPU allows",
            .hazards = sub002Hazards},
};

}  // namespace rungproof
