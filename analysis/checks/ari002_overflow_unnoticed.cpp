// ARI002: a result that can leave its type although neither ENO nor SM1.1 is tested. Candidates are products of two
// values and sums that only ever grow; the prover decides. On an S7-300/400 products of two values that nothing
// compares before, and nobody is asked. Tested by its examples, tests/rules/data_rules_test.cpp and
// tests/rules/step7_data_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isReal(const Desc& desc) { return desc.operands[0].type == Type::Real; }
bool isProduct(const Desc& desc) { return desc.role == Role::Mul && !isReal(desc); }
/// INC and DEC of any width.
bool isCountingStep(const Desc& desc) { return desc.role == Role::Increment || desc.role == Role::Decrement; }
bool isGrowth(const Desc& desc) { return isCountingStep(desc) || (desc.role == Role::Add && !isReal(desc)); }

/// What becomes of a value behind the end of its type. The manual repeats its rule about operands for no INC and DEC.
std::string stepOverflow(const Desc& desc) {
  const bool isByte = desc.operands[0].type == Type::Byte, isDouble = desc.operands[0].type == Type::DInt;
  const bool isUp = desc.role == Role::Increment;
  const std::string_view low = isByte ? "0" : isDouble ? "-2147483648" : "-32768";
  const std::string_view high = isByte ? "255" : isDouble ? "2147483647" : "32767";
  return fmt::format("{} goes on from {} with {} (001:4999; 'increment-overflow' names the other reading)", desc.stl,
                     isUp ? high : low, isUp ? low : high);
}

/// Whether one of the next instructions asks ENO or SM1.1: in the same network or the one after it.
bool isTested(const Facts& facts, const InstructionPlace& place) {
  const Flow& flow = facts.plan().flows[place.block];
  for (std::uint32_t at = place.step + 1; at < flow.steps.size() && flow.steps[at].network <= place.network + 1; ++at) {
    const Instruction& instruction = *flow.steps[at].instruction;
    if (roleOf(instruction) == Role::Aeno) return true;
    if (instruction.desc->affects != 0 && at > place.step + 4) return false;
    for (const Operand& o : instruction.operands) {
      if (o.kind == OperandKind::Direct && o.area == Area::SM && o.offset == 1 && o.bit == 1) return true;
    }
  }
  return false;
}

/// Whether nothing else writes the place and no comparison looks at it: the value only grows.
bool growsForEver(const Facts& facts, const Access& target) {
  const std::uint32_t cell = facts.cellOf(target);
  if (cell == facts.index().cells().size() || target.area == Area::AC || target.byNumber()) return false;
  if (facts.index().isWrittenAtLarge(cell) || facts.isExternal(cell)) return false;
  for (const std::uint32_t i : facts.index().at(cell)) {
    const Access& access = facts.access(i);
    if (access.instruction == target.instruction) continue;
    if (access.write || facts.instruction(access.instruction).desc->execution == Execution::Compare) return false;
  }
  return true;
}

/// Whether the statement stores less of a product than there may be.
bool losesProduct(const Instruction& multiplication, const Instruction& store) {
  const std::optional<Product> product = productOf(multiplication);
  if (!product || statementRole(store) != StatementRole::Transfer) return false;
  return *product == Product::LowHalf || bytes(store.operands[0].width) <= 2;
}

/// S7-300/400: a product of two values that were loaded, stored at once, when nothing asks OV or OS behind it. Whether
/// one ever leaves its type is not asked.
void checkProductsOfAccus(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    for (std::uint32_t at = 0; at + 1 < flow.steps.size(); ++at) {
      const Instruction& product = *flow.steps[at].instruction;
      if (!losesProduct(product, *flow.steps[at + 1].instruction) || !facts.execution().at(product.id).isReachable)
        continue;
      const LoadsBefore loads = loadsBefore(flow, at);
      if (loads.accu1 == nullptr || loads.accu2 == nullptr || asksOverflowBehind(flow, at)) continue;
      const Operand& first = loads.accu2->operands[0];
      const Operand& second = loads.accu1->operands[0];
      if (!first.isMemory() || !second.isMemory() || isComparedBefore(flow, at, first) ||
          isComparedBefore(flow, at, second))
        continue;
      Finding& finding = sink.report(
          product.span, fmt::format("the product of {} and {} can leave its type, and neither OV nor OS is asked",
                                    facts.name(first), facts.name(second)));
      finding.related.push_back({loads.accu2->span, "the first factor"});
      finding.help = "ask OV behind it, compare the factors with limits before, or use a wider type";
    }
  });
}

void checkAri002(const Facts& facts, FindingSink& sink) {
  if (facts.hasUnreadCode()) return;
  if (facts.form() == StatementForm::Accumulators) return checkProductsOfAccus(facts, sink);
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return isProduct(desc) || isGrowth(desc); })) {
    const Instruction& instruction = *place.instruction;
    const Desc& desc = *instruction.desc;
    if (!facts.execution().at(instruction.id).isReachable) continue;
    const Access* target = nullptr;
    for (const Access& access : facts.accesses().of(instruction.id)) {
      if (access.write && !access.viaPointer) target = &access;
    }
    if (target == nullptr) continue;
    const bool hasConstant = instruction.operands[0].kind == OperandKind::Constant;
    const bool isCandidate = isProduct(desc) ? !hasConstant : growsForEver(facts, *target);
    if (!isCandidate || isTested(facts, place)) continue;
    const std::string name = accessName(*target);
    const std::string text =
        isProduct(desc)
            ? fmt::format("the product in {} can leave its type, and neither ENO nor SM1.1 is asked",
                          Facts::text(instruction))
            : fmt::format("{} only ever grows by {}; in the end it overflows, and neither ENO nor SM1.1 is asked", name,
                          Facts::text(instruction));
    Finding& finding = sink.report(instruction.span, text);
    finding.address = name;
    finding.help = fmt::format(
        "{}; add AENO and a reaction, limit the value, or use a wider type",
        isCountingStep(desc) ? stepOverflow(desc) : "on overflow the operands stay as they were (001:4814)");
  }
}

constexpr Hazard ari002Hazards[] = {Hazard::Overflow};

}  // namespace

extern constexpr Rule ari002_overflow_unnoticed = {
    .id = "ARI002",
    .title = "Overflow goes unnoticed",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects =
        "a product of two variables, or on an S7-200 a value that only grows, whose overflow the program asks for "
        "neither by ENO or SM1.1 nor by OV or OS",
    .why =
        "S7-200: on overflow a product or a sum leaves the operands as they were, so the program goes on with the old "
        "value, and INC and DEC go on at the other end of their range; S7-300/400: what is stored is no longer the "
        "product",
    .manual = "001:4814, 001:4999-5028, 002:1563-1578",
    .bad = "Network 1\nLD SM0.0\nMOVW AIW0, VW0\n*I VW2, VW0\n",
    .good = "Network 1\nLD SM0.0\nMOVW AIW0, VW0\n*I VW2, VW0\nAENO\nNOT\n= M0.0\n",
    .falsePositives = "values whose range is known from elsewhere: on an S7-200 the prover drops them",
    .check = checkAri002,
    .ask = {.in = asked::Builtin, .turn = 30, .cost = 4, .hazards = ari002Hazards},
};

}  // namespace rungproof
