// A comment goes to the end of the line, into the comment that stands there, or on a line of its own.
#include "frontend/editor/suppression_edit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/lint/suppress.hpp"
#include "analysis/read_errors.hpp"
#include "frontend/editor/structured_text.hpp"
#include "frontend/stl/directive.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof {

namespace {

/// Stands where the engineer's reason belongs: a suppression without one is a finding.
constexpr std::string_view reasonToBe = "say why";

/// What a text of IEC 61131-3 says, comments apart.
struct LexedText {
  std::vector<iec::IecToken> tokens;
  std::vector<Directive> directives;
  std::vector<Span> comments;
};

LexedText lexedText(std::string_view text, std::uint32_t file) {
  Program unheard;
  SyntaxSink sink(unheard, file);
  LexedText lexed;
  lexed.tokens = iec::tokensOf({.text = text, .file = file}, sink, lexed.directives, &lexed.comments);
  return lexed;
}

bool saySame(const LexedText& a, const LexedText& b) {
  const auto isSameToken = [](const iec::IecToken& x, const iec::IecToken& y) { return x.text == y.text; };
  const auto isSameText = [](const Directive& x, const Directive& y) { return x.text == y.text; };
  return std::ranges::equal(a.tokens, b.tokens, isSameToken) &&
         std::ranges::equal(a.directives, b.directives, isSameText);
}

/// The comments of the document as its reader found them. Those that end on their line need not be there: what is
/// asked is what stands at the end of a line.
std::vector<Span> commentsIn(const CheckedDocument& document) {
  if (isStructuredText(document)) return lexedText(document.source().text(), document.file()).comments;
  std::vector<Span> spans;
  const auto add = [&](const std::vector<Comment>& comments) {
    for (const Comment& comment : comments) {
      if (document.isHere(comment.span)) spans.push_back(comment.span);
    }
  };
  for (const Pou& pou : document.program().pous) {
    add(pou.comments);
    for (const Network& network : pou.networks) add(network.comments);
  }
  return spans;
}

/// Whether text is a reason: readers take these signs off its ends.
bool isReason(std::string_view text) { return text.find_first_not_of(" \t:-()/*{}") != std::string_view::npos; }

/// "OUT001 is known": the first word would be read as one more rule.
bool beginsWithRule(std::string_view text) {
  return text.size() >= 6 && std::ranges::all_of(text.substr(0, 3), isLetter) &&
         std::ranges::all_of(text.substr(3, 3), isDigit);
}

bool speaksOfTool(std::string_view comment) {
  const std::string_view bare = comment.substr(std::min(comment.find_first_not_of(" \t/*(){}"), comment.size()));
  return equalsIgnoringCase(bare.substr(0, 10), "rungproof:");
}

class Allowance {
 public:
  Allowance(const CheckedDocument& document, const Finding& finding)
      : document_(document),
        source_(document.source()),
        rule_(finding.rule),
        place_(PlaceIndex(document.program()).at(finding.span)),
        comments_(commentsIn(document)),
        line_(source_.position(finding.span.offset).line),
        begin_(source_.lineStart(line_)) {
    const std::string_view text = source_.line(line_);
    first_ = begin_ + static_cast<std::uint32_t>(std::min(text.find_first_not_of(" \t\r"), text.size()));
    end_ = begin_ + static_cast<std::uint32_t>(text.find_last_not_of(" \t\r") + 1);
  }

  std::optional<TextEdit> onLine() const {
    const bool isText = isStructuredText(document_);
    if (!isText && (!hasStatements() || !startsOne())) return std::nullopt;
    TextEdit edit;
    if (goesOn(end_)) return ownLine();
    if (const auto behind = lineComment()) {
      const auto changed = withRule(*behind);
      if (!changed) return ownLine();
      edit = {*behind, *changed};
    } else {
      edit = {{document_.file(), end_, 0}, "  " + comment()};
    }
    return isReadAsMeant(edit) ? std::optional(edit) : std::nullopt;
  }

  std::optional<TextEdit> inNetwork() const {
    if (isStructuredText(document_) || !hasStatements() || place_.network->isStructured) return std::nullopt;
    const Instruction& first = place_.network->instructions.front();
    if (!document_.isHere(first.span)) return std::nullopt;
    const std::uint32_t begin = source_.lineStart(source_.position(first.span.offset).line);
    if (goesOn(begin) || !isLeftEmpty(begin, first.span.offset)) return std::nullopt;
    return TextEdit{{document_.file(), begin, 0}, comment() + lineEnd()};
  }

 private:
  std::string comment() const { return fmt::format("// rungproof: allow {} {}", rule_, reasonToBe); }
  std::string lineEnd() const {
    const std::size_t newline = source_.text().find('\n');
    return newline != std::string_view::npos && newline > 0 && source_.text()[newline - 1] == '\r' ? "\r\n" : "\n";
  }

