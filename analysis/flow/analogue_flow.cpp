// Marks places until nothing new is marked. Accumulators carry a value within a network only.
#include "analysis/flow/analogue_flow.hpp"

#include <algorithm>
#include <set>

namespace rungproof {

namespace {

constexpr int mostRounds = 8;

bool carriesValues(const Instruction& instruction) {
  return instruction.desc->execution == Execution::Conditional && instruction.desc->control == Control::None;
}

}  // namespace

AnalogueFlow::AnalogueFlow(const Facts& facts) : concerned_(facts.instructionCount(), 0) {
  spread(facts, true);
  spread(facts, false);
}

void AnalogueFlow::spread(const Facts& facts, bool forwards) {
  const Area source = forwards ? Area::AI : Area::AQ;
  std::vector<std::uint8_t> marked(facts.index().cells().size() + 1, 0);
  std::set<std::pair<std::uint64_t, std::uint32_t>> accumulators;  // block and network, number
  const auto mark = [&](const Access& access, bool set) {
    const InstructionPlace& place = facts.place(access.instruction);
    if (access.area == Area::AC) {
      const std::pair key{std::uint64_t{place.block} << 32 | place.network, access.offset};
      return set ? accumulators.insert(key).second : accumulators.contains(key);
    }
    const std::uint32_t cell = facts.cellOf(access);
    bool result = false;
    for (std::uint32_t k = 0; k < access.certainLength() && cell + k < marked.size() - 1; ++k) {
      result = result || (set ? marked[cell + k] == 0 : marked[cell + k] != 0);
      if (set) marked[cell + k] = 1;
    }
    return result;
  };
  bool hasNew = true;
  for (int round = 0; hasNew && round < mostRounds; ++round) {
    hasNew = false;
    for (std::uint32_t n = 0; n < facts.instructionCount(); ++n) {
      const std::uint32_t id = forwards ? n : facts.instructionCount() - 1 - n;
      const auto accesses = facts.accesses().of(id);
      // Forwards a value comes in by what is read, backwards by what is written.
      const bool carries = std::ranges::any_of(accesses, [&](const Access& a) {
        return !a.viaPointer && a.write != forwards && a.width != Width::Bit && (a.area == source || mark(a, false));
      });
      if (!carries) continue;
      concerned_[id] = 1;
      if (!carriesValues(facts.instruction(id))) continue;
      for (const Access& access : accesses) {
        if (access.write == forwards && !access.viaPointer && access.most == 1 && access.width != Width::Bit)
          hasNew = mark(access, true) || hasNew;
      }
    }
  }
}

}  // namespace rungproof
