// HSP004: something that should run once but stands behind a level. Edges, the first scan, interrupt routines, a
// condition that the same rung resets, and for NETR and NETW the status bits of their own table are guards. Tested by
// its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include <set>
#include <vector>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/pulse_generator.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Whether the instruction starts a save to permanent memory: a 1 into SM31.7 (001:1629).
bool savesToEeprom(const Instruction& instruction) {
  const Role role = roleOf(instruction);
  if (instruction.operands.empty()) return false;
  const Operand& target = instruction.operands.back();
  const Operand& bit = instruction.operands[0];
  if (isSet(role)) return bit.area == Area::SM && bit.offset == 31 && bit.bit == 7;
  if (!isMoveOf(*instruction.desc, Type::Byte) || target.kind != OperandKind::Direct || target.area != Area::SM ||
      target.offset != 31)
    return false;
  return bit.kind == OperandKind::Constant && (bit.value & 0x80) != 0;
}

std::string_view harmOf(const Instruction& instruction) {
  switch (roleOf(instruction)) {
    case Role::Att:
    case Role::Lifo:
    case Role::Fifo: return "the table fills or empties within a few scans (001:6511)";
    case Role::Netr:
    case Role::Netw: return "the transfer is started again before it is done";
    case Role::Hdef: return "a counter can be defined once only (001:4360)";
    case Role::Pls: return "the pulse output is started anew in every scan";
    default:
      return "permanent memory is good for about 100 000 writes: with a scan of 50 ms that is 5 000 seconds "
             "(001:1637-1639)";
  }
}

bool isMeantOnce(Role role) {
  switch (role) {
    case Role::Att:
    case Role::Lifo:
    case Role::Fifo:
    case Role::Netr:
    case Role::Netw:
    case Role::Hdef:
    case Role::Pls: return true;
    default: return false;
  }
}

bool maySave(const Desc& desc) { return isSet(desc.role) || isMoveOf(desc, Type::Byte); }

/// Whether the network itself ends the condition: it resets a bit that it reads, or asks the table's own status bits.
bool endsItself(const Facts& facts, const InstructionPlace& place) {
  const Flow& flow = facts.plan().flows[place.block];
  std::uint32_t from = place.step, to = place.step;
  while (from > 0 && flow.steps[from - 1].network == place.network) --from;
  while (to + 1 < flow.steps.size() && flow.steps[to + 1].network == place.network) ++to;
  const Operand* table = nullptr;
  const Role role = roleOf(*place.instruction);
  if (role == Role::Netr || role == Role::Netw) table = &place.instruction->operands[0];
  for (std::uint32_t i = from; i <= to; ++i) {
    for (const Access& read : facts.accesses().of(flow.steps[i].instruction->id)) {
      const bool isContact = !read.write && read.width == Width::Bit && !read.viaPointer;
      if (!isContact) continue;
      if (table != nullptr && table->kind == OperandKind::Direct && read.area == table->area &&
          read.offset == table->offset)
        return true;
      for (std::uint32_t k = i + 1; k <= to; ++k) {
        if (!isReset(roleOf(*flow.steps[k].instruction)) && !isSet(roleOf(*flow.steps[k].instruction)) &&
            !isCoil(roleOf(*flow.steps[k].instruction)))
          continue;
        for (const Access& write : facts.accesses().of(flow.steps[k].instruction->id)) {
          if (write.write && write.area == read.area && write.offset == read.offset && write.bit == read.bit)
            return true;
        }
      }
    }
  }
  return false;
}

/// Whether the same network has just cleared bit 7 of the control byte: this PLS ends the train (001:4528).
bool endsTrain(const Facts& facts, const InstructionPlace& place) {
  const auto output = pulseOutputOf(*place.instruction);
  if (!output || roleOf(*place.instruction) != Role::Pls) return false;
  const Flow& flow = facts.plan().flows[place.block];
  for (std::uint32_t i = place.step; i > 0 && flow.steps[i - 1].network == place.network; --i) {
    const Instruction& before = *flow.steps[i - 1].instruction;
    if (before.operands.size() != 2 || !isMoveOf(*before.desc, Type::Byte)) continue;
    const Operand &value = before.operands[0], &target = before.operands[1];
    if (target.kind == OperandKind::Direct && target.area == Area::SM && target.offset == pulseControl(*output))
      return value.kind == OperandKind::Constant && (value.value & 0x80) == 0;
  }
  return false;
}

