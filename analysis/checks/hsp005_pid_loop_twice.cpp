// HSP005: two PID boxes with one loop number. Tested by its examples.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkHsp005(const Facts& facts, FindingSink& sink) {
  std::map<std::int64_t, const Instruction*> loops;
  for (const InstructionPlace& place : facts.placesOf(Role::Pid)) {
    const Instruction& instruction = *place.instruction;
    if (roleOf(instruction) != Role::Pid || instruction.operands.size() < 2 ||
        instruction.operands[1].kind != OperandKind::Constant)
      continue;
    const auto [found, isNew] = loops.emplace(instruction.operands[1].value, &instruction);
    if (isNew) continue;
    Finding& finding = sink.report(
        instruction.span,
        fmt::format("{} uses loop number {} a second time", Facts::text(instruction), instruction.operands[1].value));
    finding.related.push_back({found->second->span, "first PID with that number"});
    finding.help = "give each PID its own number, 0 to 7";
  }
}

}  // namespace

extern constexpr Rule hsp005_pid_loop_twice = {
    .id = "HSP005",
    .title = "PID loop number used twice",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "two PID boxes with one loop number",
    .why = "the two calculations disturb each other and the output is unpredictable, even with different tables",
    .manual = "001:5073",
    .bad = "Network 1\nLD SM0.0\nPID VB100, 0\nNetwork 2\nLD SM0.0\nPID VB200, 0\n",
    .good = "Network 1\nLD SM0.0\nPID VB100, 0\nNetwork 2\nLD SM0.0\nPID VB200, 1\n",
    .falsePositives = "two boxes of which only one runs per scan",
    .peers = "CP20 (nearest)",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkHsp005,
};

}  // namespace rungproof
