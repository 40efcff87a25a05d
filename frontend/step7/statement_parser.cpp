// One statement.
#include "frontend/step7/statement_parser.hpp"

#include <algorithm>
#include <array>

#include "frontend/step7/source_keyword.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::step7 {

namespace {

class StatementParser {
 public:
  StatementParser(Cursor& cursor, const Spelling7& spelling, std::vector<Span>& remarks)
      : cursor_(cursor), spelling_(spelling), remarks_(remarks), begin_(cursor.at()) {}

  Statement read() {
    label();
    mnemonic();
    std::uint32_t end = cursor_.at();
    if (!statement_.mnemonic.text.empty()) {
      if (statement_.fault.empty()) operands();
      end = cursor_.at();
      finish();
    }
    statement_.span = cursor_.span(begin_, end);
    return std::move(statement_);
  }

 private:
  void fail(std::string reason, std::uint32_t from, std::uint32_t to) {
    if (!statement_.fault.empty()) return;
    statement_.fault = std::move(reason);
    statement_.faultSpan = cursor_.span(from, to);
  }

  /// A word before a colon; the statement may follow on the next line.
  void label() {
    const std::uint32_t begin = cursor_.at();
    const std::string_view word = cursor_.word();
    if (!word.empty()) {
      const std::uint32_t end = cursor_.at();
      cursor_.skipBlanks();
      if (cursor_.peek() == ':' && cursor_.peek(1) != '=') {
        cursor_.skip(1);
        statement_.label = {std::string(word), cursor_.span(begin, end)};
        cursor_.skipSpace(remarks_);
        return;
      }
    }
    cursor_.to(begin);
  }

  void mnemonic() {
    const std::uint32_t begin = cursor_.at();
    // A label alone at the end of a network or block.
    if (!statement_.label.text.empty() && (cursor_.atEnd() || isSourceKeyword(cursor_.peekWord()))) return;
    const std::string_view word = cursor_.word();
    if (word.empty()) {
      signs();
    } else {
      behindWord(word);
    }
    const std::uint32_t end = cursor_.at();
    statement_.mnemonic = {std::string(cursor_.slice(begin, end)), cursor_.span(begin, end)};
    std::erase_if(statement_.mnemonic.text, [](char c) { return c == ' ' || c == '\t'; });
    std::ranges::transform(statement_.mnemonic.text, statement_.mnemonic.text.begin(), upper);
    if (end > begin) return;
    cursor_.skip(cursor_.atEnd() ? 0 : 1);
    statement_.mnemonic = {std::string(cursor_.slice(begin, cursor_.at())), cursor_.spanFrom(begin)};
    fail("no instruction begins like this", begin, cursor_.at());
  }

  bool isTypeLetter(std::size_t ahead) const {
    const char c = upper(cursor_.peek(ahead));
    return (c == 'I' || c == 'D' || c == 'R') && !isWordByte(cursor_.peek(ahead + 1));
  }

  /// ==I, <>R, =, +I, +AR1, +, ), )MCR.
  void signs() {
    const char c = cursor_.peek();
    if (c == ')') {
      cursor_.skip(1);
      if (equalsWord(cursor_.peekWord(), "MCR")) cursor_.skip(3);
    } else if (c == '+' || c == '-' || c == '*' || c == '/') {
      if (isTypeLetter(1)) return cursor_.skip(2);
      if (c == '+' && upper(cursor_.peek(1)) == 'A' && upper(cursor_.peek(2)) == 'R' &&
          (cursor_.peek(3) == '1' || cursor_.peek(3) == '2'))
        return cursor_.skip(4);
      if (c == '+') cursor_.skip(1);
    } else if (c == '=' || c == '<' || c == '>') {
      std::size_t length = 1;
      while (cursor_.peek(length) == '=' || cursor_.peek(length) == '>' || cursor_.peek(length) == '<') ++length;
      if (isTypeLetter(length) && (length > 1 || c != '='))
        cursor_.skip(length + 1);
      else if (c == '=')
        cursor_.skip(1);
    }
  }

  /// A( and MCR( belong together, as RND+ does.
  void behindWord(std::string_view word) {
    static constexpr std::array<std::string_view, 9> opening = {"A", "AN", "U", "UN", "O", "ON", "X", "XN", "MCR"};
    const bool mayOpen = std::ranges::any_of(opening, [&](std::string_view w) { return equalsWord(word, w); });
    const std::uint32_t back = cursor_.at();
    if (mayOpen) {
      cursor_.skipBlanks();
      if (cursor_.take('(')) return;
      cursor_.to(back);
    }
    if (equalsWord(word, "RND") && (cursor_.peek() == '+' || cursor_.peek() == '-')) cursor_.skip(1);
  }

