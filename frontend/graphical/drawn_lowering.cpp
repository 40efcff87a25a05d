// Results, contacts, coils, variables, values.
#include "frontend/graphical/drawn_lowering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "frontend/graphical/drawn_blocks.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "ir/check.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {

namespace {

/// Elements in a row that are still followed; far more than fit a page.
constexpr int deepestRow = 400;

}  // namespace

Wire DrawnLowering::add(Shape shape, std::string_view mnemonic, Operands operands, std::vector<Wire> inputs) {
  Element element;
  element.shape = shape;
  element.span = circuit_->element(current_).span;
  if (!mnemonic.empty()) {
    element.desc = s7200Instructions().named(mnemonic);
    CHECK(element.desc != nullptr, "a drawing is made of instructions of the table");
  }
  for (Operand& operand : operands) operand.span = element.span;
  element.operands = std::move(operands);
  element.inputs = std::move(inputs);
  drawing_.elements.push_back(std::move(element));
  owner_.push_back(current_);
  return {static_cast<std::uint32_t>(drawing_.elements.size() - 1), false};
}

Wire DrawnLowering::contact(const Operand& bit, Wire input) { return add(Shape::Contact, "LD", {bit}, {input}); }
Wire DrawnLowering::compare(std::string_view mnemonic, const Operand& a, const Operand& b, Wire input) {
  return add(Shape::Contact, mnemonic, {a, b}, {input});
}
Wire DrawnLowering::box(std::string_view mnemonic, Operands operands, Wire enable) {
  return add(Shape::Box, mnemonic, std::move(operands), {enable});
}

/// The memory of an edge starts with 0, so there may be one in the first scan, in which EU and ED see none (001:2763):
/// R_TRIG and P with 1; F_TRIG and N, which keep the negated value, with 0.
Wire DrawnLowering::edge(Wire input, DrawnEdge kind) {
  if (kind == DrawnEdge::None) return input;
  const Wire now = throughMemory(kind == DrawnEdge::Rising ? input : inverted(input));
  const Operand last = temporary(IecType::Bool);
  const Wire before = contact(last, rail());
  const Wire found = throughMemory(gate(Shape::And, {now, inverted(before)}));
  assign(last, now);
  return found;
}

Wire DrawnLowering::negation(Wire wire) {
  if (wire.from == 0 || wire.from != fresh_ || wire.negated) return inverted(wire);
  Element& element = drawing_.elements[wire.from];
  element.desc = s7200Instructions().negatedForm(*element.desc);
  fresh_ = 0;
  return wire;
}

Wire DrawnLowering::gate(Shape shape, std::vector<Wire> inputs) {
  const bool isAnd = shape == Shape::And;
  std::vector<Wire> kept;
  for (const Wire wire : inputs) {
    if (isAnd ? isFalse(wire) : isTrue(wire)) return wire;
    if (!(isAnd ? isTrue(wire) : isFalse(wire))) kept.push_back(wire);
  }
  if (kept.empty()) return inputs.empty() ? rail() : inputs.front();
  if (kept.size() == 1) return kept.front();
  return add(shape, "", {}, std::move(kept));
}

std::vector<std::uint32_t> DrawnLowering::seriesOf(Wire wire) const {
  std::vector<std::uint32_t> series;
  while (wire.from != 0 && !wire.negated) {
    series.push_back(wire.from);
    const Element& element = drawing_.elements[wire.from];
    if (element.shape != Shape::Contact || element.inputs.size() != 1) break;
    wire = element.inputs[0];
  }
  std::reverse(series.begin(), series.end());
  return series;
}

Wire DrawnLowering::parallel(std::vector<Wire> wires, std::size_t shared) {
  if (wires.size() < 3) return gate(Shape::Or, std::move(wires));
  std::vector<std::pair<std::uint32_t, std::vector<Wire>>> groups;  // by the element behind the shared beginning
  for (const Wire wire : wires) {
    const std::vector<std::uint32_t> series = seriesOf(wire);
    const std::uint32_t at = shared < series.size() ? series[shared] : 0;
    const auto found =
        std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group.first == at && at != 0; });
    if (found == groups.end())
      groups.push_back({at, {wire}});
    else
      found->second.push_back(wire);
  }
  if (groups.size() == wires.size()) return gate(Shape::Or, std::move(wires));
  std::vector<Wire> joined;
  for (auto& [at, members] : groups)
    joined.push_back(members.size() == 1 ? members.front() : parallel(std::move(members), shared + 1));
  return gate(Shape::Or, std::move(joined));
}

