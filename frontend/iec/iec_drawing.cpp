// LD and FBD bodies to statements.
#include "frontend/iec/iec_drawing.hpp"

#include <algorithm>

#include "frontend/iec/iec_drawing_statements.hpp"
#include "frontend/iec/iec_feedback.hpp"
#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/iec_parser.hpp"
#include "frontend/iec/iec_pictures.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::iec {

namespace {

constexpr int mostNested = 400;
constexpr int mostTaken = 2000;  // as many operators as an expression of structured text has

/// Joined behind what leads to it.
ExprPtr inSeries(ExprPtr flow, ExprPtr value) {
  const bool isAtRail = flow->kind == ExprKind::Literal && foldedName(flow->text) == "TRUE";
  return isAtRail ? std::move(value) : andOf(std::move(flow), std::move(value));
}

}  // namespace

DrawingToStatements::DrawingToStatements(Program& program, const DrawnNetwork& network, Form form, BlockSyntax& block,
                                         SyntaxSink& sink)
    : form_(form),
      block_(block),
      sink_(sink),
      drawnSink_(program),
      circuit_(network, placed(block), isInstance, true),
      isDone_(static_cast<std::size_t>(circuit_.count()), false),
      flows_(static_cast<std::size_t>(circuit_.count())),
      written_(circuit_),
      refused_(static_cast<std::size_t>(circuit_.count())) {}

void DrawingToStatements::run() {
  for (int i = 0; i < circuit_.count(); ++i) {
    const DrawnElement& e = circuit_.element(i);
    if (e.kind == DrawnKind::Contact) contacts_.insert(inCircuit(i));
  }
  const std::vector<int> byPosition = withoutUnneeded(circuit_.resultsByPosition());
  for (const int i : circuit_.results()) {
    if (isEarly(i)) early_.insert(i);
  }
  const std::vector<int> results = withoutUnneeded(circuit_.results());
  if (results != byPosition && (!early_.empty() || ordersDiffer(circuit_, results, byPosition)))
    return writeBothOrders(results, byPosition);
  for (std::size_t k = 0; k < results.size();) {
    std::size_t end = k;
    const int number = circuit_.circuitOf(results[k]);
    const std::size_t first = block_.body.size();
    for (; end < results.size() && circuit_.circuitOf(results[end]) == number; ++end) attempt(results[end]);
    joined(first,
           {results.begin() + static_cast<std::ptrdiff_t>(k), results.begin() + static_cast<std::ptrdiff_t>(end)});
    k = end;
  }
  placeNotes();
  dropUnused();
}

/// What the drawing does in either order of its results, as one statement.
void DrawingToStatements::writeBothOrders(const std::vector<int>& stated, const std::vector<int>& byPosition) {
  Statements before = std::exchange(block_.body, {});
  for (const int i : stated) attempt(i);
  Statements byNumber = std::exchange(block_.body, {});
  isDone_.assign(isDone_.size(), false);
  flows_.assign(flows_.size(), {});
  written_ = WrittenNames(circuit_);
  before_.clear();
  edges_.clear();
  boxes_.clear();
  early_.clear();
  for (const int i : byPosition) attempt(i);
  Statement both = ifOf(readingOf("iec-fbd-order", "execution-id", circuit_.network().span), std::move(byNumber),
                        circuit_.network().span);
  both.otherwise = std::exchange(block_.body, std::move(before));
  both.hasElse = true;
  both.circuit = static_cast<int>(block_.body.size()) + 1;
  both.drawn = pictureOf(circuit_, stated, form_, isInstance);
  block_.body.push_back(std::move(both));
}

/// Values of before that no contact took.
void DrawingToStatements::dropUnused() {
  std::set<std::string> unused;
  for (const auto& [variable, name] : before_) {
    if (!isTaken_.contains(name)) unused.insert(name);
  }
  const auto isUnused = [&](const Statement& one) {
    return one.kind == StatementKind::Assign && one.target->parts.size() == 1 &&
           unused.contains(one.target->parts[0].name);
  };
  for (std::size_t k = 0; k + 1 < block_.body.size(); ++k) {
    Statement &one = block_.body[k], &next = block_.body[k + 1];
    if (isUnused(one) && one.drawn != nullptr) next.drawn = std::move(one.drawn);
  }
  std::erase_if(block_.body, isUnused);
}

