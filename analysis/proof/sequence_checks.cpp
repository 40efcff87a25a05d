// Questions about the course of the program for lint --prove: steps that are entered and left (SCR003), transitions
// that can be taken together (SCR004), code that runs at all (CTL003, CTL005), counters that can count (TIM012).
// Covered by tests/prover/rule_questions_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/facts.hpp"
#include "analysis/proof/builtin_checks.hpp"

namespace rungproof {

namespace {

class SequenceChecks {
 public:
  SequenceChecks(Obligations& obligations, const ExecutionRecord& record, std::vector<BuiltinCheck>& checks)
      : obligations_(obligations), encoding_(obligations.encoding()), graph_(encoding_.graph()), checks_(checks) {
    for (const Visit& visit : record.visits()) {
      Runs& runs = runs_.try_emplace(visit.instruction, Runs{graph_.constant(false), {}}).first->second;
      runs.guard = graph_.lor(runs.guard, {visit.guard});
      for (std::size_t k = 0; k < visit.flow.size(); ++k) {
        if (visit.flow[k] == noNode) continue;
        const Graph::Bool flows = graph_.land({visit.guard}, {visit.flow[k]});
        const Graph::Bool rests = graph_.land({visit.guard}, graph_.lnot({visit.flow[k]}));
        runs.on[k] = runs.on[k].node == noNode ? flows : graph_.lor(runs.on[k], flows);
        runs.off[k] = runs.off[k].node == noNode ? rests : graph_.lor(runs.off[k], rests);
      }
    }
  }

  void run() {
    for (const Flow& flow : encoding_.plan().flows) {
      askSteps(flow);
      askTransitions(flow);
      askCode(flow);
      for (const FlowStep& step : flow.steps) askCounter(*step.instruction);
    }
  }

 private:
  struct Runs {
    Graph::Bool guard;
    std::array<Graph::Bool, 3> on{}, off{};
  };
  const Runs* runsOf(const Instruction& instruction) const {
    const auto found = runs_.find(&instruction);
    return found == runs_.end() ? nullptr : &found->second;
  }
  void ask(BuiltinKind kind, const char* rule, std::string name, std::string message, std::string address,
           const Instruction& place, Node bad, const Instruction* other = nullptr) {
    checks_.push_back({kind, std::move(name), rule, std::move(message), std::move(address), &place, other, bad});
  }
  static Place placeOf(const Operand& bit) { return memoryPlace(bit.area, bit.offset, Width::Bit, bit.bit); }

  void askSteps(const Flow& flow) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& head = *step.instruction;
      if (head.desc->control != Control::Lscr || head.operands.empty() ||
          head.operands[0].kind != OperandKind::Direct || runsOf(head) == nullptr)
        continue;
      const Place place = placeOf(head.operands[0]);
      const std::string name = toString(head.operands[0]);
      const Graph::Bool now{encoding_.atEnd(place)}, before{encoding_.atStart(place)};
      ask(BuiltinKind::StepEntered, "SCR003", fmt::format("step {} can be active", name),
          fmt::format("no reachable state activates step {}", name), name, head, now.node);
      ask(BuiltinKind::StepLeft, "SCR003", fmt::format("step {} can be left", name),
          fmt::format("once active, step {} is never left in any reachable state", name), name, head,
          graph_.land(before, graph_.lnot(now)).node);
    }
  }

  /// Transitions of one step behind rungs of their own. One rung that drives two transitions is meant to start both.
  void askTransitions(const Flow& flow) {
    std::map<std::uint32_t, std::vector<const Instruction*>> ofStep;
    for (const FlowStep& step : flow.steps) {
      const bool isKnown = step.instruction->desc->control == Control::Scrt && step.partner != noPartner &&
                           !step.instruction->operands.empty() && runsOf(*step.instruction) != nullptr;
      if (isKnown) ofStep[step.partner].push_back(step.instruction);
    }
    bool hasParallel = false, hasDouble = false;
    for (const auto& [head, transitions] : ofStep) {
      for (std::size_t i = 0; i < transitions.size(); ++i) {
        for (std::size_t k = i + 1; k < transitions.size(); ++k) {
          const Instruction &first = *transitions[i], &second = *transitions[k];
          const std::string a = toString(first.operands[0]), b = toString(second.operands[0]);
          const Graph::Bool one = runsOf(first)->on[0], other = runsOf(second)->on[0];
          if (a == b) continue;
          if (one.node == other.node) {
            hasParallel = true;
            continue;
          }
          const std::string from = toString(flow.steps[head].instruction->operands[0]);
          ask(BuiltinKind::TwoWaysOut, "SCR004", fmt::format("step {} is left to {} and {} at once", from, a, b),
              fmt::format(
                  "the transitions of step {} to {} and to {} can be taken in one scan: both steps are then active",
                  from, a, b),
              b, second, graph_.land(one, other).node, &first);
          hasDouble = true;
        }
      }
    }
    if (!hasParallel && !hasDouble) askTogether(flow, ofStep);
  }

