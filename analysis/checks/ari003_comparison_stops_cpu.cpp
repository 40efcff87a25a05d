// ARI003: a comparison whose operand may be bad: a pointer that is moved without limit, a REAL that was never made as a
// REAL. Errors of comparisons are fatal, and they run without power flow too. Tested by its examples and
// tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/dataflow_pointers.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// An instruction that makes a whole number where the comparison wants a REAL, if nothing else writes the place.
const Instruction* integerWriter(const Facts& facts, const Access& real) {
  const std::uint32_t cell = facts.cellOf(real);
  if (cell == facts.index().cells().size() || real.area == Area::AC || facts.index().isWrittenAtLarge(cell) ||
      facts.isExternal(cell))
    return nullptr;
  const Instruction* writer = nullptr;
  for (const std::uint32_t i : facts.index().at(cell)) {
    const Access& access = facts.access(i);
    if (!access.write) continue;
    const Instruction& instruction = facts.instruction(access.instruction);
    if (access.operand >= instruction.desc->operandCount) return nullptr;
    const Type type = instruction.desc->operands[access.operand].type;
    if (type != Type::DInt && type != Type::Int) return nullptr;
    writer = &instruction;
  }
  return writer;
}

void checkAri003(const Facts& facts, FindingSink& sink) {
  const PointerTable& pointers = facts.pointers();
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.execution == Execution::Compare; })) {
    const Instruction& instruction = *place.instruction;
    if (instruction.desc->execution != Execution::Compare) continue;
    for (const Access& access : facts.accesses().of(instruction.id)) {
      if (access.viaPointer) {
        const Pointer* pointer = pointers.find(access, place.block);
        if (pointer == nullptr || !pointer->isUnbounded()) continue;
        Finding& finding = sink.report(
            instruction.operands[access.operand].span,
            fmt::format("{} compares through {}, which nothing keeps inside its area; a bad pointer stops the CPU",
                        Facts::text(instruction), accessName(access)));
        finding.address = accessName(access);
        finding.related.push_back({pointer->steps.front()->span, "the pointer is moved here"});
        finding.help =
            "compare the pointer with its end before this network runs, for example by a jump: contacts in front do "
            "not help (001:3391)";
      } else if (access.operand < instruction.desc->operandCount &&
                 instruction.desc->operands[access.operand].type == Type::Real) {
        const Instruction* writer = integerWriter(facts, access);
        if (writer == nullptr) continue;
        Finding& finding = sink.report(instruction.operands[access.operand].span,
                                       fmt::format("{} compares {} as a REAL, but {} makes a whole number there",
                                                   Facts::text(instruction), accessName(access), Facts::text(*writer)));
        finding.address = accessName(access);
        finding.related.push_back({writer->span, "written as a whole number"});
        finding.help =
            "convert it by DTR, or compare as a double integer; an illegal REAL in a comparison stops the CPU "
            "(001:3384-3389)";
      }
    }
  }
}

constexpr Hazard ari003Hazards[] = {Hazard::FatalIndirectAddress, Hazard::FatalReal, Hazard::FatalRange};

}  // namespace

extern constexpr Rule ari003_comparison_stops_cpu = {
    .id = "ARI003",
    .title = "Comparison that stops the CPU",
    .severity = Severity::Error,
    .needs = Needs::FlowThenSolver,
    .detects = "a comparison of a pointer operand that may be bad, or of a REAL that may be illegal",
    .why = "fatal error: the CPU goes to STOP, and comparisons run whatever the power flow is",
    .manual = "001:3384-3391, 001:13934-13937",
    .bad = "Network 1\nLD SM0.1\nMOVD &VB100, AC1\nNetwork 2\nLD SM0.0\nINCD AC1\nNetwork 3\nLDB= *AC1, 5\n= Q0.0\n",
    .good = "Network 1\nLD SM0.0\nMOVD &VB100, AC1\nNetwork 2\nLDB= *AC1, 5\n= Q0.0\n",
    .falsePositives = "a pointer whose range is known from elsewhere: the prover drops it",
    .dialects = dialect::S7200,
    .check = checkAri003,
    .ask = {.in = asked::Builtin, .turn = 30, .cost = 1, .hazards = ari003Hazards},
};

}  // namespace rungproof
