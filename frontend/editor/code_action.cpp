// Fixes and suppressions as edits.
#include "frontend/editor/code_action.hpp"

#include <fmt/format.h>

#include "frontend/editor/diagnostics.hpp"
#include "frontend/editor/suppression_edit.hpp"
#include "frontend/linting/fix.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

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

void addSuppressions(const CheckedDocument& document, const Finding& finding, Json& actions) {
  const auto add = [&](const std::optional<TextEdit>& edit, std::string_view where) {
    if (!edit) return;
    actions.push_back(actionJson(document, finding, fmt::format("Allow {} {}", finding.rule, where),
                                 editJson(document, edit->span, edit->text)));
  };
  add(allowOnLine(document, finding), "on this line");
  add(allowInNetwork(document, finding), "in this network");
}

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
    addSuppressions(document, finding, actions);
  }
  addAllFixes(document, actions);
  return actions;
}

}  // namespace rungproof
