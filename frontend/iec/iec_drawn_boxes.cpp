// Boxes of a drawing: calls of functions and of instances, and what their pins give.
#include <algorithm>

#include "frontend/iec/iec_drawing_statements.hpp"
#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/iec_parser.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::iec {

namespace {

const std::string noVariable;

/// A value that has no type of its own, or TRUE, or a literal with its type.
bool isLiteralText(const std::string& text) {
  const std::string folded = foldedName(text);
  return folded == "TRUE" || folded == "FALSE" || folded.find('#') != std::string::npos || text.starts_with('\'') ||
         (!text.empty() && text.find_first_not_of("0123456789+-._eE") == std::string::npos);
}

bool isLiteralValue(const Expr& expr) {
  return expr.kind == ExprKind::Literal || (expr.kind == ExprKind::Unary && isLiteralValue(*expr.operands[0]));
}

bool isEnablePin(const DrawnPin& pin) { return foldedName(pin.name) == "EN"; }

/// EN where something leads to it.
const DrawnPin* enablePinOf(const DrawnElement& element) {
  const auto pin = std::ranges::find_if(element.inputs, [](const DrawnPin& each) {
    return isEnablePin(each) && (!each.links.empty() || !each.expression.empty());
  });
  return pin == element.inputs.end() ? nullptr : &*pin;
}

bool hasTargets(const DrawnElement& element) {
  return std::ranges::any_of(element.outputs, [](const DrawnPin& pin) { return !pin.expression.empty(); });
}

bool isReturn(const DrawnElement& element) { return element.code.empty() && foldedName(element.text) == "RETURN"; }
bool isWithoutResult(const DrawnElement& element) { return !element.code.empty() || isReturn(element); }

/// Whether ENO tells more than that EN is TRUE.
bool tellsByEnabled(const DrawnElement& element) {
  const std::string name = foldedName(element.text);
  return name == "DIV" || name == "MOD" || isPartialFunction(name);
}

}  // namespace

bool DrawingToStatements::isFunction(int i) const {
  return circuit_.element(i).kind == DrawnKind::Block && !isInstance(circuit_.element(i));
}

const DrawnPin* DrawingToStatements::outputOf(const DrawnElement& element, const std::string& pin) {
  for (const DrawnPin& output : element.outputs) {
    if (output.name == pin || (pin.empty() && &output == &element.outputs.front())) return &output;
  }
  return nullptr;
}

const DrawnPin* DrawingToStatements::inputNamed(const DrawnElement& element, const std::string& folded) {
  const auto pin =
      std::ranges::find_if(element.inputs, [&](const DrawnPin& each) { return foldedName(each.name) == folded; });
  return pin == element.inputs.end() ? nullptr : &*pin;
}

/// The name of the output that a line comes from, in capitals.
std::string DrawingToStatements::nameOfOutput(const DrawnElement& element, const std::string& pin) {
  const DrawnPin* output = outputOf(element, pin);
  return foldedName(pin.empty() && output != nullptr ? output->name : pin);
}

/// Editors name the result of a function OUT, like the function, or not at all. A box of statements and RETURN have no
/// result: the flow leaves them, whatever the pin is called.
DrawingToStatements::Output DrawingToStatements::outputKind(const DrawnElement& element, const std::string& folded) {
  if (folded == "ENO" || isWithoutResult(element)) return Output::Enabled;
  if (!folded.empty() && folded != "EN" && inputNamed(element, folded) != nullptr) return Output::Passed;
  const std::string name = foldedName(element.text);
  const bool isResult = folded.empty() || folded == "OUT" || folded == name || isStandardFunction(name);
  return isResult ? Output::Result : Output::Other;
}

/// An output of an instance.
ExprPtr DrawingToStatements::memberOf(int i, const std::string& pin) {
  const DrawnElement& element = circuit_.element(i);
  if (!circuit_.isCut(i)) attempt(i);
  const DrawnPin* output = outputOf(element, pin);
  const std::string name = pin.empty() && output != nullptr ? output->name : pin;
  if (name.empty()) refuse(element, fmt::format("which output of {} is meant is not said", nameOf(element)));
  if (outputKind(element, foldedName(name)) == Output::Passed) return passedOn(i, foldedName(name));
  ExprPtr value = parsed(element.instance + "." + name, element.span);
  return output != nullptr && output->negated ? inverted(std::move(value)) : std::move(value);
}

/// The right pin of an IN_OUT gives the variable that the left one has.
ExprPtr DrawingToStatements::passedOn(int i, const std::string& folded) {
  const DrawnElement& element = circuit_.element(i);
  const DrawnPin* pin = inputNamed(element, folded);
  ExprPtr value = pin != nullptr ? arriving(i, *pin) : nullptr;
  if (value == nullptr) refuse(element, fmt::format("nothing leads to {} of {}", folded, nameOf(element)));
  return value;
}

