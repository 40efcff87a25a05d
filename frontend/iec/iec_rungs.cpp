// A rung is the conjunction of its contacts, given to each of its coils; a block stands in a rung alone and is called
// in every scan. Numbers at the pins of timers are milliseconds there. Each rung is one network, drawn as it stands.
#include "frontend/iec/iec_rungs.hpp"

#include <array>
#include <string_view>

#include "frontend/graphical/drawn_circuit.hpp"
#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/iec_pictures.hpp"
#include "frontend/iec/iec_tree.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/xml/xml_shape.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::iec {

namespace {

bool isElement(const pugi::xml_node& node, std::string_view name) {
  return node.type() == pugi::node_element && localName(node) == name;
}

class RungReader {
 public:
  RungReader(PlcopenBodies& bodies, BlockSyntax& block) : bodies_(bodies), block_(block) {}

  void rung(const pugi::xml_node& node) {
    const std::size_t first = made.size();
    drawn_ = {};
    drawn_.span = bodies_.placeOf(node);
    drawn_.elements.push_back(elementOf(DrawnKind::LeftRail, drawn_.span));
    results_.clear();
    if (!statementsOf(node) || first == made.size()) return;
    for (std::size_t i = first; i < made.size(); ++i) made[i].circuit = static_cast<int>(drawn_.span.offset) + 1;
    Program unused;  // what the drawing could say has been said
    DrawnSink sink(unused);
    const auto isInstance = [](const DrawnElement& e) { return !isStandardFunction(foldedName(e.text)); };
    made[first].drawn = pictureOf(DrawnCircuit(drawn_, sink, isInstance), results_, Form::Ladder, isInstance);
  }

  Statements made;

 private:
  struct Unwritable {};

  /// False: something of the rung cannot be written.
  bool statementsOf(const pugi::xml_node& node) {
    ExprPtr flow;
    std::size_t coils = 0;
    for (const pugi::xml_node& child : node.children()) coils += isElement(child, "coil") ? 1 : 0;
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      const std::size_t before = made.size();
      try {
        if (isElement(child, "contact")) {
          flow = andOf(std::move(flow), contact(child));
        } else if (isElement(child, "coil")) {
          if (flow == nullptr) flow = literalOf("TRUE", bodies_.placeOf(child));
          if (coils > 1) flow = kept(std::move(flow), child);
          coils = 1;
          coil(child, copyOf(*flow));
        } else if (isElement(child, "block")) {
          if (flow != nullptr) refuse(child, "contacts in front of a block of such a rung are not modelled");
          callBlock(child);
        } else {
          refuse(child, fmt::format("<{}> in a rung is not modelled", localName(child)));
        }
      } catch (const Unwritable&) {
        made.resize(before);
        Statement& lost = made.emplace_back();
        lost.kind = StatementKind::Unread;
        lost.span = bodies_.placeOf(child);
        return false;
      }
    }
    return true;
  }

  DrawnElement elementOf(DrawnKind kind, Span span) const {
    DrawnElement made;
    made.kind = kind;
    made.id = std::to_string(drawn_.elements.size());
    made.x = static_cast<double>(drawn_.elements.size());
    made.span = span;
    return made;
  }
  static DrawnPin pinOf(std::string name, std::string expression, Span span) {
    DrawnPin made;
    made.name = std::move(name);
    made.expression = std::move(expression);
    made.span = span;
    return made;
  }
  /// The next element of the rung's drawing; contacts feed what stands behind them.
  DrawnElement& draw(DrawnKind kind, Span span) {
    DrawnElement element = elementOf(kind, span);
    std::size_t before = drawn_.elements.size() - 1;
    while (before > 0 && drawn_.elements[before].kind != DrawnKind::Contact) --before;
    if (kind != DrawnKind::Block) {
      element.inputs.push_back(pinOf({}, {}, span));
      element.inputs[0].links.push_back({drawn_.elements[before].id, {}, span});
    }
    drawn_.elements.push_back(std::move(element));
    if (kind != DrawnKind::Contact) results_.push_back(static_cast<int>(drawn_.elements.size()) - 1);
    return drawn_.elements.back();
  }

