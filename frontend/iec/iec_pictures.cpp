// From the elements of a circuit to a drawing, backwards from its results.
#include "frontend/iec/iec_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "frontend/iec/iec_feedback.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof::iec {

namespace {

/// Functions whose pins are all alike: their names say nothing.
bool hasLikePins(std::string_view folded) {
  constexpr std::string_view alike[] = {"AND", "OR", "XOR", "NOT", "ADD", "MUL", "MAX", "MIN", "EQ", "NE", "CONCAT"};
  return std::ranges::find(alike, folded) != std::end(alike);
}

bool isLiteral(std::string_view text) {
  const std::string folded = foldedName(text);
  return folded == "TRUE" || folded == "FALSE" || folded.find('#') != std::string::npos || text.starts_with('\'') ||
         (!text.empty() && text.find_first_not_of("0123456789+-._eE") == std::string_view::npos);
}

class PictureMaker {
 public:
  PictureMaker(const DrawnCircuit& circuit, const std::function<bool(const DrawnElement&)>& isInstance, Form form)
      : circuit_(circuit), isInstance_(isInstance), table_(s7200Instructions()) {
    made_.form = form;
    made_.drawing.isOfVariables = true;
    made_.drawing.elements.emplace_back();  // the rail
  }

  std::shared_ptr<const CircuitPicture> run(const std::vector<int>& results) {
    own_.insert(results.begin(), results.end());
    std::uint32_t first = ~0U, end = 0;
    for (const int i : results) {
      const Span span = circuit_.element(i).span;
      first = std::min(first, span.offset);
      end = std::max(end, span.offset + span.length);
      made_.span = {span.file, first, end - first};
    }
    for (const int i : results) result(i);
    if (made_.drawing.elements.size() == 1 || isDeep_) made_.drawing.elements.clear();
    return std::make_shared<const CircuitPicture>(std::move(made_));
  }

 private:
  using At = ShownValue::At;
  using Part = ShownValue::Part;

  const DrawnElement& at(int i) const { return circuit_.element(i); }
  std::uint32_t add(Shape shape, const Desc* desc, std::vector<Wire> inputs, const DrawnElement& of) {
    Element element;
    element.shape = shape;
    element.desc = desc;
    element.inputs = std::move(inputs);
    element.span = of.span;
    made_.drawing.elements.push_back(std::move(element));
    return static_cast<std::uint32_t>(made_.drawing.elements.size() - 1);
  }
  void shows(std::uint32_t element, At how, Span span, std::string member = {}, Part part = Part::Whole,
             std::size_t pin = 0) {
    made_.values.push_back({part, how, element, static_cast<std::uint32_t>(pin), span.offset, std::move(member)});
  }
  /// Variables that the reader made stand for the condition of a transition, or for what a wire carried before.
  static std::string shownName(const std::string& text) {
    return text.starts_with(feedbackName) ? "value before" : text.starts_with("__") ? "condition" : text;
  }
  static Operand named(const std::string& text, Span span) {
    Operand operand;
    operand.kind = OperandKind::Symbol;
    operand.text = shownName(text);
    operand.span = span;
    return operand;
  }
  Wire inverted(Wire wire, const DrawnElement& of) {
    return {add(Shape::Contact, &table_.only(Role::Not), {wire}, of), false};
  }
  const Desc& edgeDesc(DrawnEdge edge) const { return table_.only(edge == DrawnEdge::Rising ? Role::Eu : Role::Ed); }

  /// A name at the rail: what is read there.
  Wire leaf(const std::string& text, const DrawnElement& of, At how, const std::string& member = {}) {
    const std::uint32_t made = add(Shape::Contact, &table_.bitContact(Role::Load), {{0, false}}, of);
    made_.drawing.elements[made].operands = {named(text, of.span)};
    shows(made, how, of.span, member);
    return {made, false};
  }

  /// What arrives at a pin; several lines are branches that meet.
  std::optional<Wire> arriving(int i, const DrawnPin& pin) {
    std::vector<Wire> wires;
    for (const DrawnLink& link : pin.links) {
      const int source = circuit_.sourceOf(link);
      if (source != DrawnCircuit::nothing) wires.push_back(leaving(source, link.pin));
    }
    if (wires.empty()) return std::nullopt;
    Wire wire = wires.size() == 1 ? wires[0] : Wire{add(Shape::Or, nullptr, wires, at(i)), false};
    if (pin.negated) wire.negated = !wire.negated;
    if (pin.edge != DrawnEdge::None) {
      const std::uint32_t edge = add(Shape::Contact, &edgeDesc(pin.edge), {wire}, at(i));
      shows(edge, At::Member, at(i).span, "Q");
      wire = {edge, false};
    }
    return wire;
  }
  Wire flowInto(int i) {
    const DrawnElement& element = at(i);
    return element.inputs.empty() ? Wire{} : arriving(i, element.inputs[0]).value_or(Wire{});
  }

