// Charts to statements. In a scan all transitions are tested on the situation of its start, then the steps change, then
// the actions of the new situation run; or the actions run first (iec-sfc-order). The action control is that of the
// standard: of each action one value Q over all its associations.
#include "frontend/iec/iec_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "frontend/iec/iec_parser.hpp"
#include "frontend/iec/iec_tree.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "ir/iec/statement_text.hpp"

namespace rungproof::iec {

namespace {

constexpr std::pair<std::string_view, Qualifier> qualifiers[] = {
    {"N", Qualifier::N},   {"S", Qualifier::S},   {"R", Qualifier::R},   {"L", Qualifier::L},
    {"D", Qualifier::D},   {"P", Qualifier::P},   {"P0", Qualifier::P0}, {"P1", Qualifier::P1},
    {"SD", Qualifier::SD}, {"DS", Qualifier::DS}, {"SL", Qualifier::SL}};

/// Whether computing it may end the scan or has an effect: it is computed only where the transition is enabled.
bool isGuarded(const Expr& expr) {
  if (expr.kind == ExprKind::Call || (expr.kind == ExprKind::Binary && (expr.text == "/" || expr.text == "MOD")))
    return true;
  const bool hasIndex = std::ranges::any_of(expr.parts, [](const PathPart& p) { return !p.indices.empty(); });
  return hasIndex || std::ranges::any_of(expr.operands, [](const ExprPtr& inner) { return isGuarded(*inner); });
}

class ChartWriter {
 public:
  ChartWriter(ChartSyntax& chart, BlockSyntax& block, SyntaxSink& sink) : chart_(chart), block_(block), sink_(sink) {}

  Statements run() {
    Statements made;
    limitSize();
    const std::string picture = pictureOf();
    check();
    if (!chart_.isWhole) {
      Statement lost;
      lost.kind = StatementKind::Unread;
      lost.span = chart_.span;
      made.push_back(std::move(lost));
    }
    declareSteps();
    for (ChartBody& body : chart_.actions) addBody(body);
    readClocks();
    const std::string transitions = routine("transitions", writeTransitions());
    Statements control = actionStatements(chart_, block_);
    const bool hasActions = !control.empty();
    const std::string actions = hasActions ? routine("actions", std::move(control)) : std::string();
    const Span place{chart_.span.file, chart_.span.offset, 0};
    const auto call = [&](const std::string& name) { return callStatementOf(callOf({name}, place)); };
    if (!hasActions) {
      made.push_back(call(transitions));
    } else {
      Statements actionsFirst;
      actionsFirst.push_back(call(actions));
      actionsFirst.push_back(call(transitions));
      Statement order = ifOf(readingOf("iec-sfc-order", "actions-first", place), std::move(actionsFirst), place);
      order.hasElse = true;
      order.otherwise.push_back(call(transitions));
      order.otherwise.push_back(call(actions));
      made.push_back(std::move(order));
    }
    made.back().picture = picture;
    return made;
  }

 private:
  /// The chart for people: each step with its actions, and below it the transitions that leave it.
  ///   [[Idle]]
  ///     | Start => (Fill, Heat)
  ///   [Fill]  Valve(N), Late(D, T#2s)
  std::string pictureOf() {
    std::string text;
    for (const ChartStep& step : chart_.steps) {
      text += fmt::format(fmt::runtime(step.isInitial ? "[[{}]]" : "[{}]"), step.name);
      for (const ChartAction& action : step.actions)
        text += fmt::format("{}{}({}{})", &action == &step.actions.front() ? "  " : ", ", action.name,
                            nameOf(action.qualifier), action.timeText.empty() ? "" : ", " + action.timeText);
      text += "\n";
      for (const ChartTransition& transition : chart_.transitions) {
        if (transition.from.empty() || foldedName(transition.from[0].first) != foldedName(step.name)) continue;
        text += "  | ";
        if (transition.priority) text += fmt::format("{}: ", *transition.priority);
        if (transition.from.size() > 1) text += fmt::format("{}: ", namesOf(transition.from));
        text += conditionText(transition);
        text += fmt::format(" {} {}\n", transition.to.size() > 1 ? "=>" : "->", namesOf(transition.to));
      }
    }
    return text;
  }
  static std::string namesOf(const std::vector<std::pair<std::string, Span>>& list) {
    std::string names;
    for (const auto& [name, span] : list) names += (names.empty() ? "" : ", ") + name;
    return list.size() == 1 ? names : "(" + names + ")";
  }
  static std::string_view nameOf(Qualifier qualifier) {
    for (const auto& [text, known] : qualifiers) {
      if (known == qualifier) return text;
    }
    return {};
  }
  /// As it stands in the file, in one line.
  std::string written(Span span) const {
    std::string text;
    for (const char c : sink_.program().sources->text(span)) {
      const bool isBlank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
      if (!isBlank || (!text.empty() && text.back() != ' ')) text += isBlank ? ' ' : c;
    }
    return text;
  }
  std::string conditionText(const ChartTransition& transition) const {
    if (transition.condition != nullptr) return written(transition.condition->span);
    std::string text;
    for (const Statement& s : transition.body) {
      if (s.kind != StatementKind::Line && transition.result.empty()) continue;
      text += (text.empty() ? "" : "; ") + written(s.span);
    }
    if (text.empty()) return "(not read)";
    const bool isDrawn = transition.body[0].kind != StatementKind::Line && text.starts_with("<");
    return isDrawn ? drawnText(transition.body) : text;
  }
  /// What a drawing says of a transition, as structured text.
  static std::string drawnText(const Statements& body) {
    const Statement& last = body.back();
    if (body.size() == 1 && last.kind == StatementKind::Assign) return expressionText(*last.value);
    std::string text;
    for (const Statement& one : body) {
      for (const std::string& line : statementLines(one)) text += (text.empty() ? "" : " ") + line;
    }
    return text;
  }

