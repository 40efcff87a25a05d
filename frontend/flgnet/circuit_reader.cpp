// Accesses, parts, wires.
#include "frontend/flgnet/circuit_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "frontend/flgnet/access_reader.hpp"
#include "frontend/flgnet/circuit_pins.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/xml/xml_shape.hpp"

namespace rungproof::flgnet {

namespace {

constexpr XmlShape circuitShapes[] = {
    {"FlgNet", "", "Labels Parts Wires"},
    {"Labels", "", "LabelDeclaration"},
    {"LabelDeclaration", "UId", "Label Comment"},
    {"Label", "Name UId", ""},
    {"Parts", "", "Access Part Call"},
    {"Access",
     "UId Type "
     "Scope:LocalVariable|GlobalVariable|LiteralConstant|TypedConstant|LocalConstant|GlobalConstant|Address|Label",
     "Symbol Constant Address Label Comment"},
    {"Symbol", "UId", "Component Address"},
    {"Component", "Name UId AccessModifier:None|Array SimpleAccessModifier:None SliceAccessModifier:undef", "Access"},
    {"Constant", "Name UId", "ConstantType ConstantValue StringAttribute"},
    {"Part", "Name UId Version DisabledENO:b", "TemplateValue Negated Instance AutomaticTyped Invisible Comment"},
    {"Negated", "Name", ""},
    {"TemplateValue", "Name Type:Cardinality|Type|Operation|Function|String", ""},
    {"Instance", "Scope:LocalVariable|GlobalVariable UId", "Component Address"},
    {"Call", "UId", "CallInfo Comment"},
    {"CallInfo", "Name UId BlockType:FC|FB", "Instance Parameter IntegerAttribute DateAttribute"},
    {"Wires", "", "Wire"},
    {"Wire", "UId Name", "Powerrail IdentCon NameCon OpenCon"},
    {"Powerrail", "UId", ""},
    {"IdentCon", "UId", ""},
    {"NameCon", "UId Name", ""},
    {"OpenCon", "UId", ""},
};

class CircuitReader {
 public:
  CircuitReader(const XmlText& xml, const XmlText::Part& part, SyntaxSink& sink)
      : xml_(xml), part_(part), sink_(sink) {}

  std::optional<Circuit> read(const pugi::xml_node& net) {
    circuit_.span = xml_.span(part_, net);
    for (const ShapeFault& found : faultsOf(net, circuitShapes)) fault(found.node, found.message);
    for (const pugi::xml_node& label : childNamed(net, "Labels").children()) {
      if (localName(label) == "LabelDeclaration")
        circuit_.labels.push_back({childNamed(label, "Label").attribute("Name").value(), xml_.span(part_, label)});
    }
    for (const pugi::xml_node& node : childNamed(net, "Parts").children()) {
      if (node.type() == pugi::node_element) part(node);
    }
    for (const pugi::xml_node& wire : childNamed(net, "Wires").children()) {
      if (localName(wire) == "Wire") readWire(wire);
    }
    return isDamaged_ ? std::nullopt : std::optional(std::move(circuit_));
  }

 private:
  void fault(const pugi::xml_node& node, std::string message) {
    sink_.report(Syntax::XmlStructure, xml_.span(part_, node), std::move(message));
    isDamaged_ = true;
  }

  void part(const pugi::xml_node& node) {
    const std::string_view kind = localName(node);
    const std::string id = node.attribute("UId").value();
    if (kind == "Access") {
      if (std::optional<Operand> operand = access(node)) accesses_.emplace(id, std::move(*operand));
      return;
    }
    Part result;
    result.span = xml_.span(part_, node);
    if (kind == "Call")
      call(node, result);
    else
      shape(node, result);
    index_.emplace(id, circuit_.parts.size());
    circuit_.parts.push_back(std::move(result));
  }

  std::optional<Operand> access(const pugi::xml_node& node) {
    std::optional<Operand> operand = accessFrom(node, xml_.span(part_, node));
    if (!operand) fault(node, "the operand cannot be read");
    return operand;
  }

  void call(const pugi::xml_node& node, Part& result) {
    const pugi::xml_node info = childNamed(node, "CallInfo");
    result.callee = step7::BlockName{std::nullopt, 0, info.attribute("Name").value(), result.span};
    if (result.callee->symbol.empty()) fault(node, "the call names no block");
    const pugi::xml_node instance = childNamed(info, "Instance");
    const bool needsInstance = std::string_view(info.attribute("BlockType").value()) == "FB";
    if (needsInstance != static_cast<bool>(instance))
      fault(node, "a call of an FB names its instance, one of an FC none");
    if (instance) setInstance(instance, result);
  }

  void setInstance(const pugi::xml_node& instance, Part& result) {
    if (std::optional<Operand> operand = instanceFrom(instance, xml_.span(part_, instance)))
      result.instance = std::move(*operand);
    else
      fault(instance, "the instance cannot be read");
  }

