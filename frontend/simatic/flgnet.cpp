// One network: parts, accesses, calls, and the wires between them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <unordered_map>

#include "frontend/graphical/drawn_scope.hpp"
#include "frontend/simatic/simatic_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/xml/xml_shape.hpp"

namespace rungproof {

namespace {

/// Parts that are functions of the standard, with the pins whose order matters first.
struct FunctionPart {
  std::string_view part;
  std::string_view function;
  std::array<std::string_view, 3> first{};
};
constexpr FunctionPart functionParts[] = {{"Add", "ADD"},
                                          {"Sub", "SUB"},
                                          {"Mul", "MUL"},
                                          {"Div", "DIV"},
                                          {"Mod", "MOD"},
                                          {"Eq", "EQ"},
                                          {"Ne", "NE"},
                                          {"Gt", "GT"},
                                          {"Ge", "GE"},
                                          {"Lt", "LT"},
                                          {"Le", "LE"},
                                          {"Move", "MOVE"},
                                          {"Abs", "ABS"},
                                          {"Neg", "NEG"},
                                          {"Sqrt", "SQRT"},
                                          {"Ln", "LN"},
                                          {"Exp", "EXP"},
                                          {"Sin", "SIN"},
                                          {"Cos", "COS"},
                                          {"Tan", "TAN"},
                                          {"Min", "MIN"},
                                          {"Max", "MAX"},
                                          {"And", "AND"},
                                          {"Or", "OR"},
                                          {"Xor", "XOR"},
                                          {"A", "AND"},
                                          {"O", "OR"},
                                          {"X", "XOR"},
                                          {"Not", "NOT"},
                                          {"Inv", "NOT"},
                                          {"Invert", "NOT"},
                                          {"Round", "ROUND"},
                                          {"Trunc", "TRUNC"},
                                          {"Limit", "LIMIT", {"MN", "IN", "MX"}},
                                          {"Sel", "SEL", {"G", "IN0", "IN1"}},
                                          {"Mux", "MUX", {"K"}},
                                          {"Shl", "SHL", {"IN", "N"}},
                                          {"Shr", "SHR", {"IN", "N"}},
                                          {"Rol", "ROL", {"IN", "N"}},
                                          {"Ror", "ROR", {"IN", "N"}}};

const FunctionPart* functionPart(std::string_view name) {
  for (const FunctionPart& row : functionParts) {
    if (row.part == name) return &row;
  }
  return nullptr;
}

/// Elements of a network. Whatever is not listed would change what it means.
constexpr XmlShape networkShapes[] = {
    {"FlgNet", "", "Labels Parts Wires"},
    {"Labels", "", "LabelDeclaration"},
    {"LabelDeclaration", "UId", "Label Comment"},
    {"Label", "Name UId", ""},
    {"Parts", "", "Access Part Call"},
    {"Access",
     "UId Type Scope:LocalVariable|GlobalVariable|LiteralConstant|TypedConstant|LocalConstant|GlobalConstant|Address|"
     "Label",
     "Symbol Constant Address Label Comment"},
    {"Symbol", "UId", "Component Address"},
    {"Component", "Name UId AccessModifier:None SimpleAccessModifier:None SliceAccessModifier:undef", ""},
    {"Constant", "Name UId", "ConstantType ConstantValue StringAttribute"},
    {"Part", "Name UId Version DisabledENO:b", "TemplateValue Negated Instance AutomaticTyped Invisible Comment"},
    {"Negated", "Name", ""},
    {"TemplateValue", "Name Type:Cardinality|Type|Operation|Function|String", ""},
    {"Instance", "Scope:LocalVariable|GlobalVariable UId", "Component Address"},
    {"Call", "UId", "CallInfo Comment"},
    {"Wires", "", "Wire"},
    {"Wire", "UId Name", "Powerrail IdentCon NameCon OpenCon Openbranch"},
    {"Powerrail", "UId", ""},
    {"IdentCon", "UId", ""},
    {"NameCon", "UId Name", ""},
    {"OpenCon", "UId", ""},
    {"Openbranch", "UId", ""},
};

/// "DB.Member", without the quotation marks of the editor.
std::string componentsOf(const pugi::xml_node& node) {
  std::string path;
  for (const pugi::xml_node& child : node.children()) {
    if (localName(child) != "Component") continue;
    if (!path.empty()) path += '.';
    path += child.attribute("Name").value();
  }
  return path;
}

/// <Address Area="Input" Type="Bool" BitOffset="3"/> to "%I0.3".
std::string addressOf(const pugi::xml_node& node) {
  const std::string_view area = node.attribute("Area").value(), type = node.attribute("Type").value();
  const char letter = area == "Input" ? 'I' : area == "Output" ? 'Q' : area == "Memory" ? 'M' : '\0';
  const std::string_view offset = node.attribute("BitOffset").value();
  int bit = -1;
  const auto [end, error] = std::from_chars(offset.data(), offset.data() + offset.size(), bit);
  if (letter == '\0' || bit < 0 || error != std::errc() || end != offset.data() + offset.size()) return "";
  if (type == "Bool") return fmt::format("%{}{}.{}", letter, bit / 8, bit % 8);
  const char width = type == "Byte" || type == "SInt" || type == "USInt"                      ? 'B'
                     : type == "Word" || type == "Int" || type == "UInt"                      ? 'W'
                     : type == "DWord" || type == "DInt" || type == "UDInt" || type == "Real" ? 'D'
                                                                                              : '\0';
  return width == '\0' || bit % 8 != 0 ? "" : fmt::format("%{}{}{}", letter, width, bit / 8);
}

int pinNumber(const std::string& name) {
  std::size_t at = name.size();
  while (at > 0 && isDigit(name[at - 1])) --at;
  return at == name.size() || name.size() - at > 6 ? 0 : std::atoi(name.c_str() + at);
}

class FlgNetReader {
 public:
  FlgNetReader(const XmlText& xml, const XmlText::Part& part, SyntaxSink& sink, std::vector<DrawnVariable>& instances)
      : xml_(xml), part_(part), sink_(sink), instances_(instances) {}

