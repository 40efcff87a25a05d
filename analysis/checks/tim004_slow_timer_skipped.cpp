// TIM004: a 100 ms timer that does not run exactly once per scan: its value moves only when the box runs. Steps are
// left out: an inactive step runs its timers without power flow or leaves them reset (an open point, 001:5830). Whether
// the jump or the return ever comes to pass is for the prover to say.
// Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/machine/reading.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

/// Why the box does not run exactly once per scan, or empty.
std::string reason(const Facts& facts, const InstructionPlace& place, const Instruction*& cause) {
  const ExecutionPoint& point = facts.execution().at(place.instruction->id);
  const Pou& pou = facts.program().pous[place.block];
  if (!point.isReachable || facts.execution().runs(place.block) == Runs::Never) return {};
  if (point.inLoop) return "it stands in a loop and would gain time in every round";
  if (pou.kind == PouKind::Interrupt) return "it stands in an interrupt routine, which runs when its event comes";
  if (facts.execution().runs(place.block) == Runs::Several)
    return fmt::format("{} may be called several times in a scan", pou.name);
  const Instruction* skipper = facts.skippedBy(place.instruction->id);
  if (skipper != nullptr && skipper->desc->control != Control::Lscr &&
      skipper->desc->control != Control::ScrEndConditional) {
    cause = skipper;
    return fmt::format("{} may leave it out", Facts::text(*skipper));
  }
  if (facts.execution().runs(place.block) == Runs::AtMostOnce)
    return fmt::format("{} is not called in every scan", pou.name);
  return {};
}

void checkTim004(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place : facts.placesOf([](const Desc& desc) { return isTimerBox(desc.role); })) {
    const Instruction& instruction = *place.instruction;
    const Role role = roleOf(instruction);
    if (!isTimerBox(role) || instruction.operands.empty() || instruction.operands[0].kind != OperandKind::Direct)
      continue;
    if (timerResolution(static_cast<int>(instruction.operands[0].offset)) != 100) continue;
    const Instruction* cause = nullptr;
    const std::string text = reason(facts, place, cause);
    if (text.empty() || facts.hasUnreadCode()) continue;
    Finding& finding =
        sink.report(instruction.span, fmt::format("the 100 ms timer {} does not run exactly once in every scan: {}",
                                                  facts.name(instruction.operands[0]), text));
    finding.address = toString(instruction.operands[0]);
    if (cause != nullptr) finding.related.push_back({cause->span, "this decides whether the timer runs"});
    finding.help = "put the box where it runs once in every scan, or use a timer of 1 or 10 ms (001:6607-6611)";
  }
}

/// That inactive segments are not executed at all, where both readings are open.
Graph::Bool skipsInactiveSegments(Asking& asking) {
  const Place reading = registerPlace(Reg::Reading, readingIndex(Choice::InactiveScr, 1));
  const auto cell = std::ranges::find(asking.encoding().cells(), reading, &Cell::place);
  if (cell == asking.encoding().cells().end() || cell->kind != CellKind::State) return asking.graph().constant(false);
  return {cell->start};
}

/// The box to speak of: the first that may be left out, else the second, else the only one.
const Instruction* accused(Asking& asking, const std::vector<const Instruction*>& boxes, Graph::Bool isWhole) {
  Graph& graph = asking.graph();
  for (const Instruction* box : boxes) {
    const Asking::Runs* runs = asking.runsOf(*box);
    if (runs == nullptr) return box;
    const auto isSkipped = graph.truth(graph.land(isWhole, graph.lnot(runs->guard)));
    if (!isSkipped || *isSkipped) return box;
  }
  return boxes.size() > 1 ? boxes[1] : boxes.front();
}

/// 001:6611: boxes of a 100 ms timer run exactly once in every scan; more than one, or none, makes it run wrongly. A
/// box in an inactive segment runs without power flow, as the manual's own sequences take it (001:6575), unless the
/// other reading was chosen.
void askTim004(Asking& asking, const Instruction& box) {
  const Operand& timer = box.operands[0];
  if (!isBoxOf(box, Type::Timer) || timerResolution(static_cast<int>(timer.offset)) != 100) return;
  Graph& graph = asking.graph();
  Graph::Bool some = graph.constant(false), twice = some;
  std::vector<const Instruction*> boxes;
  for (const Visit& visit : asking.record().visits()) {
    if (!isBoxOf(*visit.instruction, Type::Timer) || visit.instruction->operands[0].offset != timer.offset) continue;
    twice = graph.lor(twice, graph.land(some, {visit.guard}));
    some = graph.lor(some, {visit.guard});
    if (std::ranges::find(boxes, visit.instruction) == boxes.end()) boxes.push_back(visit.instruction);
  }
  if (some.node == graph.constant(false).node) return;  // in a block that nothing calls
  // Of a scan that a fatal error has cut off nothing is asked.
  const Graph::Bool isWhole =
      graph.land(graph.lnot({asking.encoding().faulted()}), graph.lnot(skipsInactiveSegments(asking)));
  const Node bad = graph.lor(graph.land(isWhole, graph.lnot(some)), twice).node;
  if (const auto known = graph.truth({bad}); known && !*known && !asking.settles()) return;
  const std::string name = toString(timer);
  asking.ask({.name = fmt::format("{} runs once a scan", name),
              .message = fmt::format(
                  "{} has a resolution of 100 ms, but its box does not run exactly once in every scan", name),
              .address = name,
              .place = accused(asking, boxes, isWhole),
              .bad = bad});
}

/// A jump or a return that never comes to pass.
constexpr Explanation tim004Explained[] = {{"LOG001", Where::RelatedPlace, powerReaches}};

}  // namespace

extern constexpr Rule tim004_slow_timer_skipped = {
    .id = "TIM004",
    .title = "100 ms timer not run exactly once per scan",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects =
        "a 100 ms timer in code that may be skipped, in a loop, in an interrupt routine, or in a subroutine called "
        "twice in a scan or not in "
        "every scan",
    .why =
        "the value of a 100 ms timer moves only when its box runs: skipped scans lose time, a second run in a scan "
        "counts the time twice",
    .manual = "001:6611, 004:4596",
    .bad = "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.1\nTON T37, +10\nNetwork 3\nLBL 1\nNetwork 4\nLD T37\n= Q0.0\n",
    .good = "Network 1\nLDN I0.0\nA I0.1\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .falsePositives =
        "a timer that is meant to stand still while its code is left out; a jump or return that never comes to pass: "
        "the "
        "prover drops it",
    .dialects = dialect::S7200,
    .check = checkTim004,
    .ask = {.in = asked::Builtin | asked::Lint, .turn = 41, .cost = 3, .box = askTim004},
    .explainedBy = tim004Explained,
};

}  // namespace rungproof
