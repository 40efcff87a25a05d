// INT005: an input that a fast counter and an edge event, or two fast counters, use. Inputs of the modes:
// ir/s7200/hsc_inputs.hpp. Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <array>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/event.hpp"
#include "ir/s7200/hsc_inputs.hpp"

namespace rungproof {

namespace {

constexpr int inputCount = 16;

struct Claim {
  const Instruction* instruction = nullptr;
  int counter = -1;  ///< -1: an edge event
};

std::string ownerText(const Claim& claim) {
  return claim.counter >= 0 ? fmt::format("HSC{}", claim.counter) : std::string("an edge event");
}

void checkInt005(const Facts& facts, FindingSink& sink) {
  std::array<Claim, inputCount> claims{};
  const auto claim = [&](int input, Claim next) {
    Claim& owner = claims[static_cast<std::size_t>(input)];
    if (owner.instruction == nullptr) {
      owner = next;
      return;
    }
    const bool isSame = owner.counter == next.counter;
    if (isSame) return;
    Finding& finding =
        sink.report(next.instruction->span,
                    fmt::format("{} needs input I{}.{} for {}, but {} uses it already", Facts::text(*next.instruction),
                                input / 8, input % 8, ownerText(next), ownerText(owner)));
    finding.address = fmt::format("I{}.{}", input / 8, input % 8);
    finding.related.push_back({owner.instruction->span, fmt::format("{} claims the input", ownerText(owner))});
    finding.help =
        "use another mode, counter or input: an input serves one purpose (001:4211-4213; errors 0002 and 0003)";
  };
  for (const InstructionPlace& place : facts.placesOf(Role::Hdef)) {
    const Instruction& instruction = *place.instruction;
    if (roleOf(instruction) != Role::Hdef || instruction.operands.size() < 2) continue;
    if (instruction.operands[0].kind != OperandKind::Constant || instruction.operands[1].kind != OperandKind::Constant)
      continue;
    const int counter = static_cast<int>(instruction.operands[0].value),
              mode = static_cast<int>(instruction.operands[1].value);
    for (int input = 0; input < inputCount; ++input) {
      if (hscUsesInput(facts.target(), counter, mode, input)) claim(input, {&instruction, counter});
    }
  }
  for (const Attachment& a : facts.calls().attachments()) {
    if (!isEdgeEvent(a.event)) continue;
    const auto input = static_cast<int>(edgeInputFor(a.event).bit);
    if (input < inputCount) claim(input, {a.instruction, -1});  // no counter uses the others
  }
}

}  // namespace

extern constexpr Rule int005_input_claimed_twice = {
    .id = "INT005",
    .title = "Input claimed twice",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "an input used by a fast counter and by an I/O interrupt, or by two fast counters",
    .why = "the second claim is refused at run time with error 0002 or 0003",
    .manual = "001:4211-4213, 001:13950-13951",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nMOVB 16#F8, SMB37\nHDEF 0, 0\nHSC 0\nATCH INT0, "
        "0\nENI\nEND_ORGANIZATION_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW0\nEND_INTERRUPT_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nMOVB 16#F8, SMB37\nHDEF 0, 0\nHSC 0\nATCH INT0, "
        "2\nENI\nEND_ORGANIZATION_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW0\nEND_INTERRUPT_BLOCK\n",
    .dialects = dialect::S7200,
    .check = checkInt005,
};

}  // namespace rungproof