  DrawnNetwork read(const pugi::xml_node& net) {
    network_.span = xml_.span(part_, net);
    network_.isWhole = true;
    for (const ShapeFault& found : faultsOf(net, networkShapes)) fault(found.node, found.message);
    DrawnElement rail;
    rail.kind = DrawnKind::LeftRail;
    rail.id = "rail";
    rail.span = network_.span;
    network_.elements.push_back(std::move(rail));
    for (const pugi::xml_node& label : childNamed(net, "Labels").children()) {
      DrawnElement e;
      e.kind = DrawnKind::Label;
      e.id = fmt::format("label {}", label.attribute("UId").value());
      e.text = childNamed(label, "Label").attribute("Name").value();
      e.span = xml_.span(part_, label);
      network_.elements.push_back(std::move(e));
    }
    for (const pugi::xml_node& node : childNamed(net, "Parts").children()) {
      if (node.type() == pugi::node_element) readPart(node);
    }
    for (const pugi::xml_node& wire : childNamed(net, "Wires").children()) {
      if (localName(wire) == "Wire") readWire(wire);
    }
    finish();
    return std::move(network_);
  }

 private:
  void fault(const pugi::xml_node& node, std::string message) {
    sink_.report(Syntax::XmlStructure, xml_.span(part_, node), std::move(message));
    network_.isDamaged = true;
  }

  void readPart(const pugi::xml_node& node) {
    const std::string_view kind = localName(node);
    const std::string id = node.attribute("UId").value();
    if (kind == "Access") {
      accesses_[id] = accessText(node);
      return;
    }
    DrawnElement e;
    e.id = id;
    e.span = xml_.span(part_, node);
    if (kind == "Call") {
      const pugi::xml_node info = childNamed(node, "CallInfo");
      e.text = info.attribute("Name").value();
      if (const pugi::xml_node instance = childNamed(info, "Instance")) addInstance(e, instance, e.text);
    } else if (kind == "Part") {
      if (!shape(node, e)) return;
    } else {
      return;
    }
    index_.emplace(id, network_.elements.size());
    network_.elements.push_back(std::move(e));
  }

  std::string accessText(const pugi::xml_node& node) {
    const std::string_view scope = node.attribute("Scope").value();
    if (scope == "Label") return childNamed(node, "Label").attribute("Name").value();
    if (scope == "Address") {
      const std::string address = addressOf(childNamed(node, "Address"));
      if (address.empty()) fault(node, "the address cannot be read");
      return address;
    }
    if (const pugi::xml_node constant = childNamed(node, "Constant")) {
      if (constant.attribute("Name")) return constant.attribute("Name").value();
      return std::string(trimmed(childNamed(constant, "ConstantValue").child_value()));
    }
    return componentsOf(childNamed(node, "Symbol"));
  }