  void error(Syntax code, Span span, std::string message) {
    chart_.isWhole = false;
    sink_.report(code, span, std::move(message));
  }

  ChartStep* stepNamed(const std::string& name) {
    const std::string folded = foldedName(name);
    const auto found =
        std::ranges::find_if(chart_.steps, [&](const ChartStep& s) { return foldedName(s.name) == folded; });
    return found == chart_.steps.end() ? nullptr : &*found;
  }

  /// Which transition comes before which is written out for all that leave one step.
  void limitSize() {
    std::map<std::string, std::size_t> leaving;
    std::size_t most = 0;
    for (const ChartTransition& transition : chart_.transitions) {
      for (const auto& [name, span] : transition.from) most = std::max(most, ++leaving[foldedName(name)]);
    }
    if (chart_.steps.size() <= mostParts && chart_.transitions.size() <= mostParts && most <= mostBranches) return;
    error(Syntax::IecNotModelled, chart_.span,
          fmt::format("a chart of more than {} steps or transitions, or of {} that leave one step, is not modelled",
                      mostParts, mostBranches));
    chart_.transitions.clear();
    chart_.steps.resize(std::min<std::size_t>(chart_.steps.size(), mostParts));
  }

  /// Names, and one initial step in each net.
  void check() {
    std::set<std::string> names;
    for (const VariableSyntax& variable : block_.variables) names.insert(foldedName(variable.name));
    for (const ChartStep& step : chart_.steps) {
      if (!names.insert(foldedName(step.name)).second)
        error(Syntax::IecName, step.span, fmt::format("the name {} of a step is taken", excerpt(step.name)));
    }
    std::vector<std::size_t> net(chart_.steps.size());
    std::iota(net.begin(), net.end(), std::size_t{0});
    const auto join = [&](std::size_t a, std::size_t b) {
      const std::size_t from = net[a], to = net[b];
      std::ranges::replace(net, from, to);
    };
    for (const ChartTransition& transition : chart_.transitions) {
      std::vector<std::size_t> known;
      for (const auto* list : {&transition.from, &transition.to}) {
        for (const auto& [name, span] : *list) {
          if (const ChartStep* step = stepNamed(name))
            known.push_back(static_cast<std::size_t>(step - chart_.steps.data()));
          else
            error(Syntax::IecName, span, fmt::format("there is no step {}", excerpt(name)));
        }
      }
      for (const std::size_t one : known) join(known[0], one);
    }
    std::map<std::size_t, const ChartStep*> initial;
    for (std::size_t i = 0; i < net.size(); ++i) {
      if (!chart_.steps[i].isInitial) continue;
      const auto [at, isNew] = initial.emplace(net[i], &chart_.steps[i]);
      if (!isNew)
        error(Syntax::IecText, chart_.steps[i].span,
              fmt::format("{} and {} are both initial steps of one chart", at->second->name, chart_.steps[i].name));
    }
    if (initial.empty()) error(Syntax::IecText, chart_.span, "the chart has no initial step");
  }