  [[noreturn]] void refuse(const pugi::xml_node& node, std::string message) {
    bodies_.report(node, Syntax::IecNotModelled, std::move(message));
    throw Unwritable{};
  }

  /// The flow that several coils take is computed once.
  ExprPtr kept(ExprPtr flow, const pugi::xml_node& node) {
    VariableSyntax hidden;
    hidden.name = fmt::format("__flow_{}", block_.variables.size());
    hidden.type = std::make_shared<TypeSyntax>();
    hidden.type->name = "BOOL";
    hidden.type->span = hidden.span = bodies_.placeOf(node);
    block_.variables.push_back(hidden);
    made.push_back(assignmentOf(pathOf({hidden.name}, hidden.span), std::move(flow), hidden.span));
    return pathOf({hidden.name}, hidden.span);
  }

  /// The variable of an element, as an expression.
  ExprPtr variableOf(const pugi::xml_node& node) {
    const std::string name = node.attribute("variable").value();
    if (name.empty()) {
      bodies_.report(node, Syntax::XmlStructure, fmt::format("<{}> names no variable", localName(node)));
      throw Unwritable{};
    }
    ExprPtr made = bodies_.expressionOf(name, node);
    if (made == nullptr) throw Unwritable{};
    return made;
  }
  static bool isNegated(const pugi::xml_node& node) {
    const std::string_view value = node.attribute("negated").value();
    return value == "negated" || value == "true" || value == "1";
  }
  /// What a contact or coil does beside its variable: in the words of this form (kind), or in those of PLCopen.
  static std::string kindOf(const pugi::xml_node& node) {
    for (const char* name : {"kind", "storage", "edge"}) {
      const std::string value = node.attribute(name).value();
      if (!value.empty() && value != "normal" && value != "none") return value;
    }
    return {};
  }

  ExprPtr contact(const pugi::xml_node& node) {
    const std::string kind = kindOf(node);
    if (!kind.empty() && kind != "negated")
      refuse(node, fmt::format("a contact of kind {} is not modelled", excerpt(kind)));
    ExprPtr value = variableOf(node);
    DrawnElement& drawn = draw(DrawnKind::Contact, value->span);
    drawn.text = node.attribute("variable").value();
    drawn.negated = isNegated(node) || kind == "negated";
    return drawn.negated ? notOf(std::move(value)) : std::move(value);
  }

  void coil(const pugi::xml_node& node, ExprPtr flow) {
    const Span span = bodies_.placeOf(node);
    const std::string kind = kindOf(node);
    ExprPtr target = variableOf(node);
    DrawnElement& drawn = draw(DrawnKind::Coil, target->span);
    drawn.text = node.attribute("variable").value();
    if (kind == "set" || kind == "reset") {
      if (isNegated(node)) refuse(node, fmt::format("a negated coil of kind {} is not modelled", kind));
      drawn.storage = kind == "set" ? DrawnStorage::Set : DrawnStorage::Reset;
      Statements body;
      body.push_back(assignmentOf(std::move(target), literalOf(kind == "set" ? "TRUE" : "FALSE", span), span));
      made.push_back(ifOf(std::move(flow), std::move(body), span));
      return;
    }
    if (!kind.empty() && kind != "negated")
      refuse(node, fmt::format("a coil of kind {} is not modelled", excerpt(kind)));
    drawn.negated = isNegated(node) || kind == "negated";
    if (drawn.negated) flow = notOf(std::move(flow));
    made.push_back(assignmentOf(std::move(target), std::move(flow), span));
  }

  /// The type that the block declares for a variable that is written alone, in capitals.
  std::string typeOf(const Expr& expr) const {
    if (expr.kind != ExprKind::Path || expr.parts.size() != 1) return {};
    for (const VariableSyntax& variable : block_.variables) {
      if (foldedName(variable.name) == foldedName(expr.parts[0].name)) return foldedName(variable.type->name);
    }
    return {};
  }
  static bool isNumber(const std::string& type) {
    const Type* known = elementaryType(type);
    return known != nullptr && known->isNumber();
  }
  ExprPtr converted(const std::string& function, ExprPtr value, Span span) {
    ExprPtr call = callOf({function}, span);
    addArgument(*call, std::move(value));
    return call;
  }

