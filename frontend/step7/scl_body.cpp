// The parser of IEC 61131-3, with the marks of SCL.
#include "frontend/step7/scl_body.hpp"

#include <algorithm>

#include "frontend/iec/iec_statement_parser.hpp"
#include "frontend/step7/cursor.hpp"

namespace rungproof::step7 {

namespace {

class SclParser : public iec::StatementParser {
 public:
  SclParser(const iec::SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives)
      : StatementParser(source, sink, directives) {}

  /// CONST name := value; ... END_CONST, LABEL name, name; END_LABEL.
  void section(SclBody& body) {
    const bool isConst = isWord(peek(), "CONST");
    take();
    while (!isEnd() && !isAny({"END_CONST", "END_LABEL"})) {
      try {
        if (isConst)
          constant(body);
        else
          label();
      } catch (const Unreadable&) {
        body.isWhole = false;
        while (!isEnd() && !isAny({"END_CONST", "END_LABEL", ";"})) take();
        accept(";");
      }
    }
  }

 private:
  void constant(SclBody& body) {
    SclConstant made;
    made.name = name("the name of a constant");
    expect(":=");
    made.value = expression();
    expect(";");
    body.constants.push_back(std::move(made));
  }
  void label() {
    name("a label");
    if (!accept(",")) expect(";");
  }
};

bool hasUnread(const iec::Statements& statements) {
  return std::ranges::any_of(statements, [](const iec::Statement& one) {
    return one.kind == iec::StatementKind::Unread || hasUnread(one.otherwise) ||
           std::ranges::any_of(one.branches, [](const iec::Branch& branch) { return hasUnread(branch.body); });
  });
}

}  // namespace

std::shared_ptr<const SclBody> readSclBody(std::string_view text, const SclPlaces& places, SyntaxSink& sink,
                                           BlockSyntax& block, NetworkSyntax& network) {
  auto body = std::make_shared<SclBody>();
  std::vector<Directive> directives;
  const auto sourceOf = [&](std::uint32_t begin, std::uint32_t end) {
    iec::SourceText source;
    source.text = text.substr(begin, end - begin);
    source.file = sink.file();
    source.offset = begin;
    source.isScl = true;
    return source;
  };
  for (const auto& [begin, end] : places.sections) {
    const iec::SourceText source = sourceOf(begin, end);
    SclParser(source, sink, directives).section(*body);
  }
  const iec::SourceText source = sourceOf(places.begin, places.end);
  body->statements = SclParser(source, sink, directives).wholeBody();
  body->isWhole = body->isWhole && !hasUnread(body->statements);
  for (Directive& directive : directives)
    block.directives.push_back({std::move(directive.text), directive.span, network.number});
  Cursor cursor(text.substr(0, places.end), sink.file());
  cursor.to(places.begin);
  std::vector<Span> remarks;
  for (cursor.skipSpace(remarks); !cursor.atEnd(); cursor.skipSpace(remarks)) {
    const char c = cursor.peek();
    if (c == '"' || c == '\'')
      cursor.to(std::max(cursor.quotedEnd(), cursor.at() + 1));
    else
      cursor.skip(1);
  }
  for (const Span remark : remarks) network.remarks.push_back({remark});
  return body;
}

}  // namespace rungproof::step7