  void shape(const pugi::xml_node& node, Part& result) {
    result.name = node.attribute("Name").value();
    result.hasEno = std::string_view(node.attribute("DisabledENO").value()) != "true";
    std::string from, to;
    for (const pugi::xml_node& child : node.children()) {
      const std::string_view kind = localName(child), name = child.attribute("Name").value();
      if (kind == "Negated") result.negated.insert(inSmallLetters(name));
      if (kind == "Instance") setInstance(child, result);
      if (kind != "TemplateValue") continue;
      const std::string value(trimmed(child.child_value()));
      if (name == "Card")
        result.cardinality = numberIn(value).value_or(0);
      else if (name == "SrcType")
        from = value;
      else if (name == "DestType")
        to = value;
      else if (name != "time_type" && name != "value_type")
        fault(child, fmt::format("{} of part {} is not covered", excerpt(name), excerpt(result.name)));
    }
    result.type = to.empty() || to == from ? from : fmt::format("{}>{}", from, to);
    const bool rounds =
        result.name == "Round" || result.name == "Trunc" || result.name == "Ceil" || result.name == "Floor";
    if (rounds && result.type == "Real") result.type = "Real>DInt";
    const bool isKnown = elementPart(result.name) != nullptr || isBoxPart(result.name) ||
                         !relationOf(result.name).empty() || !iecBlock(result.name).empty();
    if (!isKnown) return fault(node, fmt::format("part {} is not covered", excerpt(result.name)));
    const bool isTyped = (isBoxPart(result.name) && boxOf(result.name, result.type) == nullptr) ||
                         (!relationOf(result.name).empty() && compareSuffix(result.type).empty());
    if (isTyped)
      fault(node, fmt::format("part {} with type {} is not covered", excerpt(result.name),
                              result.type.empty() ? "none" : excerpt(result.type)));
  }

  // Wires -----------------------------------------------------------------------------------------------------------

  /// The first end of a wire is where something comes from.
  void readWire(const pugi::xml_node& wire) {
    Pin source;
    source.span = xml_.span(part_, wire);
    bool isFirst = true;
    std::size_t outputPart = 0;
    for (const pugi::xml_node& end : wire.children()) {
      if (end.type() != pugi::node_element) continue;
      const std::string_view kind = localName(end);
      const std::string id = end.attribute("UId").value(), pin = inSmallLetters(end.attribute("Name").value());
      if (isFirst) {
        isFirst = false;
        if (kind == "Powerrail") source.source = Pin::Source::Rail;
        if (kind == "IdentCon") {
          const auto found = accesses_.find(id);
          if (found == accesses_.end()) return missing(end, "access", id);
          source.source = Pin::Source::Value;
          source.value = found->second;
        } else if (kind == "NameCon") {
          const auto found = index_.find(id);
          if (found == index_.end()) return missing(end, "part", id);
          outputPart = found->second;
          source.source = Pin::Source::Flow;
          source.part = outputPart;
          source.from = pin;
        }
        continue;
      }
      if (kind == "OpenCon" || source.source == Pin::Source::Open) continue;
      if (kind == "IdentCon") {
        const auto found = accesses_.find(id);
        if (found == accesses_.end() || source.source != Pin::Source::Flow) return missing(end, "access", id);
        outputOf(outputPart, source.from).targets.push_back(found->second);
        continue;
      }
      const auto found = index_.find(id);
      if (found == index_.end()) return missing(end, "part", id);
      if (source.source == Pin::Source::Flow) ++outputOf(outputPart, source.from).readers;
      Part& target = circuit_.parts[found->second];
      Pin input = source;
      input.name = pin;
      if (target.input(pin) != nullptr) fault(end, fmt::format("two wires end at {}", excerpt(pin)));
      target.inputs.add(std::move(input));
    }
  }

  void missing(const pugi::xml_node& end, std::string_view what, const std::string& id) {
    if (!isDamaged_ || what == "part")
      fault(end, fmt::format("the {} {} of the wire does not exist", what, excerpt(id)));
  }

  Output& outputOf(std::size_t part, const std::string& pin) { return circuit_.parts[part].outputs.named(pin); }

  const XmlText& xml_;
  const XmlText::Part& part_;
  SyntaxSink& sink_;
  Circuit circuit_;
  std::map<std::string, Operand> accesses_;
  std::map<std::string, std::size_t> index_;
  bool isDamaged_ = false;
};

}  // namespace

std::optional<Circuit> readCircuit(const XmlText& xml, const XmlText::Part& part, const pugi::xml_node& net,
                                   SyntaxSink& sink) {
  return CircuitReader(xml, part, sink).read(net);
}

}  // namespace rungproof::flgnet
