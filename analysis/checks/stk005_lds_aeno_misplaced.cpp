// STK005: LDS beyond the filled levels, AENO without a box before it. The run is analysis/stack_depth.
// Tested by its examples and tests/rules/stack_depth_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkStk005(const Facts& facts, FindingSink& sink) {
  for (const StackFault& fault : facts.stack().faults()) {
    if (fault.kind == StackFaultKind::LdsBeyond) {
      sink.report(fault.instruction->span,
                  fmt::format("{} copies level {}, but the network has loaded {} {}", Facts::text(*fault.instruction),
                              fault.needed, fault.found, fault.found == 1 ? "level" : "levels"))
          .help = "levels count from 0 at the top (001:2857)";
    } else if (fault.kind == StackFaultKind::AenoWithoutBox) {
      sink.report(fault.instruction->span,
                  "AENO stands in a network that has no box before it; ENO is that of some earlier box")
          .help = "put AENO directly behind the box whose success it asks for (001:2851)";
    }
  }
}

}  // namespace

extern constexpr Rule stk005_lds_aeno_misplaced = {
    .id = "STK005",
    .title = "LDS or AENO misplaced",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "LDS beyond the filled depth; AENO with no box before it in the network",
    .why =
        "LDS would copy a level of unknown content, AENO would ask an instruction that has nothing to do with the rung",
    .manual = "001:2851-2857",
    .bad = "Network 1\nLD I0.0\nAENO\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nMOVB VB0, VB1\nAENO\n= Q0.0\n",
    .dialects = dialect::S7200,
    .ofLists = true,
    .check = checkStk005,
};

}  // namespace rungproof
