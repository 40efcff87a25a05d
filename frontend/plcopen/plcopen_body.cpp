// Elements of a ladder or FBD body.
#include <charconv>
#include <map>

#include "frontend/plcopen/plcopen_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

DrawnEdge edgeNamed(std::string_view name) {
  return name == "rising" ? DrawnEdge::Rising : name == "falling" ? DrawnEdge::Falling : DrawnEdge::None;
}
DrawnStorage storageNamed(std::string_view name) {
  return name == "set" ? DrawnStorage::Set : name == "reset" ? DrawnStorage::Reset : DrawnStorage::None;
}

/// Elements of a drawing (TC6 2.01). A value that the reader would not follow is not listed.
constexpr XmlShape bodyShapes[] = {
    {"LD", "localId globalId",
     "leftPowerRail rightPowerRail contact coil block inVariable outVariable inOutVariable connector continuation jump "
     "label return comment vendorElement addData documentation"},
    {"FBD", "localId globalId",
     "leftPowerRail rightPowerRail contact coil block inVariable outVariable inOutVariable connector continuation jump "
     "label return comment vendorElement addData documentation"},
    {"leftPowerRail", "localId globalId height:d width:d executionOrderId:n",
     "position connectionPointOut documentation addData"},
    {"rightPowerRail", "localId globalId height:d width:d executionOrderId:n",
     "position connectionPointIn documentation addData"},
    {"contact", "localId globalId height:d width:d executionOrderId:n negated:b edge:none|rising|falling storage:none",
     "position connectionPointIn connectionPointOut variable documentation addData"},
    {"coil",
     "localId globalId height:d width:d executionOrderId:n negated:b edge:none|rising|falling storage:none|set|reset",
     "position connectionPointIn connectionPointOut variable documentation addData"},
    {"block", "localId globalId height:d width:d executionOrderId:n typeName instanceName",
     "position inputVariables inOutVariables outputVariables documentation addData"},
    {"inputVariables", "", "variable"},
    {"inOutVariables", "", "variable"},
    {"outputVariables", "", "variable"},
    {"variable", "formalParameter negated:b edge:none|rising|falling storage:none hidden:b",
     "connectionPointIn connectionPointOut documentation addData"},
    {"inVariable",
     "localId globalId height:d width:d executionOrderId:n negated:b edge:none|rising|falling storage:none",
     "position connectionPointOut expression documentation addData"},
    {"outVariable", "localId globalId height:d width:d executionOrderId:n negated:b edge:none storage:none|set|reset",
     "position connectionPointIn expression documentation addData"},
    {"inOutVariable",
     "localId globalId height:d width:d executionOrderId:n negatedIn:b edgeIn:none|rising|falling storageIn:none "
     "negatedOut:false|0 edgeOut:none storageOut:none",
     "position connectionPointIn connectionPointOut expression documentation addData"},
    {"connector", "localId globalId height:d width:d executionOrderId:n name",
     "position connectionPointIn documentation addData"},
    {"continuation", "localId globalId height:d width:d executionOrderId:n name",
     "position connectionPointOut documentation addData"},
    {"jump", "localId globalId height:d width:d executionOrderId:n label negated:b",
     "position connectionPointIn documentation addData"},
    {"label", "localId globalId height:d width:d executionOrderId:n label", "position documentation addData"},
    {"return", "localId globalId height:d width:d executionOrderId:n negated:b",
     "position connectionPointIn documentation addData"},
    {"vendorElement", "localId globalId height:d width:d executionOrderId:n",
     "position alternativeText documentation addData"},
    {"connectionPointIn", "globalId", "relPosition connection expression addData"},
    {"connectionPointOut", "globalId formalParameter", "relPosition expression addData"},
    {"connection", "globalId refLocalId formalParameter", "position addData"},
    {"position", "x:d y:d", ""},
};

class BodyReader {
 public:
  BodyReader(const XmlText& xml, const XmlText::Part& part, std::string_view text)
      : xml_(xml), part_(part), text_(text) {}

  DrawnNetwork read(const pugi::xml_node& body) {
    network_.span = xml_.span(part_, body);
    for (const pugi::xml_node& node : body.children()) {
      if (node.type() == pugi::node_element) element(node);
    }
    return std::move(network_);
  }