  void declareSteps() {
    for (const ChartStep& step : chart_.steps) {
      const bool isTaken = std::ranges::any_of(
          block_.variables, [&](const VariableSyntax& v) { return foldedName(v.name) == foldedName(step.name); });
      if (isTaken) continue;
      VariableSyntax made;
      made.name = step.name;
      made.type = std::make_shared<TypeSyntax>();
      made.type->name = "__STEP";
      made.type->span = made.span = step.span;
      if (step.isInitial) {
        made.initial = std::make_shared<Initial>();
        made.initial->isStructure = true;
        made.initial->span = step.span;
        made.initial->fields.emplace_back("X", Initial{});
        made.initial->fields[0].second.value = literalOf("TRUE", step.span);
        made.initial->fields[0].second.span = step.span;
      }
      block_.variables.push_back(std::move(made));
    }
  }

  void addBody(ChartBody& body) {
    ActionSyntax made;
    made.name = body.name;
    made.span = body.span;
    made.body = std::move(body.body);
    if (body.chart != nullptr) made.body = ChartWriter(*body.chart, block_, sink_).run();
    const std::string folded = foldedName(made.name);
    if (std::ranges::any_of(block_.actions, [&](const ActionSyntax& a) { return foldedName(a.name) == folded; }))
      error(Syntax::IecName, body.span, fmt::format("two actions are named {}", excerpt(body.name)));
    block_.actions.push_back(std::move(made));
  }

  /// A name that no text can have; a chart within an action has further ones.
  std::string routine(std::string_view what, Statements body) {
    ActionSyntax made;
    made.name = fmt::format("({})", what);
    const bool isTaken =
        std::ranges::any_of(block_.actions, [&](const ActionSyntax& other) { return other.name == made.name; });
    if (isTaken) made.name = fmt::format("({} {})", what, block_.actions.size());
    made.span = chart_.span;
    made.isChart = true;
    made.body = std::move(body);
    block_.actions.push_back(std::move(made));
    return block_.actions.back().name;
  }

  static ExprPtr member(const ChartStep& step, std::string_view name) { return pathOf({step.name, name}, step.span); }
  static ExprPtr active(const ChartStep& step) { return member(step, "X"); }

  // The clock of a step, as far as conditions compare it with constants: it stands still one millisecond above the
  // greatest of them, which no comparison can tell.

  void readClock(Expr& expr) {
    for (const ExprPtr& operand : expr.operands) readClock(*operand);
    for (const Argument& argument : expr.arguments) {
      if (argument.value != nullptr) readClock(*argument.value);
    }
    const bool isComparison = expr.kind == ExprKind::Binary &&
                              (expr.text == "<" || expr.text == ">" || expr.text == "<=" || expr.text == ">=");
    if (!isComparison) return;
    for (const std::size_t side : {0, 1}) {
      Expr& clock = *expr.operands[side];
      const auto duration = constantDuration(block_, *expr.operands[1 - side]);
      if (clock.kind != ExprKind::Path || clock.parts.size() != 2 || clock.parts[1].kind != PathPart::Kind::Name ||
          foldedName(clock.parts[1].name) != "T" || stepNamed(clock.parts[0].name) == nullptr || !duration ||
          *duration < 0)
        continue;
      clock.parts[1].name = "CLOCK";
      countClockTo(block_, clock.parts[0].name, *duration);
    }
  }
  void readClocks(Statements& list) {
    for (Statement& s : list) {
      for (const ExprPtr* const expr : {&s.target, &s.value, &s.last, &s.by}) {
        if (*expr != nullptr) readClock(**expr);
      }
      for (Branch& branch : s.branches) {
        if (branch.condition != nullptr) readClock(*branch.condition);
        readClocks(branch.body);
      }
      readClocks(s.otherwise);
    }
  }
  void readClocks() {
    for (ChartTransition& transition : chart_.transitions) {
      if (transition.condition != nullptr) readClock(*transition.condition);
      readClocks(transition.body);
    }
    for (ActionSyntax& action : block_.actions) readClocks(action.body);
  }

