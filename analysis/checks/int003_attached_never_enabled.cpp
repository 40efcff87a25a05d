// INT003: ATCH without ENI, ENI without ATCH, DISI that is never undone. Tested by its examples and
// tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkInt003(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode()) return;
  std::vector<const Instruction*> enables, disables, attaches;
  bool hasUnknownCall = false;
  for (const InstructionPlace& place : facts.placesOf([](const Desc& desc) {
         return desc.role == Role::Eni || desc.role == Role::Disi || desc.role == Role::Atch;
       })) {
    const Instruction& instruction = *place.instruction;
    const bool isLive = facts.execution().at(instruction.id).isReachable &&
                        (facts.stack().at(instruction.id).flow & condition::Never) == 0;
    if (!isLive) continue;
    if (roleOf(instruction) == Role::Eni) enables.push_back(&instruction);
    if (roleOf(instruction) == Role::Disi) disables.push_back(&instruction);
    if (roleOf(instruction) == Role::Atch) attaches.push_back(&instruction);
  }
  for (const CallSite& site : facts.calls().sites()) hasUnknownCall = hasUnknownCall || site.callee == noBlock;
  if (hasUnknownCall) return;  // a library may attach and enable
  if (!attaches.empty() && enables.empty()) {
    sink.report(attaches.front()->span, fmt::format("{} attaches a routine, but nothing in the program runs ENI",
                                                    Facts::text(*attaches.front())))
        .help = "interrupts are disabled when RUN begins; add ENI (001:5331-5333)";
  }
  if (attaches.empty() && !enables.empty()) {
    sink.report(enables.front()->span, "ENI enables interrupts, but nothing is attached to an event").help =
        "add the ATCH, or remove ENI";
  }
  if (enables.empty() || disables.empty()) return;
  bool isUndone = false;
  for (const Instruction* enable : enables)
    isUndone = isUndone || (facts.conditionOf(enable->id) & condition::FirstScan) == 0;
  for (const Instruction* disable : disables) {
    if (isUndone || (facts.conditionOf(disable->id) & condition::FirstScan) != 0) continue;
    Finding& finding = sink.report(disable->span, "DISI is never undone: every ENI runs in the first scan only");
    finding.related.push_back({enables.front()->span, "ENI of the first scan"});
    finding.help = "add an ENI where the protected part ends";
    break;
  }
}

}  // namespace

extern constexpr Rule int003_attached_never_enabled = {
    .id = "INT003",
    .title = "Attached, never enabled",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "ATCH without a reachable ENI, ENI without ATCH, DISI that no later ENI undoes",
    .why = "interrupts are off when RUN begins; without ENI events are queued until the queue overflows",
    .manual = "001:5331-5333, 001:5372",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nEND_ORGANIZATION_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW0\nEND_INTERRUPT_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nENI\nEND_ORGANIZATION_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW0\nEND_INTERRUPT_BLOCK\n",
    .dialects = dialect::S7200,
    .check = checkInt003,
};

}  // namespace rungproof
