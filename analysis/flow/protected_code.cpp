// One pass over each block.
#include "analysis/flow/protected_code.hpp"

namespace rungproof {

std::vector<std::uint8_t> protectedCode(const Facts& facts) {
  std::vector<std::uint8_t> marks(facts.instructionCount(), 0);
  for (const Flow& flow : facts.plan().flows) {
    bool isOff = false;
    for (const FlowStep& step : flow.steps) {
      if (facts.isUnread(step.instruction->id)) isOff = true;  // the unread line may be DISI
      if (roleOf(*step.instruction) == Role::Disi) isOff = true;
      if (roleOf(*step.instruction) == Role::Eni) isOff = false;
      marks[step.instruction->id] = isOff;
    }
  }
  return marks;
}

}  // namespace rungproof
