// STK001: a level of the logic stack is lost at the bottom and used later. The stack has nine levels, that of
// the S7-200 SMART 32; only levels that
// something still needs are counted, because leftovers of earlier networks may fall out unharmed.
// The run is analysis/stack_depth. Tested by its examples and tests/rules/stack_depth_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

void checkStk001(const Facts& facts, FindingSink& sink) {
  const int levels = cpuFeatures(facts.target()).stackLevels;
  for (const StackFault& fault : facts.stack().faults()) {
    if (fault.kind != StackFaultKind::TooDeep) continue;
    Finding& finding = sink.report(
        fault.instruction->span,
        fmt::format("{} pushes level {}; the stack has {}, and the lowest level is lost though {} uses it later",
                    Facts::text(*fault.instruction), levels + 1, levels, Facts::text(*fault.other)));
    finding.related.push_back({fault.other->span, "the lost level is used here, where the CPU finds 0 or 1 by chance"});
    finding.help = "split the network, or keep an intermediate result in an M bit (error 0081, 001:13983)";
  }
}

/// Levels that a push has lost (001:2759) and that are used nevertheless, on the paths that the scan can take.
void askStk001(Asking& asking) {
  Graph& graph = asking.graph();
  std::map<std::pair<const Instruction*, const Instruction*>, Node> lost;
  for (const LostLevel& level : asking.record().lostLevels()) {
    Node& bad = lost.try_emplace({level.use, level.push}, graph.constant(false).node).first->second;
    bad = graph.lor({bad}, {level.condition}).node;
  }
  for (const auto& [places, bad] : lost) {
    const auto [use, push] = places;
    const std::string text = Facts::text(*use);
    asking.ask(
        {.name = fmt::format("the logic stack is deep enough at {}", text),
         .message = fmt::format("{} takes a level that was pushed out of the nine levels of the logic stack", text),
         .place = push == nullptr ? use : push,
         .bad = bad,
         .other = use});
  }
}

}  // namespace

extern constexpr Rule stk001_stack_too_deep = {
    .id = "STK001",
    .title = "Stack deeper than nine",
    .severity = Severity::Error,
    .needs = Needs::Flow,
    .detects =
        "a load or LPS when all nine levels are in use (S7-200 SMART: 32), so that a level which is needed later is "
        "pushed out of the bottom",
    .why =
        "the ninth level is lost silently at run time, a pop brings an unknown value, and the compiler may refuse the "
        "network with error 0081",
    .manual = "001:2759, 001:2870, 001:2868, 001:13983",
    .bad =
        "Network 1\nLD I0.0\nLD I0.1\nLD I0.2\nLD I0.3\nLD I0.4\nLD I0.5\nLD I0.6\nLD I0.7\nLD I1.0\nLD "
        "I1.1\nOLD\nOLD\nOLD\nOLD\nOLD\nOLD\nOLD\nOLD\nOLD\n= Q0.0\n",
    .good =
        "Network 1\nLD I0.0\nLD I0.1\nLD I0.2\nLD I0.3\nLD I0.4\nLD I0.5\nLD I0.6\nLD I0.7\nLD "
        "I1.0\nOLD\nOLD\nOLD\nOLD\nOLD\nOLD\nOLD\nOLD\n= Q0.0\n",
    .falsePositives = "none known; at which depth the compiler itself refuses is not stated in the manual",
    .peers = "Omron stack overflows",
    .dialects = dialect::S7200,
    .ofLists = true,
    .check = checkStk001,
    .ask = {.in = asked::Builtin,
            .turn = 20,
            .cost = 1,
            .whenNone = "the logic stack loses no level that is used",
            .program = askStk001},
    .tell = {.otherPlace = "the level is used here"},
};

}  // namespace rungproof
