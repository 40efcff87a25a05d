// PTR001: an indirect access whose address can pass the end of its area. Pointers that hold a known address are decided
// here, with the limits of ADR001; pointers that are moved without any limit are candidates for the prover.
// Tested by its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/dataflow_pointers.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void reportKnown(const Facts& facts, FindingSink& sink, const PointerUse& use) {
  const Access& access = *use.access;
  const Target& target = facts.target();
  const bool isNumber = hasBitAndWord(use.area);
  if (use.offset >= 0 &&
      addressExists(target, use.area, isNumber ? Width::Word : access.width, static_cast<std::uint32_t>(use.offset), 0))
    return;
  const Instruction& instruction = facts.instruction(access.instruction);
  const std::string place = use.offset < 0
                                ? fmt::format("{} bytes before the {} area", -use.offset, areaName(use.area))
                                : addressName(use.area, access.width, static_cast<std::uint32_t>(use.offset));
  Finding& finding = sink.report(instruction.operands[access.operand].span,
                                 fmt::format("{} in {} points to {}, which the CPU {} does not have",
                                             accessName(access), Facts::text(instruction), place, cpuName(target.cpu)));
  finding.address = accessName(access);
  finding.confirmation = Confirmation::NotNeeded;
  finding.related.push_back({use.set->span, "the pointer is made here"});
  finding.help = "the same limits hold as for direct addresses (table 6-2); at run time error 0006 (001:13954)";
}

void checkPtr001(const Facts& facts, FindingSink& sink) {
  const PointerTable& pointers = facts.pointers();
  for (const PointerUse& use : pointers.knownUses()) reportKnown(facts, sink, use);
  for (const Pointer& pointer : pointers.all()) {
    if (!pointer.isUnbounded() || pointer.uses.empty() || facts.hasUnreadCode()) continue;
    const Access& access = *pointer.uses.front();
    const Instruction& instruction = facts.instruction(access.instruction);
    Finding& finding = sink.report(
        instruction.operands[access.operand].span,
        fmt::format("{} in {} may leave its area: the pointer is moved on and nothing sets it back or limits it",
                    accessName(access), Facts::text(instruction)));
    finding.address = accessName(access);
    finding.related.push_back({pointer.steps.front()->span, "the pointer is moved here"});
    finding.help = "set the pointer to its start with MOVD & before each pass, or compare it with its end";
  }
}

constexpr Hazard ptr001Hazards[] = {Hazard::BadIndirectAddress};

}  // namespace

extern constexpr Rule ptr001_pointer_may_leave_area = {
    .id = "PTR001",
    .title = "Pointer may leave its area",
    .severity = Severity::Error,
    .needs = Needs::FlowThenSolver,
    .detects = "an indirect access whose address can pass the end of the area of this CPU",
    .why = "run-time error 0006 or 0091, or data of another variable; in a comparison the CPU stops",
    .manual = "001:1459-1478, 001:13954, 001:13968",
    .bad = "Network 1\nLD SM0.0\nMOVD &VB10238, AC1\nMOVD *AC1, VD0\n",
    .good = "Network 1\nLD SM0.0\nMOVD &VB10236, AC1\nMOVD *AC1, VD0\n",
    .falsePositives = "a pointer whose steps are counted elsewhere: the prover drops it",
    .peers = "SA0172; iec-checker OutOfBounds",
    .dialects = dialect::S7200,
    .check = checkPtr001,
    .ask = {.in = asked::Builtin, .turn = 30, .cost = 1, .hazards = ptr001Hazards},
};

}  // namespace rungproof
