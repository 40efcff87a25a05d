// A rung is the conjunction of its contacts, given to each of its coils; a block stands in a rung alone and is called
// in every scan. Numbers at the pins of timers are milliseconds there.
#include "frontend/iec/iec_rungs.hpp"

#include <array>
#include <string_view>

#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/iec_tree.hpp"
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
        return;
      }
    }
  }

  Statements made;

 private:
  struct Unwritable {};

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
    return value == "negated" || value == "true";
  }

  ExprPtr contact(const pugi::xml_node& node) {
    const std::string kind = node.attribute("kind").value();
    if (!kind.empty() && kind != "negated" && kind != "normal")
      refuse(node, fmt::format("a contact of kind {} is not modelled", excerpt(kind)));
    ExprPtr value = variableOf(node);
    return isNegated(node) || kind == "negated" ? notOf(std::move(value)) : std::move(value);
  }

  void coil(const pugi::xml_node& node, ExprPtr flow) {
    const Span span = bodies_.placeOf(node);
    const std::string kind = node.attribute("kind").value();
    if (kind == "set" || kind == "reset") {
      Statements body;
      body.push_back(assignmentOf(variableOf(node), literalOf(kind == "set" ? "TRUE" : "FALSE", span), span));
      made.push_back(ifOf(std::move(flow), std::move(body), span));
      return;
    }
    if (!kind.empty() && kind != "normal" && kind != "negated")
      refuse(node, fmt::format("a coil of kind {} is not modelled", excerpt(kind)));
    if (isNegated(node) || kind == "negated") flow = notOf(std::move(flow));
    made.push_back(assignmentOf(variableOf(node), std::move(flow), span));
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
    for (const pugi::xml_node& pin : node.children()) {
      if (!isElement(pin, "variable")) continue;
      const std::string formal = foldedName(pin.attribute("formalParameter").value());
      ExprPtr actual = bodies_.expressionOf(pin);
      if (actual == nullptr) throw Unwritable{};
      if (std::ranges::find(results, formal) != results.end()) {
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
