// SCR002: one S bit as a step in two blocks. Tested by its examples.
#include <fmt/format.h>

#include <unordered_map>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkScr002(const Facts& facts, FindingSink& sink) {
  std::unordered_map<std::uint32_t, const Instruction*> first;
  for (const InstructionPlace& place : facts.placesOf(
           [](const Desc& desc) { return desc.control == Control::Lscr || desc.control == Control::Scrt; })) {
    const Instruction& instruction = *place.instruction;
    const Control control = instruction.desc->control;
    if ((control != Control::Lscr && control != Control::Scrt) || instruction.operands.empty() ||
        instruction.operands[0].kind != OperandKind::Direct)
      continue;
    const Operand& bit = instruction.operands[0];
    const auto [found, isNew] = first.emplace(bitKey(Area::S, bit.offset, bit.bit), &instruction);
    const std::uint32_t home = facts.blockOf(found->second->id);
    if (isNew || home == place.block) continue;
    Finding& finding = sink.report(
        instruction.span, fmt::format("step {} is used in {} and in {}", facts.name(bit),
                                      facts.program().pous[home].name, facts.program().pous[place.block].name));
    finding.address = toString(bit);
    finding.related.push_back({found->second->span, "the step is used here in the other block"});
    finding.help = "give each block its own S bits (001:5817)";
  }
}

}  // namespace

extern constexpr Rule scr002_step_in_two_blocks = {
    .id = "SCR002",
    .title = "One S bit in two POUs",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "an S bit used as a step in more than one block",
    .why = "the manual does not allow it: an S bit used in the main program cannot be used in a subroutine",
    .manual = "001:5817",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nS S0.0, 1\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD "
        "I0.0\nR S0.0, 1\nNetwork 4\nSCRE\nNetwork 5\nLD SM0.0\nCALL SBR0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLSCR S0.0\nNetwork 2\nLD I0.1\nR S0.0, 1\nNetwork "
        "3\nSCRE\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nS S0.0, 2\nNetwork 2\nLSCR S0.0\nNetwork 3\nLD "
        "I0.0\nR S0.0, 1\nNetwork 4\nSCRE\nNetwork 5\nLD SM0.0\nCALL SBR0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLSCR S0.1\nNetwork 2\nLD I0.1\nR S0.1, 1\nNetwork "
        "3\nSCRE\nEND_SUBROUTINE_BLOCK\n",
    .dialects = dialect::S7200,
    .check = checkScr002,
};

}  // namespace rungproof
