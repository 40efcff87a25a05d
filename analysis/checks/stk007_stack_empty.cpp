// STK007: on an S7-200 SMART, an instruction that takes a stack level although nothing has loaded one. Its compiler
// refuses what goes below the stack; on an S7-200 it is STK002. The run is analysis/flow/stack_depth. Tested by its
// examples and tests/rules/smart_refused_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

void checkStk007(const Facts& facts, FindingSink& sink) {
  if (!isSmart(facts.target())) return;
  for (const StackFault& fault : facts.stack().faults()) {
    if (fault.kind != StackFaultKind::FromBelow || fault.other != nullptr) continue;
    sink.report(fault.instruction->span,
                fmt::format("{} uses a stack level that nothing has loaded", Facts::text(*fault.instruction)))
        .help = "begin the network with a load such as LD, or remove the instruction";
  }
}

}  // namespace

extern constexpr Rule stk007_stack_empty = {
    .id = "STK007",
    .title = "Logic stack is empty",
    .severity = Severity::Error,
    .needs = Needs::Flow,
    .detects = "S7-200 SMART: ALD, OLD, LPP or another instruction that takes a stack level that nothing has loaded",
    .why = "the compiler of the S7-200 SMART refuses the block with error 0081: the logic stack goes below its start",
    .bad = "Network 1\nLD I0.0\nALD\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nLD I0.1\nALD\n= Q0.0\n",
    .exampleCpu = "ST40",
    .dialects = dialect::S7200,
    .ofLists = true,
    .refuses = true,
    .check = checkStk007,
};

}  // namespace rungproof
