// Statements and expressions of ST. Precedence, tightest first: parentheses, call, unary - and NOT, **, * / MOD, + -,
// < > <= >=, = <>, & AND, XOR, OR.
#include "frontend/iec/iec_statement_parser.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "frontend/iec/iec_tree.hpp"

namespace rungproof::iec {

namespace {

using Level = std::array<std::string_view, 4>;
/// Loosest first.
constexpr std::array<Level, 8> levels = {{{"OR", "OR_ELSE"},
                                          {"XOR"},
                                          {"AND", "&", "AND_THEN"},
                                          {"=", "<>"},
                                          {"<", ">", "<=", ">="},
                                          {"+", "-"},
                                          {"*", "/", "MOD"},
                                          {"**"}}};

template <std::size_t N>
bool isAmongWords(const std::array<std::string_view, N>& words, std::string_view folded) {
  return std::ranges::find(words, folded) != words.end();
}

}  // namespace

bool isSectionWord(const std::string& folded) {
  static constexpr std::array<std::string_view, 12> words = {"VAR",        "VAR_INPUT",    "VAR_OUTPUT", "VAR_IN_OUT",
                                                             "VAR_TEMP",   "VAR_EXTERNAL", "VAR_GLOBAL", "VAR_ACCESS",
                                                             "VAR_CONFIG", "VAR_STAT",     "VAR_INST",   "VAR_GENERIC"};
  return isAmongWords(words, folded);
}

bool isEndWord(const std::string& folded) {
  static constexpr std::array<std::string_view, 29> words = {"END_IF",
                                                             "END_CASE",
                                                             "END_FOR",
                                                             "END_WHILE",
                                                             "END_REPEAT",
                                                             "END_VAR",
                                                             "END_STRUCT",
                                                             "END_UNION",
                                                             "END_TYPE",
                                                             "END_STEP",
                                                             "END_TRANSITION",
                                                             "END_ACTION",
                                                             "END_PROGRAM",
                                                             "END_FUNCTION_BLOCK",
                                                             "END_FUNCTION",
                                                             "END_METHOD",
                                                             "END_PROPERTY",
                                                             "END_GET",
                                                             "END_SET",
                                                             "END_INTERFACE",
                                                             "END_CLASS",
                                                             "END_NAMESPACE",
                                                             "END_RESOURCE",
                                                             "END_CONFIGURATION",
                                                             "END_DATA_BLOCK",
                                                             "END_CONST",
                                                             "END_LABEL",
                                                             "END_REGION",
                                                             "END_ORGANIZATION_BLOCK"};
  return isAmongWords(words, folded);
}

Statements StatementParser::wholeBody() {
  Statements all = statements();
  while (!isEnd()) {
    report(fmt::format("'{}' does not belong here", excerpt(peek().text)), peek());
    take();
    Statement lost;
    lost.kind = StatementKind::Unread;
    lost.span = spanFrom(peek().begin);
    all.push_back(std::move(lost));
    for (Statement& more : statements()) all.push_back(std::move(more));
  }
  return all;
}

ExprPtr StatementParser::wholeExpression() {
  try {
    ExprPtr made = expression();
    if (!isEnd()) fail(fmt::format("'{}' does not belong here", excerpt(peek().text)));
    return made;
  } catch (const Unreadable&) {
    return nullptr;
  }
}

bool StatementParser::endsStatements() const {
  if (isEnd()) return true;
  const IecToken& token = peek();
  if (token.kind != TokenKind::Word) return false;
  const std::string word = foldedName(token.text);
  return isEndWord(word) || word == "ELSE" || word == "ELSIF" || word == "UNTIL" || word == "__CATCH" ||
         word == "__FINALLY" || word == "__ENDTRY" || beginsMember();
}

/// `: =` with a blank is what its writer means, and no compiler takes it.
void StatementParser::expectAssignment() {
  if (!is(":") || peek(1).text != "=") return expect(":=");
  if (source_.isScl) fail("':=' is written without a blank");
  sink_.report(Syntax::IecSpelling, source_.span(peek().begin, peek(1).end), "':=' is written without a blank");
  take();
  take();
}

/// A label of CASE begins with a constant and goes on with `:`, `,` or `..`.
bool StatementParser::isCaseLabel() const {
  std::size_t i = 0;
  if (peek().text == "-" || peek().text == "+") ++i;
  const IecToken& first = peek(i);
  if (first.kind == TokenKind::Punctuation || first.kind == TokenKind::End) return false;
  ++i;
  while (peek(i).text == "." && peek(i + 1).kind == TokenKind::Word) i += 2;
  const std::string_view next = peek(i).text;
  return next == ":" || next == "," || next == "..";
}

Statements StatementParser::statements(bool inCase) {
  Nesting nesting(*this);
  Statements all;
  for (;;) {
    while (accept(";")) {
    }
    if (endsStatements() || (inCase && isCaseLabel())) return all;
    const std::size_t before = at_;
    Statement made = statement();
    for (Statement& first : std::exchange(chained_, {})) all.push_back(std::move(first));
    all.push_back(std::move(made));
    if (at_ == before) take();
  }
}

Statement StatementParser::statement() {
  const std::uint32_t begin = peek().begin;
  const int depth = depth_;
  try {
    Statement made = plain();
    made.span = spanFrom(begin);
    // The last word of the one, and the brace of code in C, end them. Behind END_IF and its kin CODESYS takes none.
    const bool isLastWord = !source_.isScl && made.kind != StatementKind::Assign &&
                            tokens_[at_ - 1].kind == TokenKind::Word && isEndWord(foldedName(tokens_[at_ - 1].text));
    const bool isClosed = made.kind == StatementKind::Try || made.kind == StatementKind::Unread || isLastWord ||
                          (source_.isScl && made.kind == StatementKind::Label);
    if (!accept(";") && !isClosed && !endsStatements()) fail(fmt::format("';' is needed here{}", found()));
    return made;
  } catch (const Unreadable&) {
    depth_ = depth;
    skipStatement();
    Statement lost;
    lost.kind = StatementKind::Unread;
    lost.span = spanFrom(begin);
    return lost;
  }
}

void StatementParser::skipStatement() {
  while (!isEnd() && !endsStatements() && !accept(";")) take();
}

Statement StatementParser::plain() {
  Statement made;
  const std::uint32_t begin = peek().begin;
  const std::size_t first = at_;
  if (accept("IF")) {
    ifStatement(made);
  } else if (accept("CASE")) {
    caseStatement(made);
  } else if (accept("FOR")) {
    forStatement(made);
  } else if (accept("WHILE")) {
    made.kind = StatementKind::While;
    made.value = expression();
    expect("DO");
    made.otherwise = statements();
    expect("END_WHILE");
  } else if (accept("REPEAT")) {
    made.kind = StatementKind::Repeat;
    made.otherwise = statements();
    expect("UNTIL");
    made.value = expression();
    accept(";");
    expect("END_REPEAT");
  } else if (accept("__TRY")) {
    tryStatement(made);
  } else if (accept("EXIT")) {
    made.kind = StatementKind::Exit;
  } else if (accept("CONTINUE")) {
    made.kind = StatementKind::Continue;
  } else if (accept("RETURN")) {
    made.kind = StatementKind::Return;
  } else if (source_.isScl && accept("GOTO")) {
    made.kind = StatementKind::Jump;
    made.target = path();
  } else if (source_.isScl && peek().kind == TokenKind::Word && peek(1).text == ":" && peek(2).text != "=") {
    made.kind = StatementKind::Label;
    made.target = path();
    take();
  } else {
    if (peek().text.starts_with("{")) {
      take();
      leaveOut(begin, "code in C is not modelled: it is left out", Severity::Warning);
      accept(";");
      made.kind = StatementKind::Unread;
      return made;
    }
    if (peek().kind != TokenKind::Word && peek().kind != TokenKind::Address)
      fail(fmt::format("a statement cannot begin with '{}'", excerpt(peek().text)));
    made.target = path();
    if (made.target->kind == ExprKind::Call) {
      made.kind = StatementKind::Call;
    } else if (!source_.isScl && (is("S") || is("R")) &&
               peek(1).text == "=") {  // S= and R=: set and reset where it is TRUE
      const bool sets = is("S");
      take();
      take();
      Branch branch;
      branch.condition = expression();
      Statement& inner = branch.body.emplace_back();
      inner.target = std::move(made.target);
      inner.value = std::make_unique<Expr>();
      inner.value->text = sets ? "TRUE" : "FALSE";
      inner.span = inner.value->span = spanFrom(begin);
      made.kind = StatementKind::If;
      made.branches.push_back(std::move(branch));
    } else if (source_.isScl && peek(1).text == "=" && isAny({"+", "-", "*", "/"})) {
      made.kind = StatementKind::Assign;
      made.value = withTarget(first);
    } else {
      expectAssignment();
      made.kind = StatementKind::Assign;
      made.value = expression();
      if (!source_.isScl && is(":=")) chain(made);
    }
  }
  return made;
}

/// `n += 1` of TIA Portal: what `n := n + (1)` gives. The target, which begins at the token `first`, is read twice.
ExprPtr StatementParser::withTarget(std::size_t first) {
  const std::size_t behind = std::exchange(at_, first);
  ExprPtr made = std::make_unique<Expr>();
  made->kind = ExprKind::Binary;
  made->operands.push_back(path());
  at_ = behind;
  made->text = take().text;
  take();
  made->operands.push_back(expression());
  made->span = spanFrom(tokens_[first].begin);
  return made;
}

/// `x := y := 5`, an extension of CODESYS: first y gets 5, then x gets y.
void StatementParser::chain(Statement& first) {
  std::vector<ExprPtr> targets;
  while (is(":=")) {
    const bool isVariable = first.value->kind == ExprKind::Path;
    const bool hasIndex = isVariable && std::ranges::any_of(first.value->parts, [](const PathPart& part) {
                            return part.kind == PathPart::Kind::Index;
                          });
    if (!isVariable) fail("only a variable stands in front of ':='");
    if (hasIndex) fail("an element of an array in a chain of ':=' is not read: write one assignment for each variable");
    take();
    targets.push_back(std::move(first.value));
    first.value = expression();
  }
  Statements made;
  while (!targets.empty()) {
    ExprPtr target = std::move(targets.back());
    targets.pop_back();
    ExprPtr next = copyOf(*target);
    const Span span = target->span;
    made.push_back(assignmentOf(std::move(target), std::move(first.value), span));
    first.value = std::move(next);
  }
  chained_ = std::move(made);
}

void StatementParser::tryStatement(Statement& made) {
  made.kind = StatementKind::Try;
  made.otherwise = statements();
  Branch caught, last;
  expect("__CATCH");
  if (accept("(")) {
    caught.condition = path();
    expect(")");
  }
  caught.body = statements();
  if (accept("__FINALLY")) last.body = statements();
  expect("__ENDTRY");
  made.branches.push_back(std::move(caught));
  made.branches.push_back(std::move(last));
}

void StatementParser::ifStatement(Statement& made) {
  made.kind = StatementKind::If;
  do {
    Branch branch;
    branch.condition = expression();
    expect("THEN");
    branch.body = statements();
    made.branches.push_back(std::move(branch));
  } while (accept("ELSIF"));
  if (accept("ELSE")) {
    made.hasElse = true;
    made.otherwise = statements();
  }
  expect("END_IF");
}

void StatementParser::caseStatement(Statement& made) {
  made.kind = StatementKind::Case;
  made.value = expression();
  expect("OF");
  while (!endsStatements()) {
    Branch branch;
    do {
      CaseLabel label;
      label.low = expression();
      if (accept("..")) label.high = expression();
      branch.labels.push_back(std::move(label));
    } while (accept(","));
    expect(":");
    branch.body = statements(true);
    made.branches.push_back(std::move(branch));
  }
  if (accept("ELSE")) {
    accept(":");
    made.hasElse = true;
    made.otherwise = statements();
  }
  expect("END_CASE");
}

void StatementParser::forStatement(Statement& made) {
  made.kind = StatementKind::For;
  made.target = path();
  expect(":=");
  made.value = expression();
  expect("TO");
  made.last = expression();
  if (accept("BY")) made.by = expression();
  expect("DO");
  made.otherwise = statements();
  expect("END_FOR");
}

/// Trees of expressions are walked by recursion: they are as deep as they have operators.
struct StatementParser::Operators {
  explicit Operators(StatementParser& parser) : parser(parser), isOutermost(parser.operators_ < 0) {
    if (isOutermost) parser.operators_ = 0;
  }
  ~Operators() {
    if (isOutermost) parser.operators_ = -1;
  }
  Operators(const Operators&) = delete;
  Operators& operator=(const Operators&) = delete;
  StatementParser& parser;
  const bool isOutermost;
};

ExprPtr StatementParser::expression() {
  Nesting nesting(*this);
  const Operators operators(*this);
  return binary(0);
}

/// Operators of one level bind from left to right.
ExprPtr StatementParser::binary(int level) {
  if (level == static_cast<int>(levels.size())) return unary();
  const std::uint32_t begin = peek().begin;
  ExprPtr left = binary(level + 1);
  for (;;) {
    std::string_view found;
    for (const std::string_view op : levels[static_cast<std::size_t>(level)]) {
      if (!op.empty() && is(op)) found = op;
    }
    constexpr int productLevel = 6;
    if (source_.isScl && level == productLevel && is("DIV")) found = "/";
    if (found.empty()) return left;
    constexpr int mostOperators = 2000;
    if (++operators_ > mostOperators)
      fail(fmt::format("an expression has at most {} operators: write it in several statements", mostOperators));
    take();
    ExprPtr made = std::make_unique<Expr>();
    made->kind = ExprKind::Binary;
    made->text = found == "&" ? "AND" : found;
    made->operands.push_back(std::move(left));
    made->operands.push_back(binary(level + 1));
    made->span = spanFrom(begin);
    left = std::move(made);
  }
}

ExprPtr StatementParser::unary() {
  const std::uint32_t begin = peek().begin;
  const bool isNot = is("NOT");
  if (!isNot && !is("-") && !is("+")) return primary();
  Nesting nesting(*this);
  const bool isPlus = is("+");
  take();
  ExprPtr inner = unary();
  if (isPlus) return inner;
  ExprPtr made = std::make_unique<Expr>();
  made->kind = ExprKind::Unary;
  made->text = isNot ? "NOT" : "-";
  made->operands.push_back(std::move(inner));
  made->span = spanFrom(begin);
  return made;
}

ExprPtr StatementParser::primary() {
  if (accept("(")) {
    ExprPtr inner = expression();
    expect(")");
    return inner;
  }
  const IecToken& token = peek();
  if (token.kind == TokenKind::Number || token.kind == TokenKind::Text || is("TRUE") || is("FALSE")) return literal();
  if (token.kind == TokenKind::Word || token.kind == TokenKind::Address) return path();
  fail(fmt::format("a value is needed here{}", found()));
}

ExprPtr StatementParser::literal() {
  const IecToken& token = take();
  ExprPtr made = std::make_unique<Expr>();
  made->kind = token.kind == TokenKind::Text ? ExprKind::Text : ExprKind::Literal;
  made->text = token.text;
  made->prefix = foldedName(token.prefix);
  made->span = source_.span(token.begin, token.end);
  return made;
}

ExprPtr StatementParser::path() {
  const std::uint32_t begin = peek().begin;
  ExprPtr made = std::make_unique<Expr>();
  made->kind = ExprKind::Path;
  const IecToken& first = take();
  made->parts.push_back(
      {PathPart::Kind::Name, std::string(first.text), {}, 0, 1, source_.span(first.begin, first.end)});
  for (;;) {
    if (is("^")) {  // what a pointer points to: a part that no type has
      const IecToken& part = take();
      made->parts.push_back({PathPart::Kind::Name, "^", {}, 0, 1, source_.span(part.begin, part.end)});
      continue;
    }
    if (is("[")) {
      made->parts.push_back(indexPart());
    } else if (is(".") && peek(1).kind == TokenKind::Word) {
      take();
      const IecToken& part = take();
      made->parts.push_back(
          {PathPart::Kind::Name, std::string(part.text), {}, 0, 1, source_.span(part.begin, part.end)});
    } else if (is(".") && (peek(1).kind == TokenKind::Number || peek(1).kind == TokenKind::Address)) {
      take();
      const IecToken& part = take();
      std::string_view digits = part.text;
      std::uint32_t bits = 1;
      if (part.kind == TokenKind::Address && digits.size() > 2) {
        switch (std::toupper(static_cast<unsigned char>(digits[1]))) {
          case 'X': digits.remove_prefix(2); break;
          case 'B': bits = 8, digits.remove_prefix(2); break;
          case 'W': bits = 16, digits.remove_prefix(2); break;
          case 'D': bits = 32, digits.remove_prefix(2); break;
          default: break;
        }
      }
      if (digits.empty() || digits.size() > 2 || digits.find_first_not_of("0123456789") != std::string_view::npos) {
        report(fmt::format("'.{}' is no bit of a value", excerpt(part.text)), part);
        throw Unreadable{};
      }
      PathPart bit{PathPart::Kind::Bit, {}, {}, 0, bits, source_.span(part.begin, part.end)};
      bit.isSlice = part.kind == TokenKind::Address;
      for (const char c : digits) bit.bit = bit.bit * 10 + static_cast<std::uint32_t>(c - '0');
      bit.bit *= bits;
      made->parts.push_back(std::move(bit));
    } else {
      break;
    }
  }
  if (is("(")) {
    made->kind = ExprKind::Call;
    made->arguments = arguments();
  }
  made->span = spanFrom(begin);
  return made;
}

PathPart StatementParser::indexPart() {
  PathPart part{PathPart::Kind::Index, {}, {}, 0, 1, {}};
  const std::uint32_t begin = peek().begin;
  expect("[");
  do part.indices.push_back(expression());
  while (accept(","));
  expect("]");
  part.span = spanFrom(begin);
  return part;
}

std::vector<Argument> StatementParser::arguments() {
  std::vector<Argument> all;
  expect("(");
  if (accept(")")) return all;
  do all.push_back(argument());
  while (accept(","));
  expect(")");
  return all;
}

Argument StatementParser::argument() {
  Argument made;
  const std::uint32_t begin = peek().begin;
  const bool isNegated = is("NOT") && peek(1).kind == TokenKind::Word && peek(2).text == "=>";
  if (isNegated) take();
  if (peek().kind == TokenKind::Word && (peek(1).text == ":=" || peek(1).text == "=>")) {
    made.name = take().text;
    made.isOutput = take().text == "=>";
    made.isNegated = isNegated;
    if (made.isOutput && (is(",") || is(")"))) {
      made.span = spanFrom(begin);
      return made;
    }
  }
  made.value = expression();
  made.span = spanFrom(begin);
  return made;
}

Statements parseBody(const SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives) {
  return StatementParser(source, sink, directives).wholeBody();
}

ExprPtr parseExpression(const SourceText& source, SyntaxSink& sink) {
  std::vector<Directive> none;
  return StatementParser(source, sink, none).wholeExpression();
}

}  // namespace rungproof::iec