  void addInstance(DrawnElement& e, const pugi::xml_node& instance, const std::string& type) {
    e.instance = componentsOf(instance);
    const bool isGlobal = std::string_view(instance.attribute("Scope").value()) == "GlobalVariable";
    if (!isGlobal || e.instance.empty()) return;
    DrawnVariable variable;
    variable.name = e.instance;
    variable.section = DrawnSection::Global;
    variable.typeName = type;
    variable.span = xml_.span(part_, instance);
    instances_.push_back(std::move(variable));
  }

  static bool isNegated(const pugi::xml_node& node, std::string_view pin) {
    for (const pugi::xml_node& child : node.children()) {
      if (localName(child) == "Negated" && pin == child.attribute("Name").value()) return true;
    }
    return false;
  }

  static std::string templateValue(const pugi::xml_node& node, std::string_view name) {
    for (const pugi::xml_node& child : node.children()) {
      if (localName(child) == "TemplateValue" && name == child.attribute("Name").value()) return child.child_value();
    }
    return "";
  }

  /// What a part is; false if it is not known (reported).
  bool shape(const pugi::xml_node& node, DrawnElement& e) {
    const std::string_view name = node.attribute("Name").value();
    for (const pugi::xml_node& child : node.children()) {
      if (localName(child) != "Negated") continue;
      negatedPins_[e.id].push_back(foldedName(child.attribute("Name").value()));
      negations_.push_back({child, e.id});
    }
    if (name == "Contact" || name == "PContact" || name == "NContact") {
      e.kind = DrawnKind::Contact;
      e.negated = isNegated(node, "operand");
      e.edge = name[0] == 'P' ? DrawnEdge::Rising : name[0] == 'N' ? DrawnEdge::Falling : DrawnEdge::None;
      return true;
    }
    if (name == "Coil" || name == "SCoil" || name == "RCoil" || name == "PCoil" || name == "NCoil") {
      e.kind = DrawnKind::Coil;
      e.negated = isNegated(node, "operand");
      e.storage = name[0] == 'S' ? DrawnStorage::Set : name[0] == 'R' ? DrawnStorage::Reset : DrawnStorage::None;
      e.edge = name[0] == 'P' ? DrawnEdge::Rising : name[0] == 'N' ? DrawnEdge::Falling : DrawnEdge::None;
      return true;
    }
    if (name == "PBox" || name == "NBox") {  // an edge in the line: twice negated, with the edge sign at the input
      e.text = "NOT";
      edges_[e.id] = name[0] == 'P' ? DrawnEdge::Rising : DrawnEdge::Falling;
      return true;
    }
    if (name == "Sr" || name == "Rs") {
      bistables_[e.id] = std::string(name);
      e.text = name == "Sr" ? "AND" : "OR";
      return true;
    }
    if (name == "Jump" || name == "JumpNot") {
      e.kind = DrawnKind::Jump;
      e.negated = name == "JumpNot";
      return true;
    }
    if (name == "Return") {
      e.kind = DrawnKind::Return;
      return true;
    }
    if (name == "Convert") {
      e.text = fmt::format("{}_TO_{}", foldedName(templateValue(node, "SrcType")),
                           foldedName(templateValue(node, "DestType")));
      return true;
    }
    if (name == "Inc" || name == "Dec") {
      e.text = name == "Inc" ? "ADD" : "SUB";
      counts_.push_back(e.id);
      return true;
    }
    if (standardBlockNamed(name) != StandardBlock::None && name != "SR" && name != "RS") {
      e.text = foldedName(name);
      if (const pugi::xml_node instance = childNamed(node, "Instance")) addInstance(e, instance, e.text);
      return true;
    }
    if (const FunctionPart* row = functionPart(name)) {
      e.text = row->function;
      order_[e.id] = row;
      return true;
    }
    fault(node, fmt::format("part {} is not covered", excerpt(name)));
    unknown_.push_back(e.id);
    return false;
  }

  DrawnElement* find(const std::string& id) {
    const auto found = index_.find(id);
    return found == index_.end() ? nullptr : &network_.elements[found->second];
  }

