// HSP002: Q0.0 or Q0.1 driven by a pulse generator and by networks. Clearing the image before the start is what the
// manual asks for (001:4539) and no finding. Tested by its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include <array>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/pulse_generator.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool clears(const Instruction& instruction) {
  if (isReset(roleOf(instruction))) return true;
  const bool isMove = roleOf(instruction) == Role::Move;
  return isMove && instruction.operands[0].kind == OperandKind::Constant && instruction.operands[0].value == 0;
}

void checkHsp002(const Facts& facts, FindingSink& sink) {
  std::array<const Instruction*, pulseOutputCount> generator{};
  for (const InstructionPlace& place : facts.placesOf(mayPulse)) {
    const auto output = pulseOutputOf(*place.instruction);
    if (output && generator[*output] == nullptr) generator[*output] = place.instruction;
  }
  const std::uint32_t cell = facts.index().cells().cell(Area::Q, 0, 0);
  for (std::uint32_t output = 0; output < pulseOutputCount; ++output) {
    if (generator[output] == nullptr) continue;
    const std::uint32_t bit = pulseOutputs[output].point;
    for (const std::uint32_t i : facts.index().at(cell)) {
      const Access& access = facts.access(i);
      const Instruction& instruction = facts.instruction(access.instruction);
      if (!access.write || clears(instruction)) continue;
      const bool covers =
          access.width != Width::Bit || (access.offset == 0 && bit >= access.bit && bit < access.bit + access.count);
      if (!covers) continue;
      Finding& finding =
          sink.report(instruction.span, fmt::format("{} writes Q0.{}, which {} drives as a pulse output",
                                                    Facts::text(instruction), bit, Facts::text(*generator[output])));
      finding.address = fmt::format("Q0.{}", bit);
      finding.related.push_back({generator[output]->span, "the pulse generator"});
      finding.help =
          "while the generator runs the image has no effect, and when it stops the image decides: keep the bit 0 "
          "(001:4528-4539)";
      break;
    }
  }
}

}  // namespace

extern constexpr Rule hsp002_pulse_output_two_masters = {
    .id = "HSP002",
    .title = "Q0.0 or Q0.1 has two masters",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a pulse output whose image bit a network writes as well",
    .why =
        "an active generator owns the output; its image bit sets the level before and after the train, so it must be 0 "
        "at the start",
    .manual = "001:4528, 001:4539, 001:13961",
    .bad =
        "Network 1\nLD SM0.1\nMOVB 16#85, SMB67\nMOVW +500, SMW68\nMOVD +1000, SMD72\nPLS 0\nNetwork 2\nLD I0.0\n= "
        "Q0.0\n",
    .good =
        "Network 1\nLD SM0.1\nR Q0.0, 1\nMOVB 16#85, SMB67\nMOVW +500, SMW68\nMOVD +1000, SMD72\nPLS 0\nNetwork 2\nLD "
        "I0.0\n= Q0.2\n",
    .falsePositives = "an output that is switched by hand while the generator is off, on purpose",
    .peers = "SA0004 (nearest)",
    .dialects = dialect::S7200,
    .check = checkHsp002,
};

}  // namespace rungproof
