// Questions about parts, and what is wrong with them.
#include "frontend/flgnet/circuit_pins.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::flgnet {

namespace {

using s7300::BoxFrame;
using s7300::FbdBox;
using step7::OperandForm;

bool isConstant(const Pin& pin) { return pin.source == Pin::Source::Value && pin.value.form == OperandForm::Constant; }

}  // namespace

std::string inSmallLetters(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

Element CircuitPins::elementOf(std::size_t i) const {
  const ElementPart* row = elementPart(part(i).name);
  return row == nullptr ? Element::None : row->element;
}

bool CircuitPins::isGate(std::size_t i) const {
  const Element element = elementOf(i);
  return element == Element::And || element == Element::Or || element == Element::Xor;
}

bool CircuitPins::isTimerOrCounter(std::size_t i) const {
  const FbdBox* row = box(i);
  return row != nullptr && (row->frame == BoxFrame::Timer || row->frame == BoxFrame::Counter);
}

std::vector<std::string> CircuitPins::inputPins(std::size_t i) const {
  switch (elementOf(i)) {
    case Element::Contact:
    case Element::Coil:
    case Element::SetCoil:
    case Element::ResetCoil: return {"in", "operand"};
    case Element::EdgeContact:
    case Element::EdgeCoil: return {"in", "operand", "bit"};
    case Element::Not:
    case Element::Return: return {"in"};
    case Element::EdgeBox: return {"in", "bit"};
    case Element::SetReset: return {"s", "r1", "operand"};
    case Element::ResetSet: return {"r", "s1", "operand"};
    case Element::Jump:
    case Element::JumpNot: return {"in", "label"};
    default: break;
  }
  std::vector<std::string> pins;
  if (isGate(i)) {
    // A number that no drawing can mean shows in the first pins that are open.
    const std::size_t most = part(i).inputs.size() + 16;
    for (std::size_t k = 1; k <= std::min(std::max<std::size_t>(part(i).cardinality, 2), most); ++k)
      pins.push_back(fmt::format("in{}", k));
    return pins;
  }
  if (isCompare(i)) return {"pre", "in1", "in2"};
  const FbdBox* row = box(i);
  if (row == nullptr) return pins;
  for (const std::string& pin : s7300::pinsOf(*row)) pins.push_back(inSmallLetters(pin));
  if (jumps(i)) pins.emplace_back(enablePin);
  return pins;
}

std::vector<std::string_view> CircuitPins::outputPins(std::size_t i) const {
  const FbdBox* row = box(i);
  if (row == nullptr) return {flowOutput(i)};
  if (row->frame == BoxFrame::Timer) return {"q", "bi", "bcd"};
  if (row->frame == BoxFrame::Counter) return {"q", "cv", "cv_bcd"};
  const std::string_view result = part(i).name == "Move" ? "out1" : "out";
  return part(i).hasEno ? std::vector{result, enabledPin} : std::vector{result};
}

std::vector<std::string> CircuitPins::neededPins(std::size_t i) const {
  const Element element = elementOf(i);
  if (element == Element::Contact) return {"operand"};
  if (element == Element::EdgeContact) return {"operand", "bit"};
  if (element == Element::SetReset || element == Element::ResetSet) return {"operand"};
  if (element != Element::None) return inputPins(i);
  if (isCompare(i)) return {"in1", "in2"};
  const FbdBox* row = box(i);
  if (row == nullptr || row->frame == BoxFrame::Counter) return {};
  if (row->frame == BoxFrame::Timer) return {"s", "tv"};
  std::vector<std::string> pins = inputPins(i);
  std::erase_if(pins, [](const std::string& pin) { return pin == "out" || pin == enablePin; });
  return pins;
}

bool CircuitPins::isValuePin(std::size_t i, std::string_view pin) const {
  if (isCall(i) || isGate(i)) return false;
  if (elementOf(i) != Element::None) return pin == "operand" || pin == "bit" || pin == "label";
  if (isCompare(i)) return pin != "pre";
  return isTimerOrCounter(i) ? pin == "tv" || pin == "pv" : pin != enablePin;
}

std::string_view CircuitPins::flowOutput(std::size_t i) const {
  const Element element = elementOf(i);
  if (element == Element::SetReset || element == Element::ResetSet) return "q";
  if (element != Element::None || isCompare(i)) return "out";
  return jumps(i) ? enabledPin : std::string_view("q");
}

bool CircuitPins::isLeading(std::size_t i, std::string_view pin) const {
  return !isGate(i) && (isCall(i) ? pin == enablePin : !isValuePin(i, pin));
}

bool CircuitPins::isTrue(const Pin& pin) {
  const bool isWritten = isConstant(pin) && pin.value.constant.kind == s7300::ConstantKind::Boolean;
  return pin.source == Pin::Source::Rail || (isWritten && pin.value.constant.value == 1);
}

std::vector<CircuitPins::Fault> CircuitPins::faults() const {
  std::vector<Fault> found;
  for (std::size_t i = 0; i < size(); ++i) check(i, found);
  return found;
}

void CircuitPins::check(std::size_t i, std::vector<Fault>& faults) const {
  const Part& p = part(i);
  const auto add = [&](std::string message) { faults.push_back({i, std::move(message)}); };
  if (!isCall(i)) checkInputs(i, faults);
  const bool negatesOperand = elementOf(i) == Element::Contact || elementOf(i) == Element::Coil;
  for (const std::string& pin : p.negated) {
    const Pin* input = p.input(pin);
    const bool isFlow = pin == "operand" ? negatesOperand : input != nullptr && !isValuePin(i, pin);
    if (!isFlow) add(fmt::format("a negation stands at {}, which is no input of the flow", excerpt(pin)));
    if (isFlow && input != nullptr && isTrue(*input)) add(fmt::format("the negation at {} is not covered", pin));
  }
  const std::vector<std::string_view> outputs = outputPins(i);
  for (const Output& output : p.outputs) {
    if (!isCall(i) && std::ranges::find(outputs, output.name) == outputs.end())
      add(fmt::format("output {} is not covered", excerpt(output.name)));
    if (output.readers > 0 && !isCall(i) && output.name != flowOutput(i))
      add(fmt::format("the value at {} goes to another part without an operand", excerpt(output.name)));
  }
  const bool needsInstance = isTimerOrCounter(i) || !iecBlock(p.name).empty();
  if (needsInstance && p.instance.form == OperandForm::None) add("no instance is given");
}

void CircuitPins::checkInputs(std::size_t i, std::vector<Fault>& faults) const {
  const Part& p = part(i);
  const auto add = [&](std::string message) { faults.push_back({i, std::move(message)}); };
  const std::vector<std::string> pins = inputPins(i);
  const std::set<std::string_view> known(pins.begin(), pins.end());
  for (const Pin& pin : p.inputs) {
    if (!known.contains(pin.name)) add(fmt::format("pin {} is not covered", excerpt(pin.name)));
    const bool isValue = isValuePin(i, pin.name);
    if (isValue && pin.source != Pin::Source::Value) add(fmt::format("pin {} needs an operand", excerpt(pin.name)));
    if (!isValue && isConstant(pin) && !isTrue(pin)) add(fmt::format("the constant at {} is not covered", pin.name));
  }
  for (const std::string& pin : neededPins(i)) {
    if (p.input(pin) == nullptr) add(fmt::format("pin {} is open", pin));
  }
  if (p.cardinality > 2 && !isGate(i)) add("more than two inputs are not covered");
  const FbdBox* row = box(i);
  if (row != nullptr && row->frame == BoxFrame::Counter && (p.input("s") != nullptr) != (p.input("pv") != nullptr))
    add("s and pv belong together");
}

}  // namespace rungproof::flgnet
