// The network is followed instruction by instruction over levels that hold wires. Afterwards the drawing is lowered
// along its branches again: what that refuses has no picture.
#include "analysis/drawing/raise.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/drawing/branches.hpp"
#include "analysis/drawing/code.hpp"
#include "analysis/drawing/levels.hpp"
#include "analysis/drawing/raise_step7.hpp"
#include "analysis/flow/stack_depth.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7300/cpu.hpp"

namespace rungproof {

namespace {

constexpr std::string_view behindAPoint = "joins a branch behind a point that also feeds something else";
constexpr std::string_view beginsSecondRung = "begins a second rung in the network";

class Raising {
 public:
  Raising(const Network& network, Form form, const Target& target)
      : network_(network),
        form_(form),
        idiom_(callIdiomOf(network)),
        stackLevels_(static_cast<std::size_t>(cpuFeatures(target).stackLevels)) {}

  Raised run() {
    if (!network_.complete) return {std::nullopt, "a line of the network could not be read", nullptr};
    elements_.emplace_back();  // the rail
    for (at_ = 0; at_ < network_.instructions.size() && !failed_; ++at_) step(network_.instructions[at_]);
    if (failed_) return std::move(result_);
    if (form_ == Form::Fbd) foldNegations();
    compact();
    if (!failed_) findOpenEnds();
    if (!failed_) findPicture();
    if (!failed_) result_.drawing = std::move(drawing_);
    return std::move(result_);
  }

 private:
  void refuse(const Instruction* at, std::string reason) {
    if (failed_) return;
    failed_ = true;
    result_.reason = std::move(reason);
    result_.at = at;
  }
  void refuse(const Instruction& at, std::string_view clause) {
    if (!failed_) result_.clause = clause;
    refuse(&at, fmt::format("{} {}", nameInReason(at), clause));
  }
  void refuseHere(std::string_view clause) { refuse(current(), clause); }
  const Instruction& current() const { return network_.instructions[at_]; }

  // ---- Elements and levels --------------------------------------------------------------------------

  std::uint32_t add(Shape shape, const Desc* desc, std::vector<std::uint32_t> inputs) {
    Element element;
    element.shape = shape;
    element.desc = desc;
    if (desc != nullptr) element.operands = current().operands;
    for (const std::uint32_t from : inputs) element.inputs.push_back({from, false});
    element.span = current().span;
    element.instruction = static_cast<std::uint32_t>(at_);
    elements_.push_back(std::move(element));
    return static_cast<std::uint32_t>(elements_.size() - 1);
  }

  bool has(std::size_t count) {
    if (levels_.size() >= count && levels_.size() - count + 1 < loopLevels_) {
      refuseHere("takes a value from in front of FOR in every round");
      return false;
    }
    if (levels_.size() >= count) return true;
    refuseHere(isLost_ ? "takes a value that was pushed out of the logic stack"
                       : "takes a value that this network has not loaded");
    return false;
  }
  void push(DrawnLevel level) {
    levels_.push_back(std::move(level));
    if (levels_.size() <= stackLevels_) return;
    levels_.erase(levels_.begin());
    isLost_ = true;
  }
  DrawnLevel& top() { return levels_.back(); }
  /// The value on the top is used by an element.
  bool mayUseTop() { return has(1); }
  /// Something beside the next element uses the value; from here on its circuit is no plain branch.
  static void tap(DrawnLevel& level) {
    level.isOpen = level.mayExtend = false;
    level.heads.clear();
  }

  DrawnLevel loaded(const Desc* load) {
    DrawnLevel level;
    level.element = add(Shape::Contact, load, {0});
    level.heads = {level.element};
    return level;
  }

  // ---- Instructions ---------------------------------------------------------------------------------

  void step(const Instruction& instruction) {
    if (idiom_.roles[at_] != CallRole::None) return callStep(instruction);
    switch (roleOf(instruction)) {
      case Role::Load: return load();
      case Role::And: return series();
      case Role::Or: return parallel();
      case Role::Not:
      case Role::Eu:
      case Role::Ed: return transform();
      case Role::Ald: return joinSeries();
      case Role::Old: return joinParallel();
      case Role::Lps: return copy();
      case Role::Lrd:
      case Role::Lpp: return restore(roleOf(instruction) == Role::Lpp);
      case Role::Lds:
      case Role::Nop: return refuseHere("has no picture in LAD or FBD");
      case Role::Aeno: return eno();
      default: break;
    }
    if (shapeOf(*instruction.desc) == Shape::Coil) return coil();
    box();
  }

