// The paths through a block of an S7-300/400: which statement may follow which, and what holds before each of them on
// every path or on some. Rules about registers, logic strings and local data give the state and what a statement does
// to it. Linear in the block but for loops. Tested by tests/rules/step7_paths_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/flow.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

/// Calls visit(step) for every step that may run right after this one; the number of steps: the block ends.
template <class Visit>
void eachNext(const Flow& flow, std::uint32_t at, Visit&& visit) {
  const FlowStep& step = flow.steps[at];
  const auto end = static_cast<std::uint32_t>(flow.steps.size());
  switch (statementRole(*step.instruction)) {
    case StatementRole::JumpAlways: return visit(step.partner != noPartner ? step.partner : at + 1);
    case StatementRole::End: return visit(end);
    case StatementRole::EndByRlo: visit(end); return visit(at + 1);
    case StatementRole::Distributor: {
      std::uint32_t entry = at + 1;
      while (entry < end && statementRole(*flow.steps[entry].instruction) == StatementRole::JumpAlways) visit(entry++);
      return visit(step.partner != noPartner ? step.partner : entry);
    }
    default: break;
  }
  if (step.instruction->desc->control == Control::Branch && step.partner != noPartner) visit(step.partner);
  visit(at + 1);
}

/// What holds before each step. `State` has `bool join(const State&)`, which adds what holds on another path and says
/// whether that changed anything; it must not go on changing for ever. `apply(state, step)` makes the state behind it.
/// One more entry at the end: when the block is left. Nothing where no path leads.
template <class State, class Apply>
std::vector<std::optional<State>> statesOf(const Flow& flow, const State& entry, Apply&& apply) {
  const auto end = static_cast<std::uint32_t>(flow.steps.size());
  std::vector<std::optional<State>> before(end + 1);
  std::vector<std::uint8_t> isDue(end + 1, 0);
  before[0] = entry;
  isDue[0] = 1;
  for (bool again = true; again;) {
    again = false;
    for (std::uint32_t at = 0; at < end; ++at) {
      if (isDue[at] == 0) continue;
      isDue[at] = 0;
      State state = *before[at];
      apply(state, flow.steps[at]);
      eachNext(flow, at, [&](std::uint32_t next) {
        if (!before[next]) {
          before[next] = state;
        } else if (!before[next]->join(state)) {
          return;
        }
        isDue[next] = 1;
        again = again || (next <= at && next < end);
      });
    }
  }
  return before;
}

/// The loads whose values stand in ACCU1 and ACCU2 before the step; nullptr: something else made it, or it is not
/// known.
struct LoadsBefore {
  const Instruction* accu1 = nullptr;
  const Instruction* accu2 = nullptr;
};
LoadsBefore loadsBefore(const Flow& flow, std::uint32_t at);
/// Whether one of the next statements asks OV or OS.
bool asksOverflowBehind(const Flow& flow, std::uint32_t at);
/// Whether a comparison before the step, anywhere in the block, has that operand loaded.
bool isComparedBefore(const Flow& flow, std::uint32_t until, const Operand& operand);

/// Whether a path through the block leads from one step to the other.
bool isPath(const Flow& flow, std::uint32_t from, std::uint32_t to);
/// Whether a run of the block can pass both, in whatever order.
inline bool mayRunBoth(const Flow& flow, std::uint32_t a, std::uint32_t b) {
  return isPath(flow, a, b) || isPath(flow, b, a);
}

}  // namespace rungproof
