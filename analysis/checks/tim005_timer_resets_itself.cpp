// TIM005: a timer that its own inverted bit enables. A 10 ms bit is never seen by later networks, a 1 ms bit only if
// the update falls between the two contacts; with 100 ms it works, because bit and value change at the box itself, so
// that one is only a note. Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

/// The inverted contact of the timer in the rung that ends at step `at`, or nullptr. Walks back until every level that
/// the box needs has been loaded.
const Instruction* ownContact(const Flow& flow, std::uint32_t at, std::uint32_t number) {
  int needed = 1;
  const std::uint32_t network = flow.steps[at].network;
  bool isInverted = false;
  while (at > 0 && flow.steps[at - 1].network == network && needed > 0) {
    const Instruction& instruction = *flow.steps[--at].instruction;
    const Role role = roleOf(instruction);
    const bool isContact = role == Role::Load || role == Role::And || role == Role::Or;
    if (isContact && instruction.desc->execution == Execution::Stack && !instruction.operands.empty()) {
      const Operand& o = instruction.operands[0];
      const bool isNegated = instruction.desc->negated;
      if (o.kind == OperandKind::Direct && o.area == Area::T && o.offset == number && isNegated != isInverted)
        return &instruction;
    }
    if (role == Role::Not) isInverted = !isInverted;
    if (role == Role::Load) --needed;
    if (role == Role::Ald || role == Role::Old) ++needed;
  }
  return nullptr;
}

void checkTim005(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.role == Role::Ton || desc.role == Role::Tonr; })) {
    const Instruction& instruction = *place.instruction;
    if (roleOf(instruction) != Role::Ton && roleOf(instruction) != Role::Tonr) continue;
    if (facts.isUnread(instruction.id)) continue;
    if (instruction.operands.empty() || instruction.operands[0].kind != OperandKind::Direct) continue;
    const std::uint32_t number = instruction.operands[0].offset;
    const Instruction* contact = ownContact(facts.plan().flows[place.block], place.step, number);
    if (contact == nullptr) continue;
    const int resolution = timerResolution(static_cast<int>(number));
    const std::string name = facts.name(instruction.operands[0]);
    const std::string_view effect = resolution == 10 ? "a 10 ms timer clears its bit before any later network sees it"
                                    : resolution == 1
                                        ? "the bit of a 1 ms timer is seen only if it rises between the two contacts"
                                        : "it works for 100 ms timers only";
    Finding& finding =
        sink.report(contact->span, fmt::format("{} is enabled by its own inverted bit: {}", name, effect));
    if (resolution == 100) finding.severity = Severity::Note;
    finding.address = toString(instruction.operands[0]);
    finding.related.push_back({instruction.span, fmt::format("the box of {}", name)});
    finding.help = fmt::format("enable {} by the inverse of the output that its bit drives (001:6623)",
                               toString(instruction.operands[0]));
  }
}

}  // namespace

extern constexpr Rule tim005_timer_resets_itself = {
    .id = "TIM005",
    .title = "Timer reset by its own bit",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "a timer whose enable contains the inverse of its own bit",
    .why =
        "a 10 ms bit is never seen by the later network, a 1 ms bit only if the update falls between the two contacts",
    .manual = "001:6623, 004:4604-4622",
    .bad = "Network 1\nLDN T33\nTON T33, +100\nNetwork 2\nLD T33\n= Q0.0\n",
    .good = "Network 1\nLDN M0.0\nTON T33, +100\nNetwork 2\nLD T33\n= M0.0\nNetwork 3\nLD M0.0\n= Q0.0\n",
    .falsePositives = "100 ms timers, for which it works: reported as a note",
    .dialects = dialect::S7200,
    .check = checkTim005,
};

}  // namespace rungproof