Operand DrawnLowering::temporary(IecType type) {
  const auto place = build_.temporary(type);
  return place ? *place : direct(Area::V, widthOf(type), 0);
}

Wire DrawnLowering::throughMemory(Wire input) {
  const Operand bit = temporary(IecType::Bool);
  assign(bit, input);
  return contact(bit, rail());
}

DrawnValue DrawnLowering::power(Wire wire) { return {DrawnValue::Kind::Power, wire, {}, IecType::Bool}; }
DrawnValue DrawnLowering::data(Operand operand, IecType type) {
  return {DrawnValue::Kind::Data, {}, std::move(operand), type};
}

DrawnValue DrawnLowering::literalValue(const IecLiteral& literal) const {
  if (literal.type == IecType::Bool) return power({0, literal.value == 0});
  const ConstantForm form = literal.type == IecType::Real ? ConstantForm::Real : ConstantForm::Decimal;
  return data(constant(literal.value, form), literal.type);
}

DrawnValue DrawnLowering::readPlace(const VariablePlace& place, const DrawnElement& element) {
  if (place.constant) return literalValue(*place.constant);
  if (place.copy != nullptr) {
    sink_.operand(element, "an instance of a function block has no value of its own; name one of its outputs");
    return {};
  }
  if (place.type == IecType::Bool) {
    const Wire wire = contact(place.operand, rail());
    fresh_ = wire.from;
    return power(wire);
  }
  return data(place.operand, place.type);
}

std::optional<VariablePlace> DrawnLowering::memberOf(DrawnCopy& copy, std::string_view pin) {
  const auto found = copy.places.find(foldedName(pin));
  if (found == copy.places.end()) return std::nullopt;
  return found->second;
}

std::optional<VariablePlace> DrawnLowering::resolve(std::string_view text, const DrawnElement& element) {
  text = trimmed(text);
  if (text.empty()) {
    sink_.operand(element, "the operand is left open");
    return std::nullopt;
  }
  if (const auto literal = iecLiteral(text)) {
    VariablePlace place;
    place.type = literal->type;
    place.constant = literal;
    return place;
  }
  if (text[0] == '%') {
    const auto address = locatedAddress(text);
    if (!address) {
      sink_.operand(element, fmt::format("{} is no address of the S7-200", excerpt(text)));
      return std::nullopt;
    }
    const bool isBit = address->width == Width::Bit;
    return VariablePlace{isBit                           ? IecType::Bool
                         : address->width == Width::Byte ? IecType::Byte
                         : address->width == Width::Word ? IecType::Word
                                                         : IecType::Dword,
                         *address, std::nullopt, nullptr};
  }
  if (const VariablePlace* whole = build_.lookUp(copy_, text)) return *whole;
  // The longest beginning that is an instance, then its pins; names of data blocks have points of their own.
  for (std::size_t point = text.rfind('.'); point != std::string_view::npos && point > 0;
       point = text.rfind('.', point - 1)) {
    const VariablePlace* first = build_.lookUp(copy_, text.substr(0, point));
    if (first == nullptr || first->copy == nullptr) continue;
    DrawnCopy* at = first->copy;
    const std::string_view instance = text.substr(0, point);
    std::string_view rest = text.substr(point + 1);
    while (at != nullptr) {
      point = rest.find('.');
      const std::optional<VariablePlace> member = memberOf(*at, rest.substr(0, point));
      if (!member) break;
      if (point == std::string_view::npos) return member;
      at = member->copy;
      rest = rest.substr(point + 1);
    }
    sink_.operand(element, fmt::format("{} has no output {} that is kept", instance, excerpt(rest)));
    return std::nullopt;
  }
  const bool isName = std::all_of(text.begin(), text.end(), [](char c) {
    return isLetter(c) || isDigit(c) || c == '_' || c == '.' || (static_cast<unsigned char>(c) & 0x80) != 0;
  });
  sink_.operand(element, isName ? fmt::format("{} is not declared", excerpt(text))
                                : fmt::format("\"{}\" is neither a variable nor a constant that the S7-200 can hold",
                                              excerpt(text)));
  return std::nullopt;
}

DrawnValue DrawnLowering::expression(std::string_view text, const DrawnElement& element) {
  const std::optional<VariablePlace> place = resolve(text, element);
  return place ? readPlace(*place, element) : DrawnValue{};
}

