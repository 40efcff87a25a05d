// SFC bodies of PLCopen TC6 XML to charts.
#include "frontend/iec/iec_plcopen_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "frontend/iec/iec_tree.hpp"
#include "frontend/plcopen/plcopen_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/xml/xml_shape.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::iec {

namespace {

/// Elements of a chart (TC6 2.01); those of LD and FBD have their shapes in frontend/plcopen/plcopen_body.cpp.
constexpr XmlShape chartShapes[] = {
    {"SFC", "localId globalId",
     "step macroStep jumpStep transition selectionDivergence selectionConvergence simultaneousDivergence "
     "simultaneousConvergence actionBlock leftPowerRail rightPowerRail contact coil block inVariable outVariable "
     "inOutVariable connector continuation comment vendorElement addData documentation"},
    {"step", "localId globalId height:d width:d executionOrderId:n name initialStep:b negated:false|0",
     "position connectionPointIn connectionPointOut connectionPointOutAction documentation addData"},
    {"transition", "localId globalId height:d width:d executionOrderId:n priority:n",
     "position connectionPointIn connectionPointOut condition documentation addData"},
    {"condition", "negated:b", "reference inline connectionPointIn addData"},
    {"jumpStep", "localId globalId height:d width:d executionOrderId:n targetName",
     "position connectionPointIn documentation addData"},
    {"selectionDivergence", "localId globalId height:d width:d executionOrderId:n name",
     "position connectionPointIn connectionPointOut documentation addData"},
    {"selectionConvergence", "localId globalId height:d width:d executionOrderId:n name",
     "position connectionPointIn connectionPointOut documentation addData"},
    {"simultaneousDivergence", "localId globalId height:d width:d executionOrderId:n name",
     "position connectionPointIn connectionPointOut documentation addData"},
    {"simultaneousConvergence", "localId globalId height:d width:d executionOrderId:n name",
     "position connectionPointIn connectionPointOut documentation addData"},
    {"actionBlock", "localId globalId height:d width:d executionOrderId:n negated:false|0",
     "position connectionPointIn connectionPointOut action documentation addData"},
    {"action", "localId globalId height:d width:d qualifier duration indicator executionOrderId:n",
     "relPosition reference inline connectionPointOut documentation addData"},
    {"reference", "name", "addData"},
};

class PlcopenChart {
 public:
  PlcopenChart(PlcopenBodies& bodies, const pugi::xml_node& sfc, const pugi::xml_node& pou, BlockSyntax& block)
      : bodies_(bodies), sfc_(sfc), pou_(pou), block_(block) {}

  ChartSyntax read() {
    chart_.span = bodies_.placeOf(sfc_);
    for (const ShapeFault& fault : faultsOf(sfc_, chartShapes)) refuse(fault.node, fault.message);
    for (const pugi::xml_node& node : sfc_.children()) {
      if (node.type() != pugi::node_element) continue;
      const std::string id = node.attribute("localId").value();
      if (!id.empty()) elements_.emplace(id, node);
      const std::string_view name = localName(node);
      if (name == "step") readStep(node);
      if (name == "transition") transitions_.push_back(node);
      if (name == "macroStep") refuse(node, "macro steps are not modelled", Syntax::IecNotModelled);
      refuseVendorActions(node);
    }
    readActions();
    std::ranges::stable_sort(transitions_, {}, [](const pugi::xml_node& node) {
      return childNamed(node, "position").attribute("x").as_double();
    });
    for (const pugi::xml_node& node : transitions_) readTransition(node);
    for (const pugi::xml_node& node : sfc_.children()) {
      const std::string_view name = localName(node);
      if (name == "step" || name == "jumpStep") readSuccessor(node, name == "step" ? "name" : "targetName");
      if (name == "actionBlock") readActionBlock(node);
    }
    refuseLooseResults();
    for (std::size_t i = 0; i < transitions_.size(); ++i) {
      if (chart_.transitions[i].to.empty()) refuse(transitions_[i], "the transition leads to no step");
    }
    return std::move(chart_);
  }

 private:
  void refuse(const pugi::xml_node& node, std::string message, Syntax code = Syntax::XmlStructure) {
    chart_.isWhole = false;
    bodies_.report(node, code, std::move(message));
  }

