// Both instructions are followed up to the calls in the main program that lead to them, then down again through the
// calls that they have in common.
#include "analysis/flow/scan_order.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "ir/machine/frame.hpp"

namespace rungproof {

namespace {

/// Steps of a block in which an instruction runs: its own, or those of calls that lead to it.
struct StepRange {
  std::uint32_t first, last;
  std::uint32_t callee;  ///< if a single call leads there, else noBlock
};

class ScanOrder {
 public:
  ScanOrder(const Facts& facts, std::uint32_t earlier, std::uint32_t later)
      : facts_(facts), earlier_{earlier, callersOf(earlier)}, later_{later, callersOf(later)} {}

  bool holdsIn(std::uint32_t block, int depth = 0) const {
    const std::optional<StepRange> a = within(block, earlier_), b = within(block, later_);
    if (!a || !b) return false;
    if (a->last < b->first) return true;
    const bool isSameCall = a->callee != noBlock && a->callee == b->callee && a->first == b->first;
    return isSameCall && depth < static_cast<int>(mainNesting) && holdsIn(a->callee, depth + 1);
  }

 private:
  struct Followed {
    std::uint32_t instruction;
    std::vector<std::uint8_t> callers;  ///< by block: its own, and those from which calls lead there
  };

  std::vector<std::uint8_t> callersOf(std::uint32_t instruction) const {
    std::vector<std::uint8_t> marks(facts_.program().pous.size(), 0);
    std::vector<std::uint32_t> open{facts_.blockOf(instruction)};
    marks[open.front()] = 1;
    while (!open.empty()) {
      const std::uint32_t block = open.back();
      open.pop_back();
      for (const std::uint32_t s : facts_.calls().callsOf(block)) {
        const std::uint32_t caller = facts_.calls().sites()[s].caller;
        if (marks[caller] != 0) continue;
        marks[caller] = 1;
        open.push_back(caller);
      }
    }
    return marks;
  }

  /// Nothing if the block never comes there, or repeats a call that does.
  std::optional<StepRange> within(std::uint32_t block, const Followed& followed) const {
    std::optional<StepRange> range;
    const auto add = [&](std::uint32_t step, std::uint32_t callee) {
      if (!range) {
        range = StepRange{step, step, callee};
        return;
      }
      range = StepRange{std::min(range->first, step), std::max(range->last, step), noBlock};
    };
    if (facts_.blockOf(followed.instruction) == block) add(facts_.place(followed.instruction).step, noBlock);
    for (const std::uint32_t s : facts_.calls().callsIn(block)) {
      const CallSite& site = facts_.calls().sites()[s];
      if (site.callee == noBlock || followed.callers[site.callee] == 0) continue;
      if (facts_.execution().at(site.instruction->id).inLoop) return std::nullopt;
      add(facts_.place(site.instruction->id).step, site.callee);
    }
    return range;
  }

  const Facts& facts_;
  Followed earlier_, later_;
};

}  // namespace

bool runsBefore(const Facts& facts, std::uint32_t earlier, std::uint32_t later) {
  for (const std::uint32_t id : {earlier, later}) {
    if (facts.execution().at(id).inLoop || facts.calls().reachedFromInterrupt(facts.blockOf(id))) return false;
  }
  const std::vector<Pou>& pous = facts.program().pous;
  const InstructionPlace &a = facts.place(earlier), &b = facts.place(later);
  if (a.block == b.block && pous[a.block].kind == PouKind::Main) return a.step < b.step;
  for (std::uint32_t block = 0; block < pous.size(); ++block) {
    if (pous[block].kind == PouKind::Main) return ScanOrder(facts, earlier, later).holdsIn(block);
  }
  return false;
}

}  // namespace rungproof
