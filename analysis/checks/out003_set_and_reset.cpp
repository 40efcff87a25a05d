// OUT003: set and reset true together. Only the prover can say whether both come in one scan; where one reset switches
// off several coils that stand in front of it, that is meant. Tested by tests/prover/builtin_test.cpp and
// tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/call_graph.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isLatchOrCoil(const Instruction& instruction) {
  return isCoil(roleOf(instruction)) || isLatch(roleOf(instruction));
}

/// When instructions run: in an interrupt, which comes anywhere, or in the start-up, which ends before the first scan
/// (002:1367-1375).
class Moments {
 public:
  explicit Moments(Asking& asking) {
    const Plan& plan = asking.encoding().plan();
    const CallGraph calls(asking.program(), plan);
    for (std::uint32_t block = 0; block < plan.flows.size(); ++block) {
      const Flow& flow = plan.flows[block];
      const bool isInterrupt = flow.pou->kind == PouKind::Interrupt, isStartUp = calls.isStartUpOnly(block);
      if (flow.steps.empty() || !(isInterrupt || isStartUp)) continue;
      parts_.push_back({flow.steps.front().id(), flow.steps.back().id(), isInterrupt, isStartUp});
    }
  }
  bool isInInterrupt(const Instruction& instruction) const {
    const Part* part = partOf(instruction);
    return part != nullptr && part->isInterrupt;
  }
  bool isInStartUp(const Instruction& instruction) const {
    const Part* part = partOf(instruction);
    return part != nullptr && part->isStartUp;
  }

 private:
  struct Part {
    std::uint32_t first, last;  ///< Instruction::id
    bool isInterrupt, isStartUp;
  };
  const Part* partOf(const Instruction& instruction) const {
    const auto found = std::ranges::find_if(
        parts_, [&](const Part& part) { return part.first <= instruction.id && instruction.id <= part.last; });
    return found == parts_.end() ? nullptr : &*found;
  }

  std::vector<Part> parts_;
};

bool isRowReset(const Instruction& reset) {
  if (!isReset(roleOf(reset)) || reset.operands.size() < 2) return false;
  return reset.operands[1].kind != OperandKind::Constant || reset.operands[1].value > 1;
}

/// A reset of several bits behind their coils switches them off in general; OUT005 recommends it.
bool isSwitchOff(const Moments& moments, const BitWrite& a, const BitWrite& b) {
  const Instruction& reset = *b.instruction;
  return isCoil(roleOf(*a.instruction)) && isRowReset(reset) && !moments.isInInterrupt(*a.instruction) &&
         !moments.isInInterrupt(reset);
}

/// Whether a reset runs last: what it switches off stays off, whatever sets it. An interrupt comes anywhere.
bool isResetLast(const Moments& moments, const Instruction& first, const Instruction& last) {
  return isReset(roleOf(last)) && !moments.isInInterrupt(first) && !moments.isInInterrupt(last);
}

/// Whether `//@ reset dominant Q0.0, Motor` names the bit.
bool isStatedResetDominant(std::span<const Operand> stated, const Place& place) {
  return std::ranges::any_of(stated, [&](const Operand& bit) {
    return bit.area == place.area && bit.offset == place.byte() && bit.bit == place.bit();
  });
}

using ConflictPairs = std::map<std::pair<const Instruction*, const Instruction*>, Node>;

/// `a` runs before `b`. The same instruction met twice does not count.
void addConflict(Asking& asking, const Moments& moments, const BitWrite& a, const BitWrite& b, ConflictPairs& pairs) {
  if (a.instruction == b.instruction || (!isLatch(roleOf(*a.instruction)) && !isLatch(roleOf(*b.instruction)))) return;
  if (isSwitchOff(moments, a, b) || moments.isInStartUp(*a.instruction) != moments.isInStartUp(*b.instruction)) return;
  Graph& graph = asking.graph();
  const Graph::Bool both = graph.land(graph.land({a.guard}, {b.guard}), graph.lxor({a.value}, {b.value}));
  if (const auto known = graph.truth(both); known && !*known) return;
  Node& bad = pairs.try_emplace({a.instruction, b.instruction}, graph.constant(false).node).first->second;
  bad = graph.lor({bad}, both).node;
}

/// What comes together at one bit, by the two instructions.
using ConflictQuestions = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<RuleQuestion>>;

/// Bits under one condition are one question. `first` is nullptr where it is one of several.
void addQuestion(ConflictQuestions& conflicts, const Instruction* first, const Instruction* last, Node bad,
                 bool resetWins, const Place& place) {
  constexpr std::uint32_t several = std::numeric_limits<std::uint32_t>::max();
  std::vector<RuleQuestion>& ofPair = conflicts[{first != nullptr ? first->id : several, last->id}];
  auto same = std::ranges::find(ofPair, bad, &RuleQuestion::bad);
  if (same == ofPair.end()) {
    ofPair.push_back({.place = last, .bad = bad, .other = first, .row = {place.area}});
    ofPair.back().isUsual = resetWins;
    same = std::prev(ofPair.end());
  }
  same->row.bits.push_back(bitPosition(place.area, place.byte(), place.bit()));
}