  void readWire(const pugi::xml_node& wire) {
    DrawnLink link;
    link.span = xml_.span(part_, wire);
    std::string expression;
    bool hasSource = false, isOpen = false;
    DrawnElement* source = nullptr;
    for (const pugi::xml_node& end : wire.children()) {
      if (end.type() != pugi::node_element) continue;
      const std::string_view kind = localName(end);
      const std::string id = end.attribute("UId").value();
      const std::string pin = end.attribute("Name").value();
      if (!hasSource) {
        hasSource = true;
        if (kind == "Powerrail") {
          link.from = "rail";
        } else if (kind == "IdentCon") {
          const auto access = accesses_.find(id);
          if (access == accesses_.end())
            return fault(end, fmt::format("a wire begins at access {}, which does not exist", excerpt(id)));
          expression = access->second;
        } else if (kind == "NameCon") {
          source = find(id);
          if (source == nullptr) {
            if (std::find(unknown_.begin(), unknown_.end(), id) == unknown_.end())
              fault(end, fmt::format("a wire begins at part {}, which does not exist", excerpt(id)));
            return;
          }
          link.from = id;
          link.pin = source->kind == DrawnKind::Block ? pin : "";
          if (source->kind == DrawnKind::Block) outputPin(*source, pin);
        } else {
          isOpen = true;
        }
        continue;
      }
      if (isOpen || kind == "OpenCon" || kind == "Openbranch") continue;
      if (kind == "IdentCon") {
        const auto access = accesses_.find(id);
        if (access == accesses_.end() || source == nullptr)
          return fault(end, fmt::format("a wire ends at access {}, which does not exist", excerpt(id)));
        if (source->kind == DrawnKind::Block) outputPin(*source, pinOf(link)).expression = access->second;
        continue;
      }
      DrawnElement* target = kind == "NameCon" ? find(id) : nullptr;
      if (target == nullptr) {
        if (std::find(unknown_.begin(), unknown_.end(), id) == unknown_.end())
          fault(end, fmt::format("a wire ends at part {}, which does not exist", excerpt(id)));
        continue;
      }
      connect(*target, pin, link, expression);
    }
  }
  static const std::string& pinOf(const DrawnLink& link) { return link.pin; }

  DrawnPin& outputPin(DrawnElement& e, const std::string& name) {
    for (DrawnPin& pin : e.outputs) {
      if (pin.name == name) return pin;
    }
    DrawnPin pin;
    pin.name = name;
    pin.span = e.span;
    e.outputs.push_back(std::move(pin));
    return e.outputs.back();
  }

  void connect(DrawnElement& e, const std::string& name, const DrawnLink& link, const std::string& expression) {
    if (e.kind != DrawnKind::Block && (name == "operand" || name == "label")) {
      e.text = expression;
      return;
    }
    if (name == "bit") return;  // memory of an edge: EU and ED keep it themselves
    DrawnPin pin;
    pin.name = name == "pre" ? "EN" : name;
    pin.span = link.span;
    if (expression.empty()) pin.links.push_back(link);
    pin.expression = expression;
    if (e.kind == DrawnKind::Jump) pin.negated = e.negated;
    const std::vector<std::string>& negated = negatedPins_[e.id];
    if (std::find(negated.begin(), negated.end(), foldedName(name)) != negated.end()) pin.negated = !pin.negated;
    e.inputs.push_back(std::move(pin));
  }

  /// A negation belongs to the operand of a contact or coil, or to an input that a wire reaches.
  void checkNegations() {
    for (const auto& [node, id] : negations_) {
      const DrawnElement* e = find(id);
      if (e == nullptr) continue;
      const std::string pin = foldedName(node.attribute("Name").value());
      const bool isOperand = (e->kind == DrawnKind::Contact || e->kind == DrawnKind::Coil) && pin == "OPERAND";
      const bool isInput = e->kind != DrawnKind::Contact && e->kind != DrawnKind::Coil &&
                           std::any_of(e->inputs.begin(), e->inputs.end(),
                                       [&](const DrawnPin& input) { return foldedName(input.name) == pin; });
      if (!isOperand && !isInput)
        fault(node, fmt::format("a negation stands at {}, which the part does not have as an input", excerpt(pin)));
    }
  }

