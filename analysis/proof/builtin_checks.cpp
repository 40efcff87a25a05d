// Gathers the built-in questions from what the encoder recorded.
#include "analysis/proof/builtin_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/facts.hpp"
#include "ir/isa.hpp"
#include "ir/reading.hpp"

namespace rungproof {

namespace {

class Gatherer {
 public:
  /// `settles`: candidates of the flow analysis wait for the answers, so that what is plain is asked as well.
  Gatherer(Obligations& obligations, const ExecutionRecord& record, bool settles, std::vector<BuiltinCheck>& checks)
      : settles_(settles),
        encoding_(obligations.encoding()),
        record_(record),
        graph_(encoding_.graph()),
        checks_(checks) {}

  void run() {
    setResetConflicts();
    stackLevels();
    hazards();
    timers();
    presets();
  }

 private:
  /// Two instructions that write different constants to one bit in one scan, or a latch against a coil that writes the
  /// opposite (001:2821). The same instruction met twice does not count.
  void setResetConflicts() {
    std::map<Place, std::vector<const BitWrite*>> writes;
    for (const BitWrite& write : encoding_.bitWrites()) {
      if (write.instruction != nullptr && isLatchOrCoil(*write.instruction)) writes[write.place].push_back(&write);
    }
    // By the two instructions: bits under one condition are one question.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<BuiltinCheck>> conflicts;
    for (const auto& [place, list] : writes) {
      ConflictPairs pairs;
      for (std::size_t i = 0; i < list.size(); ++i) {
        for (std::size_t k = i + 1; k < list.size(); ++k) addConflict(*list[i], *list[k], pairs);
      }
      const std::uint32_t bit = bitPosition(place.area, place.byte(), place.bit());
      for (const auto& [pair, bad] : pairs) {
        std::vector<BuiltinCheck>& ofPair = conflicts[{pair.first->id, pair.second->id}];
        auto same = std::ranges::find(ofPair, bad, &BuiltinCheck::bad);
        if (same == ofPair.end()) {
          ofPair.push_back({BuiltinKind::SetReset, {}, "OUT003", {}, {}, pair.second, pair.first, bad, {place.area}});
          same = std::prev(ofPair.end());
        }
        same->row.bits.push_back(bit);
      }
    }
    for (auto& [pair, ofPair] : conflicts) {
      for (BuiltinCheck& check : ofPair) {
        check.row.order();
        check.name = "set/reset conflict on " + check.row.text();
        check.message = conflictMessage(check.row, check.place->desc->stl);
        check.address = check.row.first();
        checks_.push_back(std::move(check));
      }
    }
  }
  static bool isLatchOrCoil(const Instruction& instruction) {
    return isCoil(roleOf(instruction)) || isLatch(roleOf(instruction));
  }
  using ConflictPairs = std::map<std::pair<const Instruction*, const Instruction*>, Node>;
  /// `a` runs before `b`.
  void addConflict(const BitWrite& a, const BitWrite& b, ConflictPairs& pairs) {
    if (a.instruction == b.instruction || (!isLatch(roleOf(*a.instruction)) && !isLatch(roleOf(*b.instruction))))
      return;
    if (isSwitchOff(a, b)) return;
    const Graph::Bool both = graph_.land(graph_.land({a.guard}, {b.guard}), graph_.lxor({a.value}, {b.value}));
    if (const auto known = graph_.truth(both); known && !*known) return;
    Node& bad = pairs.try_emplace({a.instruction, b.instruction}, graph_.constant(false).node).first->second;
    bad = graph_.lor({bad}, both).node;
  }

  /// A reset of several bits behind their coils switches them off in general; OUT005 recommends it.
  bool isSwitchOff(const BitWrite& a, const BitWrite& b) const {
    const Instruction& reset = *b.instruction;
    if (!isCoil(roleOf(*a.instruction)) || !isReset(roleOf(reset)) || reset.operands.size() < 2) return false;
    const bool isRow = reset.operands[1].kind != OperandKind::Constant || reset.operands[1].value > 1;
    return isRow && !isInInterrupt(*a.instruction) && !isInInterrupt(reset);
  }
  bool isInInterrupt(const Instruction& instruction) const {
    return std::ranges::any_of(encoding_.plan().flows, [&](const Flow& flow) {
      return flow.pou->kind == PouKind::Interrupt && !flow.steps.empty() && flow.steps.front().id <= instruction.id &&
             instruction.id <= flow.steps.back().id;
    });
  }

