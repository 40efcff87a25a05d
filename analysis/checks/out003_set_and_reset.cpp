// OUT003: set and reset true together. Only the prover can say whether both come in one scan; where one reset switches
// off several coils that stand in front of it, that is meant. Tested by tests/prover/builtin_test.cpp and
// tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>

#include "analysis/asking/asking.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isLatchOrCoil(const Instruction& instruction) {
  return isCoil(roleOf(instruction)) || isLatch(roleOf(instruction));
}

bool isInInterrupt(const EncodedScan& encoding, const Instruction& instruction) {
  return std::ranges::any_of(encoding.plan().flows, [&](const Flow& flow) {
    return flow.pou->kind == PouKind::Interrupt && !flow.steps.empty() && flow.steps.front().id() <= instruction.id &&
           instruction.id <= flow.steps.back().id();
  });
}

/// A reset of several bits behind their coils switches them off in general; OUT005 recommends it.
bool isSwitchOff(const EncodedScan& encoding, const BitWrite& a, const BitWrite& b) {
  const Instruction& reset = *b.instruction;
  if (!isCoil(roleOf(*a.instruction)) || !isReset(roleOf(reset)) || reset.operands.size() < 2) return false;
  const bool isRow = reset.operands[1].kind != OperandKind::Constant || reset.operands[1].value > 1;
  return isRow && !isInInterrupt(encoding, *a.instruction) && !isInInterrupt(encoding, reset);
}

/// Whether a reset runs last: what it switches off stays off, whatever sets it. An interrupt comes anywhere.
bool isResetLast(const EncodedScan& encoding, const Instruction& first, const Instruction& last) {
  return isReset(roleOf(last)) && !isInInterrupt(encoding, first) && !isInInterrupt(encoding, last);
}

/// Whether `//@ reset dominant Q0.0, Motor` names the bit.
bool isStatedResetDominant(std::span<const Operand> stated, const Place& place) {
  return std::ranges::any_of(stated, [&](const Operand& bit) {
    return bit.area == place.area && bit.offset == place.byte() && bit.bit == place.bit();
  });
}

using ConflictPairs = std::map<std::pair<const Instruction*, const Instruction*>, Node>;

/// `a` runs before `b`. The same instruction met twice does not count.
void addConflict(Asking& asking, const BitWrite& a, const BitWrite& b, ConflictPairs& pairs) {
  if (a.instruction == b.instruction || (!isLatch(roleOf(*a.instruction)) && !isLatch(roleOf(*b.instruction)))) return;
  if (isSwitchOff(asking.encoding(), a, b)) return;
  Graph& graph = asking.graph();
  const Graph::Bool both = graph.land(graph.land({a.guard}, {b.guard}), graph.lxor({a.value}, {b.value}));
  if (const auto known = graph.truth(both); known && !*known) return;
  Node& bad = pairs.try_emplace({a.instruction, b.instruction}, graph.constant(false).node).first->second;
  bad = graph.lor({bad}, both).node;
}

std::string conflictMessage(const BitRow& row, std::string_view last) {
  return fmt::format("{} {} set and reset in one scan; {} last{} wins", row.text(), row.bits.size() == 1 ? "is" : "are",
                     last.empty() ? std::string("what comes") : fmt::format("{} comes", last),
                     last.empty() ? "" : " and");
}

/// Two instructions that write different constants to one bit in one scan, or a latch against a coil that writes the
/// opposite (001:2821). Bits under one condition are one question.
void askOut003(Asking& asking) {
  std::map<Place, std::vector<const BitWrite*>> writes;
  for (const BitWrite& write : asking.encoding().bitWrites()) {
    if (write.instruction != nullptr && isLatchOrCoil(*write.instruction)) writes[write.place].push_back(&write);
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<RuleQuestion>> conflicts;  // by the two instructions
  for (const auto& [place, list] : writes) {
    const auto isByLatch = [](const BitWrite* write) { return isLatch(roleOf(*write->instruction)); };
    if (std::ranges::none_of(list, isByLatch)) continue;  // thousands of coils on one bit are as many pairs squared
    ConflictPairs pairs;
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t k = i + 1; k < list.size(); ++k) addConflict(asking, *list[i], *list[k], pairs);
    }
    const std::uint32_t bit = bitPosition(place.area, place.byte(), place.bit());
    const bool isStated = isStatedResetDominant(asking.properties().resetDominant, place);
    for (const auto& [pair, bad] : pairs) {
      const bool resetWins = isResetLast(asking.encoding(), *pair.first, *pair.second);
      if (resetWins && isStated) continue;
      std::vector<RuleQuestion>& ofPair = conflicts[{pair.first->id, pair.second->id}];
      auto same = std::ranges::find(ofPair, bad, &RuleQuestion::bad);
      if (same == ofPair.end()) {
        ofPair.push_back({.place = pair.second, .bad = bad, .other = pair.first, .row = {place.area}});
        ofPair.back().isUsual = resetWins;
        same = std::prev(ofPair.end());
      }
      same->row.bits.push_back(bit);
    }
  }
  for (auto& [pair, ofPair] : conflicts) {
    for (RuleQuestion& question : ofPair) {
      question.row.order();
      question.name = "no set/reset conflict on " + question.row.text();
      question.message = conflictMessage(question.row, question.place->desc->stl);
      question.address = question.row.first();
      asking.ask(std::move(question));
    }
  }
}

}  // namespace

extern constexpr Rule out003_set_and_reset = {
    .id = "OUT003",
    .title = "Set and reset true together",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "S and R, S or R against =, or both inputs of SR or RS, that act on one bit in one scan with opposite values; "
        "a note where a reset comes last, nothing where //@ reset dominant states that it is meant",
    .why = "the order of the networks decides which one wins, and for SR and RS the type of the box does",
    .manual = "001:2821, 001:2897",
    .bad = "Network 1\nLD I0.1\nR Q0.0, 1\nNetwork 2\nLD I0.0\nS Q0.0, 1\n",
    .good = "Network 1\nLD I0.0\nAN I0.1\nS Q0.0, 1\nNetwork 2\nLD I0.1\nR Q0.0, 1\n",
    .falsePositives = "a set that is written last on purpose",
    .ask = {.in = asked::Builtin, .turn = 10, .cost = 2, .program = askOut003},
    .tell = {.advice = "if the reset is meant to win, say so with //@ reset dominant ADDRESS", .bits = conflictMessage},
};

}  // namespace rungproof
