// The trees of the map are evaluated over the nodes of the encoding, instruction by instruction as a scan comes to
// them.
#include "analysis/testing/coverage_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "analysis/asking/asking.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr Rule coverageRule = {.id = "TST000",
                               .title = "Goal of coverage",
                               .severity = Severity::Note,
                               .needs = Needs::Solver,
                               .detects = "what no run covers",
                               .why = "tests cannot cover it",
                               .ask = {.in = asked::Lint, .wantsYes = true}};

/// The algebra of nodes.
struct NodeLogic {
  Graph& graph;
  Graph::Bool constant(bool value) const { return graph.constant(value); }
  Graph::Bool lnot(Graph::Bool a) const { return graph.lnot(a); }
  Graph::Bool land(Graph::Bool a, Graph::Bool b) const { return graph.land(a, b); }
  Graph::Bool lor(Graph::Bool a, Graph::Bool b) const { return graph.lor(a, b); }
  Graph::Bool lxor(Graph::Bool a, Graph::Bool b) const { return graph.lxor(a, b); }
};

class GoalEncoder {
 public:
  GoalEncoder(const CoverageMap& map, Asking& asking)
      : map_(map), asking_(asking), graph_(asking.graph()), values_(map.leaves().size(), noNode) {}

  /// What each goal means, as far as the encoding can say it; noNode: it cannot.
  std::vector<Node> encode(const std::vector<CoverageGoal>& goals) {
    std::vector<Node> nodes(goals.size(), noNode);
    std::unordered_map<std::uint32_t, std::vector<std::size_t>> at;  // goals by instruction
    for (std::size_t i = 0; i < goals.size(); ++i) {
      for (const std::uint32_t id : instructionsOf(goals[i])) at[id].push_back(i);
      nodes[i] = graph_.constant(false).node;
    }
    for (const Visit& visit : asking_.record().visits()) {
      const std::uint32_t id = visit.instruction->id;
      if (const int leaf = map_.leafOf(id); leaf >= 0) {
        values_[static_cast<std::size_t>(leaf)] = visit.bit;
      }
      const auto found = at.find(id);
      if (found == at.end()) continue;
      for (const std::size_t goal : found->second) {
        if (nodes[goal] == noNode) continue;
        const std::optional<Graph::Bool> shown = shownBy(goals[goal], visit);
        if (!shown) {
          nodes[goal] = noNode;
          continue;
        }
        nodes[goal] = graph_.lor({nodes[goal]}, graph_.land({visit.guard}, *shown)).node;
      }
    }
    return nodes;
  }

 private:
  std::vector<std::uint32_t> instructionsOf(const CoverageGoal& goal) const {
    switch (goal.measure) {
      case Measure::Contacts: return {map_.leaves()[goal.index].instruction->id};
      case Measure::Transitions: return {map_.transitions()[goal.index].instruction->id};
      case Measure::Mcdc: return {map_.decisions()[goal.index].instruction->id};
      default: break;
    }
    std::vector<std::uint32_t> ids;
    const CoveragePlace place = map_.networks()[goal.index];
    for (const Instruction& i : map_.program().pous[place.pou].networks[place.network].instructions) {
      if (map_.networkOf(i.id) == static_cast<int>(goal.index)) ids.push_back(i.id);
    }
    return ids;
  }

  std::optional<Graph::Bool> power(const Visit& visit, std::size_t level) const {
    if (map_.plan().form() != StatementForm::Rungs)
      return visit.result == noNode ? std::nullopt : std::optional(Graph::Bool{visit.result});
    if (level >= visit.flow.size() || visit.flow[level] == noNode) return std::nullopt;
    return Graph::Bool{visit.flow[level]};
  }

  std::optional<Graph::Bool> shownBy(const CoverageGoal& goal, const Visit& visit) {
    const std::uint32_t id = visit.instruction->id;
    switch (goal.measure) {
      case Measure::Networks: {
        if (map_.isUnconditional(id)) return graph_.constant(true);
        std::optional<Graph::Bool> any;
        const std::size_t levels =
            map_.plan().form() == StatementForm::Rungs ? visit.instruction->desc->stack.needs : 1;
        for (std::size_t level = 0; level < levels; ++level) {
          const std::optional<Graph::Bool> flows = power(visit, level);
          if (!flows) return std::nullopt;
          any = any ? graph_.lor(*any, *flows) : *flows;
        }
        return any;
      }
      case Measure::Contacts: {
        if (visit.bit == noNode) return std::nullopt;
        const Graph::Bool bit{visit.bit};
        return goal.value ? bit : graph_.lnot(bit);
      }
      case Measure::Transitions: {
        const StepTransition& step = map_.transitions()[goal.index];
        std::optional<Graph::Bool> taken =
            map_.isUnconditional(id) ? std::optional(graph_.constant(true)) : power(visit, 0);
        if (!taken || step.kind == TransitionKind::Scrt || step.kind == TransitionKind::Chart) return taken;
        if (visit.target == noNode) return std::nullopt;
        const int width = graph_[visit.target].width;
        const std::uint64_t entered = step.kind == TransitionKind::SetStep ? 1 : step.value & Graph::maskOf(width);
        const Graph::Bool isThere = graph_.equal({visit.target}, graph_.literal(entered, width), width);
        return graph_.land(*taken, graph_.lnot(isThere));
      }
      default: return decides(goal, visit);
    }
  }

