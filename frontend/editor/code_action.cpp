// Fixes and suppressions as edits.
#include "frontend/editor/code_action.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/lint/suppress.hpp"
#include "analysis/read_errors.hpp"
#include "frontend/editor/diagnostics.hpp"
#include "frontend/linting/fix.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

/// Stands where the engineer's reason belongs: a suppression without one is a finding.
constexpr std::string_view reasonToBe = "say why";

Json editJson(const CheckedDocument& document, Span span, std::string_view text) {
  Json edit{{"range", document.range(span)}, {"newText", text}};
  Json changes = Json::object();
  changes[document.uriOf(span.file)] = Json::array({edit});
  return {{"changes", changes}};
}

Json actionJson(const CheckedDocument& document, const Finding& finding, std::string title, Json edit) {
  return {{"title", title},
          {"kind", "quickfix"},
          {"diagnostics", Json::array({diagnosticOf(document, finding)})},
          {"edit", std::move(edit)}};
}

class Suppressor {
 public:
  Suppressor(const CheckedDocument& document, const Finding& finding)
      : document_(document), finding_(finding), place_(PlaceIndex(document.program()).at(finding.span)) {}

  void addTo(Json& actions) const {
    // Errors of the readers cannot be silenced, and comments of drawings are no place for suppressions.
    if (isReadError(finding_) || place_.network == nullptr || place_.network->form != Form::Stl ||
        place_.network->drawing || place_.network->instructions.empty())
      return;
    if (const Instruction* instruction = onLineOf(finding_.span)) addForLine(*instruction, actions);
    addForNetwork(actions);
  }

 private:
  const SourceFile& source() const { return document_.source(); }
  std::uint32_t lineOf(Span span) const { return source().position(span.offset).line; }

  const Instruction* onLineOf(Span span) const {
    const auto& all = place_.network->instructions;
    const auto found = std::ranges::find_if(all, [&](const Instruction& instruction) {
      return document_.isHere(instruction.span) && lineOf(instruction.span) == lineOf(span);
    });
    return found == all.end() ? nullptr : &*found;
  }

  std::string comment() const { return fmt::format("// rungproof: allow {} {}", finding_.rule, reasonToBe); }

  void addForLine(const Instruction& instruction, Json& actions) const {
    const std::uint32_t line = lineOf(instruction.span), begin = source().lineStart(line);
    const std::string_view text = source().line(line);
    StlLexer lexer(source().text());
    lexer.rewind(begin);
    Line words;
    if (!lexer.next(words)) return;
    Span span{document_.file(), words.end, 0};
    std::string replacement = "  " + comment();
    if (words.hasComment()) {
      const std::string_view old = trimmed(lexer.slice(words.commentBegin, words.commentEnd));
      span = {document_.file(), words.commentBegin, static_cast<std::uint32_t>(old.size())};
      const auto known = knownAllow(span);
      // What the comment says is the reason; one more code goes into a suppression that stands there already.
      if (known)
        replacement = fmt::format("{}{}, {}", old.substr(0, *known), finding_.rule, old.substr(*known));
      else if (old.starts_with("//") && trimmed(old.substr(2)).size() > 1)
        replacement = fmt::format("// rungproof: allow {} {}", finding_.rule, trimmed(old.substr(2)));
      else
        replacement = comment();
    } else if (text.empty()) {
      return;
    }
    actions.push_back(actionJson(document_, finding_, fmt::format("Allow {} on this line", finding_.rule),
                                 editJson(document_, span, replacement)));
  }

  /// Where the codes begin in a suppression that stands there; nothing if the comment is none.
  std::optional<std::size_t> knownAllow(Span comment) const {
    for (const Allow& allow : allowsOf(document_.program())) {
      if (allow.comment.file != comment.file || allow.comment.offset != comment.offset || allow.ids.empty()) continue;
      std::string text(source().text(comment));
      std::ranges::transform(text, text.begin(), upper);
      const std::size_t at = text.find(allow.ids.front());
      return at == std::string::npos ? std::nullopt : std::optional(at);
    }
    return std::nullopt;
  }

  void addForNetwork(Json& actions) const {
    const Instruction& first = place_.network->instructions.front();
    if (!document_.isHere(first.span)) return;
    const std::uint32_t begin = source().lineStart(lineOf(first.span));
    actions.push_back(actionJson(document_, finding_, fmt::format("Allow {} in this network", finding_.rule),
                                 editJson(document_, {document_.file(), begin, 0}, comment() + "\n")));
  }

  const CheckedDocument& document_;
  const Finding& finding_;
  const ProgramPlace place_;
};

void addFix(const CheckedDocument& document, const Finding& finding, Json& actions) {
  if (!finding.fix || !document.isHere(finding.fix->span)) return;
  const Fix& fix = *finding.fix;
  const std::string what = fix.replacement.empty() ? "remove it" : fmt::format("write '{}'", trimmed(fix.replacement));
  Json action = actionJson(
      document, finding,
      fmt::format("Mend {}: {}{}", finding.rule, what, fix.safe ? "" : " (may change what the program does)"),
      editJson(document, fix.span, fix.replacement));
  if (fix.safe) action["isPreferred"] = true;
  actions.push_back(std::move(action));
}

void addAllFixes(const CheckedDocument& document, Json& actions) {
  for (const FixedFile& fixed : fixedFiles(document.report())) {
    if (fixed.name != document.source().name()) continue;
    const Span whole{document.file(), 0, static_cast<std::uint32_t>(document.source().text().size())};
    actions.push_back({{"title", fmt::format("Mend all that can be mended safely ({})", fixed.applied.size())},
                       {"kind", "source.fixAll.rungproof"},
                       {"edit", editJson(document, whole, fixed.text)}});
  }
}

}  // namespace

Json codeActionsIn(const CheckedDocument& document, ClientPlace begin, ClientPlace end) {
  Json actions = Json::array();
  const std::uint32_t from = document.offset(begin), to = document.offset(end);
  for (const Finding& finding : document.report().findings) {
    if (!document.isHere(finding.span) || finding.span.offset > to || finding.span.offset + finding.span.length < from)
      continue;
    addFix(document, finding, actions);
    Suppressor(document, finding).addTo(actions);
  }
  addAllFixes(document, actions);
  return actions;
}

}  // namespace rungproof