  /// Orders pins, and builds what has no box in the standard.
  void finish() {
    checkNegations();
    for (std::size_t i = 0; i < network_.elements.size(); ++i) {
      const std::string id = network_.elements[i].id;
      DrawnElement& e = network_.elements[i];
      if (e.kind == DrawnKind::Jump) e.negated = false;
      if (const auto edge = edges_.find(id); edge != edges_.end()) {
        for (DrawnPin& pin : e.inputs) pin.edge = edge->second;
        for (DrawnPin& pin : e.outputs) pin.negated = true;
      }
      const FunctionPart* row = order_.contains(id) ? order_.at(id) : nullptr;
      if (row != nullptr) {
        const auto rank = [&](const DrawnPin& pin) {
          const std::string name = foldedName(pin.name);
          for (std::size_t k = 0; k < row->first.size(); ++k) {
            if (name == row->first[k]) return static_cast<int>(k) - 10;
          }
          return pinNumber(name);
        };
        std::stable_sort(e.inputs.begin(), e.inputs.end(),
                         [&](const DrawnPin& a, const DrawnPin& b) { return rank(a) < rank(b); });
      }
      if (std::find(counts_.begin(), counts_.end(), id) != counts_.end()) {
        for (DrawnPin& pin : e.inputs) {
          if (foldedName(pin.name) != "OPERAND") continue;
          DrawnPin out;
          out.name = "OUT";
          out.expression = pin.expression;
          out.span = pin.span;
          e.outputs.insert(e.outputs.begin(), std::move(out));
        }
        DrawnPin one;
        one.name = "IN2";
        one.expression = "1";
        one.span = e.span;
        e.inputs.push_back(std::move(one));
      }
      if (bistables_.contains(id)) bistable(i, bistables_.at(id) == "Sr");
    }
  }

  static DrawnPin takePin(std::vector<DrawnPin>& pins, std::initializer_list<std::string_view> names) {
    for (DrawnPin& pin : pins) {
      for (const std::string_view name : names) {
        if (foldedName(pin.name) == name) return pin;
      }
    }
    return {};
  }

  /// Sr of TIA is reset dominant: (S or Q) and not R1; Rs is set dominant: S1 or (Q and not R). Q is the operand.
  void bistable(std::size_t i, bool resetDominant) {
    DrawnElement gate = network_.elements[i];
    DrawnPin set = takePin(gate.inputs, {"S", "S1"}), reset = takePin(gate.inputs, {"R", "R1"});
    const std::string bit = takePin(gate.inputs, {"OPERAND"}).expression;
    DrawnPin held;
    held.name = "HELD";
    held.expression = bit;
    held.span = gate.span;
    reset.negated = !reset.negated;
    if (reset.links.empty() && reset.expression.empty()) {
      reset.expression = "TRUE";
      reset.negated = false;
    }
    DrawnElement inner = gate;
    inner.id = gate.id + " inner";
    inner.outputs.clear();
    inner.text = resetDominant ? "OR" : "AND";
    inner.inputs = resetDominant ? std::vector<DrawnPin>{set, held} : std::vector<DrawnPin>{held, reset};
    DrawnPin fromInner;
    fromInner.name = "INNER";
    fromInner.span = gate.span;
    fromInner.links.push_back({inner.id, "", gate.span});
    gate.inputs = resetDominant ? std::vector<DrawnPin>{fromInner, reset} : std::vector<DrawnPin>{set, fromInner};
    DrawnPin result;
    result.name = "BIT";
    result.expression = bit;
    result.span = gate.span;
    gate.outputs.insert(gate.outputs.begin(), std::move(result));
    network_.elements[i] = std::move(gate);
    network_.elements.push_back(std::move(inner));
  }

  const XmlText& xml_;
  const XmlText::Part& part_;
  SyntaxSink& sink_;
  std::vector<DrawnVariable>& instances_;
  DrawnNetwork network_;
  std::unordered_map<std::string, std::string> accesses_;
  std::unordered_map<std::string, std::size_t> index_;
  std::unordered_map<std::string, std::vector<std::string>> negatedPins_;
  std::vector<std::pair<pugi::xml_node, std::string>> negations_;  ///< with the id of their part
  std::unordered_map<std::string, DrawnEdge> edges_;
  std::unordered_map<std::string, std::string> bistables_;
  std::unordered_map<std::string, const FunctionPart*> order_;
  std::vector<std::string> counts_, unknown_;
};

}  // namespace

DrawnNetwork readFlgNet(const XmlText& xml, const XmlText::Part& part, const pugi::xml_node& net, SyntaxSink& sink,
                        std::vector<DrawnVariable>& instances) {
  return FlgNetReader(xml, part, sink, instances).read(net);
}

}  // namespace rungproof