  /// The condition or the outcome is that value, and with the other value of the condition the outcome would differ.
  std::optional<Graph::Bool> decides(const CoverageGoal& goal, const Visit& visit) {
    const Decision& decision = map_.decisions()[goal.index];
    for (const std::uint32_t leaf : decision.leaves) {
      if (values_[leaf] == noNode) return std::nullopt;
    }
    NodeLogic logic{graph_};
    const auto with = [&](bool value) {
      return map_.trees().evaluate(decision.condition, logic, [&](std::uint32_t leaf) {
        return leaf == decision.leaves[goal.condition] ? graph_.constant(value) : Graph::Bool{values_[leaf]};
      });
    };
    const Graph::Bool differs = graph_.lxor(with(true), with(false));
    // As for runs, the outcome must be the power flow: in an inactive step nothing decides.
    const std::optional<Graph::Bool> flow = power(visit, decision.level);
    if (!flow) return std::nullopt;
    const Graph::Bool outcome = map_.trees().evaluate(decision.condition, logic,
                                                      [&](std::uint32_t leaf) { return Graph::Bool{values_[leaf]}; });
    const Graph::Bool bit = goal.isOutcome ? outcome : Graph::Bool{values_[decision.leaves[goal.condition]]};
    const Graph::Bool shown = graph_.land(differs, goal.value ? bit : graph_.lnot(bit));
    return graph_.land(shown, graph_.lnot(graph_.lxor(*flow, outcome)));
  }

  const CoverageMap& map_;
  Asking& asking_;
  Graph& graph_;
  std::vector<Node> values_;
};

}  // namespace

Property oneChangeAScan(const Operands& bits) {
  Property property;
  property.name = "one input changes a scan";
  property.text = "assume one input changes a scan";
  property.kind = PropertyKind::Assume;
  std::vector<ExprNode>& nodes = property.first.nodes;
  const auto add = [&](ExprOp op, std::vector<std::uint32_t> args) {
    ExprNode node;
    node.op = op;
    node.args = std::move(args);
    nodes.push_back(std::move(node));
    return static_cast<std::uint32_t>(nodes.size() - 1);
  };
  std::uint32_t some = add(ExprOp::Constant, {}), two = some;
  for (const Operand& bit : bits) {
    const std::uint32_t now = add(ExprOp::Address, {});
    nodes.back().operand = bit;
    const std::uint32_t moved = add(ExprOp::Xor, {now, add(ExprOp::Prev, {now})});
    const std::uint32_t changes = add(ExprOp::Or, {moved, add(ExprOp::And, {add(ExprOp::FirstScan, {}), now})});
    two = add(ExprOp::Or, {two, add(ExprOp::And, {some, changes})});
    some = add(ExprOp::Or, {some, changes});
  }
  add(ExprOp::Not, {two});
  property.first.text = "one input changes a scan";
  layoutCells(property);
  return property;
}

std::map<CoverageGoal, GoalAnswer> askGoals(const CoverageMap& map, const PropertySet& set,
                                            const std::vector<CoverageGoal>& goals, ProverOptions options) {
  std::map<CoverageGoal, GoalAnswer> answers;
  PropertySet surroundings = set;
  std::erase_if(surroundings.properties, [](const Property& p) { return p.isGoal(); });
  options.checks = {};
  options.checks.rules = {};
  options.usesCone = false;
  options.checks.further = [&](Asking& asking) {
    asking.begin(coverageRule);
    const std::vector<Node> nodes = GoalEncoder(map, asking).encode(goals);
    for (std::size_t i = 0; i < goals.size(); ++i) {
      if (nodes[i] == noNode) continue;
      asking.ask({.name = std::to_string(i), .bad = asking.askedProperties().atScanEnd(nodes[i])});
    }
  };
  for (ProofResult& result : prove(map.program(), surroundings, options).results) {
    if (!result.builtin || result.builtin->rule != &coverageRule) continue;
    GoalAnswer answer{result.outcome, result.method, std::move(result.certificate), {}, std::move(result.witness)};
    answers.emplace(goals[std::stoul(result.builtin->name)], std::move(answer));
  }
  return answers;
}

}  // namespace rungproof