  /// Steps that transitions join, without a divergence: at most one of them is active at the end of a scan.
  void askTogether(const Flow& flow, const std::map<std::uint32_t, std::vector<const Instruction*>>& ofStep) {
    std::map<std::string, std::string> chain;  // by step: one step that stands for its chain
    std::map<std::string, const Instruction*> heads;
    const auto root = [&](std::string step) {
      while (chain.at(step) != step) step = chain.at(step);
      return step;
    };
    for (const auto& [head, transitions] : ofStep) {
      const std::string from = toString(flow.steps[head].instruction->operands[0]);
      heads.emplace(from, flow.steps[head].instruction);
      chain.try_emplace(from, from);
      for (const Instruction* transition : transitions) {
        const std::string to = toString(transition->operands[0]);
        heads.emplace(to, transition);
        chain.try_emplace(to, to);
        chain[root(to)] = root(from);
      }
    }
    std::map<std::string, std::vector<std::string>> chains;
    for (const auto& [step, parent] : chain) chains[root(step)].push_back(step);
    for (const auto& [first, steps] : chains) {
      Graph::Bool some = graph_.constant(false), two = some;
      for (const std::string& step : steps) {
        const Instruction& head = *heads.at(step);
        if (head.operands[0].kind != OperandKind::Direct) continue;
        const Graph::Bool active{encoding_.atEnd(placeOf(head.operands[0]))};
        two = graph_.lor(two, graph_.land(some, active));
        some = graph_.lor(some, active);
      }
      ask(BuiltinKind::StepsTogether, "SCR004",
          fmt::format("two steps of the chain {} are active", fmt::join(steps, ", ")),
          fmt::format("two steps of the chain {} can be active at the end of a scan, though it has no divergence",
                      fmt::join(steps, ", ")),
          first, *heads.at(first), obligations_.atScanEnd(two.node));
    }
  }

  void askCode(const Flow& flow) {
    // A block that is never called has no executions at all; CTL007 speaks of it.
    if (std::none_of(flow.steps.begin(), flow.steps.end(),
                     [&](const FlowStep& step) { return runsOf(*step.instruction) != nullptr; }))
      return;
    std::uint32_t network = noPartner;
    for (std::size_t i = 0; i < flow.steps.size(); ++i) {
      const Instruction& instruction = *flow.steps[i].instruction;
      const bool isFirst = flow.steps[i].network != network;
      network = flow.steps[i].network;
      const Runs* runs = runsOf(instruction);
      const Graph::Bool guard = runs == nullptr ? graph_.constant(false) : runs->guard;
      const bool isStructure =
          instruction.desc->control == Control::LabelMark || instruction.desc->control == Control::Return ||
          instruction.desc->control == Control::InterruptReturn || instruction.desc->control == Control::MainEnd;
      const bool isBody = i > 0 && flow.steps[i - 1].instruction->desc->control == Control::For;
      if (isBody) {
        const Instruction& loop = *flow.steps[i - 1].instruction;
        askRun("CTL003", fmt::format("the body of {} runs", Facts::text(loop)),
               fmt::format("{} never runs its body in any reachable state", Facts::text(loop)), loop, guard);
      } else if (isFirst && !isStructure) {
        askRun("CTL005", fmt::format("{}, network {} runs", flow.pou->name, flow.pou->networks[network].number),
               "no reachable state comes to this network", instruction, guard);
      }
    }
  }
  void askRun(const char* rule, std::string name, std::string message, const Instruction& place, Graph::Bool guard) {
    if (const auto known = graph_.truth(guard); known && *known) return;
    ask(BuiltinKind::CodeRuns, rule, std::move(name), std::move(message), "", place, guard.node);
  }

  /// The top level resets or loads, the others count (001:3994-4004).
  void askCounter(const Instruction& box) {
    const Runs* runs = runsOf(box);
    if (runs == nullptr || !isCounterBox(roleOf(box)) || roleOf(box) == Role::IecCounter || box.operands.empty())
      return;
    const std::string name = toString(box.operands[0]);
    if (runs->off[0].node != noNode) {
      ask(BuiltinKind::CounterReset, "TIM012", fmt::format("{} is not always held", name),
          fmt::format("the reset or load input of {} is on in every reachable state, so it never counts", name), name,
          box, runs->off[0].node);
    }
    for (std::size_t k = 1; k < runs->on.size(); ++k) {
      if (runs->on[k].node == noNode) continue;
      const Graph::Bool before{obligations_.before(fmt::format("rest of input {} of {}", k, name), runs->off[k].node)};
      ask(BuiltinKind::CountRises, "TIM012",
          fmt::format("the count input of {} at stack level {} can rise", name, k + 1),
          fmt::format("a count input of {} never rises in any reachable state", name), name, box,
          graph_.land(before, runs->on[k]).node);
    }
  }

  Obligations& obligations_;
  EncodedScan& encoding_;
  Graph& graph_;
  std::vector<BuiltinCheck>& checks_;
  std::map<const Instruction*, Runs> runs_;
};

}  // namespace

void addSequenceChecks(const Program&, Obligations& obligations, const ExecutionRecord& record,
                       std::vector<BuiltinCheck>& checks) {
  SequenceChecks(obligations, record, checks).run();
}

}  // namespace rungproof