DrawnValue DrawnLowering::input(const DrawnElement& element, const DrawnPin& pin) {
  DrawnValue value;
  if (pin.links.size() > 1) {
    std::vector<Wire> wires;
    for (const DrawnLink& link : pin.links) {
      const int from = circuit_->sourceOf(link);
      if (from == DrawnCircuit::nothing) return {};
      const DrawnValue one = outputOf(from, link.pin, element);
      if (one.kind == DrawnValue::Kind::Nothing) return {};
      if (!one.isPower()) {
        sink_.circuit(element, "lines that carry numbers cannot be joined");
        return {};
      }
      wires.push_back(one.wire);
    }
    value = power(parallel(std::move(wires), 0));
  } else if (pin.links.size() == 1) {
    const int from = circuit_->sourceOf(pin.links[0]);
    if (from == DrawnCircuit::nothing) return {};
    value = outputOf(from, pin.links[0].pin, element);
  } else if (!pin.expression.empty()) {
    value = expression(pin.expression, element);
  }
  if (pin.negated || pin.edge != DrawnEdge::None) {
    if (value.isData()) {
      sink_.negation(element,
                     fmt::format("the circle or edge sign at {} stands on a pin that is not Boolean", pin.name));
      return {};
    }
    if (value.isPower()) {
      if (pin.negated) value.wire = negation(value.wire);
      fresh_ = 0;
      value.wire = edge(value.wire, pin.edge);
    }
  }
  return value;
}

std::optional<Wire> DrawnLowering::powerAt(const DrawnElement& element, const DrawnPin* pin, std::string_view name) {
  if (pin == nullptr || (pin->links.empty() && pin->expression.empty())) {
    sink_.operand(element, fmt::format("input {} is left open", name));
    return std::nullopt;
  }
  const DrawnValue value = input(element, *pin);
  if (value.isPower()) return value.wire;
  if (value.isData() && value.operand.kind == OperandKind::Constant &&
      (value.operand.value == 0 || value.operand.value == 1))
    return Wire{0, value.operand.value == 0};
  if (value.isData())
    sink_.operand(element, fmt::format("input {} is BOOL, but gets {}", name, iecTypeName(value.type)));
  return std::nullopt;
}

std::optional<Wire> DrawnLowering::joinedInput(const DrawnElement& element) {
  if (element.inputs.empty() || (element.inputs[0].links.empty() && element.inputs[0].expression.empty())) {
    sink_.circuit(element, "nothing is connected at its left side");
    return std::nullopt;
  }
  const DrawnValue value = input(element, element.inputs[0]);
  if (value.isPower()) return value.wire;
  if (value.isData())
    sink_.circuit(element, fmt::format("it needs power flow, but the line carries {}",
                                       value.type == IecType::None ? "a number" : iecTypeName(value.type)));
  return std::nullopt;
}

DrawnValue DrawnLowering::outputOf(int i, std::string_view pin, const DrawnElement& asker) {
  const DrawnElement& e = circuit_->element(i);
  switch (e.kind) {
    case DrawnKind::LeftRail: return power(rail());
    case DrawnKind::InVariable: {
      State& state = states_[static_cast<std::size_t>(i)];
      if (e.readsOnce && !state.outputs.empty()) return state.outputs.front().second;
      DrawnValue value = expression(e.text, asker);
      if (e.negated) {
        if (value.isPower())
          value.wire = negation(value.wire);
        else if (value.isData()) {
          sink_.negation(e, "the negation stands on a value that is not Boolean");
          return {};
        }
      }
      if (e.readsOnce) fresh_ = 0;
      if (e.readsOnce && value.isPower()) state.outputs.emplace_back("", value);
      return value;
    }
    case DrawnKind::Continuation: {
      const int connector = circuit_->connectorOf(i);
      if (connector == DrawnCircuit::nothing) return {};
      if (circuit_->isCut(connector)) {
        Operand& bit = connectorBits_[static_cast<std::size_t>(connector)];
        if (bit.kind == OperandKind::Missing) bit = temporary(IecType::Bool);
        return power(contact(bit, rail()));
      }
      return e.id == circuit_->element(connector).id || !evaluate(connector)
                 ? DrawnValue{}
                 : states_[static_cast<std::size_t>(connector)].outputs.front().second;
    }
    case DrawnKind::InOutVariable:
      if (!e.inputs.empty() && !e.inputs[0].links.empty()) result(i);
      return expression(e.text, e);
    case DrawnKind::Contact:
    case DrawnKind::Coil:
    case DrawnKind::Connector:
    case DrawnKind::Block: break;
    default: sink_.circuit(asker, fmt::format("a line comes from the {}, which gives no power", nameOf(e))); return {};
  }
  if (e.kind == DrawnKind::Block && circuit_->isCut(i)) {
    const VariablePlace* instance = build_.lookUp(copy_, e.instance);
    std::optional<VariablePlace> place = instance != nullptr && instance->copy != nullptr
                                             ? memberOf(*instance->copy, pin.empty() ? "Q" : pin)
                                             : std::nullopt;
    if (!place && (pin.empty() || foldedName(pin) == "ENO")) {
      sink_.circuit(asker, "the loop runs through an output that is not kept from scan to scan");
      return {};
    }
    if (!place) {
      sink_.circuit(asker, fmt::format("{} has no output {}", nameOf(e), excerpt(pin)));
      return {};
    }
    DrawnValue value = readPlace(*place, asker);
    for (const DrawnPin& out : e.outputs) {
      if (foldedName(out.name) == foldedName(pin) && out.negated && value.isPower()) value.wire = inverted(value.wire);
    }
    return value;
  }
  if (!evaluate(i)) return {};
  if (e.kind != DrawnKind::Block) pin = {};  // some editors name the only output
  const State& state = states_[static_cast<std::size_t>(i)];
  const std::string name = foldedName(pin);
  for (const auto& [output, value] : state.outputs) {
    if (output != name && (!name.empty() || output == "ENO")) continue;
    DrawnValue taken = value;
    // Of the other outputs the values are negated already; ENO stays as what the block is enabled by.
    const auto isNegatedEnable = [](const DrawnPin& out) { return out.negated && foldedName(out.name) == "ENO"; };
    const bool isNegated = output == "ENO" && std::any_of(e.outputs.begin(), e.outputs.end(), isNegatedEnable);
    if (isNegated) taken.wire = inverted(taken.wire);
    return taken;
  }
  if (!state.outputs.empty() && name.empty()) return state.outputs.front().second;
  sink_.circuit(asker,
                fmt::format("{} has no output {}", nameOf(e), pin.empty() ? "that could be meant" : excerpt(pin)));
  return {};
}

