// LD and FBD bodies to statements.
#include "frontend/iec/iec_drawing.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "frontend/graphical/drawn_circuit.hpp"
#include "frontend/iec/iec_drawn_names.hpp"
#include "frontend/iec/iec_feedback.hpp"
#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/iec_parser.hpp"
#include "frontend/iec/iec_pictures.hpp"
#include "frontend/iec/iec_tree.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::iec {

namespace {

constexpr int mostNested = 400;
constexpr int mostTaken = 2000;  // as many operators as an expression of structured text has

class DrawingToStatements {
 public:
  DrawingToStatements(Program& program, const DrawnNetwork& network, Form form, BlockSyntax& block, SyntaxSink& sink)
      : form_(form),
        block_(block),
        sink_(sink),
        drawnSink_(program),
        circuit_(network, placed(block), isInstance, true),
        isDone_(static_cast<std::size_t>(circuit_.count()), false),
        flows_(static_cast<std::size_t>(circuit_.count())),
        written_(circuit_),
        refused_(static_cast<std::size_t>(circuit_.count())) {}

  void run() {
    for (int i = 0; i < circuit_.count(); ++i) {
      const DrawnElement& e = circuit_.element(i);
      if (e.kind == DrawnKind::Contact) contacts_.insert(inCircuit(i));
    }
    const std::vector<int>& results = circuit_.results();
    const std::vector<int> byPosition = circuit_.resultsByPosition();
    if (results != byPosition && ordersDiffer(circuit_, results, byPosition)) return writeBothOrders(byPosition);
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

 private:
  struct Unwritable {};

  /// What the drawing does in either order of its results, as one statement.
  void writeBothOrders(const std::vector<int>& byPosition) {
    Statements before = std::exchange(block_.body, {});
    const std::vector<int>& stated = circuit_.results();
    for (const int i : stated) attempt(i);
    Statements byNumber = std::exchange(block_.body, {});
    isDone_.assign(isDone_.size(), false);
    flows_.assign(flows_.size(), {});
    written_ = WrittenNames(circuit_);
    before_.clear();
    edges_.clear();
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
  void dropUnused() {
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
  void joined(std::size_t first, const std::vector<int>& results) {
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
  void placeNotes() {
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

  DrawnSink& placed(const BlockSyntax& block) {
    drawnSink_.setPlace(block.name, 0);
    return drawnSink_;
  }

  using InCircuit = std::pair<int, std::string>;
  InCircuit inCircuit(int i) const { return {circuit_.circuitOf(i), foldedName(circuit_.element(i).text)}; }

  /// In front of a coil: a contact of its network that is read behind it may see the value of before.
  void keepForContacts(int i) {
    const InCircuit variable = inCircuit(i);
    if (!contacts_.contains(variable) || before_.contains(variable)) return;
    const Span span = circuit_.element(i).span;
    const std::string kept = hidden("before", "BOOL", span);
    before_.emplace(variable, kept);
    assign(i, pathOf({kept}, span), parsed(circuit_.element(i).text, span));
  }
  /// The variable of a contact, by the reading in force.
  ExprPtr seenBy(int i) {
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
  void attempt(int i) {
    if (isDone_[static_cast<std::size_t>(i)]) return;
    const int outside = std::exchange(taken_, 0);  // it is a statement of its own
    const bool wasWriting = isWriting_;
    try {
      if (circuit_.damaged()[static_cast<std::size_t>(circuit_.circuitOf(i))] || circuit_.isInLoop(i))
        throw Unwritable{};
      write(i);
      written_.note(i);
    } catch (const Unwritable&) {
      Statement lost = statementAt(i, StatementKind::Unread);
      block_.body.push_back(std::move(lost));
    }
    taken_ = outside;
    isWriting_ = wasWriting;
    isDone_[static_cast<std::size_t>(i)] = true;
  }

  [[noreturn]] void refuse(const DrawnElement& element, std::string message) {
    sink_.report(Syntax::IecNotModelled, element.span, std::move(message));
    throw Unwritable{};
  }

  Statement statementAt(int i, StatementKind kind) const {
    Statement made;
    made.kind = kind;
    made.span = circuit_.element(i).span;
    return made;
  }

  static ExprPtr inverted(ExprPtr inner) {
    ExprPtr made = notOf(std::move(inner));
    made->prefix = "BOOL";  // the sign of negation belongs to truth values
    return made;
  }
  static bool isTrue(const Expr& expr) { return expr.kind == ExprKind::Literal && foldedName(expr.text) == "TRUE"; }
  ExprPtr both(ExprPtr left, ExprPtr right) const {
    if (isTrue(*left)) return right;
    return andOf(std::move(left), std::move(right));
  }

  /// The text of an element, which is a variable or any expression.
  ExprPtr parsed(const std::string& text, Span span) {
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
  std::string hidden(std::string_view what, std::string_view type, Span span) {
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

  void assign(int i, ExprPtr target, ExprPtr value) {
    block_.body.push_back(assignmentOf(std::move(target), std::move(value), circuit_.element(i).span));
  }

  /// TRUE in the scan in which the value rises or falls.
  ExprPtr edgeOf(int i, ExprPtr value, DrawnEdge edge) {
    if (edge == DrawnEdge::None) return value;
    const Span span = circuit_.element(i).span;
    const std::string instance = hidden("edge", edge == DrawnEdge::Rising ? "R_TRIG" : "F_TRIG", span);
    ExprPtr call = callOf({instance}, span);
    addArgument(*call, std::move(value), "CLK");
    block_.body.push_back(callStatementOf(std::move(call)));
    return pathOf({instance, "Q"}, span);
  }

  /// The edge memory of a contact is asked once in a scan.
  ExprPtr edgeOfContact(int i) {
    const DrawnElement& element = circuit_.element(i);
    if (element.edge == DrawnEdge::None) return seenBy(i);
    const auto known = edges_.find(i);
    if (known != edges_.end()) return copyOf(*known->second);
    ExprPtr value = edgeOf(i, seenBy(i), element.edge);
    edges_.emplace(i, copyOf(*value));
    return value;
  }

  /// What arrives at a pin: several lines are a parallel connection. nullptr: nothing is connected.
  ExprPtr arriving(int i, const DrawnPin& pin) {
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
  ExprPtr flowInto(int i) {
    const DrawnElement& element = circuit_.element(i);
    ExprPtr flow = element.inputs.empty() ? nullptr : arriving(i, element.inputs[0]);
    if (flow == nullptr) {
      sink_.report(Syntax::IecText, element.span, fmt::format("nothing leads to {}", nameOf(element)));
      throw Unwritable{};
    }
    return flow;
  }

  /// The value at an output pin of an element.
  ExprPtr leaving(int i, const std::string& pin) {
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
  ExprPtr leavingOf(int i, const std::string& pin) {
    const DrawnElement& element = circuit_.element(i);
    switch (element.kind) {
      case DrawnKind::LeftRail: return literalOf("TRUE", element.span);
      case DrawnKind::Contact:
        return shared(i, [&] {
          ExprPtr flow = element.inputs.empty() ? literalOf("TRUE", element.span) : flowInto(i);
          ExprPtr value = edgeOfContact(i);
          if (element.negated) value = inverted(std::move(value));
          return both(std::move(flow), std::move(value));
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
  template <class Make>
  ExprPtr shared(int i, Make&& make) {
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

  const DrawnPin* outputOf(const DrawnElement& element, const std::string& pin) const {
    for (const DrawnPin& output : element.outputs) {
      if (output.name == pin || (pin.empty() && &output == &element.outputs.front())) return &output;
    }
    return nullptr;
  }

  ExprPtr memberOf(int i, const std::string& pin) {
    const DrawnElement& element = circuit_.element(i);
    if (!circuit_.isCut(i)) attempt(i);
    const DrawnPin* output = outputOf(element, pin);
    const std::string name = pin.empty() && output != nullptr ? output->name : pin;
    if (name.empty()) refuse(element, fmt::format("which output of {} is meant is not said", nameOf(element)));
    ExprPtr value = parsed(element.instance + "." + name, element.span);
    return output != nullptr && output->negated ? inverted(std::move(value)) : std::move(value);
  }

  /// The result of a function, or ENO.
  ExprPtr resultOf(int i, const std::string& pin) {
    const DrawnElement& element = circuit_.element(i);
    const DrawnPin* output = outputOf(element, pin);
    const std::string name = foldedName(pin.empty() && output != nullptr ? output->name : pin);
    const auto enable =
        std::ranges::find_if(element.inputs, [](const DrawnPin& p) { return foldedName(p.name) == "EN"; });
    const bool isEnabled = enable != element.inputs.end() && !enable->links.empty();
    if (name == "ENO") return isEnabled ? arriving(i, *enable) : literalOf("TRUE", element.span);
    ExprPtr value = isEnabled && !isWriting_ ? resultKept(i, *enable) : callAt(i, false);
    return output != nullptr && output->negated ? inverted(std::move(value)) : std::move(value);
  }

  /// The result of a comparison whose EN may be FALSE: it is computed where EN is TRUE, and stands in a variable.
  ExprPtr resultKept(int i, const DrawnPin& enable) {
    const DrawnElement& element = circuit_.element(i);
    if (!isComparisonFunction(foldedName(element.text)))
      refuse(element, fmt::format("the result of {} without power flow is not modelled", nameOf(element)));
    std::string& kept = flows_[static_cast<std::size_t>(i)];
    if (kept.empty()) {
      kept = hidden("result", "BOOL", element.span);
      Statement made = statementAt(i, StatementKind::If);
      Branch& branch = made.branches.emplace_back();
      branch.condition = arriving(i, enable);
      branch.body.push_back(assignmentOf(pathOf({kept}, element.span), callAt(i, false), element.span));
      Branch& other = made.branches.emplace_back();
      other.condition = readingOf("iec-en-false-result", "zero", element.span);
      other.body.push_back(assignmentOf(pathOf({kept}, element.span), literalOf("FALSE", element.span), element.span));
      block_.body.push_back(std::move(made));
    }
    return pathOf({kept}, element.span);
  }
  ExprPtr callAt(int i, bool withEnable) {
    const DrawnElement& element = circuit_.element(i);
    ExprPtr call = callOf({}, element.span);
    if (isInstance(element)) {
      ExprPtr path = parsed(element.instance, element.span);
      call->parts = std::move(path->parts);
    } else {
      call->parts.push_back({PathPart::Kind::Name, element.text, {}, 0, 1, element.span});
    }
    for (const DrawnPin& pin : element.inputs) {
      const bool isEnable = foldedName(pin.name) == "EN";
      if (isEnable && !withEnable) continue;
      Argument argument;
      argument.name = pin.name;
      argument.value = arriving(i, pin);
      argument.span = pin.span;
      if (argument.value != nullptr) call->arguments.push_back(std::move(argument));
    }
    return call;
  }

  void write(int i) {
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

  void writeCoil(int i) {
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

  void whereTrue(int i, ExprPtr condition, ExprPtr target, ExprPtr value) {
    const Span span = circuit_.element(i).span;
    Statements body;
    body.push_back(assignmentOf(std::move(target), std::move(value), span));
    block_.body.push_back(ifOf(std::move(condition), std::move(body), span));
  }

  /// Behind a function with EN the variable keeps its value without power flow.
  void writeVariable(int i) {
    const DrawnElement& element = circuit_.element(i);
    if (element.inputs.empty()) throw Unwritable{};
    const DrawnPin& pin = element.inputs[0];
    const int source = pin.links.size() == 1 ? circuit_.sourceOf(pin.links[0]) : DrawnCircuit::nothing;
    ExprPtr enable;
    if (source != DrawnCircuit::nothing && circuit_.element(source).kind == DrawnKind::Block &&
        !isInstance(circuit_.element(source)) && foldedName(pin.links[0].pin) != "ENO") {
      for (const DrawnPin& input : circuit_.element(source).inputs) {
        if (foldedName(input.name) == "EN") enable = arriving(source, input);
      }
    }
    isWriting_ = enable != nullptr;
    ExprPtr value = arriving(i, pin);
    isWriting_ = false;
    if (value == nullptr) {
      sink_.report(Syntax::IecText, element.span, fmt::format("nothing leads to {}", nameOf(element)));
      throw Unwritable{};
    }
    if (element.negated && element.kind == DrawnKind::OutVariable) value = inverted(std::move(value));
    if (enable != nullptr) return whereTrue(i, std::move(enable), parsed(element.text, element.span), std::move(value));
    assign(i, parsed(element.text, element.span), std::move(value));
  }

  void writeBlock(int i) {
    const DrawnElement& element = circuit_.element(i);
    isDone_[static_cast<std::size_t>(i)] = true;
    if (!isInstance(element)) {  // the variable is written at the output of the function
      for (const DrawnPin& output : element.outputs) {
        if (!output.expression.empty()) assign(i, parsed(output.expression, output.span), resultOf(i, output.name));
      }
      return;
    }
    declare(element);
    Statement made = statementAt(i, StatementKind::Call);
    made.target = callAt(i, true);
    block_.body.push_back(std::move(made));
    for (const DrawnPin& output : element.outputs) {
      if (!output.expression.empty()) assign(i, parsed(output.expression, output.span), memberOf(i, output.name));
    }
  }

  /// An instance that is drawn and not declared has the type of its block.
  void declare(const DrawnElement& element) {
    const std::string folded = foldedName(element.instance);
    if (folded.find_first_of(".[") != std::string::npos) return;
    const bool isDeclared =
        std::ranges::any_of(block_.variables, [&](const VariableSyntax& v) { return foldedName(v.name) == folded; });
    if (isDeclared || element.text.empty()) return;
    VariableSyntax made;
    made.name = element.instance;
    sink_.report(Syntax::IecTaken, element.span,
                 fmt::format("{} is drawn and not declared: it is taken as an instance of {}",
                             excerpt(element.instance), excerpt(element.text)));
    made.type = std::make_shared<TypeSyntax>();
    made.type->name = element.text;
    made.type->span = made.span = element.span;
    block_.variables.push_back(std::move(made));
  }

  Form form_;
  BlockSyntax& block_;
  SyntaxSink& sink_;
  DrawnSink drawnSink_;
  DrawnCircuit circuit_;
  std::vector<bool> isDone_;
  std::vector<std::string> flows_;
  std::set<InCircuit> contacts_;             ///< variables that contacts read
  std::map<InCircuit, std::string> before_;  ///< by variable that a coil has written: its value of before
  WrittenNames written_;                     ///< by results so far
  std::map<int, ExprPtr> edges_;             ///< by contact: its edge, once it was asked
  std::vector<int> circuits_;                ///< with statements
  std::set<int> isJoined_;                   ///< the same
  std::vector<std::size_t> firsts_;          ///< parallel: the first statement of each
  std::set<std::string> isTaken_;            ///< of before_
  /// Elements behind each other, and all, of the statement that is being made.
  struct Load {
    int depth = std::numeric_limits<int>::max(), taken = std::numeric_limits<int>::max();
  };
  std::vector<Load> refused_;  ///< by element: with that and more no value leaves it
  int depth_ = 0, taken_ = 0;
  bool isWriting_ = false;
};

}  // namespace

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
