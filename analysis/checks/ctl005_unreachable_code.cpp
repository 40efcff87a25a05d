// CTL005: code that no path reaches, by jumps and returns whose condition is constant. One finding for each stretch.
// Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Marks and ends stand behind other code without being reached themselves.
bool isStructure(const Instruction& instruction) {
  switch (instruction.desc->control) {
    case Control::LabelMark:
    case Control::Next:
    case Control::ScrEnd:
    case Control::Return:
    case Control::InterruptReturn:
    case Control::MainEnd:
    case Control::BlockEnd:
    case Control::SubroutineHead:
    case Control::InterruptHead: return true;
    default: return false;
  }
}

void checkCtl005(const Facts& facts, FindingSink& sink) {
  for (const Flow& flow : facts.plan().flows) {
    // S7-300/400: labels lead on behind BEU and JU, and an unreadable line may have been a jump to one.
    if (flow.pou->type != BlockType::None && facts.hasUnreadCode(*flow.pou)) continue;
    const Instruction* first = nullptr;
    std::size_t count = 0;
    const auto report = [&] {
      if (first == nullptr) return;
      const std::string more = count == 1 ? std::string() : fmt::format(" and {} instructions after it", count - 1);
      const bool isText = facts.networkOf(first->id).isStructured;  // one statement of SCL is several instructions
      Finding& finding =
          sink.report(first->span, isText ? std::string("no path reaches this statement")
                                          : fmt::format("no path reaches {}{}", Facts::text(*first), more));
      finding.confirmation = Confirmation::NotNeeded;
      finding.help = "remove the code, or the constant condition of the jump or return before it";
      first = nullptr;
      count = 0;
    };
    for (const FlowStep& step : flow.steps) {
      if (facts.execution().at(step.instruction->id).isReachable) {
        report();
      } else if (!isStructure(*step.instruction)) {
        if (first == nullptr) first = step.instruction;
        ++count;
      }
    }
    report();
  }
}

/// A network that begins with these may be reached by no scan and nothing is lost.
bool isMarkOrEnd(const Instruction& instruction) {
  const Control control = instruction.desc->control;
  return control == Control::LabelMark || control == Control::Return || control == Control::InterruptReturn ||
         control == Control::MainEnd || control == Control::BlockEnd;
}

/// Networks at their first instruction; the body of a loop is CTL003's.
void askCtl005(Asking& asking) {
  Graph& graph = asking.graph();
  for (const Flow& flow : asking.encoding().plan().flows) {
    if (!isExecuted(asking, flow)) continue;
    for (std::size_t i = 0; i < flow.steps.size(); ++i) {
      const FlowStep& step = flow.steps[i];
      const bool isFirst = i == 0 || step.network != flow.steps[i - 1].network;
      const bool isBody = i > 0 && flow.steps[i - 1].instruction->desc->control == Control::For;
      if (!isFirst || isBody || isMarkOrEnd(*step.instruction)) continue;
      const Asking::Runs* runs = asking.runsOf(*step.instruction);
      const Graph::Bool guard = runs == nullptr ? graph.constant(false) : runs->guard;
      if (const auto known = graph.truth(guard); known && *known) continue;
      asking.ask({.name = fmt::format("{}, network {} runs", flow.pou->name, flow.pou->networks[step.network].number),
                  .message = "no reachable state comes to this network",
                  .place = step.instruction,
                  .bad = guard.node});
    }
  }
}

/// All but the first of dead networks in a row.
constexpr Explanation ctl005Explained[] = {{"CTL005", Where::NetworkBefore}};

}  // namespace

extern constexpr Rule ctl005_unreachable_code = {
    .id = "CTL005",
    .title = "Unreachable code",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects = "instructions that no path reaches",
    .why = "dead code is downloaded and trusted",
    .manual = "001:5782-5801, 001:6735, 002:2790-2824",
    .bad = "Network 1\nLD SM0.0\nJMP 1\nNetwork 2\nLD I0.0\n= Q0.0\nNetwork 3\nLBL 1\n",
    .good = "Network 1\nLD I0.1\nJMP 1\nNetwork 2\nLD I0.0\n= Q0.0\nNetwork 3\nLBL 1\n",
    .falsePositives = "code switched off for a time by a jump on SM0.0",
    .peers = "SA0001; CP2; iec-checker CP2",
    .surplus = true,
    .check = checkCtl005,
    .ask = {.in = asked::Lint, .turn = 83, .cost = 4, .wantsYes = true, .program = askCtl005},
    .tell = {.advice = "look at the conditions of the jumps, calls and loops before it"},
    .explainedBy = ctl005Explained,
};

}  // namespace rungproof
