// Questions about single rungs for lint --prove: does power ever flow (LOG001), does a latch drop out (LOG006), does a
// contact make a difference (LOG002), and whether what the flow analysis suspects can happen: two coils in one scan
// (OUT001), a bit that changes in every scan (LOG005), a box that runs in two scans in a row (HSP004).
// Covered by tests/prover/rule_questions_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/facts.hpp"
#include "analysis/proof/builtin_checks.hpp"

namespace rungproof {

namespace {

struct Position {
  const Network* network;
  std::size_t index;
};

/// Contacts that are there to be constant or to come once: special memory.
bool isSpecial(const Instruction& contact) {
  return std::all_of(contact.operands.begin(), contact.operands.end(), [](const Operand& o) {
    return o.kind == OperandKind::Constant || (o.kind == OperandKind::Direct && o.area == Area::SM);
  });
}
bool isContactOf(const Instruction& contact, const Operand& bit, bool negated) {
  if (contact.operands.size() != 1 || contact.desc->execution != Execution::Stack ||
      toString(contact.operands[0]) != toString(bit))
    return false;
  return (contact.desc->stl.back() == 'N') == negated;
}
bool isNegated(const Instruction& contact) {
  return contact.desc->execution == Execution::Stack &&
         (contact.desc->stl.back() == 'N' || contact.desc->stl.ends_with("NI"));
}

class RungChecks {
 public:
  RungChecks(const Program& program, Obligations& obligations, const ExecutionRecord& record,
             std::vector<BuiltinCheck>& checks)
      : obligations_(obligations),
        encoding_(obligations.encoding()),
        graph_(encoding_.graph()),
        record_(record),
        checks_(checks) {
    for (const Pou& pou : program.pous) {
      for (const Network& network : pou.networks) {
        for (std::size_t i = 0; i < network.instructions.size(); ++i)
          positions_[&network.instructions[i]] = {&network, i};
      }
    }
    for (const Visit& visit : record_.visits()) {
      const auto [place, isNew] = byInstruction_.try_emplace(visit.instruction);
      if (isNew) order_.push_back(visit.instruction);
      place->second.push_back(&visit);
    }
  }

  void run() {
    for (const Instruction* instruction : order_) {
      askFlow(*instruction);
      askLatch(*instruction);
      askToggle(*instruction);
      askOnce(*instruction);
    }
    askDoubleCoils();
    askContacts();
  }

 private:
  std::vector<const Instruction*> rung(const Instruction& instruction) const {
    const Position& position = positions_.at(&instruction);
    return rungOf(*position.network, position.index);
  }
  Graph::Bool anyOf(const Instruction& instruction, bool on) {
    Graph::Bool any = graph_.constant(false);
    for (const Visit* visit : byInstruction_.at(&instruction)) {
      const Graph::Bool flow{visit->flow[0]};
      any = graph_.lor(any, graph_.land({visit->guard}, on ? flow : graph_.lnot(flow)));
    }
    return any;
  }
  void ask(BuiltinKind kind, const char* rule, std::string name, std::string message, std::string address,
           const Instruction& place, Node bad) {
    checks_.push_back({kind, std::move(name), rule, std::move(message), std::move(address), &place, nullptr, bad});
  }

  /// One pair of questions for each rung: outputs behind the same contacts have the same power flow.
  void askFlow(const Instruction& output) {
    if (byInstruction_.at(&output).front()->flow[0] == noNode || isCounterBox(kindOf(output))) return;
    const std::vector<const Instruction*> contacts = rung(output);
    if (std::all_of(contacts.begin(), contacts.end(), [](const Instruction* c) { return isSpecial(*c); })) return;
    const Graph::Bool on = anyOf(output, true), off = anyOf(output, false);
    if (!askedFlows_.emplace(on.node, off.node).second) return;
    const std::string text = Facts::text(output), address = output.operands.empty() ? "" : toString(output.operands[0]);
    ask(BuiltinKind::FlowOn, "LOG001", fmt::format("power can reach {}", text),
        fmt::format("no reachable state lets power flow to {}", text), address, output, on.node);
    ask(BuiltinKind::FlowOff, "LOG001", fmt::format("{} can be without power", text),
        fmt::format("power flows to {} in every reachable state", text), address, output, off.node);
  }

  /// A coil that holds itself, and a bit with S and R.
  void askLatch(const Instruction& output) {
    const Kind kind = kindOf(output);
    if (output.operands.empty() || output.operands[0].kind != OperandKind::Direct || output.operands[0].area == Area::L)
      return;
    const Operand& bit = output.operands[0];
    if (kind == Kind::Assign) {
      const std::vector<const Instruction*> contacts = rung(output);
      if (std::none_of(contacts.begin(), contacts.end(),
                       [&](const Instruction* c) { return isContactOf(*c, bit, false); }))
        return;
    } else if (!isSet(kind) || !isReset(output)) {
      return;
    }
    if (!askedLatches_.insert(toString(bit)).second) return;
    const Place place = memoryPlace(bit.area, bit.offset, Width::Bit, bit.bit);
    const Node falls = graph_.land({encoding_.atStart(place)}, graph_.lnot({encoding_.atEnd(place)})).node;
    const std::string name = toString(bit);
    ask(BuiltinKind::LatchDrops, "LOG006", fmt::format("{} can drop out", name),
        fmt::format("once on, {} never goes off again in any reachable state", name), name, output, falls);
  }
  /// Whether the program has an R whose bits include the one that the S sets.
  bool isReset(const Instruction& set) const {
    const Operand& bit = set.operands[0];
    const auto first = [](const Operand& o) { return o.offset * 8 + o.bit; };
    return std::any_of(positions_.begin(), positions_.end(), [&](const auto& entry) {
      const Instruction& reset = *entry.first;
      if (!rungproof::isReset(kindOf(reset)) || reset.operands.size() < 2 || reset.operands[0].area != bit.area ||
          reset.operands[0].kind != OperandKind::Direct)
        return false;
      const bool isOpen = reset.operands[1].kind != OperandKind::Constant;
      const auto count = isOpen ? 255U : static_cast<std::uint32_t>(reset.operands[1].value);
      return first(reset.operands[0]) <= first(bit) && first(bit) < first(reset.operands[0]) + count;
    });
  }

