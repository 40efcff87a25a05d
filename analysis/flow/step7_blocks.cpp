// Tells blocks by where their text stands and by who calls them.
#include "analysis/flow/step7_blocks.hpp"

#include <fmt/format.h>

#include <limits>

#include "analysis/flow/statement_paths.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

bool isLibraryText(const Program& program, const Pou& pou) {
  if (pou.type == BlockType::None || pou.type == BlockType::Ob) return false;
  return pou.name.starts_with(blockName(pou.number) + " ") && program.sources->file(pou.span.file).name() == pou.name;
}

std::vector<Flow> readStretches(const Facts& facts, std::uint32_t block) {
  const Flow& whole = facts.plan().flows[block];
  const std::vector<FlowStep>& steps = whole.steps;
  struct Stretch {
    std::uint32_t begin, end;
    bool isApart = true;
  };
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<Stretch> stretches;
  std::vector<std::uint32_t> stretchOf(steps.size(), none);
  for (std::uint32_t at = 0; at < steps.size(); ++at) {
    if (facts.isUnread(steps[at].id())) continue;
    const bool goesOn = at > 0 && stretchOf[at - 1] != none && steps[at].network <= steps[at - 1].network + 1;
    if (!goesOn) stretches.push_back({at, at});
    stretches.back().end = at + 1;
    stretchOf[at] = static_cast<std::uint32_t>(stretches.size() - 1);
  }
  for (std::uint32_t at = 0; at < steps.size(); ++at) {
    const std::uint32_t partner = steps[at].partner;
    if (partner == noPartner || stretchOf[at] == stretchOf[partner]) continue;
    for (const std::uint32_t stretch : {stretchOf[at], stretchOf[partner]}) {
      if (stretch != none) stretches[stretch].isApart = false;
    }
  }
  std::vector<Flow> result;
  for (const Stretch& stretch : stretches) {
    if (!stretch.isApart) continue;
    Flow& flow = result.emplace_back();
    flow.pou = whole.pou;
    flow.steps.assign(steps.begin() + stretch.begin, steps.begin() + stretch.end);
    for (FlowStep& step : flow.steps) step.partner -= step.partner == noPartner ? 0 : stretch.begin;
  }
  return result;
}

bool mayRunInOneScan(const Facts& facts, std::uint32_t a, std::uint32_t b) {
  if (facts.blockOf(a) != facts.blockOf(b)) return true;
  const auto isInEveryRun = [&](std::uint32_t instruction) {
    const ExecutionPoint& point = facts.execution().at(instruction);
    return point.isReachable && !point.isSkipped;
  };
  if (isInEveryRun(a) && isInEveryRun(b)) return true;  // without a look at all paths
  return mayRunBoth(facts.flowOf(a), facts.place(a).step, facts.place(b).step);
}

bool mayRunTwice(const Facts& facts, std::uint32_t block) {
  std::vector<std::uint8_t> seen(facts.program().pous.size(), 0);
  std::vector<std::uint32_t> open{block};
  seen[block] = 1;
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    std::vector<std::uint32_t> calls;
    for (const std::uint32_t site : facts.calls().callsOf(at)) {
      const CallSite& call = facts.calls().sites()[site];
      if (!facts.calls().reachedFromMain(call.caller) || facts.calls().isStartUpOnly(call.caller)) continue;
      if (facts.execution().at(call.instruction->id).inLoop) return true;
      for (const std::uint32_t other : calls) {
        if (mayRunInOneScan(facts, other, call.instruction->id)) return true;
      }
      calls.push_back(call.instruction->id);
      if (seen[call.caller] != 0) continue;
      seen[call.caller] = 1;
      open.push_back(call.caller);
    }
  }
  return false;
}

std::string placeKey(const Facts& facts, std::uint32_t block, const Operand& operand) {
  if (operand.kind == OperandKind::Direct && operand.area != Area::L)
    return addressName(operand.area, operand.width, operand.offset, operand.bit);
  const bool isInstance = operand.reach != nullptr && operand.reach->way == Way::Instance;
  if (!isInstance && operand.area != Area::L) return {};
  return fmt::format("{}: {} {}.{}", facts.program().pous[block].name, isInstance ? "#" : "L", operand.offset,
                     operand.bit);
}

std::string networkText(const Facts& facts, std::uint32_t instruction) {
  return fmt::format("network {} of {}", facts.networkOf(instruction).number, facts.pouOf(instruction).name);
}

}  // namespace rungproof