  Wire leaving(int i, const std::string& pin) {
    if (++depth_ > 400) isDeep_ = true;
    const Wire wire = isDeep_ ? Wire{} : leavingOf(i, pin);
    --depth_;
    return wire;
  }
  Wire leavingOf(int i, const std::string& pin) {
    const DrawnElement& element = at(i);
    switch (element.kind) {
      case DrawnKind::Contact: return contact(i);
      case DrawnKind::Coil:
      case DrawnKind::Connector: return flowInto(i);
      case DrawnKind::InVariable:
      case DrawnKind::InOutVariable: {
        if (const auto known = contacts_.find(i); known != contacts_.end()) return known->second;
        Wire wire = leaf(element.text, element, At::FirstRead);
        wire.negated = element.negated && element.kind == DrawnKind::InVariable;
        return contacts_[i] = wire;
      }
      case DrawnKind::Continuation: {
        const int connector = circuit_.connectorOf(i);
        if (connector == DrawnCircuit::nothing || circuit_.isCut(connector))
          return leaf(element.text, element, At::FirstRead);
        return flowInto(connector);
      }
      case DrawnKind::Block: return output(i, pin);
      default: return {};
    }
  }

  Wire contact(int i) {
    if (const auto known = contacts_.find(i); known != contacts_.end()) return known->second;
    const DrawnElement& element = at(i);
    const Wire before = element.inputs.empty() ? Wire{} : flowInto(i);
    const bool isEdge = element.edge != DrawnEdge::None;
    const Desc& desc = isEdge ? edgeDesc(element.edge) : table_.bitContact(Role::Load, element.negated);
    const std::uint32_t made = add(Shape::Contact, &desc, {before}, element);
    made_.drawing.elements[made].operands = {named(element.text, element.span)};
    shows(made, isEdge ? At::LastRead : At::FirstRead, element.span);
    return contacts_[i] = {made, false};
  }

  const DrawnPin* outputPin(const DrawnElement& element, const std::string& pin) const {
    for (const DrawnPin& each : element.outputs) {
      if (each.name == pin || (pin.empty() && &each == &element.outputs.front())) return &each;
    }
    return nullptr;
  }

  /// The first output that something is wired to leaves the box as a wire; others are read by their names.
  Wire output(int i, const std::string& pin) {
    const DrawnElement& element = at(i);
    const DrawnPin* drawn = outputPin(element, pin);
    const std::string name = pin.empty() && drawn != nullptr ? drawn->name : pin;
    const bool isNegated = drawn != nullptr && drawn->negated;
    const bool isBlock = isInstance_(element);
    const bool isElsewhere = isBlock && (circuit_.isCut(i) || !own_.contains(i));
    if (!isElsewhere) {
      const std::uint32_t made = box(i);
      if (isOpen_.contains(i)) return {0, isNegated};  // it feeds itself
      auto& [wired, face] = boxes_.at(i);
      if (wired.empty() && !isBlock) wired = "=";
      if (wired.empty()) wired = foldedName(name);
      const bool isResult = !isBlock || wired == foldedName(name);
      if (isResult) {
        face->output = hasLikePins(foldedName(element.text)) || foldedName(name) == "OUT" ? std::string() : name;
        if (outputs_.insert(i).second)
          shows(made, At::Member, element.span, isBlock ? foldedName(name) : std::string());
        return {made, isNegated};
      }
    }
    const std::string text = fmt::format("{}.{}", isBlock ? element.instance : element.text, name);
    Wire wire = leaf(text, element, At::Member, foldedName(name));
    wire.negated = isNegated;
    return wire;
  }

  /// A pin whose text can stand beside it: its only line comes from a variable.
  const DrawnElement* textAt(const DrawnPin& pin) const {
    if (pin.negated || pin.edge != DrawnEdge::None || pin.links.size() != 1) return nullptr;
    const int source = circuit_.sourceOf(pin.links[0]);
    if (source == DrawnCircuit::nothing) return nullptr;
    const DrawnElement& element = at(source);
    const bool isPlain =
        (element.kind == DrawnKind::InVariable && !element.negated) ||
        (element.kind == DrawnKind::InOutVariable && (element.inputs.empty() || element.inputs[0].links.empty()));
    return isPlain ? &element : nullptr;
  }

  std::uint32_t box(int i) {
    if (const auto known = places_.find(i); known != places_.end()) return known->second;
    const DrawnElement& element = at(i);
    const bool isBlock = isInstance_(element);
    auto face = std::make_shared<BoxFace>();
    face->name = element.text;
    if (isBlock) face->instance = element.instance;
    const bool areAlike = hasLikePins(foldedName(element.text));
    isOpen_.insert(i);
    places_[i] = 0;
    boxes_[i] = {std::string(), face.get()};
    std::vector<Wire> wires;
    for (const DrawnPin& pin : element.inputs) {
      const std::string name = areAlike && foldedName(pin.name) != "EN" ? std::string() : pin.name;
      if (const DrawnElement* text = textAt(pin)) {
        face->left.push_back({name, shownName(text->text), isLiteral(text->text), text->span});
      } else if (!pin.links.empty()) {
        wires.push_back(arriving(i, pin).value_or(Wire{}));
        face->inputs.push_back(name);
      } else if (!pin.expression.empty()) {
        face->left.push_back({name, pin.expression, isLiteral(pin.expression), pin.span});
      }
    }
    isOpen_.erase(i);
    const std::uint32_t made = add(Shape::Box, nullptr, std::move(wires), element);
    places_[i] = made;
    for (std::size_t k = 0; k < face->left.size(); ++k) {
      if (!face->left[k].isConstant) shows(made, At::FirstRead, face->left[k].span, {}, Part::Left, k);
    }
    for (const DrawnPin& pin : element.outputs) outputText(i, made, pin, *face);
    made_.drawing.elements[made].face = std::move(face);
    return made;
  }