  /// A bare word behind a jump is a label.
  bool isJump() const {
    const std::string& name = statement_.mnemonic.text;
    if (name == "LOOP") return true;
    return spelling_.set == MnemonicSet::German ? name.size() > 2 && name.starts_with("SP")
                                                : name.size() > 1 && name.starts_with("J");
  }

  bool atStatementEnd() const { return cursor_.peek() == ';' || cursor_.atLineEnd(); }

  void operands() {
    cursor_.skipBlanks();
    if (atStatementEnd()) return;
    const std::uint32_t begin = cursor_.at();
    OperandOutcome outcome = readOperand7(cursor_, spelling_, isJump());
    statement_.operand = std::move(outcome.operand);
    if (!outcome.fault.empty()) return fail(std::move(outcome.fault), begin, faultEnd(begin));
    if (statement_.mnemonic.text == "CALL") return call();
    if (statement_.mnemonic.text == "UC" || statement_.mnemonic.text == "CC") braces();
  }

  /// { P#L 210.1, P#L 212.0 } behind UC, in one line or several: what an upload shows of a block that the editor calls
  /// by itself.
  void braces() {
    cursor_.skipBlanks();
    const std::size_t close =
        cursor_.peek() == '{' ? cursor_.text().find_first_of("};", cursor_.at() + 1) : std::string_view::npos;
    if (close == std::string_view::npos || cursor_.text()[close] != '}') return;
    statement_.hasArguments = true;
    cursor_.skip(1);
    for (cursor_.skipSpace(remarks_); cursor_.peek() != '}'; cursor_.skipSpace(remarks_)) {
      OperandOutcome outcome = readOperand7(cursor_, spelling_);
      if (!outcome.fault.empty() || outcome.operand.form == OperandForm::None) break;
      statement_.pointers.push_back(std::move(outcome.operand));
      cursor_.skipSpace(remarks_);
      cursor_.take(',');
    }
    cursor_.to(static_cast<std::uint32_t>(close) + 1);
  }

  /// The end of what an operand that cannot be read seems to be.
  std::uint32_t faultEnd(std::uint32_t begin) {
    std::uint32_t end = std::max(cursor_.at(), begin + 1);
    while (end < cursor_.text().size()) {
      const char c = cursor_.text()[end];
      if (c == ';' || c == ',' || c == '\n' || c == ')' || blankLength(cursor_.text(), end) > 0) break;
      ++end;
    }
    return std::min<std::uint32_t>(end, static_cast<std::uint32_t>(cursor_.text().size()));
  }

  void call() {
    cursor_.skipBlanks();
    if (cursor_.take(',')) {
      cursor_.skipSpace(remarks_);
      const std::uint32_t begin = cursor_.at();
      OperandOutcome outcome = readOperand7(cursor_, spelling_);
      statement_.instance = std::move(outcome.operand);
      if (!outcome.fault.empty()) return fail(std::move(outcome.fault), begin, faultEnd(begin));
      if (statement_.instance.form == OperandForm::None)
        return fail("an instance data block follows the comma", begin, begin + 1);
      cursor_.skipBlanks();
    }
    if (cursor_.peek() == ';') return;
    skipAttributes();
    const std::uint32_t back = cursor_.at();
    std::vector<Span> between;
    cursor_.skipSpace(between);
    if (cursor_.take('(')) {
      remarks_.insert(remarks_.end(), between.begin(), between.end());
      statement_.hasArguments = true;
      return listInParentheses();
    }
    cursor_.to(back);
    if (cursor_.atLineEnd()) listing();
  }

  /// { time_type := 'Time' }, which TIA writes behind the block of a call.
  void skipAttributes() {
    const std::uint32_t back = cursor_.at();
    std::vector<Span> between;
    cursor_.skipSpace(between);
    const std::size_t close = cursor_.peek() == '{' ? cursor_.text().find('}', cursor_.at()) : std::string_view::npos;
    cursor_.to(close == std::string_view::npos ? back : static_cast<std::uint32_t>(close) + 1);
  }