  /// Levels that a push has lost (001:2759) and that are used nevertheless, on the paths that the scan can take. Where
  /// no path uses one there is one question for the whole program, which is then proved.
  void stackLevels() {
    std::map<std::pair<const Instruction*, const Instruction*>, Node> lost;
    for (const LostLevel& level : record_.lostLevels()) {
      Node& bad = lost.try_emplace({level.use, level.push}, graph_.constant(false).node).first->second;
      bad = graph_.lor({bad}, {level.condition}).node;
    }
    if (lost.empty())
      checks_.push_back({BuiltinKind::StackLevels, "the logic stack loses no level that is used", "STK001", "", "",
                         nullptr, nullptr, graph_.constant(false).node});
    for (const auto& [places, bad] : lost) {
      const auto [use, push] = places;
      checks_.push_back(
          {BuiltinKind::StackLevels, fmt::format("logic stack at {}", Facts::text(*use)), "STK001",
           fmt::format("{} takes a level that was pushed out of the nine levels of the logic stack", Facts::text(*use)),
           "", push == nullptr ? use : push, use, bad});
    }
  }

  static std::optional<std::pair<BuiltinKind, const char*>> kindOf(Hazard hazard) {
    switch (hazard) {
      case Hazard::BadIndirectAddress: return {{BuiltinKind::OperandRange, "PTR001"}};
      case Hazard::OutOfRange:
      case Hazard::BadCount: return {{BuiltinKind::OperandRange, "PTR004"}};
      case Hazard::StringIndexZero: return {{BuiltinKind::OperandRange, "PTR005"}};
      case Hazard::NestingTooDeep: return {{BuiltinKind::Nesting, "SUB002"}};
      case Hazard::DivideByZero: return {{BuiltinKind::Division, "ARI001"}};
      case Hazard::Overflow: return {{BuiltinKind::Overflow, "ARI002"}};
      case Hazard::FatalIndirectAddress:
      case Hazard::FatalReal:
      case Hazard::FatalRange: return {{BuiltinKind::Comparison, "ARI003"}};
      case Hazard::LoopBound:
      case Hazard::FatalWatchdog: return {{BuiltinKind::LoopBound, "CTL004"}};
      default: return std::nullopt;
    }
  }
  void hazards() {
    std::map<std::pair<const Instruction*, Hazard>, Node> byPlace;
    std::vector<std::pair<const Instruction*, Hazard>> order;
    for (const HazardRecord& record : encoding_.hazards()) {
      if (!kindOf(record.hazard) || record.place == nullptr) continue;
      const std::pair key{record.place, record.hazard};
      const auto [found, isNew] = byPlace.try_emplace(key, record.condition);
      if (isNew)
        order.push_back(key);
      else
        found->second = graph_.lor({found->second}, {record.condition}).node;
    }
    if (std::none_of(order.begin(), order.end(),
                     [](const auto& key) { return key.second == Hazard::NestingTooDeep; })) {
      checks_.push_back({BuiltinKind::Nesting, "calls nest no deeper than the CPU allows", "SUB002", "", "", nullptr,
                         nullptr, graph_.constant(false).node});
    }
    for (const auto& key : order) {
      const auto [kind, rule] = *kindOf(key.second);
      const HazardInfo& info = hazardInfo(key.second);
      checks_.push_back({kind, fmt::format("{} at {}", info.text, Facts::text(*key.first)), rule,
                         fmt::format("{}: {}", Facts::text(*key.first), info.text), "", key.first, nullptr,
                         byPlace[key]});
    }
  }

  void timers() {
    std::set<std::pair<Area, std::uint32_t>> seen;
    for (const Flow& flow : encoding_.plan().flows) {
      for (const FlowStep& step : flow.steps) {
        const Instruction& box = *step.instruction;
        if (box.operands.empty() || box.desc->operandCount == 0) continue;
        const Type type = box.desc->operands[0].type;
        if (type != Type::Timer && type != Type::Counter) continue;
        if (!seen.emplace(box.operands[0].area, box.operands[0].offset).second) continue;
        reachability(box, type == Type::Timer);
      }
    }
  }
  void reachability(const Instruction& box, bool isTimer) {
    const Operand& o = box.operands[0];
    const Place bit = registerPlace(isTimer ? Reg::TimerBit : Reg::CounterBit, o.offset);
    const Node now = encoding_.atEnd(bit);
    // A bit that is reset in the scan in which it comes on is on for the instructions between.
    const Node seen = record_.seenOn(o.area, o.offset);
    const Graph::Bool within{seen == noNode ? graph_.constant(false).node : seen};
    const Node on = graph_.lor({now}, within).node;
    const Graph::Bool before = graph_.lor({encoding_.atStart(bit)}, within);
    const std::string name = toString(o);
    checks_.push_back({BuiltinKind::TimerReachable, fmt::format("{} can come on", name), "TIM008",
                       fmt::format("the bit of {} can never be 1", name), name, &box, nullptr, on});
    const Node falls = graph_.land(before, graph_.lnot({now})).node;
    checks_.push_back({BuiltinKind::TimerResettable, fmt::format("{} can be reset", name), "TIM008",
                       fmt::format("once on, the bit of {} never returns to 0", name), name, &box, nullptr, falls});
    if (isTimer && timerResolution(static_cast<int>(o.offset)) == 100) oncePerScan(o, box);
  }
  /// 001:6611: boxes of a 100 ms timer run exactly once in every scan; more than one, or none, makes it run wrongly. A
  /// box in an inactive segment runs without power flow, as the manual's own sequences take it (001:6575), unless the
  /// other reading was chosen.
  void oncePerScan(const Operand& timer, const Instruction& box) {
    Graph::Bool some = graph_.constant(false), twice = some;
    for (const Visit& visit : record_.visits()) {
      if (!isBoxOf(*visit.instruction, Type::Timer) || visit.instruction->operands[0].offset != timer.offset) continue;
      twice = graph_.lor(twice, graph_.land(some, {visit.guard}));
      some = graph_.lor(some, {visit.guard});
    }
    if (some.node == graph_.constant(false).node) return;  // in a block that nothing calls
    // Of a scan that a fatal error has cut off nothing is asked.
    const Graph::Bool isWhole = graph_.land(graph_.lnot({encoding_.faulted()}), graph_.lnot(skipsInactiveSegments()));
    const Node bad = graph_.lor(graph_.land(isWhole, graph_.lnot(some)), twice).node;
    if (const auto known = graph_.truth({bad}); known && !*known && !settles_) return;
    checks_.push_back({BuiltinKind::TimerOncePerScan, fmt::format("{} runs once a scan", toString(timer)), "TIM004",
                       fmt::format("{} has a resolution of 100 ms, but its box does not run exactly once in every scan",
                                   toString(timer)),
                       toString(timer), &box, nullptr, bad});
  }