  /// Which transitions fire, on the situation of before; then the steps.
  Statements writeTransitions() {
    Statements made;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < chart_.transitions.size(); ++i) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
      return chart_.transitions[i].priority.value_or(std::numeric_limits<std::int64_t>::max());
    });
    std::vector<std::string> fires(chart_.transitions.size());
    for (std::size_t place = 0; place < order.size(); ++place) {
      ChartTransition& transition = chart_.transitions[order[place]];
      std::string& fire = fires[order[place]];
      fire = hiddenVariable(block_, "fires", "BOOL", transition.span);
      ExprPtr enabled;
      for (const auto& [name, span] : transition.from) enabled = andOf(std::move(enabled), pathOf({name, "X"}, span));
      if (enabled == nullptr) enabled = literalOf("FALSE", transition.span);  // a drawing without its line
      // A step gives its token to one transition only.
      for (std::size_t earlier = 0; earlier < place; ++earlier) {
        const ChartTransition& other = chart_.transitions[order[earlier]];
        if (!sharesStep(other, transition)) continue;
        ExprPtr waits = notOf(pathOf({fires[order[earlier]]}, transition.span));
        if (!other.priority && !transition.priority)
          waits = orOf(readingOf("iec-sfc-selection", "all-true", transition.span), std::move(waits));
        enabled = andOf(std::move(enabled), std::move(waits));
      }
      writeTransition(transition, fire, std::move(enabled), made);
    }
    for (const ChartStep& step : chart_.steps) moveToken(step, fires, made);
    if (!blockCalls_.empty())
      made.push_back(ifOf(readingOf("iec-condition-blocks", "each-scan", chart_.span), std::move(blockCalls_),
                          {chart_.span.file, chart_.span.offset, 0}));
    return made;
  }

  static bool sharesStep(const ChartTransition& a, const ChartTransition& b) {
    return std::ranges::any_of(a.from, [&](const auto& one) {
      return std::ranges::any_of(b.from,
                                 [&](const auto& other) { return foldedName(one.first) == foldedName(other.first); });
    });
  }

  void writeTransition(ChartTransition& transition, const std::string& fire, ExprPtr enabled, Statements& made) {
    const auto fires = [&] { return pathOf({fire}, transition.span); };
    if (transition.condition == nullptr && transition.body.empty()) {
      Statement lost;
      lost.kind = StatementKind::Unread;
      lost.span = transition.span;
      lost.target = fires();
      made.push_back(std::move(lost));
      return;
    }
    ExprPtr condition = std::move(transition.condition);
    if (condition == nullptr && transition.result.empty()) storeResult(transition);
    if (condition == nullptr || isGuarded(*condition)) {
      if (condition != nullptr) {
        transition.result = hiddenVariable(block_, "condition", "BOOL", transition.span);
        const Span span = condition->span;
        transition.body.push_back(assignmentOf(pathOf({transition.result}, span), std::move(condition), span));
      }
      Statements call = callsBlocks(transition.body) ? conditionWithBlocks(transition)
                                                     : conditionCall(transition, std::move(transition.body), false);
      made.push_back(ifOf(copyOf(*enabled), std::move(call), transition.span));
      condition = pathOf({transition.result}, transition.span);
    }
    made.push_back(assignmentOf(fires(), andOf(std::move(enabled), std::move(condition)), transition.span));
  }

  /// Statements become a routine; gives its call.
  Statements conditionCall(const ChartTransition& transition, Statements body, bool mayCall) {
    ActionSyntax computed;
    computed.name = fmt::format("(condition {})", block_.actions.size() + 1);
    computed.span = transition.span;
    computed.isCondition = true;
    computed.mayCall = mayCall;
    computed.body = std::move(body);
    Statements call;
    call.push_back(callStatementOf(callOf({computed.name}, transition.span)));
    block_.actions.push_back(std::move(computed));
    return call;
  }

  /// Whether a drawing calls function blocks and is nothing but calls and assignments.
  static bool callsBlocks(const Statements& body) {
    const auto has = [&](StatementKind kind) { return std::ranges::count(body, kind, &Statement::kind); };
    const auto calls = has(StatementKind::Call);
    return calls > 0 && calls + has(StatementKind::Assign) == static_cast<std::ptrdiff_t>(body.size());
  }

  /// Function blocks of a condition are called where it is computed, while its steps are active; or they are called
  /// behind the transitions of every scan, and the condition takes what they gave last.
  Statements conditionWithBlocks(ChartTransition& transition) {
    Statements values, calls;
    for (const Statement& one : transition.body) {
      if (one.kind != StatementKind::Call) values.push_back(copyOf(one));
      calls.push_back(copyOf(one));
    }
    const std::string result = foldedName(transition.result);
    std::erase_if(calls, [&](const Statement& one) {
      return one.kind == StatementKind::Assign && one.target->parts.size() == 1 &&
             foldedName(one.target->parts[0].name) == result;
    });
    Statement choice = ifOf(readingOf("iec-condition-blocks", "each-scan", transition.span),
                            conditionCall(transition, std::move(values), true), transition.span);
    choice.hasElse = true;
    choice.otherwise = conditionCall(transition, std::move(transition.body), true);
    for (Statement& call : conditionCall(transition, std::move(calls), true)) blockCalls_.push_back(std::move(call));
    Statements made;
    made.push_back(std::move(choice));
    return made;
  }

  /// What is current behind the last line of a list.
  void storeResult(ChartTransition& transition) {
    transition.result = hiddenVariable(block_, "condition", "BOOL", transition.span);
    Statement& stored = transition.body.emplace_back();
    stored.kind = StatementKind::Line;
    stored.span = transition.span;
    stored.line = std::make_unique<ListLine>();
    stored.line->op = "ST";
    stored.line->opSpan = transition.body[transition.body.size() - 2].span;
    Argument& target = stored.line->operands.emplace_back();
    target.value = pathOf({transition.result}, transition.span);
    target.span = transition.span;
  }

  /// A step that is left and entered in one scan stays active, and its time begins anew.
  void moveToken(const ChartStep& step, const std::vector<std::string>& fires, Statements& made) {
    ExprPtr left, entered;
    for (std::size_t i = 0; i < chart_.transitions.size(); ++i) {
      const auto has = [&](const std::vector<std::pair<std::string, Span>>& list) {
        return std::ranges::any_of(list,
                                   [&](const auto& one) { return foldedName(one.first) == foldedName(step.name); });
      };
      if (has(chart_.transitions[i].from)) left = orOf(std::move(left), pathOf({fires[i]}, step.span));
      if (has(chart_.transitions[i].to)) entered = orOf(std::move(entered), pathOf({fires[i]}, step.span));
    }
    if (left == nullptr && entered == nullptr) return;
    ExprPtr value = active(step);
    if (left != nullptr) value = andOf(std::move(value), notOf(std::move(left)));
    if (entered != nullptr) value = orOf(std::move(value), copyOf(*entered));
    made.push_back(assignmentOf(active(step), std::move(value), step.span));
    if (entered == nullptr) return;
    Statements restart;
    for (const std::string_view clock : {"T", "CLOCK"})
      restart.push_back(assignmentOf(member(step, clock), literalOf("0ms", step.span, "T"), step.span));
    made.push_back(ifOf(std::move(entered), std::move(restart), {step.span.file, step.span.offset, 0}));
  }

  static constexpr std::size_t mostParts = 1000, mostBranches = 100;

  ChartSyntax& chart_;
  BlockSyntax& block_;
  SyntaxSink& sink_;
  Statements blockCalls_;  ///< of conditions, by the reading that calls function blocks in every scan
};

}  // namespace

