// TIM008: timer or counter can never fire, or never returns. The prover can say; that an on-delay timer outlasts a
// clock bit or a pulse that stands in series before it is seen in the text (analysis/flow/on_time.hpp). A TONR adds the
// pieces up and is left out. Tested by tests/rules/timer_rules_test.cpp, tests/rules/step7_timer_rules_test.cpp,
// tests/prover/builtin_test.cpp and tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/on_time.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7300/statement_detail.hpp"

namespace rungproof {

namespace {

constexpr int comesOnAtAll = 0, goesOffAgain = 1;
constexpr std::int64_t longestScan = 500;  ///< ms: the watchdog (001:5718); a bit is sampled once a scan

std::string secondsText(std::int64_t ms) { return fmt::format("{:g} s", static_cast<double>(ms) / 1000); }

void reportShortFeed(const Facts& facts, FindingSink& sink, const Instruction& box, std::int64_t timeMs,
                     const OnTime& feed) {
  const std::string name = facts.name(box.operands[0]);
  const std::string way = feed.ms == 0 ? "one scan" : secondsText(feed.ms);
  Finding& finding =
      sink.report(box.span, fmt::format("{} needs its input for {} without a break, and {} is on for {} at a time",
                                        name, secondsText(timeMs), feed.bit, way));
  finding.address = toString(box.operands[0]);
  finding.confirmation = feed.isClock ? Confirmation::NotNeeded : Confirmation::Unconfirmed;
  finding.help = "let the timer run with a level, count the edges of the clock, or use a timer that adds up (TONR)";
}

bool runsInEveryScan(const Facts& facts, std::uint32_t id) {
  const ExecutionPoint& point = facts.execution().at(id);
  return point.isReachable && !point.isSkipped && !point.inLoop &&
         facts.execution().runs(facts.blockOf(id)) == Runs::Once;
}

/// Whether its box alone moves the timer forward.
bool isMovedByBoxOnly(const Facts& facts, std::uint32_t number) {
  const std::uint32_t cell = facts.index().cells().cell(Area::T, number, 0);
  if (cell == facts.index().cells().size() || facts.index().isWrittenAtLarge(cell) || facts.isExternal(cell))
    return false;
  return std::ranges::none_of(facts.index().at(cell), [&](std::uint32_t i) {
    const Access& access = facts.access(i);
    return access.write && !access.isBox && access.width != Width::Bit &&
           !isReset(roleOf(facts.instruction(access.instruction)));
  });
}

void checkTimerBoxes(const Facts& facts, FindingSink& sink) {
  if (!facts.placesOf([](const Desc& desc) { return desc.role == Role::Wdr; }).empty()) return;
  for (const InstructionPlace& place : facts.placesOf([](const Desc& desc) { return desc.role == Role::Ton; })) {
    const Instruction& box = *place.instruction;
    if (roleOf(box) != Role::Ton || box.operands.size() < 2 || box.operands[0].kind != OperandKind::Direct ||
        box.operands[1].kind != OperandKind::Constant || !runsInEveryScan(facts, box.id))
      continue;
    const std::uint32_t number = box.operands[0].offset;
    if (facts.timerBoxes(number).size() != 1 || !isMovedByBoxOnly(facts, number) || facts.isUnread(box.id)) continue;
    const std::int64_t time = box.operands[1].value * timerResolution(static_cast<int>(number));
    const std::optional<OnTime> feed = onTimeOfFlow(facts, place);
    if (feed && time >= feed->ms + longestScan) reportShortFeed(facts, sink, box, time, *feed);
  }
}

/// S7-300/400: SD alone starts again with each change of its RLO. The time is S5TIME: base and three digits.
void checkOnDelays(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode() || usesUnnamedTimers(facts)) return;
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    for (std::uint32_t at = 1; at < flow.steps.size(); ++at) {
      const Instruction& start = *flow.steps[at].instruction;
      const Instruction& load = *flow.steps[at - 1].instruction;
      if (!startsOnDelay(start) || statementRole(load) != StatementRole::Load ||
          load.operands[0].kind != OperandKind::Constant || !runsInEveryScan(facts, start.id) ||
          startsOf(facts, start.operands[0].offset) != 1)
        continue;
      const auto value = static_cast<std::uint32_t>(load.operands[0].value);
      std::int64_t base = 10;
      for (std::uint32_t digit = value >> 12 & 3U; digit > 0; --digit) base *= 10;
      const std::int64_t time = base * ((value >> 8 & 15U) * 100 + (value >> 4 & 15U) * 10 + (value & 15U));
      const std::optional<OnTime> feed = onTimeOfRlo(facts, block, at - 1);
      if (feed && time >= feed->ms + longestScan + base) reportShortFeed(facts, sink, start, time, *feed);
    }
  });
}

void checkTim008(const Facts& facts, FindingSink& sink) {
  if (facts.form() == StatementForm::Accumulators) return checkOnDelays(facts, sink);
  checkTimerBoxes(facts, sink);
}

void askTim008(Asking& asking, const Instruction& box) {
  Graph& graph = asking.graph();
  EncodedScan& encoding = asking.encoding();
  const Operand& o = box.operands[0];
  const Place bit = registerPlace(isBoxOf(box, Type::Timer) ? Reg::TimerBit : Reg::CounterBit, o.offset);
  const Node now = encoding.atEnd(bit);
  // A bit that is reset in the scan in which it comes on is on for the instructions between.
  const Node seen = asking.record().seenOn(o.area, o.offset);
  const Graph::Bool within{seen == noNode ? graph.constant(false).node : seen};
  const Node on = graph.lor({now}, within).node;
  const Graph::Bool before = graph.lor({encoding.atStart(bit)}, within);
  const std::string name = toString(o);
  asking.ask({.name = fmt::format("{} can come on", name),
              .message = fmt::format("the bit of {} can never be 1", name),
              .address = name,
              .place = &box,
              .bad = on,
              .aspect = comesOnAtAll});
  asking.ask({.name = fmt::format("{} can be reset", name),
              .message = fmt::format("once on, the bit of {} never returns to 0", name),
              .address = name,
              .place = &box,
              .bad = graph.land(before, graph.lnot({now})).node,
              .aspect = goesOffAgain});
}

/// A bit that is never on never goes off.
constexpr Explanation tim008Explained[] = {{"TIM008", Where::SameAddress, comesOnAtAll, goesOffAgain}};

}  // namespace

extern constexpr Rule tim008_never_fires = {
    .id = "TIM008",
    .title = "Timer or counter can never fire",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "a timer or counter whose bit can never become 1, or once 1 never returns to 0; without the prover: a TON or "
        "SD "
        "behind a clock bit (SM0.4, SM0.5, SM0.6, the clock memory of an S7-300) or a pulse that is shorter than its "
        "time",
    .why = "a dead alarm or a dead step looks like a live one in the listing",
    .manual = "001:6569, 002:2865-2878",
    .bad = "Network 1\nLD I0.0\nEU\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .falsePositives = "a timer that is only used through its current value",
    .check = checkTim008,
    .ask = {.in = asked::Builtin, .turn = 40, .cost = 3, .wantsYes = true, .box = askTim008},
    .tell = {.advice = "look at the input and the preset"},
    .explainedBy = tim008Explained,
};

}  // namespace rungproof
