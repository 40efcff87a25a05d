// Instructions that are left out in some scans, grouped by what leaves them out: what rules about frozen coils and
// blind edge detectors have in common. Tested by the examples of OUT007 and TIM014 and tests/rules.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

struct SkippedCode {
  const Instruction* first;  ///< of the instructions asked for
  const Instruction* cause;  ///< jump, step or return that leaves them out; nullptr: the calls of the block
  std::size_t count = 1;
};

/// The instructions that `isMeant` picks, where a jump, a step, a conditional return or a conditional call may leave
/// them out, by cause in program order. Loops do not count: they run at least as often.
std::vector<SkippedCode> skippedCode(const Facts& facts, const std::function<bool(const Instruction&)>& isMeant);

/// "SBR_0 is not called in every scan", "JMP 1 may skip it".
std::string causeText(const Facts& facts, const SkippedCode& skipped);

}  // namespace rungproof