  /// CODESYS writes there which actions run at the entry of a step, while it is active and at its exit; without a text
  /// there is none. Its name and two values that say nothing stand there too. What else it says is not known.
  void refuseVendorActions(const pugi::xml_node& node) {
    for (const pugi::xml_node& data : childNamed(node, "addData").children()) {
      const std::string_view name = data.attribute("name").value();
      if (name.ends_with("/sfc/element")) refuseVendorAttributes(node, data);
    }
  }
  void refuseVendorAttributes(const pugi::xml_node& node, const pugi::xml_node& data) {
    enum class Meaning : std::uint8_t { Name, Switch, Number, Action };
    static const std::map<std::string_view, Meaning> meanings = {
        {"38391c6d-6d4a-42f8-8ee7-9f45e5adafa8", Meaning::Name},
        {"01580b27-6378-448b-8ecb-0e4b795b58d6", Meaning::Switch},
        {"bc882c11-1e91-4dd8-a6b8-2075724ed18b", Meaning::Number},
        {"6844a48e-46c2-4cc8-a185-a478f3b99cc0", Meaning::Name},  // initial: the step says it itself
        {"700a583f-b4d4-43e4-8c14-629c7cd3bec8", Meaning::Action},
        {"a6b08bd8-b696-47e3-9cbf-7408b61c9ff8", Meaning::Action},
        {"a2621e18-7de3-4ea6-ae6d-89e9e0b7befd", Meaning::Action}};
    for (const pugi::xml_node& attribute : childNamed(data, "attributes").children()) {
      const std::string value = foldedName(attribute.text().get());
      if (attribute.type() != pugi::node_element || value.find_first_not_of(" \t\r\n") == std::string::npos) continue;
      const std::string_view guid = attribute.attribute("guid").value();
      const auto meaning = meanings.find(guid);
      if (meaning != meanings.end() && meaning->second == Meaning::Name) continue;
      if (meaning != meanings.end() && meaning->second == Meaning::Switch && value == "FALSE") continue;
      if (meaning != meanings.end() && meaning->second == Meaning::Number && value == "0") continue;
      const bool isAction = meaning != meanings.end() && meaning->second == Meaning::Action;
      refuse(node,
             isAction ? "actions of CODESYS at entry and exit of a step are not modelled"
                      : fmt::format("what {} of CODESYS says of a step is not known", excerpt(guid)),
             Syntax::IecNotModelled);
    }
  }

  void readStep(const pugi::xml_node& node) {
    ChartStep& made = chart_.steps.emplace_back();
    made.name = node.attribute("name").value();
    made.isInitial = node.attribute("initialStep").as_bool();
    made.span = bodies_.placeOf(node);
    if (made.name.empty()) refuse(node, "a step has no name");
  }

  /// Bodies that the block names, in their order.
  void readActions() {
    for (const pugi::xml_node& node : childNamed(pou_, "actions").children()) {
      if (localName(node) != "action") continue;
      ChartBody& made = chart_.actions.emplace_back();
      made.name = node.attribute("name").value();
      made.span = bodies_.placeOf(node);
      made.body = bodies_.statementsOf(childNamed(node, "body"), block_);
      if (made.name.empty()) refuse(node, "an action has no name");
    }
  }

  static std::vector<pugi::xml_node> connections(const pugi::xml_node& node) {
    std::vector<pugi::xml_node> all;
    for (const pugi::xml_node& point : node.children()) {
      if (localName(point) != "connectionPointIn") continue;
      for (const pugi::xml_node& child : point.children()) {
        if (localName(child) == "connection") all.push_back(child);
      }
    }
    return all;
  }

  /// The elements of that kind above a node, through divergences and convergences of these two kinds.
  std::vector<pugi::xml_node> above(const pugi::xml_node& node, std::string_view wanted, std::string_view through,
                                    std::string_view orThrough) {
    std::vector<pugi::xml_node> found, open = {node};
    std::set<std::string> seen;
    while (!open.empty()) {
      const pugi::xml_node at = open.back();
      open.pop_back();
      std::vector<pugi::xml_node> next;
      for (const pugi::xml_node& connection : connections(at)) {
        const std::string id = connection.attribute("refLocalId").value();
        const auto element = elements_.find(id);
        if (element == elements_.end()) {
          refuse(connection, fmt::format("there is no element {}", excerpt(id)));
          continue;
        }
        const std::string_view kind = localName(element->second);
        if (kind == wanted)
          found.push_back(element->second);
        else if (kind == through || kind == orThrough)
          next.push_back(element->second);
        else
          refuse(connection, fmt::format("<{}> does not lead to <{}>", kind, localName(at)));
      }
      for (auto one = next.rbegin(); one != next.rend(); ++one) {
        if (seen.insert(one->attribute("localId").value()).second) open.push_back(*one);
      }
    }
    return found;
  }