  void load() {
    if (!loadsIecOutput()) return push(loaded(current().desc));
    const auto box = static_cast<std::uint32_t>(elements_.size() - 1);
    Operand& output = elements_[box].operands[iecOutputOperand];
    if (output.area == Area::L && output.offset >= 60) output.kind = OperandKind::Missing;  // the editor's own bit
    push({box, false, false, false, {}});
  }
  /// LD of the Q operand of the IEC box in front: the power output of the box.
  bool loadsIecOutput() const {
    if (at_ == 0 || current().desc != &s7200Instructions().bitContact(Role::Load)) return false;
    const Instruction& box = network_.instructions[at_ - 1];
    if (!box.desc->drawingOnly || box.desc->stack.pops > 0 || box.operands.size() <= iecOutputOperand) return false;
    const Operand& q = box.operands[iecOutputOperand];
    const Operand& loaded = current().operands[0];
    return q.kind == OperandKind::Direct && q.kind == loaded.kind && q.area == loaded.area &&
           q.offset == loaded.offset && q.bit == loaded.bit;
  }

  void series() {
    if (!mayUseTop()) return;
    const Desc* load = s7200Instructions().joinedForm(*current().desc, Role::Load);
    DrawnLevel& level = top();
    if (form_ == Form::Ladder) {
      level.element = add(Shape::Contact, load, {level.element});
      level.mayExtend = false;
      return;
    }
    const std::uint32_t contact = add(Shape::Contact, load, {0});
    joinGate(level, Shape::And, contact);
  }

  void parallel() {
    if (!mayUseTop()) return;
    DrawnLevel branch = loaded(s7200Instructions().joinedForm(*current().desc, Role::Load));
    unite(branch);
  }
  void joinParallel() {
    if (!has(2)) return;
    DrawnLevel branch = std::move(levels_.back());
    levels_.pop_back();
    // The branch was loaded behind an output: the circuit had ended there, also for FBD.
    if (!top().isOpen) return refuseHere(behindAPoint);
    unite(branch);
  }
  void unite(DrawnLevel& branch) {
    DrawnLevel& level = top();
    if (form_ == Form::Ladder && (!level.isOpen || !branch.isOpen)) {
      return refuseHere(behindAPoint);
    }
    joinGate(level, Shape::Or, branch.element);
    level.isContacts = level.isContacts && branch.isContacts;
    takeHeads(level, branch);
  }
  static void takeHeads(DrawnLevel& level, DrawnLevel& branch) {
    if (level.heads.size() < branch.heads.size()) level.heads.swap(branch.heads);
    level.heads.insert(level.heads.end(), branch.heads.begin(), branch.heads.end());
  }

  /// Joins the level and another element: in the gate that ends the level if it is free for that, else in a new one.
  void joinGate(DrawnLevel& level, Shape shape, std::uint32_t other) {
    const bool hasRoom = form_ == Form::Ladder || elements_[level.element].inputs.size() < maxGateInputs;
    std::vector<Wire> inputs = {{level.element, false}};
    if (level.mayExtend && elements_[level.element].shape == shape && hasRoom) {
      inputs = std::move(elements_[level.element].inputs);
      elements_[level.element].inputs.clear();  // replaced by the new gate
      replaced_.push_back(level.element);
    }
    inputs.push_back({other, false});
    level.element = add(shape, nullptr, {});
    elements_.back().inputs = std::move(inputs);
    level.mayExtend = true;
  }

  void joinSeries() {
    if (!has(2)) return;
    DrawnLevel block = std::move(levels_.back());
    levels_.pop_back();
    DrawnLevel& level = top();
    if (form_ == Form::Fbd) return joinGate(level, Shape::And, block.element);
    if (!block.isOpen || !block.isContacts) {
      return refuseHere("puts into series what is no plain group of contacts; a ladder cannot show it");
    }
    for (const std::uint32_t head : block.heads) elements_[head].inputs[0].from = level.element;
    level.element = block.element;
    level.mayExtend = false;
  }

