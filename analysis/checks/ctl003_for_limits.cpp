// CTL003: a loop that never runs, or whose end or index is written inside it. Constants are decided here; other limits
// are the prover's. Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// The direct place of operand i of FOR, or nullptr.
const Access* placeOf(const Facts& facts, const Instruction& loop, std::uint8_t operand) {
  for (const Access& access : facts.accesses().of(loop.id)) {
    if (access.operand == operand && !access.viaPointer && !access.write) return &access;
  }
  return nullptr;
}

bool meet(const Access& a, const Access& b) {
  return a.area == b.area && a.offset < b.offset + b.certainLength() && b.offset < a.offset + a.certainLength();
}

void checkBody(const Facts& facts, FindingSink& sink, const Flow& flow, std::uint32_t at, std::uint32_t end) {
  const Instruction& loop = *flow.steps[at].instruction;
  const Access* index = nullptr;
  for (const Access& access : facts.accesses().of(loop.id)) {
    if (access.operand == 0 && !access.viaPointer) index = &access;
  }
  const Access* final = placeOf(facts, loop, 2);
  for (std::uint32_t i = at + 1; i < end; ++i) {
    const Instruction& instruction = *flow.steps[i].instruction;
    for (const Access& access : facts.accesses().of(instruction.id)) {
      if (!access.write || access.viaPointer || access.maybe) continue;
      const bool isIndex = index != nullptr && meet(access, *index), isFinal = final != nullptr && meet(access, *final);
      if (!isIndex && !isFinal) continue;
      Finding& finding =
          sink.report(instruction.span, fmt::format("{} writes {} inside the loop that it {}", Facts::text(instruction),
                                                    accessName(access), isIndex ? "counts" : "ends"));
      finding.address = accessName(access);
      finding.confirmation = Confirmation::NotNeeded;
      finding.related.push_back({loop.span, "the loop begins here"});
      finding.help =
          "the change takes effect in the same loop (001:5762); use another place, or leave the loop by a jump";
      return;
    }
  }
}

void checkCtl003(const Facts& facts, FindingSink& sink) {
  for (const Flow& flow : facts.plan().flows) {
    int depth = 0;
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const FlowStep& step = flow.steps[at];
      const Control control = step.instruction->desc->control;
      if (control == Control::Next) --depth;
      if (control != Control::For || step.partner == noPartner || step.instruction->operands.size() < 3) continue;
      const Instruction& loop = *step.instruction;
      const Operand& init = loop.operands[1];
      const Operand& final = loop.operands[2];
      if (init.kind == OperandKind::Constant && final.kind == OperandKind::Constant && init.value > final.value) {
        Finding& finding = sink.report(loop.span, fmt::format("{} never runs its body: it starts at {} and ends at {}",
                                                              Facts::text(loop), init.value, final.value));
        finding.confirmation = Confirmation::NotNeeded;
        finding.help = "loops count upwards (001:5762-5768)";
      }
      if (++depth <= 8) checkBody(facts, sink, flow, at, step.partner);  // deeper ones are CTL002
    }
  }
}

void askCtl003(Asking& asking) {
  Graph& graph = asking.graph();
  for (const Flow& flow : asking.encoding().plan().flows) {
    if (!isExecuted(asking, flow)) continue;
    for (std::size_t i = 1; i < flow.steps.size(); ++i) {
      const Instruction& loop = *flow.steps[i - 1].instruction;
      if (loop.desc->control != Control::For) continue;
      const Asking::Runs* runs = asking.runsOf(*flow.steps[i].instruction);
      const Graph::Bool guard = runs == nullptr ? graph.constant(false) : runs->guard;
      if (const auto known = graph.truth(guard); known && *known) continue;
      asking.ask({.name = fmt::format("the body of {} runs", Facts::text(loop)),
                  .message = fmt::format("{} never runs its body in any reachable state", Facts::text(loop)),
                  .place = &loop,
                  .bad = guard.node});
    }
  }
}

}  // namespace

extern constexpr Rule ctl003_for_limits = {
    .id = "CTL003",
    .title = "FOR never runs, or its limits move",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects = "a loop whose start is above its end; an end value or index that is written inside the loop",
    .why =
        "the end is read anew in every round, so a change of it or of the index makes the loop shorter, longer or "
        "endless",
    .manual = "001:5762-5768",
    .bad = "Network 1\nLD I0.0\nFOR VW0, +1, VW2\nNetwork 2\nLD SM0.0\nINCW VW2\nNetwork 3\nNEXT\n",
    .good = "Network 1\nLD I0.0\nFOR VW0, +1, VW2\nNetwork 2\nLD SM0.0\nINCW VW4\nNetwork 3\nNEXT\n",
    .falsePositives = "an index that is raised to the end on purpose, to leave the loop early",
    .peers = "SA0072; L22",
    .dialects = dialect::S7200,
    .check = checkCtl003,
    .ask = {.in = asked::Lint, .turn = 82, .cost = 4, .wantsYes = true, .program = askCtl003},
    .tell = {.advice = "look at the conditions of the jumps, calls and loops before it"},
};

}  // namespace rungproof