bool DrawnLowering::evaluate(int i) {
  State& state = states_[static_cast<std::size_t>(i)];
  if (state.isDone) return !state.outputs.empty() || circuit_->element(i).kind == DrawnKind::Block;
  if (state.isBusy || circuit_->isInLoop(i)) return false;
  const DrawnElement& e = circuit_->element(i);
  if (depth_ > deepestRow) {
    sink_.circuit(e, fmt::format("more than {} elements stand in a row", deepestRow));
    state.isDone = true;
    return false;
  }
  const int before = std::exchange(current_, i);
  ++depth_;
  state.isBusy = true;
  bool isGood = false;
  if (e.kind == DrawnKind::Contact) isGood = evaluateContact(i, e);
  if (e.kind == DrawnKind::Block) isGood = block(i, e);
  if (e.kind == DrawnKind::Coil) {
    result(i);
    isGood = !states_[static_cast<std::size_t>(i)].outputs.empty();
  }
  if (e.kind == DrawnKind::Connector) {
    const DrawnValue value = e.inputs.empty() ? DrawnValue{} : input(e, e.inputs[0]);
    fresh_ = 0;
    isGood = value.kind != DrawnValue::Kind::Nothing;
    if (isGood) states_[static_cast<std::size_t>(i)].outputs.emplace_back("", value);
  }
  states_[static_cast<std::size_t>(i)].isBusy = false;
  states_[static_cast<std::size_t>(i)].isDone = true;
  --depth_;
  current_ = before;
  return isGood;
}

bool DrawnLowering::evaluateContact(int i, const DrawnElement& e) {
  const std::optional<Wire> left = joinedInput(e);
  if (!left) return false;
  current_ = i;
  const std::optional<VariablePlace> place = resolve(e.text, e);
  if (!place) return false;
  if (place->type != IecType::Bool || place->copy != nullptr) {
    sink_.operand(e, fmt::format("a contact needs BOOL, {} is {}", excerpt(e.text),
                                 place->copy != nullptr ? "an instance" : iecTypeName(place->type)));
    return false;
  }
  Wire wire;
  if (place->constant) {
    const bool isOn = (place->constant->value != 0) != e.negated;
    wire = isOn ? *left : Wire{0, true};
  } else if (e.edge != DrawnEdge::None) {
    Wire found = add(Shape::Contact, e.negated ? "LDN" : "LD", {place->operand}, {rail()});
    found = edge(found, e.edge);
    wire = gate(Shape::And, {*left, found});
  } else {
    wire = add(Shape::Contact, e.negated ? "LDN" : "LD", {place->operand}, {*left});
  }
  states_[static_cast<std::size_t>(i)].outputs.emplace_back("", power(wire));
  return true;
}