/// What an output of a function gives.
ExprPtr DrawingToStatements::resultOf(int i, const std::string& pin) {
  const DrawnElement& element = circuit_.element(i);
  const DrawnPin* output = outputOf(element, pin);
  const std::string name = nameOfOutput(element, pin);
  const Output kind = outputKind(element, name);
  ExprPtr value;
  if (kind == Output::Result && !isCallOfItsOwn(i)) {
    value = callAt(i, false);
  } else {
    const Box& box = called(i);
    if (kind == Output::Passed) return passedOn(i, name);
    const std::string& told = box.enabled.empty() ? box.enable : box.enabled;
    if (kind == Output::Enabled && told.empty()) {
      value = literalOf("TRUE", element.span);
    } else {
      const auto other = box.outputs.find(name);
      const std::string& given = kind == Output::Enabled      ? told
                                 : kind == Output::Result     ? box.result
                                 : other != box.outputs.end() ? other->second
                                                              : noVariable;
      if (given.empty()) refuse(element, fmt::format("which output of {} is meant is not said", nameOf(element)));
      value = pathOf({given}, element.span);
    }
  }
  return output != nullptr && output->negated ? inverted(std::move(value)) : std::move(value);
}

/// What says whether a value that comes from an element was computed; nullptr: it always is.
ExprPtr DrawingToStatements::enableOf(int source, const std::string& pin) {
  if (!isFunction(source)) return nullptr;
  const DrawnElement& element = circuit_.element(source);
  if (outputKind(element, nameOfOutput(element, pin)) == Output::Enabled) return nullptr;
  const DrawnPin* enable = enablePinOf(element);
  if (enable == nullptr) return nullptr;
  if (!isCallOfItsOwn(source)) {
    ExprPtr flow = arriving(source, *enable);
    return isTrue(*flow) ? nullptr : std::move(flow);
  }
  const Box& box = called(source);
  return box.enable.empty() ? nullptr : pathOf({box.enable}, element.span);
}

/// How many take such an output.
int DrawingToStatements::readersOf(int i, Output kind) const {
  const DrawnElement& element = circuit_.element(i);
  int count = 0;
  for (const DrawnCircuit::Consumer& consumer : circuit_.consumersOf(i)) {
    const bool isRead = circuit_.element(consumer.element).kind != DrawnKind::RightRail;
    if (isRead && outputKind(element, nameOfOutput(element, consumer.link->pin)) == kind) ++count;
  }
  for (const DrawnPin& output : element.outputs) {
    if (!output.expression.empty() && outputKind(element, foldedName(output.name)) == kind) ++count;
  }
  return count;
}

/// Otherwise it is an expression of the one who reads its result. The result of literals alone takes the type of each
/// of its readers.
bool DrawingToStatements::isCallOfItsOwn(int i) const {
  const DrawnElement& element = circuit_.element(i);
  if (!isStandardFunction(foldedName(element.text)) || early_.contains(i)) return true;
  const DrawnPin* enable = enablePinOf(element);
  if (readersOf(i, Output::Enabled) > 0) return true;
  if (enable == nullptr && readersOf(i, Output::Result) > 1) {
    return !std::ranges::all_of(element.inputs, [&](const DrawnPin& pin) {
      if (pin.links.empty()) return pin.expression.empty() || isLiteralText(pin.expression);
      const int source = pin.links.size() == 1 ? circuit_.sourceOf(pin.links[0]) : DrawnCircuit::nothing;
      return source != DrawnCircuit::nothing && circuit_.element(source).kind == DrawnKind::InVariable &&
             isLiteralText(circuit_.element(source).text);
    });
  }
  if (readersOf(i, Output::Result) != 1) return true;
  if (enable == nullptr) return false;
  const auto& readers = circuit_.consumersOf(i);
  const bool isVariable = readers.size() == 1 && circuit_.element(readers[0].element).kind == DrawnKind::OutVariable &&
                          circuit_.element(readers[0].element).inputs[0].links.size() == 1;
  return !isVariable;
}

