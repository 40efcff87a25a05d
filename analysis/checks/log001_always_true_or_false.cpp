// LOG001: always true or always false. A rung with one power flow in every reachable state. Only the prover can say.
// Tested by tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Coils and latches whose RLO the block itself has fixed by SET or CLR are meant so; those of library blocks are not
/// the program's.
std::set<const Instruction*> fixedOutputs(const Plan& plan) {
  std::set<const Instruction*> fixed;
  for (const Flow& flow : plan.flows) {
    if (isLibraryText(*plan.program, *flow.pou)) {
      for (const FlowStep& step : flow.steps) fixed.insert(step.instruction);
      continue;
    }
    const LogicStates states = logicStates(flow);
    for (std::size_t at = 0; at < flow.steps.size(); ++at) {
      if (!states[at] || states[at]->rlo != mayBeAny) fixed.insert(flow.steps[at].instruction);
    }
  }
  return fixed;
}

/// S7-300/400: the RLO of each coil, and whether that of a latch is ever 1.
void askCoils(Asking& asking) {
  Graph& graph = asking.graph();
  const std::set<const Instruction*> fixed = fixedOutputs(asking.encoding().plan());
  struct Rlo {
    Graph::Bool on, off;
  };
  std::map<std::uint32_t, std::pair<const Instruction*, Rlo>> outputs;  // by Instruction::id
  for (const BitWrite& write : asking.encoding().bitWrites()) {
    const Instruction* output = write.instruction;
    if (output == nullptr || write.place.area == Area::L || fixed.contains(output)) continue;
    const bool isOutput = isCoil(roleOf(*output)) || isSet(roleOf(*output)) || isReset(roleOf(*output));
    if (!isOutput) continue;
    const Graph::Bool never = graph.constant(false), runs{write.guard}, value{write.value};
    Rlo& rlo = outputs.try_emplace(output->id, output, Rlo{never, never}).first->second.second;
    const bool isCoilWrite = isCoil(roleOf(*output));
    rlo.on = graph.lor(rlo.on, isCoilWrite ? graph.land(runs, value) : runs);
    if (isCoilWrite) rlo.off = graph.lor(rlo.off, graph.land(runs, graph.lnot(value)));
  }
  for (const Instruction* latch : asking.executed()) {  // one whose RLO is plainly 0 has written nothing
    const bool isLatch = isSet(roleOf(*latch)) || isReset(roleOf(*latch));
    if (!isLatch || fixed.contains(latch) || latch->operands[0].kind != OperandKind::Direct ||
        latch->operands[0].area == Area::L)
      continue;
    outputs.try_emplace(latch->id, latch, Rlo{graph.constant(false), graph.constant(false)});
  }
  for (const auto& [id, output] : outputs) {
    const auto& [instruction, rlo] = output;
    const std::string text = Facts::text(*instruction), address = toString(instruction->operands[0]);
    asking.ask({.name = fmt::format("the RLO of {} can be 1", text),
                .message = fmt::format("no reachable state brings RLO 1 to {}", text),
                .address = address,
                .place = instruction,
                .bad = rlo.on.node,
                .aspect = powerReaches});
    if (!isCoil(roleOf(*instruction))) continue;
    asking.ask({.name = fmt::format("the RLO of {} can be 0", text),
                .message = fmt::format("the RLO of {} is 1 in every reachable state", text),
                .address = address,
                .place = instruction,
                .bad = rlo.off.node,
                .aspect = canBeWithoutPower});
  }
}

/// One pair of questions for each condition: outputs behind the same contacts have the same power flow. Each network
/// that has the condition is a place of its own.
void askLog001(Asking& asking) {
  if (asking.encoding().plan().form() == StatementForm::Accumulators) return askCoils(asking);
  struct Condition {
    RuleQuestion reaches, without;
    std::set<const Network*> networks;
  };
  std::map<std::pair<Node, Node>, std::size_t> known;  // by power flow
  std::vector<Condition> conditions;
  for (const Instruction* output : asking.executed()) {
    const Asking::Runs& runs = *asking.runsOf(*output);
    if (!runs.samples(0) || isCounterBox(roleOf(*output))) continue;
    if (std::ranges::all_of(asking.rungOf(*output), [](const Instruction* c) { return isOfSpecialMemory(*c); }))
      continue;
    const auto [asked, isNew] = known.try_emplace({runs.on[0].node, runs.off[0].node}, conditions.size());
    if (isNew) conditions.emplace_back();
    Condition& condition = conditions[asked->second];
    if (!condition.networks.insert(&asking.networkOf(*output)).second) continue;
    const std::string text = Facts::text(*output);
    const std::string address = output->operands.empty() ? "" : toString(output->operands[0]);
    const std::string never = fmt::format("no reachable state lets power flow to {}", text),
                      always = fmt::format("power flows to {} in every reachable state", text);
    if (!isNew) {
      condition.reaches.alike.push_back({never, address, output});
      condition.without.alike.push_back({always, address, output});
      continue;
    }
    condition.reaches = {.name = fmt::format("power can reach {}", text),
                         .message = never,
                         .address = address,
                         .place = output,
                         .bad = runs.on[0].node,
                         .aspect = powerReaches};
    condition.without = {.name = fmt::format("{} can be without power", text),
                         .message = always,
                         .address = address,
                         .place = output,
                         .bad = runs.off[0].node,
                         .aspect = canBeWithoutPower};
  }
  for (Condition& condition : conditions) {
    asking.ask(std::move(condition.reaches));
    asking.ask(std::move(condition.without));
  }
}

/// A rung that never runs.
constexpr Explanation log001Explained[] = {{"LOG001", Where::SamePlace, canBeWithoutPower, powerReaches},
                                           {"LOG001", Where::SamePlace, powerReaches, canBeWithoutPower}};

}  // namespace

extern constexpr Rule log001_always_true_or_false = {
    .id = "LOG001",
    .title = "Always true or always false",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects =
        "an output, box or jump whose rung has power in every reachable state, or in none; rungs of special memory "
        "alone (SM0.0) are excepted; S7-300/400: a coil or latch whose RLO is so, SET and CLR excepted",
    .why =
        "a dead rung, or an interlock that is none; bytes compare unsigned and words signed, which makes some "
        "comparisons constant",
    .manual = "001:3384",
    .bad = "Network 1\nLD I0.0\nLPS\nA I0.1\n= M0.0\nLPP\nAN I0.1\n= M0.1\nNetwork 2\nLD M0.0\nA M0.1\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nLPS\nA I0.1\n= M0.0\nLPP\nAN I0.1\n= M0.1\nNetwork 2\nLD M0.0\nO M0.1\n= Q0.0\n",
    .falsePositives = "a rung that waits for memory which a panel or the network writes: declare it with //@ external",
    .peers = "SA0059; SA0062; Frama-PLC E4.1",
    .ask = {.in = asked::Lint, .turn = 60, .cost = 4, .wantsYes = true, .program = askLog001},
    .tell = {.advice = "a contact is missing, of the wrong kind, or at the wrong address"},
    .explainedBy = log001Explained,
};

}  // namespace rungproof
