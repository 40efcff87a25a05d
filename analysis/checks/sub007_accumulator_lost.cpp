// SUB007: an accumulator is written, a subroutine that overwrites it is called, and then the accumulator is read. A
// subroutine that reads the accumulator first takes it as an argument; then the caller expects the change.
// Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <array>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

using Accumulators = std::uint8_t;  // one bit each

struct Summary {
  Accumulators writes = 0;      ///< in the block or its callees
  Accumulators readsFirst = 0;  ///< before it writes them
  bool isDone = false;
};

Summary summaryOf(const Facts& facts, std::uint32_t block, std::vector<Summary>& known, int depth) {
  if (known[block].isDone || depth > 16) return known[block];
  known[block].isDone = true;
  Summary result;
  std::size_t call = 0;
  for (const FlowStep& step : facts.plan().flows[block].steps) {
    for (const Access& access : facts.accesses().of(step.instruction->id)) {
      if (access.area != Area::AC || access.offset > 3) continue;
      const auto bit = static_cast<Accumulators>(1U << access.offset);
      if (access.write && !access.viaPointer)
        result.writes |= bit;
      else if ((result.writes & bit) == 0)
        result.readsFirst |= bit;
    }
    if (step.instruction->desc->control != Control::Call) continue;
    const std::uint32_t callee = facts.calls().sites()[facts.calls().callsIn(block)[call++]].callee;
    if (callee == noBlock) continue;
    const Summary below = summaryOf(facts, callee, known, depth + 1);
    result.readsFirst |= static_cast<Accumulators>(below.readsFirst & ~result.writes);
    result.writes |= below.writes;
  }
  result.isDone = true;
  return known[block] = result;
}

struct Value {
  const Instruction* write = nullptr;  ///< of the value that the block put there
  const Instruction* call = nullptr;   ///< that has overwritten it since
};

void checkAccumulatorsOf(const Facts& facts, FindingSink& sink, std::uint32_t block, std::vector<Summary>& known) {
  std::array<Value, 4> values{};
  std::size_t call = 0;
  for (const FlowStep& step : facts.plan().flows[block].steps) {
    const Instruction& instruction = *step.instruction;
    if (instruction.desc->control == Control::LabelMark) values.fill({});
    for (const bool writes : {false, true}) {
      for (const Access& access : facts.accesses().of(instruction.id)) {
        if (access.area != Area::AC || access.offset > 3 || (access.write && !access.viaPointer) != writes) continue;
        Value& value = values[access.offset];
        if (!writes && value.call != nullptr && value.write != nullptr) {
          Finding& finding =
              sink.report(instruction.span,
                          fmt::format("{} reads AC{}, which {} has overwritten since {}", Facts::text(instruction),
                                      access.offset, Facts::text(*value.call), Facts::text(*value.write)));
          finding.address = fmt::format("AC{}", access.offset);
          finding.related.push_back({value.call->span, "the called block writes the same accumulator"});
          finding.help =
              "keep the value in V, M or L memory over the call; accumulators are shared and not saved (001:6769)";
          value = {};
        }
        if (writes) value = {&instruction, nullptr};
      }
    }
    if (instruction.desc->control != Control::Call) continue;
    const std::uint32_t callee = facts.calls().sites()[facts.calls().callsIn(block)[call++]].callee;
    if (callee == noBlock) continue;
    const Summary summary = summaryOf(facts, callee, known, 0);
    for (std::uint32_t n = 0; n < 4; ++n) {
      const auto bit = static_cast<Accumulators>(1U << n);
      if ((summary.writes & bit) != 0 && (summary.readsFirst & bit) == 0)
        values[n].call = &instruction;
      else if ((summary.writes & bit) != 0)
        values[n] = {};
    }
  }
}

void checkSub007(const Facts& facts, FindingSink& sink) {
  if (!facts.usesAccumulators()) return;
  std::vector<Summary> known(facts.program().pous.size());
  for (std::uint32_t block = 0; block < known.size(); ++block) checkAccumulatorsOf(facts, sink, block, known);
}

}  // namespace

extern constexpr Rule sub007_accumulator_lost = {
    .id = "SUB007",
    .title = "Accumulator overwritten by a call",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "an accumulator value that is needed after a CALL whose routine writes the same accumulator",
    .why = "accumulators are shared between blocks and a call does not save them",
    .manual = "001:6769",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW VW0, AC0\nCALL SBR0\nMOVW AC0, "
        "VW2\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW VW10, AC0\n+I 5, AC0\nMOVW AC0, "
        "VW12\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR0\nMOVW VW0, AC0\nMOVW AC0, "
        "VW2\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW VW10, AC0\n+I 5, AC0\nMOVW AC0, "
        "VW12\nEND_SUBROUTINE_BLOCK\n",
    .falsePositives = "a routine that returns its result in the accumulator",
    .dialects = dialect::S7200,
    .ofLists = true,
    .check = checkSub007,
};

}  // namespace rungproof
