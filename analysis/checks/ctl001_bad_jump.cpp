// CTL001: a jump that finds no label in its block, two labels of one number, a jump across the border of a step.
// The pairing is ir/flow. Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <unordered_map>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

std::int64_t labelOf(const Instruction& instruction) {
  return instruction.operands.empty() ? -1 : instruction.operands[0].value;
}

void checkCtl001(const Facts& facts, FindingSink& sink) {
  std::unordered_map<std::int64_t, const Instruction*> labels;
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.control == Control::LabelMark; })) {
    if (place.instruction->desc->control == Control::LabelMark)
      labels.emplace(labelOf(*place.instruction), place.instruction);
  }
  for (const Flow& flow : facts.plan().flows) {
    if (facts.hasUnreadCode(*flow.pou)) continue;  // what is missing may stand in a line that could not be read
    for (const FlowFault& fault : flow.faults) {
      const Instruction& instruction = *fault.instruction;
      const std::int64_t number = labelOf(instruction);
      if (fault.problem == FlowProblem::LabelMissing) {
        const auto elsewhere = labels.find(number);
        Finding& finding = sink.report(instruction.span, fmt::format("{} jumps to label {}, which {} does not have",
                                                                     Facts::text(instruction), number, flow.pou->name));
        finding.help = "add LBL in the same block (error 0087, 001:13989)";
        if (elsewhere != labels.end()) {
          finding.related.push_back(
              {elsewhere->second->span,
               fmt::format("{} has a label of that number, but jumps do not leave a block (001:5788)",
                           facts.pouOf(elsewhere->second->id).name)});
        }
      } else if (fault.problem == FlowProblem::LabelTwice) {
        Finding& finding =
            sink.report(instruction.span, fmt::format("label {} is defined twice in {}", number, flow.pou->name));
        finding.related.push_back({fault.other->span, "first definition"});
        finding.help = "give each label of a block its own number (error 008C, 001:13994)";
      } else if (fault.problem == FlowProblem::JumpAcrossScr) {
        Finding& finding = sink.report(
            instruction.span, fmt::format("{} crosses the border of an SCR segment", Facts::text(instruction)));
        finding.related.push_back({fault.other->span, "the label stands here"});
        finding.help = "jump inside the segment or over whole segments only (001:5818; error 008B, 001:13993)";
      }
    }
  }
}

}  // namespace

extern constexpr Rule ctl001_bad_jump = {
    .id = "CTL001",
    .title = "Bad jump",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "a jump whose label is missing, defined twice, in another block, or across the border of an SCR segment",
    .why = "the download is refused with error 0087, 008C or 008B",
    .manual = "001:5788-5790, 001:5818, 001:13989-13994",
    .bad = "Network 1\nLD I0.0\nJMP 5\nNetwork 2\nLD I0.1\n= Q0.0\nNetwork 3\nLBL 6\n",
    .good = "Network 1\nLD I0.0\nJMP 5\nNetwork 2\nLD I0.1\n= Q0.0\nNetwork 3\nLBL 5\n",
    .peers = "Omron JMP-JME pairs; matiec/ironplc parse errors",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkCtl001,
};

}  // namespace rungproof