/// Longer lists of writers are asked about once for each writer: against all in front of it together.
constexpr std::size_t mostPaired = 12;

/// Instructions that write to one bit in front of another one and are judged alike.
struct EarlierWrites {
  bool isCoil = false, isInterrupt = false, isStartUp = false;
  std::array<Node, 2> wrote{};             ///< whether one has written 0, 1
  std::array<const Instruction*, 2> by{};  ///< the first that may have
  std::array<std::size_t, 2> writers{};    ///< how many may have
};

/// A list in which no latch writes a value that is not constant: then no instruction conflicts with itself.
bool isOfConstants(const Graph& graph, std::span<const BitWrite* const> list) {
  return std::ranges::all_of(list, [&](const BitWrite* write) {
    return !isLatch(roleOf(*write->instruction)) || graph.truth({write->value}).has_value();
  });
}

/// As addConflict for each pair of the list, in as many questions as it has writers.
void addJoined(Asking& asking, const Moments& moments, std::span<const BitWrite* const> list, bool isStated,
               ConflictQuestions& conflicts) {
  Graph& graph = asking.graph();
  std::vector<EarlierWrites> earlier;
  const auto alike = [&](bool isCoil, bool isInterrupt, bool isStartUp) -> EarlierWrites& {
    for (EarlierWrites& one : earlier) {
      if (one.isCoil == isCoil && one.isInterrupt == isInterrupt && one.isStartUp == isStartUp) return one;
    }
    const Node none = graph.constant(false).node;
    return earlier.emplace_back(EarlierWrites{isCoil, isInterrupt, isStartUp, {none, none}, {}});
  };
  for (const BitWrite* write : list) {
    const Instruction& last = *write->instruction;
    const bool isCoil = !isLatch(roleOf(last)), isInterrupt = moments.isInInterrupt(last),
               isStartUp = moments.isInStartUp(last);
    const std::array<Graph::Bool, 2> writes = {graph.land({write->guard}, graph.lnot({write->value})),
                                               graph.land({write->guard}, {write->value})};
    for (const bool resetWins : {false, true}) {
      Graph::Bool bad = graph.constant(false);
      const Instruction* first = nullptr;
      std::size_t writers = 0;
      for (const EarlierWrites& one : earlier) {
        const bool isSwitchOff = isRowReset(last) && one.isCoil && !one.isInterrupt && !isInterrupt;
        const bool isLast = isReset(roleOf(last)) && !one.isInterrupt && !isInterrupt;
        if ((isCoil && one.isCoil) || one.isStartUp != isStartUp || isSwitchOff || isLast != resetWins) continue;
        for (const std::size_t value : {0U, 1U}) {
          const Graph::Bool both = graph.land(writes[1 - value], {one.wrote[value]});
          if (one.by[value] == nullptr || graph.truth(both) == false) continue;
          bad = graph.lor(bad, both);
          first = one.by[value];
          writers += one.writers[value];
        }
      }
      if (writers > 0 && graph.truth(bad) != false && !(resetWins && isStated))
        addQuestion(conflicts, writers == 1 ? first : nullptr, &last, bad.node, resetWins, write->place);
    }
    EarlierWrites& own = alike(isCoil, isInterrupt, isStartUp);
    for (const std::size_t value : {0U, 1U}) {
      if (graph.truth(writes[value]) == false) continue;
      own.wrote[value] = graph.lor({own.wrote[value]}, writes[value]).node;
      if (own.writers[value]++ == 0) own.by[value] = &last;
    }
  }
}

std::string conflictMessage(const BitRow& row, std::string_view last) {
  return fmt::format("{} {} set and reset in one scan; {} last{} wins", row.text(), row.bits.size() == 1 ? "is" : "are",
                     last.empty() ? std::string("what comes") : fmt::format("{} comes", last),
                     last.empty() ? "" : " and");
}

/// Two instructions that write different constants to one bit in one scan, or a latch against a coil that writes the
/// opposite (001:2821).
void askOut003(Asking& asking) {
  std::map<Place, std::vector<const BitWrite*>> writes;
  for (const BitWrite& write : asking.encoding().bitWrites()) {
    if (write.instruction != nullptr && isLatchOrCoil(*write.instruction)) writes[write.place].push_back(&write);
  }
  const Moments moments(asking);
  ConflictQuestions conflicts;
  for (const auto& [place, list] : writes) {
    const auto isByLatch = [](const BitWrite* write) { return isLatch(roleOf(*write->instruction)); };
    if (std::ranges::none_of(list, isByLatch)) continue;  // thousands of coils on one bit are as many pairs squared
    const bool isStated = isStatedResetDominant(asking.properties().resetDominant, place);
    if (list.size() > mostPaired && isOfConstants(asking.graph(), list)) {
      addJoined(asking, moments, list, isStated, conflicts);
      continue;
    }
    ConflictPairs pairs;
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t k = i + 1; k < list.size(); ++k) addConflict(asking, moments, *list[i], *list[k], pairs);
    }
    for (const auto& [pair, bad] : pairs) {
      const bool resetWins = isResetLast(moments, *pair.first, *pair.second);
      if (!(resetWins && isStated)) addQuestion(conflicts, pair.first, pair.second, bad, resetWins, place);
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