/// Whether the editor's order calls the box before something is written that it reads, and nobody asks for its result
/// so early.
bool DrawingToStatements::isEarly(int i) const {
  const DrawnElement& element = circuit_.element(i);
  if (!isFunction(i) || element.order <= 0 || circuit_.isLoose(i) || hasTargets(element)) return false;
  std::set<int> behind{i};
  std::vector<int> open{i};
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    for (const DrawnCircuit::Consumer& consumer : circuit_.consumersOf(at)) {
      if (behind.insert(consumer.element).second) open.push_back(consumer.element);
    }
    if (circuit_.element(at).kind != DrawnKind::Connector) continue;
    for (int other = 0; other < circuit_.count(); ++other) {
      const bool goesOn = circuit_.element(other).kind == DrawnKind::Continuation && circuit_.connectorOf(other) == at;
      if (goesOn && behind.insert(other).second) open.push_back(other);
    }
  }
  const std::set<std::string> read = namesUsed(circuit_, i).read;
  const bool isStandard = isStandardFunction(foldedName(element.text));
  const std::vector<int>& results = circuit_.results();
  for (auto at = std::ranges::find(results, i) + 1; at < results.end(); ++at) {
    if (isFunction(*at) && !circuit_.isLoose(*at) && !hasTargets(circuit_.element(*at))) continue;
    if (behind.contains(*at)) return false;
    if (!isStandard) return true;  // it may write anything
    const std::set<std::string> written = namesUsed(circuit_, *at).written;
    if (std::ranges::any_of(written, [&](const std::string& name) { return read.contains(name); })) return true;
  }
  return false;
}

/// Boxes of functions that are called when their results are asked for are no results of the drawing.
std::vector<int> DrawingToStatements::withoutUnneeded(const std::vector<int>& results) const {
  std::vector<int> kept;
  for (const int i : results) {
    if (!isFunction(i) || circuit_.isLoose(i) || hasTargets(circuit_.element(i)) || early_.contains(i))
      kept.push_back(i);
  }
  return kept;
}

/// The box, which was called once this is back.
DrawingToStatements::Box& DrawingToStatements::called(int i) {
  Box& box = boxes_[i];
  if (hasTargets(circuit_.element(i)) && !isDone_[static_cast<std::size_t>(i)]) attempt(i);
  if (box.isLost) throw Unwritable{};
  if (std::exchange(box.isCalled, true)) return box;
  const int outside = std::exchange(taken_, 0);  // it is a statement of its own
  try {
    callBox(i, box);
  } catch (const Unwritable&) {
    box.isLost = true;
    taken_ = outside;
    throw;
  }
  taken_ = outside;
  return box;
}

void DrawingToStatements::callBox(int i, Box& box) {
  const DrawnElement& element = circuit_.element(i);
  const Span span = element.span;
  const DrawnPin* const pin = enablePinOf(element);
  if (ExprPtr flow = pin != nullptr ? arriving(i, *pin) : nullptr; flow != nullptr && !isTrue(*flow)) {
    const bool isKept = flow->kind == ExprKind::Path && flow->parts.size() == 1 &&
                        (flow->parts[0].name.starts_with("__flow_") || flow->parts[0].name.starts_with("__enable_"));
    box.enable = isKept ? flow->parts[0].name : hidden("enable", "BOOL", span);
    if (!isKept) assign(i, pathOf({box.enable}, span), std::move(flow));
  }
  Statements body;
  if (!element.code.empty()) {
    const std::vector<std::uint32_t> places(element.code.size() + 1, element.codeSpan.offset);
    std::vector<Directive> none;
    body = parseBody({element.code, span.file, 0, &places}, sink_, none);
  } else if (isReturn(element)) {
    body.push_back(statementAt(i, StatementKind::Return));
  } else {
    ExprPtr call = callAt(i, false);
    takeOutputs(i, box, *call);
    if (!box.result.empty()) {
      const bool hasType = std::ranges::any_of(call->arguments, [](const Argument& one) {
        const std::string folded = foldedName(one.name);
        return !one.isOutput && folded != "G" && folded != "K" && folded != "N" && !isLiteralValue(*one.value);
      });
      ExprPtr wanted = hasType ? nullptr : wantedAs(i);
      if (!box.enable.empty()) addArgument(*call, pathOf({box.enable}, span), "EN");
      assign(i, pathOf({box.result}, span), std::move(call));
      block_.body.back().last = std::move(wanted);
      return;
    }
    if (!box.enabled.empty() && !box.enable.empty()) assign(i, pathOf({box.enabled}, span), literalOf("FALSE", span));
    body.push_back(callStatementOf(std::move(call)));
  }
  if (box.enable.empty()) {
    for (Statement& one : body) block_.body.push_back(std::move(one));
  } else {
    block_.body.push_back(ifOf(pathOf({box.enable}, span), std::move(body), span));
  }
}

/// Gives a variable to each output that somebody reads.
void DrawingToStatements::takeOutputs(int i, Box& box, Expr& call) {
  const DrawnElement& element = circuit_.element(i);
  // The place in the file tells two boxes of one body apart, and is the same in each order of the results.
  if (readersOf(i, Output::Result) > 0) box.result = fmt::format("{}{}", resultPrefix, element.span.offset);
  const auto give = [&](const std::string& name, const std::string& variable) {
    Argument& made = call.arguments.emplace_back();
    made.name = name;
    made.isOutput = true;
    made.span = element.span;
    made.value = pathOf({variable}, element.span);
  };
  if (tellsByEnabled(element) && readersOf(i, Output::Enabled) > 0) {
    box.enabled = hidden("enabled", "BOOL", element.span);
    give("ENO", box.enabled);
  }
  const auto other = [&](const std::string& folded) {
    if (outputKind(element, folded) != Output::Other || box.outputs.contains(folded)) return;
    give(folded, box.outputs[folded] = fmt::format("{}{}_{}", resultPrefix, element.span.offset, folded));
  };
  for (const DrawnCircuit::Consumer& consumer : circuit_.consumersOf(i))
    other(nameOfOutput(element, consumer.link->pin));
  for (const DrawnPin& output : element.outputs) {
    if (!output.expression.empty()) other(foldedName(output.name));
  }
}