  void readTransition(const pugi::xml_node& node) {
    ChartTransition made;
    made.span = bodies_.placeOf(node);
    if (const int priority = node.attribute("priority").as_int(); priority != 0) made.priority = priority;
    for (const pugi::xml_node& step : above(node, "step", "selectionDivergence", "simultaneousConvergence"))
      made.from.emplace_back(step.attribute("name").value(), bodies_.placeOf(step));
    if (connections(node).size() > 1) refuse(node, "several lines lead to a transition without a convergence");
    if (made.from.empty()) refuse(node, "no step leads to the transition");
    const pugi::xml_node condition = childNamed(node, "condition");
    bool isRead = false;
    for (const pugi::xml_node& child : condition.children()) {
      if (child.type() != pugi::node_element || localName(child) == "addData") continue;
      if (std::exchange(isRead, true)) {
        refuse(child, "the transition has several conditions");
      } else if (localName(child) == "inline") {
        readInline(child, made);
      } else if (localName(child) == "reference") {
        readNamed(child, made);
      } else {
        readConnected(condition, made);
      }
    }
    if (!isRead) bodies_.report(node, Syntax::XmlStructure, "the transition has no condition");
    if (condition.attribute("negated").as_bool()) negate(made);
    chart_.transitions.push_back(std::move(made));
  }

  static void negate(ChartTransition& made) {
    if (made.condition != nullptr) made.condition = notOf(std::move(made.condition));
    if (made.body.empty()) return;
    if (made.result.empty()) {  // a list: what is current behind it
      Statement& inverted = made.body.emplace_back();
      inverted.kind = StatementKind::Line;
      inverted.span = made.span;
      inverted.line = std::make_unique<ListLine>();
      inverted.line->op = "NOT";
      inverted.line->opSpan = made.span;
      return;
    }
    made.body.push_back(
        assignmentOf(pathOf({made.result}, made.span), notOf(pathOf({made.result}, made.span)), made.span));
  }

  static pugi::xml_node languageIn(const pugi::xml_node& body) {
    for (const pugi::xml_node& child : body.children()) {
      if (child.type() == pugi::node_element && localName(child) != "documentation" && localName(child) != "addData")
        return child;
    }
    return {};
  }

  /// A condition that stands at the transition: an expression, or a list.
  void readInline(const pugi::xml_node& node, ChartTransition& made) {
    const pugi::xml_node language = languageIn(node);
    if (localName(language) == "ST") {
      made.condition = bodies_.expressionOf(language);
    } else if (localName(language) == "IL") {
      made.body = bodies_.statementsOf(node, block_);
    } else {
      readByName(node, node.attribute("name").value(), made);
    }
  }

  /// `full` or, as Beremiz writes it, `:= full;`: a condition that writes nothing.
  static bool isExpression(const pugi::xml_node& language) {
    if (localName(language) != "ST") return false;
    const std::string text = allText(language);
    const std::size_t first = text.find_first_not_of(" \t\r\n"), last = text.rfind(":=");
    return last == std::string::npos || last == first;
  }

  /// A named transition of the block, or a variable.
  void readNamed(const pugi::xml_node& node, ChartTransition& made) {
    const std::string name = node.attribute("name").value();
    for (const pugi::xml_node& transition : childNamed(pou_, "transitions").children()) {
      if (localName(transition) != "transition" || foldedName(transition.attribute("name").value()) != foldedName(name))
        continue;
      const pugi::xml_node body = childNamed(transition, "body");
      const pugi::xml_node language = languageIn(body);
      if (isExpression(language))
        made.condition = bodies_.expressionOf(language);
      else
        readByName(body, name, made);
      return;
    }
    made.condition = bodies_.expressionOf(name, node);
  }

  /// The body writes a variable with the name of the transition.
  void readByName(const pugi::xml_node& body, const std::string& name, ChartTransition& made) {
    if (name.empty()) {
      bodies_.report(body, Syntax::IecNotModelled, "the condition has no name that its drawing could write");
      return;
    }
    const bool isDeclared = std::ranges::any_of(
        block_.variables, [&](const VariableSyntax& v) { return foldedName(v.name) == foldedName(name); });
    if (!isDeclared) {
      VariableSyntax& variable = block_.variables.emplace_back();
      variable.name = name;
      variable.type = std::make_shared<TypeSyntax>();
      variable.type->name = "BOOL";
      variable.type->span = variable.span = made.span;
    }
    made.body = bodies_.statementsOf(body, block_);
    if (localName(languageIn(body)) != "IL") made.result = name;
  }

  /// What is drawn in the chart, writes something and belongs to no condition.
  void refuseLooseResults() {
    for (const pugi::xml_node& node : sfc_.children()) {
      const std::string_view name = localName(node);
      const bool isResult = name == "coil" || name == "outVariable" || name == "inOutVariable" || name == "block";
      if (isResult && !inConditions_.contains(node.attribute("localId").value()))
        refuse(node, fmt::format("<{}> in a chart belongs to no condition: when it is executed is not said", name),
               Syntax::IecNotModelled);
    }
  }