void DrawnLowering::coilOf(const DrawnElement& e) {
  const std::optional<Wire> left = joinedInput(e);
  if (!left) return;
  states_[static_cast<std::size_t>(current_)].outputs.emplace_back("", power(*left));
  const std::optional<VariablePlace> place = resolve(e.text, e);
  if (!place) return;
  if (place->type != IecType::Bool || place->constant || place->copy != nullptr) {
    return sink_.operand(e, fmt::format("a coil needs a BOOL variable, {} is {}", excerpt(e.text),
                                        place->constant ? "a constant" : iecTypeName(place->type)));
  }
  Wire wire = edge(*left, e.edge);
  if (e.negated) wire = inverted(wire);
  if (e.storage == DrawnStorage::None) return assign(place->operand, wire);
  coil(e.storage == DrawnStorage::Set ? "S" : "R", {place->operand, constant(1)}, wire);
}

void DrawnLowering::outVariable(int i, const DrawnElement& e) {
  if (states_[static_cast<std::size_t>(i)].isWritten) return;
  if (e.inputs.empty() || (e.inputs[0].links.empty() && e.inputs[0].expression.empty()))
    return sink_.circuit(e, "nothing is connected at its left side");
  DrawnValue value = input(e, e.inputs[0]);
  current_ = i;
  if (states_[static_cast<std::size_t>(i)].isWritten || value.kind == DrawnValue::Kind::Nothing) return;
  const std::optional<VariablePlace> place = resolve(e.text, e);
  if (!place) return;
  if (e.negated && value.isPower()) value.wire = inverted(value.wire);
  if (e.negated && value.isData()) return sink_.negation(e, "the negation stands on a value that is not Boolean");
  if (e.storage != DrawnStorage::None) {
    const bool isBit = value.isPower() && place->type == IecType::Bool && !place->constant && place->copy == nullptr;
    if (!isBit) return sink_.operand(e, "S and R of a variable need a BOOL");
    return coil(e.storage == DrawnStorage::Set ? "S" : "R", {place->operand, constant(1)}, value.wire);
  }
  Wire enable = rail();
  // A number computed under EN is passed on under the same EN.
  if (value.isData() && e.inputs[0].links.size() == 1) {
    const int from = circuit_->sourceOf(e.inputs[0].links[0]);
    for (const auto& [name, output] : states_[static_cast<std::size_t>(from)].outputs) {
      if (name == "ENO" && output.isPower()) enable = output.wire;
    }
  }
  moveTo(*place, value, enable, e);
}

void DrawnLowering::connector(int i, const DrawnElement& e) {
  if (e.inputs.empty()) return sink_.circuit(e, "nothing is connected at its left side");
  const std::optional<Wire> value = joinedInput(e);
  if (!value) return;
  Operand& bit = connectorBits_[static_cast<std::size_t>(i)];
  if (bit.kind == OperandKind::Missing) bit = temporary(IecType::Bool);
  current_ = i;
  assign(bit, *value);
}

int DrawnLowering::labelNumber(const std::string& name) {
  const auto [found, isNew] = labels_.emplace(foldedName(name), 0);
  if (isNew) found->second = build_.newLabel();
  return found->second;
}

void DrawnLowering::jump(const DrawnElement& e) {
  const std::optional<Wire> flow = joinedInput(e);
  if (!flow) return;
  coil("JMP", {constant(labelNumber(e.text))}, *flow);
}

void DrawnLowering::result(int i) {
  const DrawnElement& e = circuit_->element(i);
  State& state = states_[static_cast<std::size_t>(i)];
  if (e.kind != DrawnKind::Block && e.kind != DrawnKind::Coil) {
    if (state.isDone) return;
    state.isDone = true;
  } else if (state.isDone) {
    return;
  }
  const int before = std::exchange(current_, i);
  switch (e.kind) {
    case DrawnKind::Coil:
      state.isDone = true;
      coilOf(e);
      break;
    case DrawnKind::OutVariable:
    case DrawnKind::InOutVariable: outVariable(i, e); break;
    case DrawnKind::Connector: connector(i, e); break;
    case DrawnKind::Jump: jump(e); break;
    case DrawnKind::Label: add(Shape::Coil, "LBL", {constant(labelNumber(e.text))}, {}); break;
    case DrawnKind::Return:
      if (const std::optional<Wire> flow = joinedInput(e)) coil(pou_.kind == PouKind::Main ? "END" : "CRET", {}, *flow);
      break;
    case DrawnKind::Block: evaluate(i); break;
    default: break;
  }
  current_ = before;
}

}  // namespace rungproof
