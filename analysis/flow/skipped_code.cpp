// One pass over the instructions.
#include "analysis/flow/skipped_code.hpp"

#include <fmt/format.h>

#include <unordered_map>

namespace rungproof {

std::vector<SkippedCode> skippedCode(const Facts& facts, const std::function<bool(const Instruction&)>& isMeant) {
  std::vector<SkippedCode> groups;
  std::unordered_map<std::uint64_t, std::size_t> byCause;
  for (std::uint32_t id = 0; id < facts.instructionCount(); ++id) {
    const std::uint32_t block = facts.blockOf(id);
    const bool isConditionalBlock =
        facts.execution().runs(block) == Runs::AtMostOnce && facts.program().pous[block].kind == PouKind::Subroutine;
    const Instruction* cause = facts.skippedBy(id);
    if (cause == nullptr && !isConditionalBlock) continue;
    if (cause != nullptr && cause->desc->control == Control::For) continue;
    const Instruction& instruction = facts.instruction(id);
    if (!isMeant(instruction)) continue;
    // What could not be read may be the condition that is always met.
    if (cause == nullptr ? facts.hasUnreadCode() : facts.isUnread(cause->id)) continue;
    const std::uint64_t key = cause != nullptr ? std::uint64_t{cause->id} : (std::uint64_t{1} << 40) + block;
    const auto [found, isNew] = byCause.emplace(key, groups.size());
    if (isNew)
      groups.push_back({&instruction, cause});
    else
      ++groups[found->second].count;
  }
  return groups;
}

std::string causeText(const Facts& facts, const SkippedCode& skipped) {
  if (skipped.cause == nullptr)
    return fmt::format("{} is not called in every scan", facts.pouOf(skipped.first->id).name);
  switch (skipped.cause->desc->control) {
    case Control::Lscr: return fmt::format("it stands in the step {}", Facts::text(*skipped.cause));
    case Control::Jump: return fmt::format("{} may skip it", Facts::text(*skipped.cause));
    default: return fmt::format("{} may end the block before it", Facts::text(*skipped.cause));
  }
}

}  // namespace rungproof
