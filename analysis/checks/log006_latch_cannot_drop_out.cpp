// LOG006: latch cannot drop out. A bit that holds itself, or is set and reset, and never goes off. Only the prover can
// say. Tested by tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "analysis/asking/asking.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

enum LatchAspect : int { ComesOn, DropsOut };

std::vector<std::uint32_t> bitsSetBy(const Instruction& set) {
  const bool isKnown = set.operands.size() > 1 && set.operands[1].kind == OperandKind::Constant;
  const auto count = isKnown ? static_cast<std::uint32_t>(std::clamp<std::int64_t>(set.operands[1].value, 1, 255)) : 1;
  std::vector<std::uint32_t> bits(count);
  std::iota(bits.begin(), bits.end(), bitPosition(set.operands[0].area, set.operands[0].offset, set.operands[0].bit));
  return bits;
}

class LatchQuestions {
 public:
  explicit LatchQuestions(Asking& asking) : asking_(asking) {
    for (const BitWrite& write : asking.encoding().bitWrites()) {
      const Place& at = write.place;
      if (write.instruction != nullptr && !at.isRegister)
        writersOf_[{at.area, bitPosition(at.area, at.byte(), at.bit())}].insert(write.instruction->id);
    }
    for (const Pou& pou : asking.program().pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          if (isReset(roleOf(instruction))) resets_.push_back(&instruction);
        }
      }
    }
  }

  /// A coil that holds itself, and bits with S and R. Bits that the same instructions write are one question.
  void ask(const Instruction& output) {
    if (output.operands.empty() || output.operands[0].kind != OperandKind::Direct || output.operands[0].area == Area::L)
      return;
    const Operand& bit = output.operands[0];
    if (hasBitAndWord(bit.area)) return;
    if (isPlainCoil(*output.desc)) {
      const bool holds = std::ranges::any_of(asking_.rungOf(output),
                                             [&](const Instruction* c) { return isContactOf(*c, bit, false); });
      if (holds) askRow({bit.area, {bitPosition(bit.area, bit.offset, bit.bit)}}, output);
      return;
    }
    if (!isSet(roleOf(output))) return;
    std::map<std::set<std::uint32_t>, BitRow> byWriters;
    for (const std::uint32_t at : bitsSetBy(output)) {
      if (!hasReset(bit.area, at)) continue;
      const auto writers = writersOf_.find({bit.area, at});
      if (writers == writersOf_.end()) continue;
      BitRow& row = byWriters[writers->second];
      row.area = bit.area;
      row.bits.push_back(at);
    }
    for (const auto& [writers, row] : byWriters) askRow(row, output);
  }

 private:
  void askRow(const BitRow& row, const Instruction& output) {
    if (!asked_.emplace(row.area, row.bits.front()).second) return;
    Graph& graph = asking_.graph();
    Graph::Bool on = graph.constant(false), falls = on;
    for (const std::uint32_t at : row.bits) {
      const Place place = memoryPlace(row.area, at / 8, Width::Bit, at % 8);
      const Graph::Bool before{asking_.encoding().atStart(place)}, after{asking_.encoding().atEnd(place)};
      on = graph.lor(on, after);
      falls = graph.lor(falls, graph.land(before, graph.lnot(after)));
    }
    const std::string name = row.text();
    asking_.ask({.name = fmt::format("{} can be on at the end of a scan", name),
                 .address = row.first(),
                 .place = &output,
                 .bad = on.node,
                 .aspect = ComesOn});
    asking_.ask({.name = fmt::format("{} can drop out", name),
                 .message = fmt::format("once on, {} never {} off again in any reachable state", name,
                                        row.bits.size() == 1 ? "goes" : "go"),
                 .address = row.first(),
                 .place = &output,
                 .bad = falls.node,
                 .aspect = DropsOut});
  }
  /// Whether the program has an R whose bits include that one.
  bool hasReset(Area area, std::uint32_t bit) const {
    return std::ranges::any_of(resets_, [&](const Instruction* reset) {
      if (reset->operands.size() < 2 || reset->operands[0].area != area ||
          reset->operands[0].kind != OperandKind::Direct)
        return false;
      const bool isOpen = reset->operands[1].kind != OperandKind::Constant;
      const auto count = isOpen ? 255U : static_cast<std::uint32_t>(reset->operands[1].value);
      const std::uint32_t first = bitPosition(area, reset->operands[0].offset, reset->operands[0].bit);
      return first <= bit && bit < first + count;
    });
  }

  Asking& asking_;
  std::vector<const Instruction*> resets_;
  std::set<std::pair<Area, std::uint32_t>> asked_;                               ///< by their first bits
  std::map<std::pair<Area, std::uint32_t>, std::set<std::uint32_t>> writersOf_;  ///< by bit: ids of instructions
};

void askLog006(Asking& asking) {
  LatchQuestions questions(asking);
  for (const Instruction* output : asking.executed()) questions.ask(*output);
}

/// A latch of which no run was seen that has it on at the end of a scan, and one whose rung always has power.
constexpr Explanation log006Explained[] = {{"LOG006", Where::NotShown, ComesOn, DropsOut},
                                           {"LOG001", Where::SamePlace, canBeWithoutPower, DropsOut}};

}  // namespace

extern constexpr Rule log006_latch_cannot_drop_out = {
    .id = "LOG006",
    .title = "Latch cannot drop out",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "a coil that holds itself, or a bit with S and R, that no reachable state switches off again; one that none "
        "switches on is LOG001",
    .why = "the motor cannot be stopped from the program",
    .bad = "Network 1\nLD I0.0\nO Q0.0\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n",
    .falsePositives = "a fault memory that is meant to last until the next start",
    .dialects = dialect::S7200,
    .ask = {.in = asked::Lint, .turn = 61, .cost = 3, .wantsYes = true, .program = askLog006},
    .tell = {.advice = "put the contact that ends it in series behind the holding contact, or mend the reset"},
    .explainedBy = log006Explained,
};

}  // namespace rungproof