  void callBlock(const pugi::xml_node& node) {
    static constexpr std::array<std::string_view, 9> results = {"Q",  "Q1",  "ET",  "CV",  "QU",
                                                                "QD", "OUT", "ENO", "BUSY"};
    const Span span = bodies_.placeOf(node);
    const std::string type = node.attribute("typeName").value(), instance = node.attribute("instanceName").value();
    const bool isFunction = isStandardFunction(foldedName(type));
    if (!isFunction && instance.empty()) refuse(node, "a block without an instance is not modelled");
    ExprPtr call = callOf({isFunction ? type : instance}, span);
    std::vector<std::pair<std::string, ExprPtr>> outputs;
    DrawnElement& drawn = draw(DrawnKind::Block, span);
    drawn.text = type;
    drawn.instance = instance;
    for (const pugi::xml_node& pin : node.children()) {
      if (!isElement(pin, "variable")) continue;
      const std::string formal = foldedName(pin.attribute("formalParameter").value());
      if (isNegated(pin) || !kindOf(pin).empty())
        refuse(pin, fmt::format("a pin that negates or finds edges, as {}, is not modelled in such a rung", formal));
      ExprPtr actual = bodies_.expressionOf(pin);
      if (actual == nullptr) throw Unwritable{};
      const bool isOutput = std::ranges::find(results, formal) != results.end();
      (isOutput ? drawn.outputs : drawn.inputs)
          .push_back(pinOf(formal, std::string(trimmed(allText(pin))), actual->span));
      if (isOutput) {
        outputs.emplace_back(formal, std::move(actual));
        continue;
      }
      const std::string declared = typeOf(*actual);
      if (formal == "PT" && isNumber(declared)) actual = converted(declared + "_TO_TIME", std::move(actual), span);
      addArgument(*call, std::move(actual), formal);
    }
    if (!isFunction) {
      declare(node, instance, type);
      made.push_back(callStatementOf(std::move(call)));
    }
    for (auto& [formal, target] : outputs) {
      const std::string declared = typeOf(*target);
      ExprPtr value = isFunction ? copyOf(*call) : pathOf({instance, formal}, span);
      if (formal == "ET" && isNumber(declared)) value = converted("TIME_TO_" + declared, std::move(value), span);
      made.push_back(assignmentOf(std::move(target), std::move(value), span));
    }
  }

  void declare(const pugi::xml_node& node, const std::string& name, const std::string& type) {
    for (const VariableSyntax& variable : block_.variables) {
      if (foldedName(variable.name) == foldedName(name)) return;
    }
    bodies_.report(node, Syntax::IecTaken,
                   fmt::format("{} is not declared: it is taken as an instance of {}", excerpt(name), excerpt(type)));
    VariableSyntax made;
    made.name = name;
    made.type = std::make_shared<TypeSyntax>();
    made.type->name = type;
    made.type->span = made.span = bodies_.placeOf(node);
    block_.variables.push_back(std::move(made));
  }

  PlcopenBodies& bodies_;
  BlockSyntax& block_;
  DrawnNetwork drawn_;
  std::vector<int> results_;  ///< elements of it that something is computed for
};

}  // namespace

bool holdsRungs(const pugi::xml_node& ladder) {
  for (const pugi::xml_node& child : ladder.children()) {
    if (isElement(child, "rung")) return true;
  }
  return false;
}

Statements rungStatements(PlcopenBodies& bodies, const pugi::xml_node& ladder, BlockSyntax& block) {
  RungReader reader(bodies, block);
  for (const pugi::xml_node& child : ladder.children()) {
    if (child.type() != pugi::node_element) continue;
    if (isElement(child, "rung")) {
      reader.rung(child);
    } else {
      bodies.report(child, Syntax::XmlStructure, fmt::format("<{}> stands between rungs", localName(child)));
      Statement& lost = reader.made.emplace_back();
      lost.kind = StatementKind::Unread;
      lost.span = bodies.placeOf(child);
    }
  }
  return std::move(reader.made);
}

}  // namespace rungproof::iec