  /// Contacts, variables and functions that are drawn beside the transition.
  void readConnected(const pugi::xml_node& condition, ChartTransition& made) {
    const DrawnNetwork all = bodies_.networkOf(sfc_);
    std::map<std::string, const DrawnElement*> byId;
    for (const DrawnElement& element : all.elements) byId.emplace(element.id, &element);
    DrawnNetwork network;
    network.span = made.span;
    DrawnElement result;
    result.kind = DrawnKind::OutVariable;
    result.id = "condition";
    result.span = made.span;
    result.x = result.y = 1e9;
    DrawnPin& pin = result.inputs.emplace_back();
    pin.span = made.span;
    for (const pugi::xml_node& connection : connections(condition))
      pin.links.push_back({connection.attribute("refLocalId").value(), connection.attribute("formalParameter").value(),
                           bodies_.placeOf(connection)});
    std::set<std::string> seen;
    std::vector<const DrawnPin*> open = {&pin};
    while (!open.empty()) {
      const DrawnPin& at = *open.back();
      open.pop_back();
      for (const DrawnLink& link : at.links) {
        const auto element = byId.find(link.from);
        if (element == byId.end() || !seen.insert(link.from).second) continue;
        network.elements.push_back(*element->second);
        inConditions_.insert(link.from);
        for (const DrawnPin& input : element->second->inputs) open.push_back(&input);
        for (const ShapeFault& fault : plcopenFaults(elements_.at(link.from))) {
          bodies_.report(fault.node, Syntax::XmlStructure, fault.message);
          network.isDamaged = true;
        }
      }
    }
    made.result = result.text = hiddenVariable(block_, "condition", "BOOL", made.span);
    network.elements.push_back(std::move(result));
    made.body = bodies_.statementsOf(network, block_);
  }

  /// The transitions above lead to the step.
  void readSuccessor(const pugi::xml_node& node, const char* name) {
    const std::string step = node.attribute(name).value();
    for (const pugi::xml_node& transition :
         above(node, "transition", "selectionConvergence", "simultaneousDivergence")) {
      const auto at = std::ranges::find(transitions_, transition);
      chart_.transitions[static_cast<std::size_t>(at - transitions_.begin())].to.emplace_back(step,
                                                                                              bodies_.placeOf(node));
    }
  }

  void readActionBlock(const pugi::xml_node& node) {
    const std::vector<pugi::xml_node> links = connections(node);
    ChartStep* step = nullptr;
    if (links.size() == 1) {
      const auto element = elements_.find(links[0].attribute("refLocalId").value());
      if (element != elements_.end() && localName(element->second) == "step") {
        const std::string folded = foldedName(element->second.attribute("name").value());
        const auto found =
            std::ranges::find_if(chart_.steps, [&](const ChartStep& s) { return foldedName(s.name) == folded; });
        if (found != chart_.steps.end()) step = &*found;
      }
    }
    if (step == nullptr) return refuse(node, "which step has these actions is not said");
    for (const pugi::xml_node& child : node.children()) {
      if (localName(child) == "action") readAction(child, *step);
    }
  }

  void readAction(const pugi::xml_node& node, ChartStep& step) {
    ChartAction made;
    made.span = bodies_.placeOf(node);
    const std::string qualifier = node.attribute("qualifier").value();
    const auto known = qualifierNamed(qualifier.empty() ? "N" : qualifier);
    if (!known) return refuse(node, fmt::format("{} is no qualifier of an action", excerpt(qualifier)));
    made.qualifier = *known;
    const std::string duration = node.attribute("duration").value();
    if (takesTime(*known)) {
      if (duration.empty()) return refuse(node, fmt::format("{} needs a duration", qualifier));
      made.time = bodies_.expressionOf(duration, node);
      made.timeText = duration;
      if (made.time == nullptr) {
        chart_.isWhole = false;
        return;
      }
    }
    if (const pugi::xml_node reference = childNamed(node, "reference")) {
      made.name = reference.attribute("name").value();
    } else if (const pugi::xml_node body = childNamed(node, "inline")) {
      ChartBody& own = chart_.actions.emplace_back();
      own.name = made.name = fmt::format("{}.{}", step.name, step.actions.size() + 1);
      own.span = made.span;
      own.body = bodies_.statementsOf(body, block_);
    }
    if (made.name.empty()) return refuse(node, "an action has neither a name nor a body");
    step.actions.push_back(std::move(made));
  }

  PlcopenBodies& bodies_;
  pugi::xml_node sfc_, pou_;
  BlockSyntax& block_;
  ChartSyntax chart_;
  std::map<std::string, pugi::xml_node> elements_;
  std::vector<pugi::xml_node> transitions_;  ///< as in chart_
  std::set<std::string> inConditions_;       ///< elements of LD and FBD that lead to a transition
};

}  // namespace

ChartSyntax readPlcopenChart(PlcopenBodies& bodies, const pugi::xml_node& sfc, const pugi::xml_node& pou,
                             BlockSyntax& block) {
  return PlcopenChart(bodies, sfc, pou, block).read();
}

}  // namespace rungproof::iec