/// The statements from `first` on are those of one circuit.
void DrawingToStatements::joined(std::size_t first, const std::vector<int>& results) {
  if (first == block_.body.size()) return;
  const int circuit = circuit_.circuitOf(results[0]);
  for (std::size_t k = first; k < block_.body.size(); ++k) block_.body[k].circuit = static_cast<int>(first) + 1;
  if (!circuit_.damaged()[static_cast<std::size_t>(circuit)])
    block_.body[first].drawn = pictureOf(circuit_, results, form_, isInstance);
  if (!isJoined_.insert(circuit).second) return;
  circuits_.push_back(circuit);
  firsts_.push_back(first);
}

/// Comments and titles go to the first statement of the circuit below them.
void DrawingToStatements::placeNotes() {
  std::map<std::size_t, CircuitPicture> changed;
  for (const DrawnNote& note : circuit_.network().notes) {
    const std::size_t chosen = circuit_.below(note, circuits_);
    if (chosen == circuits_.size()) continue;
    const auto& drawn = block_.body[firsts_[chosen]].drawn;
    if (drawn == nullptr) continue;
    CircuitPicture& picture = changed.try_emplace(firsts_[chosen], *drawn).first->second;
    if (picture.title.empty()) picture.title = note.title;
    picture.comments.insert(picture.comments.end(), note.lines.begin(), note.lines.end());
  }
  for (auto& [first, picture] : changed)
    block_.body[first].drawn = std::make_shared<const CircuitPicture>(std::move(picture));
}

DrawnSink& DrawingToStatements::placed(const BlockSyntax& block) {
  drawnSink_.setPlace(block.name, 0);
  return drawnSink_;
}

/// In front of a coil: a contact of its network that is read behind it may see the value of before.
void DrawingToStatements::keepForContacts(int i) {
  const InCircuit variable = inCircuit(i);
  if (!contacts_.contains(variable) || before_.contains(variable)) return;
  const Span span = circuit_.element(i).span;
  const std::string kept = hidden("before", "BOOL", span);
  before_.emplace(variable, kept);
  assign(i, pathOf({kept}, span), parsed(circuit_.element(i).text, span));
}

/// The variable of a contact, by the reading in force.
ExprPtr DrawingToStatements::seenBy(int i) {
  const DrawnElement& element = circuit_.element(i);
  const auto kept = before_.find(inCircuit(i));
  if (kept == before_.end()) return parsed(element.text, element.span);
  ExprPtr choice = callOf({"SEL"}, element.span);
  addArgument(*choice, readingOf("iec-network-feedback", "snapshot", element.span));
  addArgument(*choice, parsed(element.text, element.span));
  addArgument(*choice, pathOf({kept->second}, element.span));
  isTaken_.insert(kept->second);
  return choice;
}

/// A result that cannot be written leaves a statement that was not read.
void DrawingToStatements::attempt(int i) {
  if (isDone_[static_cast<std::size_t>(i)]) return;
  const int outside = std::exchange(taken_, 0);  // it is a statement of its own
  try {
    if (circuit_.damaged()[static_cast<std::size_t>(circuit_.circuitOf(i))] || circuit_.isInLoop(i)) throw Unwritable{};
    write(i);
    written_.note(i);
  } catch (const Unwritable&) {
    Statement lost = statementAt(i, StatementKind::Unread);
    block_.body.push_back(std::move(lost));
  }
  taken_ = outside;
  isDone_[static_cast<std::size_t>(i)] = true;
}

void DrawingToStatements::refuse(const DrawnElement& element, std::string message) {
  sink_.report(Syntax::IecNotModelled, element.span, std::move(message));
  throw Unwritable{};
}

Statement DrawingToStatements::statementAt(int i, StatementKind kind) const {
  Statement made;
  made.kind = kind;
  made.span = circuit_.element(i).span;
  return made;
}

ExprPtr DrawingToStatements::inverted(ExprPtr inner) {
  ExprPtr made = notOf(std::move(inner));
  made->prefix = "BOOL";  // the sign of negation belongs to truth values
  return made;
}

