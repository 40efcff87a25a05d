// Lines of IL: `[label:] operator[modifier] [operand {, operand}]`. A line ends where the text's line ends; the list of
// a call in parentheses may go over several.
#include <algorithm>
#include <array>

#include "frontend/iec/iec_statement_parser.hpp"

namespace rungproof::iec {

namespace {

/// Which modifiers an operator has: N negates, C asks the current result, ( waits for its other side.
struct ListOperator {
  std::string_view name;
  bool hasN, hasC, hasParenthesis;
};
constexpr std::array<ListOperator, 22> listOperators = {
    {{"LD", true, false, false},  {"ST", true, false, false},   {"S", false, false, false},
     {"R", false, false, false},  {"AND", true, false, true},   {"OR", true, false, true},
     {"XOR", true, false, true},  {"NOT", false, false, false}, {"ADD", false, false, true},
     {"SUB", false, false, true}, {"MUL", false, false, true},  {"DIV", false, false, true},
     {"MOD", false, false, true}, {"GT", false, false, true},   {"GE", false, false, true},
     {"EQ", false, false, true},  {"NE", false, false, true},   {"LE", false, false, true},
     {"LT", false, false, true},  {"JMP", true, true, false},   {"CAL", true, true, false},
     {"RET", true, true, false}}};

/// A line that holds nothing but a label.
Statement labelLine(const std::string& label, Span span) {
  Statement made;
  made.kind = StatementKind::Line;
  made.span = span;
  made.line = std::make_unique<ListLine>();
  made.line->label = label;
  return made;
}

/// The operator with its modifiers taken off; nothing if the word is none.
std::optional<ListOperator> operatorOf(const std::string& folded, ListLine& line) {
  for (const ListOperator& op : listOperators) {
    if (!folded.starts_with(op.name)) continue;
    const std::string_view modifiers = std::string_view(folded).substr(op.name.size());
    const bool isWhole = modifiers.empty() || (modifiers == "N" && op.hasN && !op.hasC) ||
                         (modifiers == "C" && op.hasC) || (modifiers == "CN" && op.hasC) ||
                         (modifiers == "NC" && op.hasC);
    if (!isWhole) continue;
    line.op = op.name;
    line.isNegated = modifiers.find('N') != std::string_view::npos;
    line.isConditional = modifiers.find('C') != std::string_view::npos;
    return op;
  }
  return std::nullopt;
}

}  // namespace

/// Whether the token `ahead` stands in another line than the one before it.
bool StatementParser::isNewLine(std::size_t ahead) const {
  const std::size_t at = at_ + ahead;
  if (at == 0 || at >= tokens_.size()) return true;
  const std::string_view between = source_.text.substr(tokens_[at - 1].end, tokens_[at].begin - tokens_[at - 1].end);
  return tokens_[at].kind == TokenKind::End || between.find('\n') != std::string_view::npos;
}
bool StatementParser::isLineEnd() const { return isNewLine(0); }
bool StatementParser::isLabel() const { return peek().kind == TokenKind::Word && peek(1).text == ":"; }

void StatementParser::skipLine() {
  while (!isLineEnd()) take();
}

/// A function with named inputs, and behind its parenthesis, in a line of its own, an operator.
bool StatementParser::beginsWithCall(std::size_t open) const {
  if (peek(open + 1).kind != TokenKind::Word || peek(open + 2).text != ":=") return false;
  std::size_t at = open, depth = 0;
  do {
    if (peek(at).text == "(") ++depth;
    if (peek(at).text == ")") --depth;
    if (peek(at).kind == TokenKind::End) return false;
    ++at;
  } while (depth > 0);
  ListLine unused;
  const bool isAssigned = peek(at + 1).text == ":=" || peek(at + 1).text == "(";
  return isNewLine(at) && peek(at).kind == TokenKind::Word && operatorOf(foldedName(peek(at).text), unused) &&
         !isAssigned;
}

bool StatementParser::beginsList() const {
  const std::size_t first = isLabel() ? 2 : 0;
  ListLine unused;
  const IecToken& word = peek(first);
  if (word.text == "&") return true;
  if (word.kind == TokenKind::Word && peek(first + 1).text == "(") return beginsWithCall(first + 1);
  if (word.kind != TokenKind::Word || !operatorOf(foldedName(word.text), unused)) return false;
  const IecToken& next = peek(first + 1);
  if (isNewLine(first + 1)) return unused.op == "NOT" || unused.op == "RET";
  const bool isOperand = next.kind == TokenKind::Word || next.kind == TokenKind::Number ||
                         next.kind == TokenKind::Address || next.kind == TokenKind::Text;
  return isOperand || (next.text == "-" && peek(first + 2).kind == TokenKind::Number);
}

Statements StatementParser::listLines() {
  Statements all;
  while (!isEnd() && (isLabel() || !endsStatements())) {
    const std::uint32_t begin = peek().begin;
    const int depth = depth_;
    const std::string label(isLabel() ? peek().text : std::string_view{});
    Statement made;
    try {
      made = listLine();
      if (!isLineEnd() && !is(")")) {
        if (is(";")) fail("a line of IL ends without ';'");
        fail(fmt::format("'{}' does not belong into this line", excerpt(peek().text)));
      }
    } catch (const Unreadable&) {
      depth_ = depth;
      made = Statement{};
      made.kind = StatementKind::Unread;
      if (!label.empty()) all.push_back(labelLine(label, source_.span(begin, begin)));
      if (peek().begin == begin) take();
      skipLine();
    }
    made.span = spanFrom(begin);
    all.push_back(std::move(made));
  }
  return all;
}

Statement StatementParser::listLine() {
  Statement made;
  made.kind = StatementKind::Line;
  made.line = std::make_unique<ListLine>();
  ListLine& line = *made.line;
  if (isLabel()) {
    line.label = take().text;
    take();
    if (isLineEnd() || endsStatements()) return made;
  }
  listOperator(line);
  return made;
}

void StatementParser::listOperator(ListLine& line) {
  const IecToken& word = peek();
  line.opSpan = source_.span(word.begin, word.end);
  if (accept(")")) {
    line.op = ")";
    return;
  }
  std::optional<ListOperator> op;
  if (accept("&")) {
    op = operatorOf("AND", line);
    if (!isLineEnd() && is("N") && peek().begin == word.end) {
      take();
      line.isNegated = true;
    }
  } else {
    if (word.kind != TokenKind::Word) fail(fmt::format("a line of IL cannot begin with '{}'", excerpt(word.text)));
    op = operatorOf(foldedName(word.text), line);
    if (!op) line.op = word.text;  // a function, or an input of a function block
    take();
  }
  const std::string written(source_.text.substr(word.begin, tokens_[at_ - 1].end - word.begin));
  const bool hasOperand = line.op != "NOT" && line.op != "RET";
  if (line.op == "JMP" || line.op == "CAL") {
    if (isLineEnd()) failAt(word, fmt::format("{} needs {}", written, line.op == "JMP" ? "a label" : "an instance"));
    if (peek().kind != TokenKind::Word) fail(fmt::format("{} needs a name{}", written, found()));
    Argument& operand = line.operands.emplace_back();
    operand.value = path();
    operand.span = operand.value->span;
    if (line.op == "JMP" && operand.value->kind == ExprKind::Call) fail("a jump leads to a label");
    return;
  }
  if (!isLineEnd() && is("(")) {
    const bool isNamed = peek(1).kind == TokenKind::Word && (peek(2).text == ":=" || peek(2).text == "=>");
    if (isNamed && (!op || op->hasParenthesis)) {
      if (line.isNegated) fail(fmt::format("{} takes no named values", written));
      line.hasNames = true;
      line.operands = arguments();
      return;
    }
    if (!op) fail(fmt::format("{} in parentheses needs the names of its inputs", written));
    if (!op->hasParenthesis) fail(fmt::format("{} has no parentheses", written));
    take();
    line.opens = true;
    if (!isLineEnd() && !is(")")) listOperands(line);
    return;
  }
  if (isLineEnd() || is(")")) {
    if (hasOperand && op) failAt(word, fmt::format("{} needs a value", written));
    return;
  }
  if (hasOperand) listOperands(line);
}

/// One value; a function takes several.
void StatementParser::listOperands(ListLine& line) {
  const bool takesOne = line.opens || line.op == "LD" || line.op == "ST" || line.op == "S" || line.op == "R";
  line.operands.push_back(listOperand());
  while (accept(",")) {
    if (takesOne) fail(fmt::format("{} takes one value", line.op));
    line.operands.push_back(listOperand());
  }
}

/// A literal, with a sign too, or a variable.
Argument StatementParser::listOperand() {
  Argument made;
  const bool isSigned = (is("-") || is("+")) && peek(1).kind == TokenKind::Number;
  const bool isValue = peek().kind == TokenKind::Word || peek().kind == TokenKind::Number ||
                       peek().kind == TokenKind::Text || peek().kind == TokenKind::Address;
  if (isLineEnd() || (!isSigned && (!isValue || is("NOT")))) fail(fmt::format("a value is needed here{}", found()));
  made.value = unary();
  made.span = made.value->span;
  return made;
}

Statements StatementParser::wholeList() {
  Statements all = listLines();
  while (!isEnd()) {
    report(fmt::format("'{}' does not belong here", excerpt(peek().text)), peek());
    const std::uint32_t begin = take().begin;
    Statement lost;
    lost.kind = StatementKind::Unread;
    lost.span = spanFrom(begin);
    all.push_back(std::move(lost));
    for (Statement& more : listLines()) all.push_back(std::move(more));
  }
  return all;
}

Statements parseList(const SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives) {
  return StatementParser(source, sink, directives).wholeList();
}

}  // namespace rungproof::iec
