// Charts as text. What cannot be read is told at its place, and reading goes on with the next step, transition or
// action.
#include "frontend/iec/iec_chart_parser.hpp"

#include <cstdlib>

#include "frontend/iec/iec_tree.hpp"

namespace rungproof::iec {

void ChartParser::bodyUntil(std::string_view end, Statements& body) {
  const bool isList = beginsList();
  const auto read = [&] {
    for (Statement& s : isList ? listLines() : statements()) body.push_back(std::move(s));
  };
  read();
  while (!isEnd() && !is(end)) {
    if (beginsDeclaration() || beginsMember()) return;
    Statement lost;
    lost.kind = StatementKind::Unread;
    report(fmt::format("'{}' does not belong here", excerpt(peek().text)), peek());
    const std::uint32_t begin = take().begin;
    lost.span = spanFrom(begin);
    body.push_back(std::move(lost));
    read();
  }
}

ChartSyntax ChartParser::chart(std::string_view end) {
  Nesting nesting(*this);
  ChartSyntax made;
  const std::uint32_t begin = peek().begin;
  while (!isEnd() && !is(end) && !beginsDeclaration()) {
    const int depth = depth_;
    const std::size_t before = at_;
    try {
      if (accept(";")) continue;
      if (is("INITIAL_STEP") || is("STEP"))
        made.steps.push_back(step());
      else if (is("TRANSITION"))
        made.transitions.push_back(transition());
      else if (is("ACTION"))
        made.actions.push_back(action());
      else
        fail(fmt::format("STEP, TRANSITION or ACTION is needed here{}", found()));
    } catch (const Unreadable&) {
      depth_ = depth;
      made.isWhole = false;
      if (at_ == before) take();
      while (!isEnd() && !is(end) && !beginsDeclaration() && !beginsPart()) {
        const bool isLast = isAny({"END_STEP", "END_TRANSITION", "END_ACTION"});
        take();
        if (isLast) break;
      }
    }
  }
  made.span = spanFrom(begin);
  return made;
}

/// `STEP name: action (qualifier, time); END_STEP`
ChartStep ChartParser::step() {
  ChartStep made;
  const std::uint32_t begin = peek().begin;
  made.isInitial = is("INITIAL_STEP");
  take();
  made.name = name("the name of a step");
  expect(":");
  while (!accept("END_STEP")) {
    if (accept(";")) continue;
    if (peek().kind != TokenKind::Word || beginsPart())
      fail(fmt::format("an action or END_STEP is needed here{}", found()));
    association(made);
  }
  made.span = spanFrom(begin);
  return made;
}

void ChartParser::association(ChartStep& step) {
  ChartAction made;
  const std::uint32_t begin = peek().begin;
  made.name = name("the name of an action");
  if (accept("(") && !accept(")")) {
    const IecToken& word = peek();
    const auto qualifier = word.kind == TokenKind::Word ? qualifierNamed(word.text) : std::nullopt;
    if (!qualifier)
      failAt(word, fmt::format("'{}' is no qualifier of an action, which is N, R, S, L, D, P, P0, P1, SD, DS or SL",
                               excerpt(word.text)));
    take();
    made.qualifier = *qualifier;
    if (takesTime(*qualifier)) {
      if (!accept(",")) fail(fmt::format("{} needs a duration", foldedName(word.text)));
      const std::uint32_t first = peek().begin;
      made.time = expression();
      made.timeText = source_.text.substr(first, tokens_[at_ - 1].end - first);
    } else if (is(",") && peek(1).kind == TokenKind::Number) {
      failAt(peek(1), fmt::format("{} takes no duration", foldedName(word.text)));
    }
    while (accept(",")) name("an indicator");  // says what confirms the action, and does nothing
    expect(")");
  }
  made.span = spanFrom(begin);
  if (!accept(";") && !is("END_STEP")) expect(";");
  step.actions.push_back(std::move(made));
}

std::vector<std::pair<std::string, Span>> ChartParser::stepNames() {
  std::vector<std::pair<std::string, Span>> names;
  const auto one = [&] {
    const std::uint32_t begin = peek().begin;
    std::string step = name("the name of a step");
    names.emplace_back(std::move(step), spanFrom(begin));
  };
  if (!accept("(")) {
    one();
    return names;
  }
  do one();
  while (accept(","));
  expect(")");
  return names;
}

/// `TRANSITION name (PRIORITY := 1) FROM a TO (b, c) := condition; END_TRANSITION`
ChartTransition ChartParser::transition() {
  ChartTransition made;
  const std::uint32_t begin = take().begin;
  if (!is("FROM") && !is("(")) made.name = name("FROM");
  if (accept("(")) {
    expect("PRIORITY");
    expect(":=");
    if (peek().kind != TokenKind::Number) fail(fmt::format("a number is needed here{}", found()));
    made.priority = std::strtoll(std::string(take().text).c_str(), nullptr, 10);
    expect(")");
  }
  expect("FROM");
  made.from = stepNames();
  expect("TO");
  made.to = stepNames();
  const int depth = depth_;
  try {
    condition(made);
  } catch (const Unreadable&) {  // when it fires is not known
    depth_ = depth;
    made.condition = nullptr;
    made.body.clear();
    while (!isEnd() && !is("END_TRANSITION") && !beginsPart() && !beginsDeclaration()) take();
  }
  made.span = spanFrom(begin);
  expect("END_TRANSITION");
  made.span = spanFrom(begin);
  return made;
}

void ChartParser::condition(ChartTransition& made) {
  if (accept(":=")) {
    made.condition = expression();
    if (!accept(";") && !is("END_TRANSITION")) expect(";");
  } else if (accept(":")) {
    if (!beginsList())
      fail(fmt::format("a condition is an expression behind ':=', or a list of IL behind ':'{}", found()));
    made.body = listLines();
  } else {
    fail(fmt::format("':=' and a condition are needed here{}", found()));
  }
  if (!is("END_TRANSITION")) fail(fmt::format("END_TRANSITION is needed here{}", found()));
}

/// `ACTION name: body END_ACTION`
ChartBody ChartParser::action() {
  ChartBody made;
  const std::uint32_t begin = take().begin;
  made.name = name("the name of an action");
  expect(":");
  if (beginsChart())
    made.chart = std::make_unique<ChartSyntax>(chart("END_ACTION"));
  else
    bodyUntil("END_ACTION", made.body);
  expect("END_ACTION");
  made.span = spanFrom(begin);
  return made;
}

}  // namespace rungproof::iec
