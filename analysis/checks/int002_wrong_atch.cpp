// INT002: an ATCH that cannot work: routine or event that does not exist, timed interval outside 1 to 255 ms or never
// set, T32/T96 event without a 1 ms TON or TOF. Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

Finding& report(FindingSink& sink, const Attachment& a, std::string message, std::string_view help) {
  Finding& finding = sink.report(a.instruction->span, std::move(message));
  finding.help = std::string(help);
  return finding;
}

/// Timed interrupts take their interval from SMB34 and SMB35 at the ATCH (001:5470).
void checkInterval(const Facts& facts, FindingSink& sink, const Attachment& a) {
  const std::uint32_t byte = a.event == 10 ? 34 : 35;
  const std::uint32_t cell = facts.index().cells().cell(Area::SM, byte, 0);
  if (cell == facts.index().cells().size()) return;
  if (!facts.index().mayBeWritten(cell) && !facts.isExternal(cell) && !facts.hasUnreadCode()) {
    report(sink, a,
           fmt::format("event {} is a timed interrupt, but nothing writes its interval to SMB{}", a.event, byte),
           "move 1 to 255 (ms) there before the ATCH (001:5470)")
        .refused = false;
    return;
  }
  for (const std::uint32_t i : facts.index().at(cell)) {
    const Access& access = facts.access(i);
    const Instruction& move = facts.instruction(access.instruction);
    if (!access.write || !isMoveOf(*move.desc, Type::Byte) || move.operands[0].kind != OperandKind::Constant) continue;
    if (move.operands[0].value >= 1 && move.operands[0].value <= 255) continue;
    Finding& finding =
        sink.report(move.span, fmt::format("{} gives timed interrupt {} an interval of {} ms; 1 to 255 are allowed",
                                           Facts::text(move), a.event - 10, move.operands[0].value));
    finding.refused = false;
    finding.related.push_back({a.instruction->span, "the interrupt is attached here"});
    finding.help = "for longer times count the interrupts in the routine (001:5470)";
  }
}

void checkTimerEvent(const Facts& facts, FindingSink& sink, const Attachment& a) {
  const std::uint32_t number = a.event == 21 ? 32 : 96;
  const std::span<const std::uint32_t> boxes = facts.timerBoxes(number);
  const bool fits = std::any_of(boxes.begin(), boxes.end(), [&](std::uint32_t id) {
    const Role role = roleOf(facts.instruction(id));
    return role == Role::Ton || role == Role::Tof || role == Role::IecTimer;
  });
  if (!fits)
    report(sink, a, fmt::format("event {} needs T{} as a TON or TOF, which the program does not have", a.event, number),
           "add the timer, or attach another event (001:5476)")
        .refused = false;
}

void checkInt002(const Facts& facts, FindingSink& sink) {
  for (const Attachment& a : facts.calls().attachments()) {
    // A routine cannot hide in a network that was not read, nor in a block that is missing.
    if (a.routine == noBlock && a.number >= 0 && facts.program().main() != nullptr && !facts.hasUnreadFrame()) {
      report(sink, a,
             fmt::format("{} attaches interrupt routine {}, which the program does not have",
                         Facts::text(*a.instruction), a.number),
             "add the routine, or correct the number (error 0087, 001:13989)");
    }
    if (a.event < 0) continue;
    if (!eventExists(facts.target(), a.event)) {
      report(sink, a,
             fmt::format("{} names event {}, which the CPU {} does not have", Facts::text(*a.instruction), a.event,
                         cpuName(facts.target().cpu)),
             "see table 6-46 for the events of each CPU (001:5366)");
    } else if (a.event == 10 || a.event == 11) {
      checkInterval(facts, sink, a);
    } else if ((a.event == 21 || a.event == 22) && !facts.hasHiddenCode()) {
      checkTimerEvent(facts, sink, a);
    }
  }
}

}  // namespace

extern constexpr Rule int002_wrong_atch = {
    .id = "INT002",
    .title = "Wrong ATCH",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "ATCH of a routine that is missing, of an event that the CPU lacks, of a timed interrupt whose interval is not "
        "1-255 ms or never set, of "
        "event 21 or 22 without a TON or TOF on T32 or T96",
    .why = "the routine never runs, or the download is refused with error 0087 or 0090",
    .manual = "001:5366, 001:5470, 001:5476, 001:13989",
    .bad = "Network 1\nLD SM0.1\nATCH 5, 10\nENI\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nMOVB 100, SMB34\nATCH INT0, "
        "10\nENI\nEND_ORGANIZATION_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW0\nEND_INTERRUPT_BLOCK\n",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkInt002,
};

}  // namespace rungproof
