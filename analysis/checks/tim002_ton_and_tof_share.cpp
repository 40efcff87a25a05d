// TIM002: TON and TOF on one number. Tested by its examples.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkTim002(const Facts& facts, FindingSink& sink) {
  for (std::uint32_t number = 0; number < 256; ++number) {
    const Instruction* on = nullptr;
    const Instruction* off = nullptr;
    for (const std::uint32_t id : facts.timerBoxes(number)) {
      const Instruction& box = facts.instruction(id);
      if (roleOf(box) == Role::Ton && on == nullptr) on = &box;
      if (roleOf(box) == Role::Tof && off == nullptr) off = &box;
    }
    if (on == nullptr || off == nullptr) continue;
    const Instruction& later = on->id > off->id ? *on : *off;
    const Instruction& earlier = &later == on ? *off : *on;
    Finding& finding =
        sink.report(later.span, fmt::format("{} is a TON and a TOF in one program", facts.name(later.operands[0])));
    finding.address = toString(later.operands[0]);
    finding.related.push_back({earlier.span, fmt::format("{} stands here", Facts::text(earlier))});
    finding.help = "give one of them another number (001:6541)";
  }
}

}  // namespace

extern constexpr Rule tim002_ton_and_tof_share = {
    .id = "TIM002",
    .title = "TON and TOF share a number",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "TON Tn and TOF Tn in one program",
    .why = "the manual forbids it: TON and TOF take their numbers from one range, and a number can be only one of them",
    .manual = "001:6541",
    .bad = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD I0.1\nTOF T37, +20\nNetwork 3\nLD T37\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD I0.1\nTOF T38, +20\nNetwork 3\nLD T37\nO T38\n= Q0.0\n",
    .peers = "Omron duplicate timers/counters",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkTim002,
};

}  // namespace rungproof