  void askToggle(const Instruction& coil) {
    if (kindOf(coil) != Kind::Assign || coil.operands[0].kind != OperandKind::Direct ||
        coil.operands[0].area == Area::L)
      return;
    const Operand& bit = coil.operands[0];
    const std::vector<const Instruction*> contacts = rung(coil);
    if (std::none_of(contacts.begin(), contacts.end(),
                     [&](const Instruction* c) { return isContactOf(*c, bit, true); }))
      return;
    const Place place = memoryPlace(bit.area, bit.offset, Width::Bit, bit.bit);
    const Graph::Bool changes = graph_.lxor({encoding_.atStart(place)}, {encoding_.atEnd(place)});
    const std::string name = toString(bit);
    const Graph::Bool again = graph_.land(changes, {obligations_.before("change of " + name, changes.node)});
    ask(BuiltinKind::Toggles, "LOG005", fmt::format("{} changes in two scans in a row", name),
        fmt::format("{} changes in every scan", name), name, coil, again.node);
  }

  void askOnce(const Instruction& box) {
    static const std::set<Kind> once{Kind::Att,  Kind::Lifo, Kind::Fifo, Kind::Netr,         Kind::Netw,
                                     Kind::Hdef, Kind::Pls,  Kind::Set,  Kind::SetImmediate, Kind::MoveByte};
    const Kind kind = kindOf(box);
    if (!once.contains(kind) || box.operands.empty()) return;
    const Operand& target = kind == Kind::MoveByte ? box.operands.back() : box.operands[0];
    const bool savesMemory = target.kind == OperandKind::Direct && target.area == Area::SM && target.offset == 31;
    if ((isSet(kind) || kind == Kind::MoveByte) && !savesMemory) return;
    const Graph::Bool now = anyOf(box, true);
    const Graph::Bool again = graph_.land(now, {obligations_.before("run of " + Facts::text(box), now.node)});
    ask(BuiltinKind::RunsTwice, "HSP004", fmt::format("{} runs in two scans in a row", Facts::text(box)),
        fmt::format("{} can run in two scans in a row", Facts::text(box)), "", box, again.node);
  }

  void askDoubleCoils() {
    std::map<Place, std::map<std::uint32_t, std::pair<const Instruction*, Graph::Bool>>> coils;
    for (const BitWrite& write : encoding_.bitWrites()) {
      if (write.instruction == nullptr || !isCoil(kindOf(*write.instruction)) || write.place.area == Area::L) continue;
      auto& runs = coils[write.place]
                       .try_emplace(write.instruction->id, write.instruction, graph_.constant(false))
                       .first->second.second;
      runs = graph_.lor(runs, {write.guard});
    }
    for (const auto& [place, list] : coils) {
      if (list.size() < 2) continue;
      Graph::Bool some = graph_.constant(false), two = some;
      for (const auto& [id, coil] : list) {
        two = graph_.lor(two, graph_.land(some, coil.second));
        some = graph_.lor(some, coil.second);
      }
      const std::string name = nameOf(place);
      ask(BuiltinKind::DoubleCoil, "OUT001", fmt::format("two coils of {} run in one scan", name),
          fmt::format("{} is driven by {} coils", name, list.size()), name, *std::next(list.begin())->second.first,
          two.node);
    }
  }

  /// Interlocks against other outputs are doubled on purpose, and contacts of special memory say how often code runs.
  void askContacts() {
    for (const auto& [contact, matters] : record_.contactEffects()) {
      const bool isInterlock = isNegated(*contact) && contact->operands[0].area == Area::Q;
      if (isSpecial(*contact) || isInterlock) continue;
      const std::string text = Facts::text(*contact);
      ask(BuiltinKind::ContactMatters, "LOG002", fmt::format("{} makes a difference", text),
          fmt::format("without {} the network does the same in every reachable state", text),
          contact->operands.empty() ? "" : toString(contact->operands[0]), *contact, matters);
    }
  }

  Obligations& obligations_;
  EncodedScan& encoding_;
  Graph& graph_;
  const ExecutionRecord& record_;
  std::vector<BuiltinCheck>& checks_;
  std::map<const Instruction*, Position> positions_;
  std::map<const Instruction*, std::vector<const Visit*>> byInstruction_;
  std::vector<const Instruction*> order_;
  std::set<std::pair<Node, Node>> askedFlows_;
  std::set<std::string> askedLatches_;
};

}  // namespace

void addRungChecks(const Program& program, Obligations& obligations, const ExecutionRecord& record,
                   std::vector<BuiltinCheck>& checks) {
  RungChecks(program, obligations, record, checks).run();
}

}  // namespace rungproof
