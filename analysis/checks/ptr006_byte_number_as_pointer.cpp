// PTR006: a number of bytes, or a word, stands where a pointer in bits is asked.
// Tested by its examples and tests/rules/step7_number_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Whether the load gives a plain number that is no pointer: a word or an INT of memory, or a constant that is written
/// as a number and would name a bit in the middle of a byte.
bool isPlainNumber(const Flow& flow, const Instruction& load, bool isWide) {
  if (load.operands.empty()) return false;
  const Operand& operand = load.operands[0];
  if (operand.kind == OperandKind::Constant) {
    const std::string_view text = operand.text;
    const bool isDecimal = std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || c == '+'; });
    return isDecimal && !text.empty() && isWide && operand.value % 8 != 0;
  }
  if (operand.text.starts_with('#')) {
    const auto local = std::ranges::find_if(
        flow.pou->locals, [&](const LocalVariable& each) { return operand.text.substr(1) == each.name; });
    return local != flow.pou->locals.end() && (local->type == DataType::Int || local->type == DataType::Byte);
  }
  return operand.isMemory() && (operand.width == Width::Word || operand.width == Width::Byte);
}

void checkPtr006(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    const auto report = [&](const Instruction& user, const Instruction& load, std::string_view as) {
      Finding& finding = sink.report(load.span, fmt::format("{} is taken as a pointer in bits by {}{}",
                                                            facts.name(load.operands[0]), Facts::text(user), as));
      finding.related.push_back({user.span, "here"});
      finding.help = "a pointer counts bits: multiply the number of the byte by 8 (SLD 3), or write P#10.0";
    };
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const Instruction& instruction = *flow.steps[at].instruction;
      const StatementRole role = statementRole(instruction);
      if ((role == StatementRole::LoadAr1 || role == StatementRole::LoadAr2) && instruction.operands.empty()) {
        const LoadsBefore loads = loadsBefore(flow, at);
        if (loads.accu1 != nullptr && isPlainNumber(flow, *loads.accu1, true)) report(instruction, *loads.accu1, "");
        continue;
      }
      if (role != StatementRole::Transfer || instruction.operands.empty()) continue;
      const LoadsBefore loads = loadsBefore(flow, at);
      if (loads.accu1 == nullptr) continue;
      const std::string place = toString(instruction.operands[0]);
      // The next statement that goes through that place as a pointer, before it is stored again.
      for (std::uint32_t next = at + 1; next < flow.steps.size(); ++next) {
        const Instruction& user = *flow.steps[next].instruction;
        if (user.desc->control != Control::None) break;
        if (statementRole(user) == StatementRole::Transfer && !user.operands.empty() &&
            toString(user.operands[0]) == place)
          break;
        const auto through = std::ranges::find_if(user.operands, [&](const Operand& operand) {
          return operand.reach != nullptr && operand.reach->way == Way::Pointer &&
                 toString(operand.reach->pointer) == place;
        });
        if (through == user.operands.end() || !through->isMemory() || through->area == Area::T ||
            through->area == Area::C || instruction.operands[0].width != Width::DWord)
          continue;
        if (isPlainNumber(flow, *loads.accu1, through->width != Width::Bit))
          report(user, *loads.accu1, fmt::format(", through {}", place));
        break;
      }
    }
  });
}

}  // namespace

extern constexpr Rule ptr006_byte_number_as_pointer = {
    .id = "PTR006",
    .title = "Number of a byte taken as a pointer",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a word, an INT or a plain number that goes unchanged into LAR1, LAR2 or the double word of an indirect "
        "address",
    .why = "pointers count bits: 10 is byte 1, bit 2, and a byte or word there is an error of the CPU",
    .manual = "002:2219, 002:2257-2263",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 10;\nT MD 20;\nL MW [MD 20];\nT QW 0;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 10;\nSLD 3;\nT MD 20;\nL MW [MD 20];\nT QW 0;\n"
        "END_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .falsePositives = "words that another part of the program has multiplied by 8",
    .dialects = dialect::S7300,
    .check = checkPtr006,
};

}  // namespace rungproof