/// The text of an element, which is a variable or any expression.
ExprPtr DrawingToStatements::parsed(const std::string& text, Span span) {
  if (text.empty()) {
    sink_.report(Syntax::IecText, span, "a variable is missing here");
    throw Unwritable{};
  }
  const std::vector<std::uint32_t> places(text.size() + 1, span.offset);
  ExprPtr made = parseExpression({text, span.file, 0, &places}, sink_);
  if (made == nullptr) throw Unwritable{};
  return made;
}

/// A variable that the drawing needs and does not name.
std::string DrawingToStatements::hidden(std::string_view what, std::string_view type, Span span) {
  VariableSyntax made;
  made.name = fmt::format("__{}_{}", what, block_.variables.size());
  made.section = Section::Local;
  made.type = std::make_shared<TypeSyntax>();
  made.type->name = type;
  made.type->span = span;
  made.span = span;
  block_.variables.push_back(std::move(made));
  return block_.variables.back().name;
}

void DrawingToStatements::assign(int i, ExprPtr target, ExprPtr value) {
  block_.body.push_back(assignmentOf(std::move(target), std::move(value), circuit_.element(i).span));
}

/// TRUE in the scan in which the value rises or falls.
ExprPtr DrawingToStatements::edgeOf(int i, ExprPtr value, DrawnEdge edge) {
  if (edge == DrawnEdge::None) return value;
  const Span span = circuit_.element(i).span;
  const std::string instance = hidden("edge", edge == DrawnEdge::Rising ? "R_TRIG" : "F_TRIG", span);
  ExprPtr call = callOf({instance}, span);
  addArgument(*call, std::move(value), "CLK");
  block_.body.push_back(callStatementOf(std::move(call)));
  return pathOf({instance, "Q"}, span);
}

/// The edge memory of a contact is asked once in a scan.
ExprPtr DrawingToStatements::edgeOfContact(int i) {
  const DrawnElement& element = circuit_.element(i);
  if (element.edge == DrawnEdge::None) return seenBy(i);
  const auto known = edges_.find(i);
  if (known != edges_.end()) return copyOf(*known->second);
  ExprPtr value = edgeOf(i, seenBy(i), element.edge);
  edges_.emplace(i, copyOf(*value));
  return value;
}

/// What arrives at a pin: several lines are a parallel connection. nullptr: nothing is connected.
ExprPtr DrawingToStatements::arriving(int i, const DrawnPin& pin) {
  ExprPtr value;
  for (const DrawnLink& link : pin.links) {
    const int source = circuit_.sourceOf(link);
    if (source == DrawnCircuit::nothing) throw Unwritable{};
    ExprPtr one = leaving(source, link.pin);
    value = value == nullptr ? std::move(one) : binaryOf("OR", std::move(value), std::move(one));
  }
  if (value == nullptr && !pin.expression.empty()) value = parsed(pin.expression, pin.span);
  if (value == nullptr) return nullptr;
  if (pin.negated) value = inverted(std::move(value));
  return edgeOf(i, std::move(value), pin.edge);
}

/// The power flow into a contact or coil.
ExprPtr DrawingToStatements::flowInto(int i) {
  const DrawnElement& element = circuit_.element(i);
  ExprPtr flow = element.inputs.empty() ? nullptr : arriving(i, element.inputs[0]);
  if (flow == nullptr) {
    sink_.report(Syntax::IecText, element.span, fmt::format("nothing leads to {}", nameOf(element)));
    throw Unwritable{};
  }
  return flow;
}

/// The value at an output pin of an element.
ExprPtr DrawingToStatements::leaving(int i, const std::string& pin) {
  const DrawnElement& element = circuit_.element(i);
  const Load load{depth_ + 1, taken_ + 1};
  Load& refused = refused_[static_cast<std::size_t>(i)];
  if (load.depth >= refused.depth && load.taken >= refused.taken) throw Unwritable{};
  depth_ = load.depth;
  taken_ = load.taken;
  try {
    if (depth_ > mostNested)
      refuse(element, fmt::format("more than {} elements stand in series: put a coil between them", mostNested));
    if (taken_ > mostTaken)
      refuse(element, fmt::format("more than {} elements lead to one result: put a coil between them", mostTaken));
    ExprPtr made = leavingOf(i, pin);
    depth_ = load.depth - 1;
    return made;
  } catch (const Unwritable&) {
    depth_ = load.depth - 1;
    if (load.depth <= refused.depth && load.taken <= refused.taken) refused = load;
    throw;
  }
}

