// LIB001: blocks of libraries and wizards that do not run as often as they must, or run again and again though they set
// something up. Tested by its examples and tests/rules/library_rules_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/library_use.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Why the call is left out in some scans; empty: it runs in each.
std::string whyLeftOut(const Facts& facts, const CallInputs& inputs, const Instruction& call) {
  const InstructionPlace& place = facts.place(call.id);
  const ExecutionPoint& point = facts.execution().at(call.id);
  const Pou& block = facts.program().pous[place.block];
  if (point.isSkipped) return fmt::format("{} may leave it out", Facts::text(*facts.skippedBy(call.id)));
  if (block.kind == PouKind::Interrupt) return fmt::format("{} runs only at its event", block.name);
  const Condition known = inputs.enable(call);
  if ((known & condition::FirstScan) != 0) return "it runs in the first scan only";
  if ((known & condition::Pulse) != 0) return "it runs in single scans only";
  if (facts.execution().runs(place.block) == Runs::AtMostOnce)
    return fmt::format("{} is not called in every scan", block.name);
  if ((known & (condition::Always | condition::NotFirstScan)) != 0) return {};
  return "its condition may be 0";
}

void checkLib001(const Facts& facts, FindingSink& sink) {
  if (facts.hasUnreadCode()) return;
  const std::vector<LibraryCall> calls = libraryCalls(facts);
  if (calls.empty()) return;
  const CallInputs inputs(facts);
  std::map<std::string, const Instruction*> first;
  for (const LibraryCall& call : calls) {
    const auto report = [&](std::string message, std::string help) -> Finding& {
      Finding& finding = sink.report(call.call->span, std::move(message));
      finding.help = std::move(help);
      finding.address = call.name;
      return finding;
    };
    if (call.use->run == LibraryRun::EveryScan) {
      const std::string why = whyLeftOut(facts, inputs, *call.call);
      if (!why.empty())
        report(fmt::format("{} must run in every scan, but {}", call.name, why),
               "call it in the main program with SM0.0 in front of it and nothing in series");
    } else if (call.use->run == LibraryRun::Once) {
      const bool isOften = (inputs.enable(*call.call) & condition::Always) != 0 &&
                           facts.execution().runs(facts.blockOf(call.call->id)) == Runs::Once &&
                           facts.execution().condition(facts.blockOf(call.call->id)) == 0 &&
                           !facts.execution().at(call.call->id).isSkipped;
      if (isOften)
        report(fmt::format("{} runs in every scan; it is to run once", call.name),
               "put SM0.1 or an edge in front of it");
    }
    if (!call.use->onceInProgram) continue;
    const auto [found, isNew] = first.emplace(call.name, call.call);
    if (isNew) continue;
    report(fmt::format("{} is called a second time; it may stand once in a program", call.name),
           "keep the call that runs in every scan")
        .related.push_back({found->second->span, "the first call"});
  }
}

}  // namespace

extern constexpr Rule lib001_library_block_not_run_as_demanded = {
    .id = "LIB001",
    .title = "Library block not run as it demands",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "MBUS_CTRL, MBUS_SLAVE, MBUS_SERVER, PTOx_CTRL, POSx_CTRL, AXISx_CTRL, MODx_CTRL, PIDx_CTRL or USS_CTRL that "
        "is not called in every scan, or twice; MBUS_INIT, USS_INIT, RCPx_WRITE or DATx_WRITE in every scan",
    .why =
        "they lose characters, never answer, or stop what they control; an initialisation in every scan starts over "
        "and over, and a memory cartridge wears out",
    .manual =
        "001:8205, 001:8599, 001:9687, 001:10076, 001:10103-10107, 001:10726-10728, 001:10771, 001:11056, "
        "001:11251",
    .bad = "Network 1\nLD I0.0\nCALL MBUS_SLAVE, M0.1, VB1000\n",
    .good = "Network 1\nLD SM0.0\nCALL MBUS_SLAVE, M0.1, VB1000\n",
    .falsePositives = "a bit of the program's own that is always on: write SM0.0",
    .dialects = dialect::S7200,
    .check = checkLib001,
};

}  // namespace rungproof
