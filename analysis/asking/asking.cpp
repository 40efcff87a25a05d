// Rules ask one after the other; hazards and boxes are gone through once, for all the rules that ask about them.
#include "analysis/asking/asking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/flow/facts.hpp"
#include "ir/check.hpp"
#include "ir/hazard.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

Operands RuleQuestion::operands() const {
  Operands result;
  for (const Instruction* instruction : {place, other}) {
    if (instruction == nullptr) continue;
    for (const Operand& operand : instruction->operands) {
      if (operand.kind == OperandKind::Direct) result.push_back(operand);
    }
  }
  return result;
}

void Asking::gatherRuns() {
  if (hasRuns_) return;
  hasRuns_ = true;
  for (const Visit& visit : record_.visits()) {
    const auto [place, isNew] = runs_.try_emplace(visit.instruction, Runs{graph().constant(false)});
    if (isNew) executed_.push_back(visit.instruction);
    Runs& runs = place->second;
    runs.guard = graph().lor(runs.guard, {visit.guard});
    for (std::size_t k = 0; k < visit.flow.size(); ++k) {
      if (visit.flow[k] == noNode) continue;
      const Graph::Bool flows = graph().land({visit.guard}, {visit.flow[k]});
      const Graph::Bool rests = graph().land({visit.guard}, graph().lnot({visit.flow[k]}));
      runs.off[k] = runs.samples(k) ? graph().lor(runs.off[k], rests) : rests;
      runs.on[k] = runs.samples(k) ? graph().lor(runs.on[k], flows) : flows;
    }
  }
}

const Asking::Runs* Asking::runsOf(const Instruction& instruction) {
  gatherRuns();
  const auto found = runs_.find(&instruction);
  return found == runs_.end() ? nullptr : &found->second;
}

const std::vector<const Instruction*>& Asking::executed() {
  gatherRuns();
  return executed_;
}

const Asking::Position& Asking::positionOf(const Instruction& instruction) {
  if (positions_.empty()) {
    for (const Pou& pou : program_.pous) {
      for (const Network& network : pou.networks) {
        for (std::size_t i = 0; i < network.instructions.size(); ++i)
          positions_[&network.instructions[i]] = {&network, i};
      }
    }
  }
  return positions_.at(&instruction);
}

const Network& Asking::networkOf(const Instruction& instruction) { return *positionOf(instruction).network; }

std::vector<const Instruction*> Asking::rungOf(const Instruction& instruction) {
  const Position& position = positionOf(instruction);
  // Outputs behind each other have one rung.
  bool isSame = lastRung_.network == position.network && lastRung_.index < position.index;
  for (std::size_t i = lastRung_.index; isSame && i < position.index; ++i)
    isSame = !isLogic(roleOf(position.network->instructions[i]));
  lastRung_.network = position.network;
  lastRung_.index = position.index;
  if (!isSame) lastRung_.contacts = rungproof::rungOf(*position.network, position.index);
  return lastRung_.contacts;
}

void Asking::ask(RuleQuestion question) {
  CHECK(rule_ != nullptr, "a question needs a rule that asks");
  question.rule = rule_;
  questions_.push_back(std::move(question));
}

bool isOfSpecialMemory(const Instruction& contact) {
  return std::all_of(contact.operands.begin(), contact.operands.end(), [](const Operand& o) {
    return o.kind == OperandKind::Constant || (o.kind == OperandKind::Direct && o.area == Area::SM);
  });
}

bool isContactOf(const Instruction& contact, const Operand& bit, bool negated) {
  if (contact.operands.size() != 1 || contact.desc->execution != Execution::Stack ||
      toString(contact.operands[0]) != toString(bit))
    return false;
  return invertsImage(*contact.desc) == negated;
}

bool isBoxOf(const Instruction& instruction, Type type) {
  return !instruction.operands.empty() && instruction.desc->operandCount > 0 &&
         instruction.desc->operands[0].type == type;
}

bool isExecuted(Asking& asking, const Flow& flow) {
  return std::ranges::any_of(flow.steps,
                             [&](const FlowStep& step) { return asking.runsOf(*step.instruction) != nullptr; });
}