ExprPtr DrawingToStatements::leavingOf(int i, const std::string& pin) {
  const DrawnElement& element = circuit_.element(i);
  switch (element.kind) {
    case DrawnKind::LeftRail: return literalOf("TRUE", element.span);
    case DrawnKind::Contact:
      return shared(i, [&] {
        ExprPtr flow = element.inputs.empty() ? literalOf("TRUE", element.span) : flowInto(i);
        ExprPtr value = edgeOfContact(i);
        if (element.negated) value = inverted(std::move(value));
        return inSeries(std::move(flow), std::move(value));
      });
    case DrawnKind::Coil: return shared(i, [&] { return flowInto(i); });
    case DrawnKind::InVariable:
    case DrawnKind::InOutVariable: {
      if (element.kind == DrawnKind::InOutVariable && !circuit_.isCut(i)) attempt(i);
      ExprPtr value = parsed(element.text, element.span);
      return element.negated && element.kind == DrawnKind::InVariable ? inverted(std::move(value)) : std::move(value);
    }
    case DrawnKind::Continuation: {
      const int connector = circuit_.connectorOf(i);
      if (connector == DrawnCircuit::nothing || circuit_.isCut(connector))
        refuse(element, "a loop without a function block is not modelled");
      return flowInto(connector);
    }
    case DrawnKind::Connector: return flowInto(i);
    case DrawnKind::Block: return isInstance(element) ? memberOf(i, pin) : resultOf(i, pin);
    default: refuse(element, fmt::format("{} has no value", nameOf(element)));
  }
}

/// A flow that several take is computed once, where the first of them needs it; by the other reading for each of
/// them, which makes a difference where it reads what was written since.
ExprPtr DrawingToStatements::shared(int i, const std::function<ExprPtr()>& make) {
  std::string& kept = flows_[static_cast<std::size_t>(i)];
  const Span span = circuit_.element(i).span;
  if (!kept.empty() && !written_.areReadAt(i)) return pathOf({kept}, span);
  if (!kept.empty()) {
    ExprPtr choice = callOf({"SEL"}, span);
    addArgument(*choice, readingOf("iec-ld-flow", "per-coil", span));
    addArgument(*choice, pathOf({kept}, span));
    addArgument(*choice, make());
    return choice;
  }
  const bool isCoil = circuit_.element(i).kind == DrawnKind::Coil;
  const int outside = taken_;
  ExprPtr value = make();
  if (circuit_.consumersOf(i).size() + (isCoil ? 1 : 0) < 2) return value;
  taken_ = outside;
  kept = hidden("flow", "BOOL", span);
  assign(i, pathOf({kept}, span), std::move(value));
  return pathOf({kept}, span);
}

void DrawingToStatements::write(int i) {
  const DrawnElement& element = circuit_.element(i);
  switch (element.kind) {
    case DrawnKind::Coil: return writeCoil(i);
    case DrawnKind::OutVariable:
    case DrawnKind::InOutVariable: return writeVariable(i);
    case DrawnKind::Block: return writeBlock(i);
    case DrawnKind::Return: {
      Statement made = statementAt(i, StatementKind::If);
      Branch& branch = made.branches.emplace_back();
      branch.condition = flowInto(i);
      if (element.negated) branch.condition = inverted(std::move(branch.condition));
      branch.body.push_back(statementAt(i, StatementKind::Return));
      block_.body.push_back(std::move(made));
      return;
    }
    case DrawnKind::Jump: {
      Statement made = statementAt(i, StatementKind::Jump);
      made.target = pathOf({element.text}, element.span);
      made.value = flowInto(i);
      if (element.negated) made.value = inverted(std::move(made.value));
      block_.body.push_back(std::move(made));
      return;
    }
    case DrawnKind::Label: {
      Statement made = statementAt(i, StatementKind::Label);
      made.target = pathOf({element.text}, element.span);
      block_.body.push_back(std::move(made));
      return;
    }
    default: refuse(element, fmt::format("{} is not modelled", nameOf(element)));
  }
}