void checkHsp004(const Facts& facts, FindingSink& sink) {
  const auto mayBeOnce = [](const Desc& desc) { return isMeantOnce(desc.role) || maySave(desc); };
  for (const InstructionPlace& place : facts.placesOf(mayBeOnce)) {
    const Instruction& instruction = *place.instruction;
    if (!isMeantOnce(roleOf(instruction)) && !savesToEeprom(instruction)) continue;
    if (!facts.execution().at(instruction.id).isReachable) continue;
    const Condition known = facts.conditionOf(instruction.id);
    if ((known & (condition::Pulse | condition::FirstScan | condition::Never)) != 0) continue;
    if (facts.calls().reachedFromInterrupt(place.block) && !facts.calls().reachedFromMain(place.block)) continue;
    if (endsItself(facts, place) || endsTrain(facts, place) || facts.hasUnreadCode()) continue;
    const bool isAlways = (facts.stack().at(instruction.id).flow & condition::Always) != 0 &&
                          !facts.execution().at(instruction.id).isSkipped &&
                          facts.execution().runs(place.block) == Runs::Once;
    Finding& finding =
        sink.report(instruction.span, fmt::format("{} runs in every scan{}: {}", Facts::text(instruction),
                                                  isAlways ? "" : " while its condition holds", harmOf(instruction)));
    if (isAlways) finding.confirmation = Confirmation::NotNeeded;
    finding.help = "put EU in front of it, or a condition that is true for one scan";
  }
}

/// What is meant to run once and can run in two scans in a row.
void askHsp004(Asking& asking) {
  static const std::set<Role> once{Role::Att,  Role::Lifo, Role::Fifo, Role::Netr, Role::Netw,
                                   Role::Hdef, Role::Pls,  Role::Set,  Role::Move};
  for (const Instruction* box : asking.executed()) {
    const Role kind = roleOf(*box);
    if (!once.contains(kind) || box->operands.empty() || (kind == Role::Move && !isMoveOf(*box->desc, Type::Byte)))
      continue;
    const Operand& target = kind == Role::Move ? box->operands.back() : box->operands[0];
    const bool savesMemory = target.kind == OperandKind::Direct && target.area == Area::SM && target.offset == 31;
    if ((isSet(kind) || kind == Role::Move) && !savesMemory) continue;
    const std::string text = Facts::text(*box);
    const Graph::Bool now = asking.runsOf(*box)->on[0];
    const Graph::Bool before{asking.askedProperties().before("run of " + text, now.node)};
    asking.ask({.name = fmt::format("{} runs in two scans in a row", text),
                .message = fmt::format("{} can run in two scans in a row", text),
                .place = box,
                .bad = asking.graph().land(now, before).node});
  }
}

}  // namespace

extern constexpr Rule hsp004_runs_every_scan = {
    .id = "HSP004",
    .title = "Should run once, runs every scan",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects =
        "a save to permanent memory (SM31.7), ATT, LIFO, FIFO, NETR, NETW, HDEF or PLS without an edge or first-scan "
        "condition",
    .why = "permanent memory wears out, tables fill up, transfers and pulse trains start anew in every scan",
    .manual = "001:1637-1639, 001:6511, 001:4360",
    .bad = "Network 1\nLD SM0.1\nMOVW +10, VW200\nNetwork 2\nLD I0.0\nATT VW0, VW200\n",
    .good = "Network 1\nLD SM0.1\nMOVW +10, VW200\nNetwork 2\nLD I0.0\nEU\nATT VW0, VW200\n",
    .falsePositives = "a condition that another network ends in the next scan: the prover drops it",
    .dialects = dialect::S7200,
    .check = checkHsp004,
    .ask = {.in = asked::Lint, .turn = 63, .cost = 4, .onlySettles = true, .program = askHsp004},
};

}  // namespace rungproof