namespace {

/// A question that the program gives no occasion for, which is an answer.
void askNothing(Asking& asking, const Rule& rule) {
  asking.begin(rule);
  asking.ask({.name = std::string(rule.ask.whenNone), .bad = asking.graph().constant(false).node});
}

/// One question for each instruction and each kind of hazard it may meet, in the order of the encoding.
void askHazards(Asking& asking, const std::vector<const Rule*>& rules) {
  const auto ruleOf = [&](Hazard hazard) -> const Rule* {
    for (const Rule* rule : rules) {
      if (std::ranges::find(rule->ask.hazards, hazard) != rule->ask.hazards.end()) return rule;
    }
    return nullptr;
  };
  std::map<std::pair<const Instruction*, Hazard>, Node> byPlace;
  std::vector<std::pair<const Instruction*, Hazard>> order;
  std::set<const Rule*> met;
  for (const HazardRecord& record : asking.encoding().hazards()) {
    const Rule* rule = ruleOf(record.hazard);
    if (rule == nullptr || record.place == nullptr) continue;
    met.insert(rule);
    const std::pair key{record.place, record.hazard};
    const auto [found, isNew] = byPlace.try_emplace(key, record.condition);
    if (isNew)
      order.push_back(key);
    else
      found->second = asking.graph().lor({found->second}, {record.condition}).node;
  }
  for (const Rule* rule : rules) {
    if (!rule->ask.whenNone.empty() && !rule->ask.hazards.empty() && !met.contains(rule)) askNothing(asking, *rule);
  }
  for (const auto& key : order) {
    asking.begin(*ruleOf(key.second));
    const HazardInfo& info = hazardInfo(key.second);
    const std::string text = Facts::text(asking.program(), *key.first);
    // Named after what is good, because "PROVED" stands in front of it.
    asking.ask({.name = fmt::format("{}: never '{}'", text, info.text),
                .message = fmt::format("{}: {}", text, info.text),
                .place = key.first,
                .bad = byPlace[key]});
  }
}

/// Whether a statement of an S7-300/400 only ends what another one starts.
bool onlyEnds(StatementRole role) {
  return role == StatementRole::ResetTimer || role == StatementRole::FreeTimer || role == StatementRole::ResetCounter ||
         role == StatementRole::FreeCounter;
}

/// Each timer and counter at its first box, of an S7-300/400 at the first statement that starts or counts it.
void askBoxes(Asking& asking, const std::vector<const Rule*>& rules) {
  std::set<std::pair<Area, std::uint32_t>> seen;
  for (const Flow& flow : asking.encoding().plan().flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& box = *step.instruction;
      if (!isBoxOf(box, Type::Timer) && !isBoxOf(box, Type::Counter)) continue;
      if (box.operands[0].kind != OperandKind::Direct || onlyEnds(statementRole(box))) continue;
      if (!seen.emplace(box.operands[0].area, box.operands[0].offset).second) continue;
      for (const Rule* rule : rules) {
        if (rule->ask.box == nullptr) continue;
        asking.begin(*rule);
        rule->ask.box(asking, box);
      }
    }
  }
}

}  // namespace

std::vector<RuleQuestion> ruleQuestions(const Program& program, const PropertySet& set, const CheckGroups& groups,
                                        AskedProperties& askedProperties, const ExecutionRecord& record) {
  std::vector<const Rule*> rules;
  for (const Rule* rule : groups.rules) {
    if (groups.has(*rule) && knows(*rule, program.target)) rules.push_back(rule);
  }
  std::ranges::stable_sort(rules, {}, [](const Rule* rule) { return rule->ask.turn; });
  Asking asking(program, set, groups.lint, askedProperties, record);
  bool hasHazards = false, hasBoxes = false;
  for (const Rule* rule : rules) {
    const RuleAsks& ask = rule->ask;
    if (!ask.hazards.empty() && !std::exchange(hasHazards, true)) askHazards(asking, rules);
    if (ask.box != nullptr && !std::exchange(hasBoxes, true)) askBoxes(asking, rules);
    if (ask.program == nullptr) continue;
    const std::size_t before = asking.asked();
    asking.begin(*rule);
    ask.program(asking);
    if (asking.asked() == before && !ask.whenNone.empty()) askNothing(asking, *rule);
  }
  if (groups.further) groups.further(asking);
  return asking.take();
}

}  // namespace rungproof