void DrawingToStatements::writeCoil(int i) {
  const DrawnElement& element = circuit_.element(i);
  ExprPtr flow = circuit_.consumersOf(i).empty() ? flowInto(i) : leaving(i, "");
  flow = edgeOf(i, std::move(flow), element.edge);
  keepForContacts(i);
  if (element.storage == DrawnStorage::None) {
    if (element.negated) flow = inverted(std::move(flow));
    return assign(i, parsed(element.text, element.span), std::move(flow));
  }
  const bool sets = element.storage == DrawnStorage::Set;
  whereTrue(i, std::move(flow), parsed(element.text, element.span), literalOf(sets ? "TRUE" : "FALSE", element.span));
}

void DrawingToStatements::whereTrue(int i, ExprPtr condition, ExprPtr target, ExprPtr value) {
  const Span span = circuit_.element(i).span;
  Statements body;
  body.push_back(assignmentOf(std::move(target), std::move(value), span));
  block_.body.push_back(ifOf(std::move(condition), std::move(body), span));
}

/// Behind a function with EN the variable keeps its value without power flow.
void DrawingToStatements::writeVariable(int i) {
  const DrawnElement& element = circuit_.element(i);
  if (element.inputs.empty()) throw Unwritable{};
  const DrawnPin& pin = element.inputs[0];
  const int source = pin.links.size() == 1 ? circuit_.sourceOf(pin.links[0]) : DrawnCircuit::nothing;
  ExprPtr enable = source != DrawnCircuit::nothing ? enableOf(source, pin.links[0].pin) : nullptr;
  ExprPtr value = arriving(i, pin);
  if (value == nullptr) {
    sink_.report(Syntax::IecText, element.span, fmt::format("nothing leads to {}", nameOf(element)));
    throw Unwritable{};
  }
  if (element.negated && element.kind == DrawnKind::OutVariable) value = inverted(std::move(value));
  ExprPtr target = parsed(element.text, element.span);
  if (element.storage != DrawnStorage::None) {
    const bool sets = element.storage == DrawnStorage::Set;
    return whereTrue(i, andOf(std::move(enable), std::move(value)), std::move(target),
                     literalOf(sets ? "TRUE" : "FALSE", element.span));
  }
  if (enable != nullptr) return whereTrue(i, std::move(enable), std::move(target), std::move(value));
  assign(i, std::move(target), std::move(value));
}

void drawnStatements(Program& program, const DrawnNetwork& network, Form form, BlockSyntax& block, SyntaxSink& sink) {
  if (network.isDamaged) {
    Statement lost;
    lost.kind = StatementKind::Unread;
    lost.span = network.span;
    block.body.push_back(std::move(lost));
  }
  const std::string name = fmt::format("{}{}", feedbackName, block.variables.size());
  const std::optional<FeedbackNetworks> cut = withFeedback(network, name);
  if (!cut) return DrawingToStatements(program, network, form, block, sink).run();
  VariableSyntax& kept = block.variables.emplace_back();
  kept.name = name;
  kept.type = std::make_shared<TypeSyntax>();
  kept.type->name = "BOOL";
  kept.type->span = kept.span = network.span;
  if (cut->isSame) return DrawingToStatements(program, cut->stated, form, block, sink).run();
  std::shared_ptr<const CircuitPicture> picture;  // of the first order
  const auto drawn = [&](const DrawnNetwork& one) {
    Statements outer = std::exchange(block.body, {});
    DrawingToStatements(program, one, form, block, sink).run();
    Statements made = std::exchange(block.body, std::move(outer));
    for (Statement& s : made) {
      if (picture == nullptr) picture = s.drawn;
      s.circuit = 0;
      s.drawn = nullptr;
    }
    return made;
  };
  Statement both = ifOf(readingOf("iec-fbd-order", "execution-id", network.span), drawn(cut->stated), network.span);
  both.otherwise = drawn(cut->byPlace);
  both.hasElse = true;
  both.circuit = static_cast<int>(block.body.size()) + 1;
  both.drawn = std::move(picture);
  block.body.push_back(std::move(both));
}

}  // namespace rungproof::iec
