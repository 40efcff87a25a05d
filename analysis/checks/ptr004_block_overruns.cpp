// PTR004: a block operation that leaves its area, or whose source and target overlap. A count from memory may be 255.
// Tested by its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkEnd(const Facts& facts, FindingSink& sink, const Instruction& instruction, const Access& access) {
  const std::uint32_t size = rowEnd(facts.target(), access.area, access.offset);
  if (access.offset >= size) return;  // ADR001
  const bool isCertain = access.offset + access.certainLength() > size;
  if (!isCertain && access.offset + access.possibleLength() <= size) return;
  const std::uint16_t count = isCertain ? access.count : access.most;
  Finding& finding =
      sink.report(instruction.operands[access.operand].span,
                  fmt::format("{} {} {} elements from {}; the {} area of the CPU {} ends at {}",
                              Facts::text(instruction), isCertain ? "covers" : "may cover", count, accessName(access),
                              areaName(access.area), cpuName(facts.target().cpu),
                              addressName(access.area, access.byNumber() ? access.width : Width::Byte, size - 1)));
  finding.address = accessName(access);
  finding.confirmation = isCertain ? Confirmation::NotNeeded : Confirmation::Unconfirmed;
  if (!isCertain) finding.severity = Severity::Warning;
  finding.help = "lower the count or move the start; at run time nothing is moved and error 0091 is set (001:13968)";
}

void checkOverlap(FindingSink& sink, const Instruction& instruction, const Access& source, const Access& target) {
  if (source.area != target.area || source.offset == target.offset) return;
  if (source.count != source.most) return;
  const bool meet =
      source.offset < target.offset + target.certainLength() && target.offset < source.offset + source.certainLength();
  if (!meet) return;
  Finding& finding =
      sink.report(instruction.span, fmt::format("source and target of {} overlap", Facts::text(instruction)));
  finding.address = accessName(target);
  finding.severity = Severity::Warning;
  finding.confirmation = Confirmation::NotNeeded;
  finding.help = target.offset > source.offset ? "the order of the copy is not stated; upwards it repeats the first "
                                                 "elements. Use a third place, or FIFO for queues"
                                               : "the order of the copy is not stated; use a third place";
}

void checkPtr004(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.role == Role::BlockMove || desc.role == Role::Fill; })) {
    const Instruction& instruction = *place.instruction;
    const Role role = roleOf(instruction);
    if (role != Role::BlockMove && role != Role::Fill) continue;
    const Access* source = nullptr;
    const Access* target = nullptr;
    for (const Access& access : facts.accesses().of(instruction.id)) {
      if (access.viaPointer || (access.operand == 0 && role == Role::Fill)) continue;
      if (access.operand == 0 && !access.write) source = &access;
      if (access.operand == 1 && access.write) target = &access;
    }
    if (source != nullptr) checkEnd(facts, sink, instruction, *source);
    if (target != nullptr) checkEnd(facts, sink, instruction, *target);
    if (source != nullptr && target != nullptr) checkOverlap(sink, instruction, *source, *target);
  }
}

constexpr Hazard ptr004Hazards[] = {Hazard::OutOfRange, Hazard::BadCount};

}  // namespace

extern constexpr Rule ptr004_block_overruns = {
    .id = "PTR004",
    .title = "Block operation overruns or overlaps",
    .severity = Severity::Error,
    .needs = Needs::FlowThenSolver,
    .detects = "BMB, BMW, BMD or FILL whose range leaves its area, or whose source and target overlap",
    .why = "run-time error 0091; with an overlap the result depends on an order that the manual does not state",
    .manual = "001:5654, 001:6385, 001:13968",
    .bad = "Network 1\nLD I0.0\nFILL +0, VW10200, 100\n",
    .good = "Network 1\nLD I0.0\nFILL +0, VW10200, 20\n",
    .falsePositives = "a count from memory that is limited elsewhere: the prover drops it",
    .peers = "SA0028; SA0172 (nearest)",
    .dialects = dialect::S7200,
    .check = checkPtr004,
    .ask = {.in = asked::Builtin, .turn = 30, .cost = 1, .hazards = ptr004Hazards},
};

}  // namespace rungproof
