// TIM006: a TONR without an R of its number. Tested by its examples.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isReset(const Facts& facts, std::uint32_t number) {
  const std::uint32_t cell = facts.index().cells().cell(Area::T, number, 0);
  if (cell == facts.index().cells().size() || facts.index().isWrittenAtLarge(cell)) return true;
  const std::span<const std::uint32_t> accesses = facts.index().at(cell);
  return std::any_of(accesses.begin(), accesses.end(), [&](std::uint32_t i) {
    const Access& access = facts.access(i);
    return access.write && !access.isBox;
  });
}

void checkTim006(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode()) return;
  for (std::uint32_t number = 0; number < 256; ++number) {
    for (const std::uint32_t id : facts.timerBoxes(number)) {
      const Instruction& box = facts.instruction(id);
      if (roleOf(box) != Role::Tonr || isReset(facts, number)) continue;
      const std::string name = facts.name(box.operands[0]);
      Finding& finding = sink.report(
          box.span, fmt::format("{} is a retentive timer that nothing resets; once elapsed its bit stays on", name));
      finding.address = toString(box.operands[0]);
      finding.help = fmt::format("add R {}, 1, or use a TON (001:6581)", toString(box.operands[0]));
      break;
    }
  }
}

}  // namespace

extern constexpr Rule tim006_tonr_never_reset = {
    .id = "TIM006",
    .title = "TONR never reset",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "a TONR without any R of its number",
    .why = "a retentive timer holds value and bit when its input goes off; only R clears it",
    .manual = "001:6581",
    .bad = "Network 1\nLD I0.0\nTONR T5, +10\nNetwork 2\nLD T5\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTONR T5, +10\nNetwork 2\nLD I0.1\nR T5, 1\nNetwork 3\nLD T5\n= Q0.0\n",
    .dialects = dialect::S7200,
    .check = checkTim006,
};

}  // namespace rungproof
