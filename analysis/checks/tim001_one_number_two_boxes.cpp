// TIM001: one timer or counter number in two boxes. TON and TOF on one number are TIM002.
// Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isTonTofPair(Role a, Role b) { return (a == Role::Ton && b == Role::Tof) || (a == Role::Tof && b == Role::Ton); }

void checkBoxes(const Facts& facts, FindingSink& sink, std::span<const std::uint32_t> boxes) {
  if (boxes.size() < 2) return;
  const Instruction& first = facts.instruction(boxes[0]);
  for (std::size_t i = 1; i < boxes.size(); ++i) {
    const Instruction& box = facts.instruction(boxes[i]);
    if (isTonTofPair(roleOf(first), roleOf(box))) continue;
    const std::string number = facts.name(box.operands[0]);
    Finding& finding = sink.report(box.span, fmt::format("{} is used by a second box, {}; both share one current value",
                                                         number, Facts::text(box)));
    finding.address = toString(box.operands[0]);
    finding.related.push_back({first.span, fmt::format("first box of {}", number)});
    finding.help = "give each box its own number";
  }
}

void checkTim001(const Facts& facts, FindingSink& sink) {
  for (std::uint32_t number = 0; number < 256; ++number) {
    checkBoxes(facts, sink, facts.timerBoxes(number));
    checkBoxes(facts, sink, facts.counterBoxes(number));
  }
}

}  // namespace

extern constexpr Rule tim001_one_number_two_boxes = {
    .id = "TIM001",
    .title = "One number, two boxes",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "the same T or C number in two timer or counter boxes",
    .why = "each number has one current value, which both boxes would change",
    .manual = "001:4021, 001:4117, 001:6611",
    .bad = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD I0.1\nTON T37, +20\nNetwork 3\nLD T37\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD I0.1\nTON T38, +20\nNetwork 3\nLD T37\nO T38\n= Q0.0\n",
    .falsePositives = "boxes in code of which only one part runs per scan",
    .peers = "Omron duplicate timers/counters; SA0105; CP20",
    .dialects = dialect::S7200,
    .check = checkTim001,
};

}  // namespace rungproof
