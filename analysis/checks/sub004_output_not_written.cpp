// SUB004: an OUT parameter that a path through the block leaves untouched, or that only S, R or one box with an enable
// write. Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "analysis/flow/dataflow_locals.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/flow/step7_locals.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// The only writer of the parameter if it acts with power flow only, or if all writers are S and R; nullptr otherwise.
const Instruction* conditionalWriter(const Facts& facts, const Flow& flow, const LocalVariable& parameter) {
  const LocalBits bits = localBitsOf(parameter);
  const Instruction* first = nullptr;
  int writers = 0;
  bool isLatchesOnly = true;
  for (const FlowStep& step : flow.steps) {
    for (const Access& access : facts.accesses().of(step.instruction->id)) {
      if (!access.write || access.area != Area::L || access.viaPointer || (localBitsOf(access) & bits).none()) continue;
      const Role role = roleOf(*step.instruction);
      const bool isAlways = (facts.stack().at(step.instruction->id).flow & condition::Always) != 0;
      if (!access.conditional || isAlways) return nullptr;
      if (!isSet(role) && !isReset(role)) isLatchesOnly = false;
      if (first == nullptr) first = step.instruction;
      ++writers;
    }
  }
  return writers == 1 || isLatchesOnly ? first : nullptr;
}

void checkOutputs(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t block, const Flow& flow) {
    for (const OutputGap& gap : unwrittenOutputs(facts, block)) {
      Finding& finding =
          sink.report(gap.output->span.length > 0 ? gap.output->span : flow.steps.front().instruction->span,
                      fmt::format("output {} of {} is {}", gap.output->name, flow.pou->name,
                                  gap.isNeverWritten ? "never written"
                                  : gap.isLatched    ? "only set and reset, and written in no other way"
                                                     : "not written on every path through it"));
      if (gap.isLatched) finding.severity = Severity::Note;  // of a bit that the caller keeps it makes a latch
      finding.address = "#" + gap.output->name;
      if (gap.exit != nullptr) finding.related.push_back({gap.exit->span, "the block can be left here"});
      finding.help = gap.isLatched
                         ? "declare it in VAR_IN_OUT, or write it with = from a bit that lasts; the caller keeps its "
                           "old value, or gets any"
                         : "write the output before the first jump; without that the caller keeps its old value, or "
                           "gets any";
    }
  });
}

void checkSub004(const Facts& facts, FindingSink& sink) {
  if (facts.form() == StatementForm::Accumulators) return checkOutputs(facts, sink);
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    const Pou& pou = facts.program().pous[block];
    const Flow& flow = facts.plan().flows[block];
    if (pou.protectedBlock || flow.steps.empty() || facts.hasUnreadCode(block)) continue;
    const LocalFlow locals = localFlow(facts, block);
    std::vector<const LocalVariable*> reported;
    for (const LocalExit& exit : locals.exits) {
      reported.push_back(exit.parameter);
      Finding& finding = sink.report(
          exit.parameter->span,
          exit.isNeverWritten
              ? fmt::format("output {} of {} is never written", exit.parameter->name, pou.name)
              : fmt::format("output {} of {} is not written on every path through it", exit.parameter->name, pou.name));
      finding.address = toString(exit.parameter->address);
      if (exit.exit != nullptr) finding.related.push_back({exit.exit->span, "the block can be left here"});
      finding.help = "write the output at the start of the block; it keeps nothing between calls (001:6784)";
    }
    for (const LocalVariable& local : pou.locals) {
      if (local.section != VarSection::Output || std::find(reported.begin(), reported.end(), &local) != reported.end())
        continue;
      const Instruction* writer = conditionalWriter(facts, flow, local);
      if (writer == nullptr) continue;
      Finding& finding = sink.report(writer->span, fmt::format("output {} of {} is written only with power flow, by {}",
                                                               local.name, pou.name, Facts::text(*writer)));
      finding.address = toString(local.address);
      finding.related.push_back({local.span, fmt::format("{} is declared here", local.name)});
      finding.help = "give it a value in every call, with = for a bit or a first MOV behind LD SM0.0 (001:6784)";
    }
  }
}

}  // namespace

extern constexpr Rule sub004_output_not_written = {
    .id = "SUB004",
    .title = "OUT parameter not written on some path",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a path through the routine that leaves an OUT parameter untouched; an OUT parameter written only by S and R, "
        "or by one box with an enable; S7-300/400: an output or the return value of an FC that a path leaves out, a "
        "note "
        "where S and R alone write it",
    .why =
        "the caller gets whatever local memory held: outputs keep nothing between calls, and S and R write only with "
        "power flow",
    .manual = "001:1373, 001:6782-6784, 002:154-159",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0, I0.0, Q0.0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nStart:BOOL;\nEND_VAR\nVAR_OUTPUT\nRun:BOOL;\nEND_VAR\nBEGIN\nNetwork "
        "1\nLD L0.0\nS L0.1, 1\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0, I0.0, Q0.0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nStart:BOOL;\nEND_VAR\nVAR_OUTPUT\nRun:BOOL;\nEND_VAR\nBEGIN\nNetwork "
        "1\nLD L0.0\n= L0.1\nEND_SUBROUTINE_BLOCK\n",
    .peers = "SA0022",
    .check = checkSub004,
};

}  // namespace rungproof