  /// A variable that alone takes an output stands beside it.
  void outputText(int i, std::uint32_t made, const DrawnPin& pin, BoxFace& face) {
    const auto add = [&](const std::string& text, Span span) {
      face.right.push_back({pin.name, text, false, span});
      shows(made, At::Stored, span, {}, Part::Right, face.right.size() - 1);
    };
    if (!pin.expression.empty()) return add(pin.expression, pin.span);
    const DrawnCircuit::Consumer* only = nullptr;
    for (const DrawnCircuit::Consumer& consumer : circuit_.consumersOf(i)) {
      const bool isHere = consumer.link->pin == pin.name || (consumer.link->pin.empty() && &pin == &at(i).outputs[0]);
      if (isHere && only != nullptr) return;
      if (isHere) only = &consumer;
    }
    if (only == nullptr || pin.negated || !own_.contains(only->element)) return;
    const DrawnElement& variable = at(only->element);
    const bool isPlain = variable.kind == DrawnKind::OutVariable && !variable.negated && only->pin->links.size() == 1 &&
                         !only->pin->negated;
    if (!isPlain) return;
    add(variable.text, variable.span);
    isBeside_.insert(only->element);
  }

  void result(int i) {
    const DrawnElement& element = at(i);
    switch (element.kind) {
      case DrawnKind::Block: box(i); return;
      case DrawnKind::Coil: return coil(i);
      case DrawnKind::OutVariable:
      case DrawnKind::InOutVariable: {
        const Wire wire = flowInto(i);
        if (isBeside_.contains(i)) return;
        const bool isNegated = element.negated && element.kind == DrawnKind::OutVariable;
        return coilOf(isNegated ? inverted(wire, element) : wire, table_.plainAssign(), element);
      }
      case DrawnKind::Jump:
      case DrawnKind::Return: {
        const Wire wire = element.negated ? inverted(flowInto(i), element) : flowInto(i);
        return coilOf(wire, table_.only(element.kind == DrawnKind::Jump ? Control::Jump : Control::ReturnConditional),
                      element);
      }
      case DrawnKind::Label: {
        const std::uint32_t made = add(Shape::Coil, &table_.only(Control::LabelMark), {}, element);
        made_.drawing.elements[made].operands = {named(element.text, element.span)};
        return;
      }
      default: return;
    }
  }
  void coil(int i) {
    const DrawnElement& element = at(i);
    Wire wire = flowInto(i);
    if (element.edge != DrawnEdge::None) {
      const std::uint32_t edge = add(Shape::Contact, &edgeDesc(element.edge), {wire}, element);
      shows(edge, At::Member, element.span, "Q");
      wire = {edge, false};
    }
    const bool isPlain = element.storage == DrawnStorage::None;
    if (isPlain && element.negated) wire = inverted(wire, element);
    const Desc& set = *table_.named("S");
    const Desc& reset = *table_.named("R");
    coilOf(wire, isPlain ? table_.plainAssign() : element.storage == DrawnStorage::Set ? set : reset, element);
  }
  void coilOf(Wire wire, const Desc& desc, const DrawnElement& element) {
    if (wire.negated) wire = inverted({wire.from, false}, element);
    const std::uint32_t made = add(Shape::Coil, &desc, {wire}, element);
    if (!element.text.empty()) made_.drawing.elements[made].operands = {named(element.text, element.span)};
    if (element.kind != DrawnKind::Jump && element.kind != DrawnKind::Return) shows(made, At::Stored, element.span);
  }

  struct BoxAt {
    std::string wired;  ///< the output that leaves it as a wire, in capitals
    BoxFace* face;
  };
  const DrawnCircuit& circuit_;
  const std::function<bool(const DrawnElement&)>& isInstance_;
  const InstructionTable& table_;
  CircuitPicture made_;
  std::set<int> own_;
  std::map<int, Wire> contacts_;
  std::map<int, std::uint32_t> places_;  ///< of boxes
  std::map<int, BoxAt> boxes_;
  std::set<int> outputs_, isBeside_, isOpen_;
  int depth_ = 0;
  bool isDeep_ = false;
};

}  // namespace

std::shared_ptr<const CircuitPicture> pictureOf(const DrawnCircuit& circuit, const std::vector<int>& results, Form form,
                                                const std::function<bool(const DrawnElement&)>& isInstance) {
  return PictureMaker(circuit, isInstance, form).run(results);
}

}  // namespace rungproof::iec
