// TIM003: a timer number of the wrong kind. The number fixes kind and resolution, so the message prints both.
// Ranges come from the descriptors. Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/operand_check.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

void checkTim003(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place : facts.placesOf([](const Desc& desc) { return isTimerBox(desc.role); })) {
    const Instruction& instruction = *place.instruction;
    if (!isTimerBox(roleOf(instruction)) || instruction.operands.empty()) continue;
    const Operand& timer = instruction.operands[0];
    const int resolution = timerResolution(static_cast<int>(timer.offset));
    if (timer.kind != OperandKind::Direct || timer.area != Area::T || resolution == 0) continue;
    const OperandDesc& desc = instruction.desc->operands[0];
    if (valueIsInRange(desc, timer.offset, everyCpu)) continue;
    const bool isRetentive = timerIsRetentive(static_cast<int>(timer.offset));
    Finding& finding = sink.report(
        timer.span, fmt::format("{} cannot be a {}: the number belongs to {} with {} ms resolution", toString(timer),
                                instruction.desc->stl, isRetentive ? "TONR" : "TON and TOF", resolution));
    finding.address = toString(timer);
    finding.help = fmt::format("{} has the numbers {} (table 6-74, 001:6595-6603)", instruction.desc->stl,
                               rangesText(desc, facts.target().cpu));
  }
}

}  // namespace

extern constexpr Rule tim003_number_does_not_fit = {
    .id = "TIM003",
    .title = "Number does not fit the timer kind",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "TONR on a TON number or the reverse; an IEC timer outside T32-T63 and T96-T255",
    .why = "the number fixes the kind of the timer and its resolution of 1, 10 or 100 ms",
    .manual = "001:6595-6603, 001:6683",
    .bad = "Network 1\nLD I0.0\nTON T5, +10\nNetwork 2\nLD T5\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .dialects = dialect::S7200,
    .refuses = true,
    .standsAlone = true,
    .check = checkTim003,
};

}  // namespace rungproof