  /// That inactive segments are not executed at all, where both readings are open.
  Graph::Bool skipsInactiveSegments() {
    const Place reading = registerPlace(Reg::Reading, readingIndex(Choice::InactiveScr, 1));
    const auto cell = std::ranges::find(encoding_.cells(), reading, &Cell::place);
    if (cell == encoding_.cells().end() || cell->kind != CellKind::State) return graph_.constant(false);
    return {cell->start};
  }

  static bool isBoxOf(const Instruction& instruction, Type type) {
    return !instruction.operands.empty() && instruction.desc->operandCount > 0 &&
           instruction.desc->operands[0].type == type;
  }
  /// 001:6569, 001:4015: presets are signed words. At 0 and below a timer fires, and a counter is on, at once.
  void presets() {
    std::map<const Instruction*, Node> outside;
    std::vector<const Instruction*> order;
    for (const Visit& visit : record_.visits()) {
      if (visit.preset == noNode) continue;
      Graph::Bool bad = graph_.land({visit.guard}, graph_.slt({visit.preset}, graph_.literal(1, 16), 16));
      if (isBoxOf(*visit.instruction, Type::Timer)) bad = graph_.land(bad, {visit.flow[0]});
      const auto [place, isNew] = outside.try_emplace(visit.instruction, bad.node);
      if (isNew)
        order.push_back(visit.instruction);
      else
        place->second = graph_.lor({place->second}, bad).node;
    }
    for (const Instruction* box : order) {
      const std::string preset = toString(box->operands[1]);
      checks_.push_back({BuiltinKind::Preset, fmt::format("preset of {}", Facts::text(*box)), "TIM007",
                         fmt::format("{} can be 0 or negative when {} runs", preset, Facts::text(*box)),
                         toString(box->operands[0]), box, nullptr, outside[box]});
    }
  }

  const bool settles_;
  EncodedScan& encoding_;
  const ExecutionRecord& record_;
  Graph& graph_;
  std::vector<BuiltinCheck>& checks_;
};

}  // namespace

std::string conflictMessage(const BitRow& row, std::string_view last) {
  return fmt::format("{} {} set and reset in one scan; {} last{} wins", row.text(), row.bits.size() == 1 ? "is" : "are",
                     last.empty() ? std::string("what comes") : fmt::format("{} comes", last),
                     last.empty() ? "" : " and");
}

std::string powerUpMessage(const BitRow& row) {
  return fmt::format("{} can be on at the end of the first scan because of what retentive memory holds", row.text());
}

std::vector<BuiltinCheck> builtinChecks(const Program& program, const PropertySet& set, const CheckGroups& groups,
                                        Obligations& obligations, const ExecutionRecord& record) {
  std::vector<BuiltinCheck> checks;
  if (groups.builtin) Gatherer(obligations, record, groups.rungs, checks).run();
  if (groups.rungs) {
    addRungChecks(program, obligations, record, checks);
    addSequenceChecks(program, obligations, record, checks);
    addRestartChecks(set, obligations, checks);
  }
  if (groups.powerUp) addPowerUpChecks(program, obligations, checks);
  return checks;
}

std::vector<Operand> BuiltinCheck::operands() const {
  std::vector<Operand> result;
  for (const Instruction* instruction : {place, other}) {
    if (instruction == nullptr) continue;
    for (const Operand& operand : instruction->operands) {
      if (operand.kind == OperandKind::Direct) result.push_back(operand);
    }
  }
  return result;
}

}  // namespace rungproof