  /// Comments of drawings are no place for suppressions.
  bool hasStatements() const {
    return place_.network != nullptr && place_.network->form == Form::Stl && !place_.network->drawing &&
           !place_.network->instructions.empty();
  }
  bool isOnLine(const Instruction& instruction) const {
    return document_.isHere(instruction.span) && source_.position(instruction.span.offset).line == line_;
  }
  bool startsOne() const {
    return std::ranges::any_of(place_.network->instructions, [&](const Instruction& one) { return isOnLine(one); });
  }
  /// Whether a comment that has begun before an offset ends behind it.
  bool goesOn(std::uint32_t offset) const {
    return std::ranges::any_of(
        comments_, [&](Span comment) { return comment.offset < offset && offset < comment.offset + comment.length; });
  }
  std::optional<Span> lineComment() const {
    const auto found = std::ranges::find_if(comments_, [&](Span comment) {
      return begin_ <= comment.offset && comment.offset < end_ && source_.text(comment).starts_with("//");
    });
    if (found == comments_.end()) return std::nullopt;
    const std::string_view text = source_.text(*found);
    return Span{found->file, found->offset, static_cast<std::uint32_t>(text.find_last_not_of(" \t\r") + 1)};
  }
  /// Blanks, or a label, before a statement.
  bool isLeftEmpty(std::uint32_t from, std::uint32_t to) const {
    const std::string_view left = trimmed(source_.text().substr(from, to - from));
    return left.empty() || (left.ends_with(':') && left.find_first_of(" \t;\"") == std::string_view::npos);
  }

  /// The comment with the rule in it; what it says becomes the reason. Nothing if it speaks to the tool already and has
  /// no place for a rule.
  std::optional<std::string> withRule(Span comment) const {
    const std::string_view old = source_.text(comment);
    if (directiveText(old)) return std::nullopt;
    if (speaksOfTool(old)) return withOneMore(comment);
    const std::string_view said = trimmed(old.substr(2));
    if (!isReason(said)) return this->comment() + (said.empty() ? "" : " ") + std::string(said);
    return fmt::format("// rungproof: allow {}{} {}", rule_, beginsWithRule(said) ? ":" : "", said);
  }
  std::optional<std::string> withOneMore(Span comment) const {
    const std::string_view old = source_.text(comment);
    for (const Allow& allow : allowsOf(document_.program())) {
      if (allow.comment.file != comment.file || allow.comment.offset != comment.offset || allow.ids.empty()) continue;
      if (allow.scope != AllowScope::Line || allow.line != line_) return std::nullopt;
      std::string text(old);
      std::ranges::transform(text, text.begin(), upper);
      const std::size_t at = text.find(allow.ids.front());
      if (at == std::string::npos) return std::nullopt;
      return fmt::format("{}{}, {}{}{}", old.substr(0, at), rule_, old.substr(at), allow.reason.empty() ? " " : "",
                         allow.reason.empty() ? reasonToBe : "");
    }
    return std::nullopt;
  }

  /// Alone on the line before: where a comment there speaks for this line and for no more.
  std::optional<TextEdit> ownLine() const {
    if (goesOn(begin_) || !speaksForLineOnly()) return std::nullopt;
    const std::string_view indent = source_.text().substr(begin_, first_ - begin_);
    const TextEdit edit{{document_.file(), begin_, 0}, std::string(indent) + comment() + lineEnd()};
    return isReadAsMeant(edit) ? std::optional(edit) : std::nullopt;
  }
  bool speaksForLineOnly() const {
    if (isStructuredText(document_)) {
      // In the head of a block it would speak for the block.
      return std::ranges::none_of(document_.program().syntax->blocks, [&](const iec::BlockSyntax& block) {
        const bool isBehindHead = !block.body.empty() && block.body.front().span.offset <= first_;
        return Span{document_.file(), begin_, 0}.beginsIn(block.span) && !isBehindHead;
      });
    }
    if (place_.network->isStructured) return false;
    // Before the first statement of a network it would speak for the network.
    bool isFirst = true, isStart = false;
    for (const Instruction& one : place_.network->instructions) {
      if (!document_.isHere(one.span)) continue;
      if (one.span.offset < begin_) isFirst = false;
      if (one.span.offset < begin_ && begin_ < one.span.offset + one.span.length) return false;
      if (isOnLine(one) && isLeftEmpty(begin_, one.span.offset)) isStart = true;
    }
    return !isFirst && isStart;
  }

  /// Whether the text with the edit says the same, and the comment is one.
  bool isReadAsMeant(const TextEdit& edit) const {
    std::string text(source_.text());
    text.replace(edit.span.offset, edit.span.length, edit.text);
    const auto sign = edit.span.offset + static_cast<std::uint32_t>(edit.text.find("//"));
    if (isStructuredText(document_)) {
      const LexedText after = lexedText(text, document_.file());
      return saySame(lexedText(source_.text(), document_.file()), after) &&
             std::ranges::any_of(after.comments, [&](Span comment) { return comment.offset == sign; });
    }
    if (dialectOf(document_.program().target).text.quotesSymbols) return true;
    StlLexer lexer(text);
    lexer.rewind(begin_);
    Line words;
    while (lexer.next(words) && !words.hasComment() && lexer.position() <= sign) {
    }
    return words.hasComment() && words.commentBegin == sign;
  }

  const CheckedDocument& document_;
  const SourceFile& source_;
  const std::string rule_;
  const ProgramPlace place_;
  const std::vector<Span> comments_;
  const std::uint32_t line_, begin_;
  std::uint32_t first_ = 0, end_ = 0;  ///< what the line holds without the blanks around it
};

}  // namespace

std::optional<TextEdit> allowOnLine(const CheckedDocument& document, const Finding& finding) {
  // Errors of the readers cannot be silenced.
  return isReadError(finding) ? std::nullopt : Allowance(document, finding).onLine();
}

std::optional<TextEdit> allowInNetwork(const CheckedDocument& document, const Finding& finding) {
  return isReadError(finding) ? std::nullopt : Allowance(document, finding).inNetwork();
}

}  // namespace rungproof
