// Looks for ATCH instructions behind which no event can come.
#include "analysis/proof/hidden_code.hpp"

#include <fmt/format.h>

#include "ir/desc.hpp"

namespace rungproof {

std::optional<std::string> unfollowedRoutine(const Program& program, const EncodedScan& encoding) {
  if (!encoding.eventSites().empty()) return std::nullopt;
  for (const Flow& flow : encoding.plan().flows) {
    for (const FlowStep& step : flow.steps) {
      if (step.instruction->desc->stl != "ATCH") continue;
      const Span span = step.instruction->span;
      return fmt::format("the interrupt routine attached at {}:{} is not followed",
                         program.sources->file(span.file).name(), program.sources->position(span).line);
    }
  }
  return std::nullopt;
}

}  // namespace rungproof
