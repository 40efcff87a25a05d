// Questions about single rungs for lint --prove: does power ever flow (LOG001), does a latch that
// comes on drop out (LOG006), does a
// contact make a difference (LOG002), and whether what the flow analysis suspects can happen: two coils in one scan
// (OUT001), a bit that changes in every scan (LOG005), a box that runs in two scans in a row (HSP004).
// Covered by tests/prover/rule_questions_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
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
  return invertsImage(*contact.desc) == negated;
}
bool isNegated(const Instruction& contact) { return contact.desc->negated; }

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
    for (const BitWrite& write : encoding_.bitWrites()) {
      const Place& at = write.place;
      if (write.instruction != nullptr && !at.isRegister)
        writersOf_[{at.area, bitPosition(at.area, at.byte(), at.bit())}].insert(write.instruction->id);
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

  /// One pair of questions for each condition: outputs behind the same contacts have the same power flow. Each network
  /// that has the condition is a place of its own.
  void askFlow(const Instruction& output) {
    if (byInstruction_.at(&output).front()->flow[0] == noNode || isCounterBox(roleOf(output))) return;
    const std::vector<const Instruction*> contacts = rung(output);
    if (std::all_of(contacts.begin(), contacts.end(), [](const Instruction* c) { return isSpecial(*c); })) return;
    const Graph::Bool on = anyOf(output, true), off = anyOf(output, false);
    const auto [asked, isNew] = askedFlows_.try_emplace({on.node, off.node}, AskedFlow{checks_.size(), {}});
    if (!asked->second.networks.insert(positions_.at(&output).network).second) return;
    const std::string text = Facts::text(output), address = output.operands.empty() ? "" : toString(output.operands[0]);
    const std::string never = fmt::format("no reachable state lets power flow to {}", text),
                      always = fmt::format("power flows to {} in every reachable state", text);
    if (!isNew) {
      checks_[asked->second.check].alike.push_back({never, address, &output});
      checks_[asked->second.check + 1].alike.push_back({always, address, &output});
      return;
    }
    ask(BuiltinKind::FlowOn, "LOG001", fmt::format("power can reach {}", text), never, address, output, on.node);
    ask(BuiltinKind::FlowOff, "LOG001", fmt::format("{} can be without power", text), always, address, output,
        off.node);
  }

  /// A coil that holds itself, and bits with S and R. Bits that the same instructions write are one question.
  void askLatch(const Instruction& output) {
    const Role kind = roleOf(output);
    if (output.operands.empty() || output.operands[0].kind != OperandKind::Direct || output.operands[0].area == Area::L)
      return;
    const Operand& bit = output.operands[0];
    if (hasBitAndWord(bit.area)) return;
    if (isPlainCoil(*output.desc)) {
      const std::vector<const Instruction*> contacts = rung(output);
      if (std::none_of(contacts.begin(), contacts.end(),
                       [&](const Instruction* c) { return isContactOf(*c, bit, false); }))
        return;
      return askLatchOn({bit.area, {bitPosition(bit.area, bit.offset, bit.bit)}}, output);
    }
    if (!isSet(kind)) return;
    std::map<std::set<std::uint32_t>, BitRow> byWriters;
    for (const std::uint32_t at : bitsSetBy(output)) {
      if (!isReset(bit.area, at)) continue;
      const auto writers = writersOf_.find({bit.area, at});
      if (writers == writersOf_.end()) continue;
      BitRow& row = byWriters[writers->second];
      row.area = bit.area;
      row.bits.push_back(at);
    }
    for (const auto& [writers, row] : byWriters) askLatchOn(row, output);
  }
  void askLatchOn(const BitRow& row, const Instruction& output) {
    if (!askedLatches_.emplace(row.area, row.bits.front()).second) return;
    Graph::Bool on = graph_.constant(false), falls = on;
    for (const std::uint32_t at : row.bits) {
      const Place place = memoryPlace(row.area, at / 8, Width::Bit, at % 8);
      const Graph::Bool before{encoding_.atStart(place)}, after{encoding_.atEnd(place)};
      on = graph_.lor(on, after);
      falls = graph_.lor(falls, graph_.land(before, graph_.lnot(after)));
    }
    const std::string name = row.text();
    ask(BuiltinKind::LatchOn, "LOG006", fmt::format("{} can be on at the end of a scan", name), "", row.first(), output,
        on.node);
    ask(BuiltinKind::LatchDrops, "LOG006", fmt::format("{} can drop out", name),
        fmt::format("once on, {} never {} off again in any reachable state", name,
                    row.bits.size() == 1 ? "goes" : "go"),
        row.first(), output, falls.node);
  }
  static std::vector<std::uint32_t> bitsSetBy(const Instruction& set) {
    const bool isKnown = set.operands.size() > 1 && set.operands[1].kind == OperandKind::Constant;
    const auto count =
        isKnown ? static_cast<std::uint32_t>(std::clamp<std::int64_t>(set.operands[1].value, 1, 255)) : 1;
    std::vector<std::uint32_t> bits(count);
    std::iota(bits.begin(), bits.end(), bitPosition(set.operands[0].area, set.operands[0].offset, set.operands[0].bit));
    return bits;
  }
  /// Whether the program has an R whose bits include that one.
  bool isReset(Area area, std::uint32_t bit) const {
    return std::any_of(positions_.begin(), positions_.end(), [&](const auto& entry) {
      const Instruction& reset = *entry.first;
      if (!rungproof::isReset(roleOf(reset)) || reset.operands.size() < 2 || reset.operands[0].area != area ||
          reset.operands[0].kind != OperandKind::Direct)
        return false;
      const bool isOpen = reset.operands[1].kind != OperandKind::Constant;
      const auto count = isOpen ? 255U : static_cast<std::uint32_t>(reset.operands[1].value);
      const std::uint32_t first = bitPosition(area, reset.operands[0].offset, reset.operands[0].bit);
      return first <= bit && bit < first + count;
    });
  }

  void askToggle(const Instruction& coil) {
    if (!isPlainCoil(*coil.desc) || coil.operands[0].kind != OperandKind::Direct || coil.operands[0].area == Area::L)
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
    static const std::set<Role> once{Role::Att,  Role::Lifo, Role::Fifo, Role::Netr, Role::Netw,
                                     Role::Hdef, Role::Pls,  Role::Set,  Role::Move};
    const Role kind = roleOf(box);
    if (!once.contains(kind) || box.operands.empty() || (kind == Role::Move && !isMoveOf(*box.desc, Type::Byte)))
      return;
    const Operand& target = kind == Role::Move ? box.operands.back() : box.operands[0];
    const bool savesMemory = target.kind == OperandKind::Direct && target.area == Area::SM && target.offset == 31;
    if ((isSet(kind) || kind == Role::Move) && !savesMemory) return;
    const Graph::Bool now = anyOf(box, true);
    const Graph::Bool again = graph_.land(now, {obligations_.before("run of " + Facts::text(box), now.node)});
    ask(BuiltinKind::RunsTwice, "HSP004", fmt::format("{} runs in two scans in a row", Facts::text(box)),
        fmt::format("{} can run in two scans in a row", Facts::text(box)), "", box, again.node);
  }

  void askDoubleCoils() {
    std::map<Place, std::map<std::uint32_t, std::pair<const Instruction*, Graph::Bool>>> coils;
    for (const BitWrite& write : encoding_.bitWrites()) {
      if (write.instruction == nullptr || !isCoil(roleOf(*write.instruction)) || write.place.area == Area::L) continue;
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
  struct AskedFlow {
    std::size_t check;  ///< position of the first of the two questions
    std::set<const Network*> networks;
  };
  std::map<std::pair<Node, Node>, AskedFlow> askedFlows_;
  std::set<std::pair<Area, std::uint32_t>> askedLatches_;                        ///< by their first bits
  std::map<std::pair<Area, std::uint32_t>, std::set<std::uint32_t>> writersOf_;  ///< by bit: ids of instructions
};

}  // namespace

void addRungChecks(const Program& program, Obligations& obligations, const ExecutionRecord& record,
                   std::vector<BuiltinCheck>& checks) {
  RungChecks(program, obligations, record, checks).run();
}

}  // namespace rungproof