  void transform() {
    if (!mayUseTop()) return;
    DrawnLevel& level = top();
    level.element = add(Shape::Contact, current().desc, {level.element});
    level.isContacts = level.mayExtend = false;
  }

  void copy() {
    if (!mayUseTop()) return;
    tap(top());
    push(top());
  }
  void restore(bool pops) {
    if (!has(2)) return;
    levels_.pop_back();
    if (!pops) {
      tap(top());
      levels_.push_back(top());
    }
  }

  void coil() {
    const Desc& desc = *current().desc;
    if (desc.eno) lastBox_ = 0;
    if (desc.stack.needs == 0) {
      add(Shape::Coil, &desc, {});
      return;
    }
    if (!mayUseTop()) return;
    add(Shape::Coil, &desc, {top().element});
    tap(top());
  }

  void box() {
    const Desc& desc = *current().desc;
    const std::size_t inputs = std::max<std::size_t>(desc.stack.needs, 1);
    if (!has(inputs)) return;
    std::vector<std::uint32_t> from;
    bool areOpen = true;
    for (std::size_t i = levels_.size() - inputs; i < levels_.size(); ++i) {
      from.push_back(levels_[i].element);
      areOpen = areOpen && levels_[i].isOpen;
    }
    const std::uint32_t element = add(Shape::Box, &desc, std::move(from));
    if (desc.stack.pops > 0) {  // SR, RS: the output is the new top
      levels_.resize(levels_.size() - desc.stack.pops);
      top() = {element, areOpen, false, false, {}};
      return;
    }
    boxDone(desc, element);
  }
  /// EN stays on the top; AENO may take the output.
  void boxDone(const Desc& desc, std::uint32_t element) {
    if (desc.eno) {
      lastBox_ = element;
      enabledBy_ = top().element;
      wasOpen_ = top().isOpen;
    }
    for (std::size_t i = levels_.size() - std::max<std::size_t>(desc.stack.needs, 1); i < levels_.size(); ++i)
      tap(levels_[i]);
    // In the rounds of the loop the top is 1, as it was in front of it (001:5770); what lies below is taken once only.
    if (desc.control == Control::For) loopLevels_ = levels_.size();
  }

  void eno() {
    if (!has(1)) return;
    DrawnLevel& level = top();
    if (lastBox_ == 0) return refuseHere("stands behind no box with ENO");
    if (level.element != enabledBy_) return refuseHere("joins ENO to the power flow of another circuit");
    level = {lastBox_, wasOpen_, false, false, {}};
  }

  // ---- CALL with flow inputs ------------------------------------------------------------------------

  void callStep(const Instruction& instruction) {
    switch (idiom_.roles[at_]) {
      case CallRole::StoreEnable: flows_.clear(); [[fallthrough]];
      case CallRole::StoreFlow:
        if (!mayUseTop()) return;
        flows_.push_back(top().element);
        if (flows_.size() == 1) enabled_ = top();
        tap(top());
        return;
      case CallRole::Recall: push(enabled_); return;
      default: break;
    }
    const std::uint32_t element = add(Shape::Box, instruction.desc, flows_);
    std::size_t open = flows_.size() - 1;
    for (std::size_t i = 1; i < elements_[element].operands.size() && open > 0; ++i) {
      Operand& operand = elements_[element].operands[i];
      if (operand.kind != OperandKind::Direct || operand.area != Area::L || operand.offset < 60) continue;
      operand.kind = OperandKind::Missing;
      --open;
    }
    boxDone(*instruction.desc, element);
  }

  // ---- The whole drawing ----------------------------------------------------------------------------

  std::vector<std::uint32_t> countUses() const {
    std::vector<std::uint32_t> uses(elements_.size(), 0);
    for (const Element& element : elements_) {
      for (const Wire& wire : element.inputs) ++uses[wire.from];
    }
    return uses;
  }

  static bool isNot(const Element& element) { return element.desc != nullptr && element.desc->role == Role::Not; }

