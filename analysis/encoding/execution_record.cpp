// The stack is followed twice more beside the machine: as a pair of heights, and, for each contact, as the levels that
// it would have without the contact, up to the end of the network.
#include "analysis/encoding/execution_record.hpp"

#include <algorithm>

#include "analysis/flow/stack_depth.hpp"

namespace rungproof {

namespace {

/// A plain contact of a bit that stands in memory: its value can be read again without asking anything new.
bool isPlainContact(const Instruction& i) {
  return i.operands.size() == 1 && i.operands[0].kind == OperandKind::Direct && i.desc->execution == Execution::Stack &&
         isContact(i.desc->role) && !i.desc->immediate;
}

}  // namespace

ExecutionRecord::ExecutionRecord(const Program& program, bool contacts, bool bits) : contacts_(contacts), bits_(bits) {
  const Plan plan(program);
  sites_.resize(program.instructionCount());
  hasEntriesWithin_.assign(plan.flows.size(), false);
  takesFromBelow_.assign(plan.flows.size(), false);
  for (std::uint32_t b = 0; b < plan.flows.size(); ++b) {
    const std::vector<FlowStep>& steps = plan.flows[b].steps;
    for (std::uint32_t i = 0; i < steps.size(); ++i) {
      Site& site = sites_[steps[i].id()];
      site.block = b;
      site.network = steps[i].network;
      site.isFirst = i == 0 || steps[i - 1].network != steps[i].network;
      site.isEntry = i == 0;
      if (i + 1 < steps.size() && steps[i + 1].network == steps[i].network) site.next = steps[i + 1].instruction;
    }
    for (const FlowStep& step : steps) {
      if (step.partner == noPartner) continue;
      const Control control = step.instruction->desc->control;
      const bool isLoop = control == Control::For || control == Control::Next;
      if (control != Control::Jump && !isLoop) continue;
      const std::uint32_t target = step.partner + (isLoop ? 1 : 0);
      if (target >= steps.size()) continue;
      if (target == 0) sites_[steps[target].id()].isEntry = false;
      if (!sites_[steps[target].id()].isFirst) hasEntriesWithin_[b] = true;
    }
  }
  const StackRun run(program, plan, {});
  for (const StackFault& fault : run.faults()) {
    if (fault.kind == StackFaultKind::FromBelow || fault.kind == StackFaultKind::TooFewInputs ||
        fault.kind == StackFaultKind::LdsBeyond)
      takesFromBelow_[sites_[fault.instruction->id].block] = true;
  }
}

void ExecutionRecord::at(Machine<Graph>& machine, const Instruction& instruction) {
  const Site& site = sites_[instruction.id];
  const Desc& desc = *instruction.desc;
  Visit visit{&instruction, machine.guard.node};
  if (!isLogic(roleOf(instruction))) {
    for (std::size_t k = 0; k < std::min<std::size_t>(desc.stack.needs, visit.flow.size()); ++k)
      visit.flow[k] = machine.powerFlow(k).node;
  }
  const bool isBox = isTimerBox(roleOf(instruction)) || isCounterBox(roleOf(instruction));
  if (isBox && instruction.operands.size() > 1 && instruction.operands[1].kind == OperandKind::Direct &&
      instruction.operands[1].area != Area::AI) {
    visit.preset = machine.load(instruction.operands[1].area, instruction.operands[1].offset, Width::Word).node;
  }
  if (bits_) noteBits(machine, instruction, visit);
  visits_.push_back(visit);
  for (const Operand& o : instruction.operands) {
    if (o.kind != OperandKind::Direct || !hasBitAndWord(o.area) || o.offset >= machine.areaSize(o.area)) continue;
    Node& seen = seenOn_.try_emplace({o.area, o.offset}, machine.d.constant(false).node).first->second;
    seen =
        machine.d
            .lor({seen}, machine.d.land(machine.guard,
                                        machine.getBit(o.area == Area::T ? Reg::TimerBit : Reg::CounterBit, o.offset)))
            .node;
  }
  followHeights(machine, instruction, site);
  if (contacts_) followContacts(machine, instruction, site);
}

void ExecutionRecord::followHeights(Machine<Graph>& machine, const Instruction& instruction, const Site& site) {
  Graph& graph = machine.d;
  const auto number = [&](std::uint64_t value) { return graph.literal(value, heightBits); };
  const std::uint64_t levels = machine.stackLevels;
  Heights& here = heights_[machine.frame];
  // Where no path enters a network in its middle, all paths that come here have the same heights.
  const bool isSame = !hasEntriesWithin_[site.block] || site.isEntry;
  const Graph::Bool always = graph.constant(true);
  const Graph::Bool changes = isSame ? always : machine.guard;
  const auto set = [&](Node& place, Graph::Bits value) {
    place = place == noNode ? value.node : graph.select(changes, value, {place}, heightBits).node;
  };
  if (site.isFirst || here.height == noNode) {
    set(here.height, number(bottom));
    set(here.lost, number(bottom - levels));
    here.lostBy.clear();
  }
  const StackEffect effect = instruction.desc->stack;
  const Role role = roleOf(instruction);
  std::uint64_t deepest = effect.needs;  // levels that must be there
  if (role == Role::Lds && !instruction.operands.empty())
    deepest = static_cast<std::uint64_t>(
                  std::clamp<std::int64_t>(instruction.operands[0].value, 0, static_cast<std::int64_t>(levels) - 1)) +
              1;
  if (deepest > 0) {
    const Graph::Bool isLost =
        graph.ult({here.height}, graph.add({here.lost}, number(deepest), heightBits), heightBits);
    const Graph::Bool bad = graph.land(machine.guard, isLost);
    if (const auto known = graph.truth(bad); !known || *known) {
      const auto height = graph.known({here.height});
      const auto push = height ? here.lostBy.find(*height - deepest) : here.lostBy.end();
      lostLevels_.push_back({push == here.lostBy.end() ? nullptr : push->second, &instruction, bad.node});
    }
  }
  if (effect.pops == 0 && effect.pushes == 0) return;
  const Graph::Bits rest = graph.sub({here.height}, number(effect.pops), heightBits);
  const Graph::Bits height = graph.add(rest, number(effect.pushes), heightBits);
  const Graph::Bits kept = graph.select(graph.ult(rest, {here.lost}, heightBits), rest, {here.lost}, heightBits);
  const Graph::Bits lost = graph.sub(height, number(levels), heightBits);
  set(here.height, height);
  set(here.lost, graph.select(graph.ult(kept, lost, heightBits), lost, kept, heightBits));
  const auto before = graph.known(kept), now = graph.known({here.lost});
  if (before && now && *now > *before) here.lostBy[*now - 1] = &instruction;
}

// ---- Contacts that make no difference --------------------------------------------------------------------

void ExecutionRecord::followContacts(Machine<Graph>& machine, const Instruction& instruction, const Site& site) {
  std::erase_if(bridged_,
                [&](const Bridged& b) { return b.block != site.block || b.network != site.network || site.isFirst; });
  for (Bridged& bridged : bridged_) {
    if (bridged.takesTop) bridged.stack[0] = machine.stack[0];
    bridged.takesTop = false;
  }
  std::erase_if(bridged_, [&](Bridged& bridged) {
    if (follow(machine, instruction, bridged)) return false;
    contactEffects_[bridged.contact] = machine.d.constant(true).node;
    return true;
  });
  if (isContact(roleOf(instruction)) && !hasEntriesWithin_[site.block] && !takesFromBelow_[site.block])
    begin(machine, instruction, site);
}

/// What the instruction does to the levels without the contact. False if that cannot be told.
bool ExecutionRecord::follow(Machine<Graph>& machine, const Instruction& instruction, Bridged& bridged) {
  Graph& graph = machine.d;
  LogicStack<Graph>& stack = bridged.stack;
  const Role role = roleOf(instruction);
  const auto push = [&](Graph::Bool value) {
    std::copy_backward(stack.begin(), stack.end() - 1, stack.end());
    stack[0] = value;
  };
  const auto pop = [&] { std::copy(stack.begin() + 1, stack.end(), stack.begin()); };
  if (isContact(role)) {
    if (!isPlainContact(instruction)) return false;
    const Operand& o = instruction.operands[0];
    Graph::Bool value = graph.bit(machine.load(o.area, o.offset, Width::Bit, o.bit), 0);
    if (instruction.desc->negated) value = graph.lnot(value);
    if (role == Role::Load)
      push(value);
    else
      stack[0] = role == Role::And ? graph.land(stack[0], value) : graph.lor(stack[0], value);
    return true;
  }
  switch (role) {
    case Role::Not: stack[0] = graph.lnot(stack[0]); return true;
    case Role::Ald:
    case Role::Old: {
      const Graph::Bool joined = role == Role::Ald ? graph.land(stack[0], stack[1]) : graph.lor(stack[0], stack[1]);
      pop();
      stack[0] = joined;
      return true;
    }
    case Role::Lps: push(stack[0]); return true;
    case Role::Lrd: stack[0] = stack[1]; return true;
    case Role::Lpp: pop(); return true;
    case Role::Lds: return false;
    default: break;
  }
  const StackEffect effect = instruction.desc->stack;
  Graph::Bool differs = graph.constant(false);
  for (std::size_t k = 0; k < effect.needs; ++k) differs = graph.lor(differs, graph.lxor(machine.stack[k], stack[k]));
  differs = graph.land(differs, machine.guard);
  if (!isLogic(role)) differs = graph.land(differs, machine.scrActive);
  Node& effectOf = contactEffects_.try_emplace(bridged.contact, graph.constant(false).node).first->second;
  effectOf = graph.lor({effectOf}, differs).node;
  for (std::uint8_t k = 0; k < effect.pops; ++k) pop();
  const Control control = instruction.desc->control;
  const bool setsTop = control == Control::For || control == Control::Next || control == Control::Lscr;
  bridged.takesTop = setsTop || role == Role::Eu || role == Role::Ed || role == Role::Aeno;
  return true;
}

void ExecutionRecord::begin(Machine<Graph>& machine, const Instruction& contact, const Site& site) {
  Bridged bridged{&contact, site.block, site.network, machine.stack};
  if (roleOf(contact) == Role::Load) {
    // The first contact of a parallel circuit is cut out of it, that of a series is bridged.
    const bool isParallel = site.next != nullptr && roleOf(*site.next) == Role::Or;
    std::copy_backward(bridged.stack.begin(), bridged.stack.end() - 1, bridged.stack.end());
    bridged.stack[0] = machine.d.constant(!isParallel);
  }
  bridged_.push_back(bridged);
}

std::vector<const Instruction*> rungOf(const Network& network, std::size_t at) {
  std::vector<const Instruction*> contacts;
  std::size_t missing = 1;  // levels whose load has not been met
  for (std::size_t i = at; i-- > 0 && missing > 0;) {
    const Instruction& instruction = network.instructions[i];
    switch (const Role role = roleOf(instruction)) {
      case Role::Load:
        contacts.push_back(&instruction);
        --missing;
        break;
      case Role::And:
      case Role::Or: contacts.push_back(&instruction); break;
      case Role::Ald:
      case Role::Old: ++missing; break;
      case Role::Lrd:
      case Role::Lpp:
        // The branch before this one is not part of the way: back to the push that both begin at.
        for (std::size_t open = 1; open > 0 && i > 0;) {
          const Role earlier = roleOf(network.instructions[--i]);
          if (earlier == Role::Lpp) ++open;
          if (earlier == Role::Lps) --open;
        }
        break;
      default: (void)role; break;
    }
  }
  return contacts;
}

}  // namespace rungproof
