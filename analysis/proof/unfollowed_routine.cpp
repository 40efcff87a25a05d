// Looks for ATCH instructions behind which no event can come.
#include "analysis/proof/unfollowed_routine.hpp"

#include <fmt/format.h>

#include "analysis/encoding/scan_encoding.hpp"
#include "ir/desc.hpp"

namespace rungproof {

std::optional<std::string> unfollowedRoutine(const Program& program, const EncodedScan& encoding) {
  const Attachments followed = encoding.options().interrupts ? attachmentsOf(encoding.plan()) : Attachments{};
  for (const Flow& flow : encoding.plan().flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      if (roleOf(instruction) != Role::Atch) continue;
      if (instruction.operands.size() == 2) {
        const auto event = followed.find(static_cast<int>(instruction.operands[1].value));
        if (event != followed.end() && event->second.contains(static_cast<int>(instruction.operands[0].value)))
          continue;
      }
      const Span span = instruction.span;
      return fmt::format("the interrupt routine attached at {}:{} is not followed",
                         program.sources->file(span.file).name(), program.sources->position(span).line);
    }
  }
  return std::nullopt;
}

}  // namespace rungproof