  /// FBD shows NOT as a circle at the pin that it feeds (001:2249), if that is the only one and no NOT itself.
  void foldNegations() {
    const std::vector<std::uint32_t> uses = countUses();
    for (Element& element : elements_) {
      if (isNot(element)) continue;
      for (Wire& wire : element.inputs) {
        const Element& from = elements_[wire.from];
        if (uses[wire.from] != 1 || !isNot(from)) continue;
        replaced_.push_back(wire.from);
        wire = {from.inputs[0].from, true};
      }
    }
  }

  /// Leaves out the gates and negations that others replaced.
  void compact() {
    std::vector<std::uint32_t> place(elements_.size(), 0);
    for (const std::uint32_t element : replaced_) place[element] = noElement;
    std::uint32_t next = 0;
    for (std::uint32_t& entry : place) {
      if (entry != noElement) entry = next++;
    }
    drawing_.elements.reserve(next);
    for (std::uint32_t i = 0; i < elements_.size(); ++i) {
      if (place[i] == noElement) continue;
      for (Wire& wire : elements_[i].inputs) wire.from = place[wire.from];
      drawing_.elements.push_back(std::move(elements_[i]));
    }
    if (drawing_.elements.size() == 1) drawing_.elements.clear();  // an empty network
  }

  const Instruction* instructionOf(std::uint32_t element) const {
    const std::uint32_t position = drawing_.elements[element].instruction;
    return position == noInstruction ? nullptr : &network_.instructions[position];
  }

  void findOpenEnds() {
    std::vector<std::uint8_t> isUsed(drawing_.elements.size(), 0);
    for (const Element& element : drawing_.elements) {
      for (const Wire& wire : element.inputs) isUsed[wire.from] = 1;
    }
    for (std::uint32_t i = 1; i < drawing_.elements.size(); ++i) {
      const Element& element = drawing_.elements[i];
      if (isUsed[i] != 0 || element.shape == Shape::Box || element.shape == Shape::Coil) continue;
      return refuse(instructionOf(i), fmt::format("the branch of {} ends without a coil or box", nameOf(element)));
    }
  }

  void findPicture() {
    const Circuit circuit = circuitOf(drawing_);
    if (circuit.fault) return refuse(instructionOf(circuit.fault->element), circuit.fault->message);
    const Branches branches = lowerAlongBranches(drawing_, circuit, PinOrder::AsDrawn, editorBitsUsed(drawing_));
    result_.comparedAddresses = branches.comparedAddresses;
    if (branches.circuits > 1) {
      const Instruction* second = instructionOf(branches.second);
      return refuse(*second, beginsSecondRung);
    }
    if (branches.lowered.fault)
      return refuse(instructionOf(branches.lowered.fault->element), branches.lowered.fault->message);
  }

  const Network& network_;
  Form form_;
  CallIdiom idiom_;
  std::size_t stackLevels_;
  std::size_t at_ = 0;
  std::vector<Element> elements_;
  std::vector<std::uint32_t> replaced_;
  std::vector<DrawnLevel> levels_;
  std::uint32_t lastBox_ = 0;         ///< the box that set ENO last; 0: none in this network
  std::uint32_t enabledBy_ = 0;       ///< what fed it
  bool wasOpen_ = false;              ///< isOpen of that level before the box
  std::vector<std::uint32_t> flows_;  ///< EN and flow inputs stored for the next CALL
  DrawnLevel enabled_;
  Drawing drawing_;
  Raised result_;
  bool isLost_ = false;         ///< a level was pushed out
  std::size_t loopLevels_ = 0;  ///< levels there were at the last FOR; 0: none
  bool failed_ = false;
};

}  // namespace

std::string nameInReason(const Instruction& instruction) {
  std::string text(instruction.desc->stl);
  if (!instruction.operands.empty() && instruction.operands[0].kind != OperandKind::Missing)
    text += " " + toString(instruction.operands[0]);
  return text;
}

Raised raise(const Network& network, Form form, const Target& target) {
  const Dialect& dialect = dialectOf(target);
  switch (dialect.form) {
    case StatementForm::Rungs: return Raising(network, form, target).run();
    case StatementForm::Accumulators: return raiseStep7(network, form);
    case StatementForm::Expressions: break;
  }
  return {std::nullopt, fmt::format("statements of {} are not drawn", dialect.title), nullptr};
}

}  // namespace rungproof