  /// One NAME := actual at the cursor, which begins a name.
  bool argument() {
    const std::uint32_t begin = cursor_.at();
    Argument argument;
    if (cursor_.peek() == '#') cursor_.skip(1);
    const std::optional<Name> name = readName(cursor_);
    if (!name) {
      fail("the name of a parameter is missing", begin, faultEnd(begin));
      return false;
    }
    argument.formal = *name;
    cursor_.skipBlanks();
    if (!cursor_.startsWith(":=") && !cursor_.startsWith("=>")) {
      fail(":= is missing behind the name of the parameter", begin, faultEnd(begin));
      return false;
    }
    cursor_.skip(2);
    cursor_.skipBlanks();
    const char next = cursor_.peek();
    if (next != ',' && next != ')' && next != ';' && !cursor_.atLineEnd()) {
      const std::uint32_t from = cursor_.at();
      OperandOutcome outcome = readOperand7(cursor_, spelling_);
      argument.actual = std::move(outcome.operand);
      if (!outcome.fault.empty()) {
        fail(std::move(outcome.fault), from, faultEnd(from));
        return false;
      }
    }
    argument.span = cursor_.spanFrom(begin);
    statement_.arguments.push_back(std::move(argument));
    return true;
  }

  void listInParentheses() {
    for (;;) {
      cursor_.skipSpace(remarks_);
      if (cursor_.take(')')) return;
      const std::uint32_t at = cursor_.at();
      if (cursor_.atEnd() || cursor_.peek() == ';' || isSourceKeyword(cursor_.peekWord()))
        return fail("the parameter list is not closed", statement_.mnemonic.span.offset,
                    statement_.mnemonic.span.offset + statement_.mnemonic.span.length);
      if (!argument()) return skipList();
      cursor_.skipSpace(remarks_);
      if (cursor_.take(',') || cursor_.peek() == ')') continue;
      if (cursor_.atEnd() || cursor_.peek() == ';' || isSourceKeyword(cursor_.peekWord())) continue;
      fail("a comma is missing between two parameters", at, cursor_.at());
      return skipList();
    }
  }

  /// Behind a mistake in a list: to its closing parenthesis, a semicolon or the next part of the block.
  void skipList() {
    int depth = 1;
    while (!cursor_.atEnd() && cursor_.peek() != ';') {
      const char c = cursor_.peek();
      if (c == '\n') {
        std::vector<Span> skipped;
        cursor_.skipSpace(skipped);
        if (isSourceKeyword(cursor_.peekWord())) return;
        continue;
      }
      if (c == '"' || c == '\'') {
        if (const std::uint32_t end = cursor_.quotedEnd(); end > 0) {
          cursor_.to(end);
          continue;
        }
      }
      cursor_.skip(1);
      if (c == '(') ++depth;
      if (c == ')' && --depth == 0) return;
    }
  }

  /// NAME:=actual, one a line below the call, without parentheses and commas.
  void listing() {
    for (;;) {
      const std::uint32_t back = cursor_.at();
      std::vector<Span> between;
      cursor_.skipSpace(between);
      const std::uint32_t line = cursor_.at();
      const std::optional<Name> name = readName(cursor_);
      cursor_.skipBlanks();
      const bool isArgument = name && cursor_.startsWith(":=");
      if (!isArgument) return cursor_.to(back);
      cursor_.to(line);
      remarks_.insert(remarks_.end(), between.begin(), between.end());
      statement_.hasArguments = true;
      if (!argument()) return;
      cursor_.skipBlanks();
      if (cursor_.peek() == ',') cursor_.skip(1);
      cursor_.skipBlanks();
      if (!cursor_.atLineEnd()) return;
    }
  }

  /// The semicolon or the end of the line; what stands before it and was not read is a mistake.
  void finish() {
    cursor_.skipBlanks();
    if (isSourceKeyword(cursor_.peekWord())) return;
    if (!atStatementEnd()) {
      const std::uint32_t from = cursor_.at();
      const std::uint32_t lineEnd = cursor_.lineEnd();
      while (!cursor_.atEnd() && !atStatementEnd()) {
        const std::uint32_t quoted = cursor_.peek() == '"' ? cursor_.quotedEnd() : 0;
        cursor_.to(quoted > 0 ? quoted : cursor_.at() + 1);
      }
      std::uint32_t to = std::min(cursor_.at(), lineEnd);
      while (to > from && blankLength(cursor_.text(), to - 1) > 0) --to;
      fail("text behind the end of the statement", from, to);
    }
    cursor_.take(';');
  }

  Cursor& cursor_;
  const Spelling7& spelling_;
  std::vector<Span>& remarks_;
  std::uint32_t begin_;
  Statement statement_;
};

}  // namespace

Statement readStatement(Cursor& cursor, const Spelling7& spelling, std::vector<Span>& remarks) {
  return StatementParser(cursor, spelling, remarks).read();
}

}  // namespace rungproof::step7
