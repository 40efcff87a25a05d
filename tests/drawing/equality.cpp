// Two machines over one graph.
#include "tests/drawing/equality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>

#include "analysis/encoding/symbolic_store.hpp"
#include "analysis/graph/z3_terms.hpp"
#include "ir/machine/dispatch.hpp"
#include "ir/s7200/args.hpp"

namespace rungproof::testing {

namespace {

/// The unknowns that both sides share.
class World final : public CellSource, public Graph::Listener {
 public:
  World() { graph.listen(this); }
  Graph graph;
  bool hasPointers = false;

  void beginSide() { asked_.clear(); }
  Cell cellAt(const Place& place) override {
    const auto [entry, isNew] = cells_.try_emplace(place, noNode);
    const bool isAlwaysOn =
        !place.isRegister && place.area == Area::SM && place.byte() == 0 && place.bit() == 0 && place.width == 1;
    if (isNew) entry->second = isAlwaysOn ? graph.constantNode(1, 1) : graph.variable(nameOf(place), place.width, true);
    return {place, CellKind::State, entry->second};
  }
  Node localByte(std::uint32_t, std::uint32_t) override { return graph.constantNode(0, 8); }
  /// The n-th question of a kind about an index has the same answer on both sides.
  Graph::Bits external(const ExternalSite& site, int width) override {
    const int turn = asked_[{site.kind, site.index}]++;
    const auto [entry, isNew] = externals_.try_emplace({site.kind, site.index, turn}, noNode);
    if (isNew) entry->second = graph.variable(fmt::format("external {}", externals_.size()), width, false);
    return {entry->second};
  }
  void report(Hazard, Graph::Bool, const Instruction*) override {}
  Graph::Bool targets(Machine<Graph>&, Graph::Bits, Width, Ref<Graph>& ref) override {
    hasPointers = ref.isUnresolved = true;
    return graph.constant(true);
  }
  std::optional<std::vector<std::uint64_t>> locations(Machine<Graph>&, Graph::Bits) override { return std::nullopt; }
  std::optional<std::vector<std::uint64_t>> locationsInBlock(Machine<Graph>&, Graph::Bits, Width) override {
    return std::nullopt;
  }
  Graph::Bits unresolved(Machine<Graph>&, int width) override { return graph.literal(0, width); }
  void havoc(Machine<Graph>&) override { hasPointers = true; }

 private:
  std::map<Place, Node> cells_;
  std::map<std::pair<External, std::uint32_t>, int> asked_;
  std::map<std::tuple<External, std::uint32_t, int>, Node> externals_;
};

Program wrapped(std::vector<Instruction> instructions, const Target& target) {
  Program program;
  program.target = target;
  program.pous.emplace_back().name = "MAIN";
  program.pous[0].networks.emplace_back().instructions = std::move(instructions);
  program.number();
  return program;
}

/// One side: its own machine and store in the common world.
class Side {
 public:
  Side(World& world, const Program& program, const MemoryLayout& layout, const Plan& plan)
      : program_(program), store_(world.graph, layout, world, plan), machine_(world.graph, store_, plan) {
    world.beginSide();
    store_.follow(&machine_);
  }
  const std::vector<Instruction>& instructions() const { return program_.pous[0].networks[0].instructions; }

  void execute(const Instruction& instruction) {
    Machine<Graph>& m = machine_;
    m.current = &instruction;
    if (instruction.desc->control != Control::None) {
      if (instruction.desc->stack.needs > 0) flows.push_back(m.top());
      if (instruction.desc->eno) m.enoAfter(m.top());
      return;
    }
    dispatchTable<Graph>()[instruction.desc->opcode](m, instruction);
  }
  Graph::Bool bit(const Operand& operand) { return machine_.loadBit(operand.area, operand.offset, operand.bit); }

  Machine<Graph>& machine() { return machine_; }
  Graph::Store& store() { return store_; }
  std::vector<Graph::Bool> flows;  ///< at control instructions, and flow parameters of CALL