std::optional<Qualifier> qualifierNamed(std::string_view name) {
  const std::string folded = foldedName(name);
  for (const auto& [text, qualifier] : qualifiers) {
    if (folded == text) return qualifier;
  }
  return std::nullopt;
}

bool takesTime(Qualifier qualifier) {
  return qualifier == Qualifier::L || qualifier == Qualifier::D || qualifier == Qualifier::SD ||
         qualifier == Qualifier::DS || qualifier == Qualifier::SL;
}

std::optional<std::int64_t> constantDuration(const BlockSyntax& block, const Expr& expr) {
  if (expr.kind == ExprKind::Literal && !expr.prefix.empty()) return millisecondsOf(expr.text);
  if (expr.kind != ExprKind::Path || expr.parts.size() != 1) return std::nullopt;
  for (const VariableSyntax& v : block.variables) {
    if (!v.isConstant || foldedName(v.name) != foldedName(expr.parts[0].name) || v.initial == nullptr) continue;
    const Expr* value = v.initial->value.get();
    if (value != nullptr && value->kind == ExprKind::Literal) return constantDuration(block, *value);
  }
  return std::nullopt;
}

void countClockTo(BlockSyntax& block, const std::string& step, std::int64_t duration) {
  for (VariableSyntax& v : block.variables) {
    if (foldedName(v.name) == foldedName(step)) v.longestClock = std::max(v.longestClock, duration + 1);
  }
}

std::string hiddenVariable(BlockSyntax& block, std::string_view what, std::string_view type, Span span) {
  VariableSyntax made;
  made.name = fmt::format("__{}_{}", what, block.variables.size());
  made.type = std::make_shared<TypeSyntax>();
  made.type->name = type;
  made.type->span = made.span = span;
  block.variables.push_back(std::move(made));
  return block.variables.back().name;
}

void chartStatements(ChartSyntax chart, BlockSyntax& block, SyntaxSink& sink) {
  if (block.kind == BlockKind::Function) {
    sink.report(Syntax::IecText, chart.span, "a FUNCTION keeps no state and cannot be a chart");
    chart.isWhole = false;
  }
  for (Statement& s : ChartWriter(chart, block, sink).run()) block.body.push_back(std::move(s));
}

}  // namespace rungproof::iec