/// A variable with the type that the readers of a result want, if that can be seen: SEL of two literals has none.
ExprPtr DrawingToStatements::wantedAs(int i) {
  std::set<int> seen{i};
  std::vector<int> open{i};
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    for (const DrawnPin& output : circuit_.element(at).outputs) {
      const bool isResult = outputKind(circuit_.element(at), foldedName(output.name)) == Output::Result;
      if (isResult && !output.expression.empty()) return parsed(output.expression, output.span);
    }
    for (const DrawnCircuit::Consumer& consumer : circuit_.consumersOf(at)) {
      const DrawnElement& reader = circuit_.element(consumer.element);
      if (reader.kind == DrawnKind::OutVariable) return parsed(reader.text, reader.span);
      if (!isFunction(consumer.element) || !seen.insert(consumer.element).second) continue;
      for (const DrawnPin& pin : reader.inputs) {
        const std::string folded = foldedName(pin.name);
        if (folded == "EN" || folded == "G" || folded == "K" || folded == "N" || pin.links.size() != 1) continue;
        const int source = circuit_.sourceOf(pin.links[0]);
        if (source == DrawnCircuit::nothing || circuit_.element(source).kind != DrawnKind::InVariable) continue;
        ExprPtr value = parsed(circuit_.element(source).text, reader.span);
        if (value->kind == ExprKind::Path) return value;
      }
      if (!isComparisonFunction(foldedName(reader.text))) open.push_back(consumer.element);
    }
  }
  return nullptr;
}

ExprPtr DrawingToStatements::callAt(int i, bool withEnable) {
  const DrawnElement& element = circuit_.element(i);
  ExprPtr call = callOf({}, element.span);
  if (isInstance(element)) {
    ExprPtr path = parsed(element.instance, element.span);
    call->parts = std::move(path->parts);
  } else {
    if (element.text.empty()) refuse(element, "a box without a name is not modelled");
    call->parts.push_back({PathPart::Kind::Name, element.text, {}, 0, 1, element.span});
  }
  for (const DrawnPin& pin : element.inputs) {
    if (isEnablePin(pin) && !withEnable) continue;
    Argument argument;
    argument.name = pin.name;
    argument.value = arriving(i, pin);
    argument.span = pin.span;
    if (argument.value != nullptr) call->arguments.push_back(std::move(argument));
  }
  return call;
}

void DrawingToStatements::writeBlock(int i) {
  const DrawnElement& element = circuit_.element(i);
  isDone_[static_cast<std::size_t>(i)] = true;
  if (!isFunction(i)) {
    declare(element);
    Statement made = statementAt(i, StatementKind::Call);
    made.target = callAt(i, true);
    block_.body.push_back(std::move(made));
  } else if (isCallOfItsOwn(i)) {
    called(i);
  }
  for (const DrawnPin& output : element.outputs) {
    if (output.expression.empty()) continue;
    ExprPtr value = isFunction(i) ? resultOf(i, output.name) : memberOf(i, output.name);
    ExprPtr target = parsed(output.expression, output.span);
    if (ExprPtr enable = enableOf(i, output.name)) {
      whereTrue(i, std::move(enable), std::move(target), std::move(value));
    } else {
      assign(i, std::move(target), std::move(value));
    }
  }
}

/// An instance that is drawn and not declared has the type of its block.
void DrawingToStatements::declare(const DrawnElement& element) {
  const std::string folded = foldedName(element.instance);
  if (folded.find_first_of(".[") != std::string::npos) return;
  const bool isDeclared =
      std::ranges::any_of(block_.variables, [&](const VariableSyntax& v) { return foldedName(v.name) == folded; });
  if (isDeclared || element.text.empty()) return;
  VariableSyntax made;
  made.name = element.instance;
  sink_.report(Syntax::IecTaken, element.span,
               fmt::format("{} is drawn and not declared: it is taken as an instance of {}", excerpt(element.instance),
                           excerpt(element.text)));
  made.type = std::make_shared<TypeSyntax>();
  made.type->name = element.text;
  made.type->span = made.span = element.span;
  block_.variables.push_back(std::move(made));
}

}  // namespace rungproof::iec