 private:
  const Program& program_;
  Graph::Store store_;
  Machine<Graph> machine_;
};

bool isFlowBit(const Operand& operand) {
  return operand.kind == OperandKind::Direct && operand.area == Area::L && operand.offset >= 60;
}

void runInstructions(Side& side) {
  for (const Instruction& instruction : side.instructions()) {
    side.execute(instruction);
    if (instruction.desc->control != Control::Call) continue;
    for (const Operand& operand : instruction.operands) {
      if (isFlowBit(operand)) side.flows.push_back(side.bit(operand));
    }
  }
}

/// Executes the elements one after the other. `instructionOf`: by element, its instruction in the side's program.
void runDrawing(World& world, Side& side, const Drawing& drawing,
                const std::vector<const Instruction*>& instructionOf) {
  Graph& g = world.graph;
  Machine<Graph>& m = side.machine();
  std::vector<Graph::Bool> output(drawing.elements.size(), g.constant(true));
  for (std::size_t i = 0; i < drawing.elements.size(); ++i) {
    const Element& element = drawing.elements[i];
    std::vector<Graph::Bool> inputs;
    for (const Wire& wire : element.inputs)
      inputs.push_back(wire.negated ? g.lnot(output[wire.from]) : output[wire.from]);
    if (element.shape == Shape::Rail) continue;
    if (element.shape == Shape::And || element.shape == Shape::Or) {
      output[i] = inputs[0];
      for (const Graph::Bool input : inputs)
        output[i] = element.shape == Shape::And ? g.land(output[i], input) : g.lor(output[i], input);
      continue;
    }
    const Instruction& instruction = *instructionOf[i];
    if (element.shape == Shape::Contact && element.desc->stack.pushes == 1) {
      side.execute(instruction);
      output[i] = g.land(inputs[0], m.top());
      continue;
    }
    const bool isCall = element.desc->control == Control::Call;
    const std::size_t pins = isCall ? 1 : inputs.size();
    for (std::size_t pin = 0; pin < pins; ++pin) m.push(inputs[pin]);
    side.execute(instruction);
    for (std::size_t pin = pins; pin < inputs.size(); ++pin) side.flows.push_back(inputs[pin]);
    if (element.shape == Shape::Contact || (element.desc->drawingOnly && element.desc->stack.pops > 0)) {
      output[i] = m.top();
    } else if (element.desc->drawingOnly) {
      const Operand& number = instruction.operands[0];  // Q is the bit of the number (001:6693, 001:4097)
      output[i] = m.getBit(number.area == Area::T ? Reg::TimerBit : Reg::CounterBit, number.offset);
    } else if (element.desc->eno) {
      output[i] = g.land(inputs[0], m.getBit(Reg::Eno));
    }
  }
}

/// Places that a run may leave changed, apart from the editor's own bits.
std::set<Place> placesOf(Side& a, Side& b) {
  std::set<Place> places;
  for (Side* side : {&a, &b}) {
    for (const Place& place : side->store().places()) places.insert(place);
    for (const Instruction& instruction : side->instructions()) {
      for (const Operand& operand : instruction.operands) {
        if (operand.kind == OperandKind::Direct && operand.area == Area::L && operand.offset < 60) {
          places.insert(memoryPlace(Area::L, operand.offset, operand.width, operand.bit));
        }
      }
    }
  }
  return places;
}

std::string compare(World& world, Side& a, Side& b) {
  Graph& g = world.graph;
  if (world.hasPointers) return "pointers";
  if (a.flows.size() != b.flows.size()) return fmt::format("{} and {} flows", a.flows.size(), b.flows.size());
  std::vector<std::pair<Node, std::string>> questions;
  questions.emplace_back(g.lxor(a.machine().halted, b.machine().halted).node, "the stop");
  for (std::size_t i = 0; i < a.flows.size(); ++i)
    questions.emplace_back(g.lxor(a.flows[i], b.flows[i]).node, fmt::format("flow {}", i));
  for (const Place& place : placesOf(a, b)) {
    if (place.isRegister && place.reg == Reg::Eno) continue;
    if (!place.isRegister && place.area == Area::L && place.byte() >= 60) continue;
    const Graph::Bits left{a.store().value(place)}, right{b.store().value(place)};
    questions.emplace_back(g.lnot(g.equal(left, right, place.width)).node, nameOf(place));
  }
  Graph::Bool any = g.constant(false);
  for (const auto& [node, name] : questions) any = g.lor(any, {node});
  if (const std::optional<bool> known = g.truth(any); known && !*known) return "";
  std::vector<Node> wanted;
  for (const auto& [node, name] : questions) wanted.push_back(node);
  std::vector<std::uint64_t> values;
  const std::optional<bool> differs = satisfiable(g, std::array{any.node}, 120000, wanted, &values);
  if (!differs) return "the solver gave up";
  if (!*differs) return "";
  for (std::size_t i = 0; i < questions.size(); ++i) {
    if (values[i] != 0) return questions[i].second + " differs";
  }
  return "differs";
}

}  // namespace

std::string difference(const Drawing& drawing, const std::vector<Instruction>& instructions,
                       const std::vector<std::uint32_t>& instructionOf, const Target& target) {
  std::vector<Instruction> drawn;
  std::vector<std::size_t> positions(drawing.elements.size(), 0);
  for (std::size_t i = 0; i < drawing.elements.size(); ++i) {
    const Element& element = drawing.elements[i];
    if (element.desc == nullptr) continue;
    positions[i] = drawn.size();
    Instruction& instruction = drawn.emplace_back();
    instruction.desc = element.desc;
    instruction.operands = element.operands;
  }
  const Program left = wrapped(std::move(drawn), target), right = wrapped(instructions, target);
  Plan leftPlan(left), rightPlan(right);
  MemoryLayout layout(leftPlan);
  layout.add(Area::SM, Width::Bit, 0);
  layout.add(left, leftPlan);
  layout.add(right, rightPlan);
  std::vector<const Instruction*> ofElement(drawing.elements.size(), nullptr);
  for (std::size_t i = 0; i < drawing.elements.size(); ++i) {
    if (drawing.elements[i].desc == nullptr) continue;
    ofElement[i] = &left.pous[0].networks[0].instructions[positions[i]];
    const Instruction& other = right.pous[0].networks[0].instructions[instructionOf[i]];
    if (roleOf(other) == Role::Eu || roleOf(other) == Role::Ed)
      rightPlan.edge[other.id] = leftPlan.edge[ofElement[i]->id];
  }
  World world;
  Side a(world, left, layout, leftPlan);
  runDrawing(world, a, drawing, ofElement);
  Side b(world, right, layout, rightPlan);
  runInstructions(b);
  return compare(world, a, b);
}

std::string difference(const std::vector<Instruction>& a, const std::vector<Instruction>& b, const Target& target) {
  const Program left = wrapped(a, target), right = wrapped(b, target);
  const Plan leftPlan(left), rightPlan(right);
  MemoryLayout layout(leftPlan);
  layout.add(Area::SM, Width::Bit, 0);
  layout.add(left, leftPlan);
  layout.add(right, rightPlan);
  World world;
  Side x(world, left, layout, leftPlan);
  runInstructions(x);
  Side y(world, right, layout, rightPlan);
  runInstructions(y);
  return compare(world, x, y);
}

}  // namespace rungproof::testing
