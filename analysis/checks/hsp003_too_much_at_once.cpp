// HSP003: XMT and RCV of one port in one rung, more than eight NETR and NETW in every scan, the clock in the scan and
// in an interrupt routine. Tested by its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr int mostTransfers = 8;  // 001:3033

bool sharesRung(const Facts& facts, const Instruction& a, const Instruction& b) {
  return facts.blockOf(a.id) == facts.blockOf(b.id) && facts.place(a.id).network == facts.place(b.id).network &&
         facts.stack().at(a.id).source == facts.stack().at(b.id).source &&
         facts.stack().at(a.id).source != StackPoint::noSource;
}

void checkClock(const Facts& facts, FindingSink& sink) {
  const Instruction* scan = nullptr;
  const Instruction* interrupt = nullptr;
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.role == Role::Todr || desc.role == Role::Todw; })) {
    const Role role = roleOf(*place.instruction);
    if (role != Role::Todr && role != Role::Todw) continue;
    if (facts.calls().reachedFromInterrupt(place.block))
      interrupt = place.instruction;
    else
      scan = place.instruction;
  }
  if (scan == nullptr || interrupt == nullptr) return;
  Finding& finding = sink.report(
      interrupt->span,
      fmt::format("{} uses the clock in an interrupt routine, and the scan uses it too", Facts::text(*interrupt)));
  finding.related.push_back({scan->span, "the clock is used here in the scan"});
  finding.help = "read the clock in the scan only; the second use at one time is not executed (001:2949; error 0007)";
}

void checkTransfers(const Facts& facts, FindingSink& sink) {
  int count = 0;
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.role == Role::Netr || desc.role == Role::Netw; })) {
    const Instruction& instruction = *place.instruction;
    if (roleOf(instruction) != Role::Netr && roleOf(instruction) != Role::Netw) continue;
    const bool isAlways = (facts.stack().at(instruction.id).flow & condition::Always) != 0;
    if (!isAlways || ++count != mostTransfers + 1) continue;
    sink.report(instruction.span,
                fmt::format("{} is the ninth NETR or NETW that runs in every scan; eight may be active at one time",
                            Facts::text(instruction)))
        .help = "start the next transfer when the one before is done (001:3033)";
  }
}

void checkHsp003(const Facts& facts, FindingSink& sink) {
  checkClock(facts, sink);
  checkTransfers(facts, sink);
  const Instruction* send = nullptr;
  const Instruction* receive = nullptr;
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.role == Role::Xmt || desc.role == Role::Rcv; })) {
    const Instruction& instruction = *place.instruction;
    const Role role = roleOf(instruction);
    if ((role != Role::Xmt && role != Role::Rcv) || instruction.operands.size() < 2) continue;
    const Instruction* other = role == Role::Xmt ? receive : send;
    (role == Role::Xmt ? send : receive) = &instruction;
    if (other == nullptr || other->operands[1].value != instruction.operands[1].value ||
        !sharesRung(facts, *other, instruction))
      continue;
    Finding& finding = sink.report(instruction.span, fmt::format("{} and {} run at the same time on one port",
                                                                 Facts::text(*other), Facts::text(instruction)));
    finding.related.push_back({other->span, "the other transfer"});
    finding.help =
        "start RCV when the transmission is complete, in the routine of event 9 or 26 (errors 0009 and 000B, "
        "001:13957-13959)";
  }
}

}  // namespace

extern constexpr Rule hsp003_too_much_at_once = {
    .id = "HSP003",
    .title = "Too much at once",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "XMT and RCV started together on one port, more than eight NETR and NETW in every scan, the clock used in the "
        "scan and in an interrupt routine",
    .why = "the second one is not executed and gives run-time error 0009, 000B or 0007",
    .manual = "001:2949, 001:3033, 001:13957-13959",
    .bad = "Network 1\nLD I0.0\nEU\nXMT VB100, 0\nRCV VB200, 0\n",
    .good = "Network 1\nLD I0.0\nEU\nXMT VB100, 0\nNetwork 2\nLD I0.1\nEU\nRCV VB200, 0\n",
    .dialects = dialect::S7200,
    .check = checkHsp003,
};

}  // namespace rungproof
