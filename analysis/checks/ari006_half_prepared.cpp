// ARI006: a double word is read of which only one word was prepared: in V and M memory over the whole program, in an
// accumulator along its block. Tested by its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include <array>
#include <unordered_set>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isFilled(const Facts& facts, std::uint32_t cell) {
  if (facts.index().isWrittenAtLarge(cell) || facts.isExternal(cell)) return true;
  for (unsigned bit = 0; bit < 8; ++bit) {
    if (facts.writers(cell, bit) > 0) return true;
  }
  return false;
}

/// The word access that writes one half of the double word while nothing writes the other, or nullptr.
const Access* writtenHalf(const Facts& facts, const Access& access) {
  const std::uint32_t cell = facts.cellOf(access);
  if (cell + 3 >= facts.index().cells().size()) return nullptr;
  const bool high = isFilled(facts, cell) || isFilled(facts, cell + 1);
  const bool low = isFilled(facts, cell + 2) || isFilled(facts, cell + 3);
  if (high == low) return nullptr;
  for (const std::uint32_t i : facts.index().at(high ? cell : cell + 2)) {
    const Access& write = facts.access(i);
    if (write.write && write.width == Width::Word && write.offset == access.offset + (high ? 0 : 2)) return &write;
  }
  return nullptr;
}

void checkMemory(const Facts& facts, FindingSink& sink) {
  std::unordered_set<std::uint32_t> reported;
  for (const Access& access : facts.accesses().all()) {
    if (access.write || access.viaPointer || access.maybe || access.width != Width::DWord || access.count != 1 ||
        access.operand == impliedOperand)
      continue;
    if (access.area != Area::V && access.area != Area::M) continue;
    const std::uint32_t cell = facts.cellOf(access);
    if (cell >= facts.index().cells().size() || reported.contains(cell)) continue;
    const Access* half = writtenHalf(facts, access);
    if (half == nullptr) continue;
    reported.insert(cell);
    const Instruction& instruction = facts.instruction(access.instruction);
    const std::uint32_t missing = half->offset == access.offset ? access.offset + 2 : access.offset;
    Finding& finding = sink.report(
        instruction.operands[access.operand].span,
        fmt::format("{} reads {}, but only its {} word {} is ever written; {} is not", Facts::text(instruction),
                    accessName(access), missing > access.offset ? "upper" : "lower", accessName(*half),
                    addressName(access.area, Width::Word, missing)));
    finding.address = accessName(access);
    finding.related.push_back({facts.instruction(half->instruction).span, "one half is written here"});
    finding.help = "extend the word by ITD, or clear the other half";
  }
}

/// Accumulators: what the block itself has put into them.
enum class Fill : std::uint8_t { Unknown, WordOnly, Full };

void checkAccumulators(const Facts& facts, FindingSink& sink, const Flow& flow) {
  std::array<Fill, 4> fill{};
  std::array<const Instruction*, 4> writer{};
  for (const FlowStep& step : flow.steps) {
    const Instruction& instruction = *step.instruction;
    const Control control = instruction.desc->control;
    if (control == Control::LabelMark || control == Control::Call || control == Control::Next) fill.fill(Fill::Full);
    for (const bool writes : {false, true}) {
      for (const Access& access : facts.accesses().of(instruction.id)) {
        if (access.area != Area::AC || access.offset > 3 || access.write != writes || access.operand == impliedOperand)
          continue;
        Fill& state = fill[access.offset];
        const bool isPointer = access.viaPointer;
        if (!writes && access.width == Width::DWord && !isPointer && state == Fill::WordOnly) {
          Finding& finding =
              sink.report(instruction.operands[access.operand].span,
                          fmt::format("{} reads all of AC{}, but {} wrote only its lower word",
                                      Facts::text(instruction), access.offset, Facts::text(*writer[access.offset])));
          finding.address = fmt::format("AC{}", access.offset);
          finding.related.push_back({writer[access.offset]->span, "only 16 bits are written here"});
          finding.help = "extend the word by ITD, or clear the accumulator by MOVD 0 first";
          state = Fill::Full;
        }
        if (!writes || isPointer) continue;
        if (access.width == Width::DWord) state = Fill::Full;
        if (access.width == Width::Word && state == Fill::Unknown) {
          state = Fill::WordOnly;
          writer[access.offset] = &instruction;
        }
      }
    }
  }
}

void checkAri006(const Facts& facts, FindingSink& sink) {
  if (facts.hasUnreadCode()) return;
  checkMemory(facts, sink);
  if (!facts.usesAccumulators()) return;
  for (const Flow& flow : facts.plan().flows) checkAccumulators(facts, sink, flow);
}

}  // namespace

extern constexpr Rule ari006_half_prepared = {
    .id = "ARI006",
    .title = "Double word half prepared",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects = "a double word or REAL that is read although only one of its words was written",
    .why = "a typical slip in chains of MUL, DIV and DTR: the other word holds whatever was there",
    .manual = "001:1272-1277, 001:1344, 001:4890-4936",
    .bad = "Network 1\nLD SM0.0\nMOVW AIW0, VW102\nDTR VD100, VD200\n",
    .good = "Network 1\nLD SM0.0\nITD AIW0, VD100\nDTR VD100, VD200\n",
    .falsePositives = "an upper word that is 0 from the start and values that are never negative",
    .dialects = dialect::S7200,
    .check = checkAri006,
};

}  // namespace rungproof