 private:
  void element(const pugi::xml_node& node) {
    static const std::map<std::string_view, DrawnKind> kinds = {{"leftPowerRail", DrawnKind::LeftRail},
                                                                {"rightPowerRail", DrawnKind::RightRail},
                                                                {"contact", DrawnKind::Contact},
                                                                {"coil", DrawnKind::Coil},
                                                                {"block", DrawnKind::Block},
                                                                {"inVariable", DrawnKind::InVariable},
                                                                {"outVariable", DrawnKind::OutVariable},
                                                                {"inOutVariable", DrawnKind::InOutVariable},
                                                                {"connector", DrawnKind::Connector},
                                                                {"continuation", DrawnKind::Continuation},
                                                                {"jump", DrawnKind::Jump},
                                                                {"label", DrawnKind::Label},
                                                                {"return", DrawnKind::Return}};
    const std::string_view name = localName(node);
    if (name == "comment" || name == "vendorElement") return note(node, name == "vendorElement");
    const auto kind = kinds.find(name);
    if (kind == kinds.end()) return;
    DrawnElement e;
    e.kind = kind->second;
    e.span = xml_.span(part_, node);
    e.id = node.attribute("localId").value();
    e.order = node.attribute("executionOrderId").as_int();
    e.negated = node.attribute("negated").as_bool();
    e.edge = edgeNamed(node.attribute("edge").value());
    e.storage = storageNamed(node.attribute("storage").value());
    const pugi::xml_node position = childNamed(node, "position");
    e.x = position.attribute("x").as_double();
    e.y = position.attribute("y").as_double();
    switch (e.kind) {
      case DrawnKind::Contact:
      case DrawnKind::Coil: e.text = trimmed(childNamed(node, "variable").child_value()); break;
      case DrawnKind::InVariable:
      case DrawnKind::OutVariable:
      case DrawnKind::InOutVariable: e.text = trimmed(childNamed(node, "expression").child_value()); break;
      case DrawnKind::Connector:
      case DrawnKind::Continuation: e.text = node.attribute("name").value(); break;
      case DrawnKind::Jump:
      case DrawnKind::Label: e.text = node.attribute("label").value(); break;
      case DrawnKind::Block: readBlock(node, e); break;
      default: break;
    }
    if (e.kind == DrawnKind::InOutVariable) {
      e.negated = node.attribute("negatedIn").as_bool();
      e.edge = edgeNamed(node.attribute("edgeIn").value());
    }
    if (e.kind == DrawnKind::InVariable && e.edge != DrawnEdge::None) e.kind = DrawnKind::Contact;
    if (e.kind != DrawnKind::Block) {
      for (const pugi::xml_node& child : node.children()) {
        if (localName(child) == "connectionPointIn") e.inputs.push_back(inputPin(child, ""));
      }
    }
    network_.elements.push_back(std::move(e));
  }

  void readBlock(const pugi::xml_node& node, DrawnElement& e) {
    e.text = node.attribute("typeName").value();
    e.instance = node.attribute("instanceName").value();
    // CODESYS: the text of an EXECUTE box.
    for (const pugi::xml_node& data : childNamed(node, "addData").children()) {
      const pugi::xml_node code = childNamed(data, "STCode");
      if (!code) continue;
      e.code = code.child_value();
      e.codeSpan = xml_.span(part_, code);
    }
    for (const std::string_view list : {"inputVariables", "inOutVariables"}) {
      for (const pugi::xml_node& variable : childNamed(node, list).children()) {
        if (localName(variable) != "variable") continue;
        DrawnPin pin =
            inputPin(childNamed(variable, "connectionPointIn"), variable.attribute("formalParameter").value());
        pin.span = xml_.span(part_, variable);
        pin.negated = variable.attribute("negated").as_bool();
        pin.edge = edgeNamed(variable.attribute("edge").value());
        e.inputs.push_back(std::move(pin));
      }
    }
    for (const pugi::xml_node& variable : childNamed(node, "outputVariables").children()) {
      if (localName(variable) != "variable") continue;
      DrawnPin pin;
      pin.name = variable.attribute("formalParameter").value();
      pin.negated = variable.attribute("negated").as_bool();
      pin.span = xml_.span(part_, variable);
      // CODESYS writes the variable of an output at the output.
      pin.expression = trimmed(childNamed(childNamed(variable, "connectionPointOut"), "expression").child_value());
      e.outputs.push_back(std::move(pin));
    }
  }

  DrawnPin inputPin(const pugi::xml_node& point, std::string name) {
    DrawnPin pin;
    pin.name = std::move(name);
    pin.span = xml_.span(part_, point);
    for (const pugi::xml_node& child : point.children()) {
      if (localName(child) == "connection")
        pin.links.push_back({child.attribute("refLocalId").value(), child.attribute("formalParameter").value(),
                             xml_.span(part_, child)});
      if (localName(child) == "expression") pin.expression = trimmed(child.child_value());
    }
    return pin;
  }

  void note(const pugi::xml_node& node, bool isVendor) {
    DrawnNote note;
    note.y = childNamed(node, "position").attribute("y").as_double();
    note.before = network_.elements.size();
    if (isVendor) {
      note.title =
          trimmed(childNamed(node, "alternativeText") ? allText(childNamed(node, "alternativeText")) : std::string());
      network_.notes.push_back(std::move(note));
      return;
    }
    const pugi::xml_node content = childNamed(node, "content");
    std::vector<Directive> unused;
    pugi::xml_node at = content.first_child();
    while (at) {
      if (at.type() == pugi::node_pcdata || at.type() == pugi::node_cdata) {
        const Span span = xml_.span(part_, at);
        readComment(span, text_.substr(span.offset, span.length), note.lines, unused);
      }
      if (at.first_child()) {
        at = at.first_child();
        continue;
      }
      while (at && at != content && !at.next_sibling()) at = at.parent();
      if (!at || at == content) break;
      at = at.next_sibling();
    }
    network_.notes.push_back(std::move(note));
  }

  const XmlText& xml_;
  const XmlText::Part& part_;
  std::string_view text_;
  DrawnNetwork network_;
};

}  // namespace

std::vector<ShapeFault> plcopenFaults(const pugi::xml_node& body) {
  std::vector<ShapeFault> faults = faultsOf(body, bodyShapes);
  for (const pugi::xml_node& node : body.children()) {
    if (localName(node) != "vendorElement") continue;
    for (const pugi::xml_node& data : childNamed(node, "addData").children()) {
      const std::string type(trimmed(childNamed(data, "ElementType").child_value()));
      if (!type.empty() && type != "networktitle")
        faults.push_back({node, fmt::format("an element of type {} is not modelled", excerpt(type))});
    }
  }
  return faults;
}

DrawnNetwork readPlcopenBody(const XmlText& xml, const XmlText::Part& part, const pugi::xml_node& body,
                             std::string_view text) {
  return BodyReader(xml, part, text).read(body);
}

}  // namespace rungproof
