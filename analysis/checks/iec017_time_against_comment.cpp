// IEC017: a TIME literal that the comment on its line contradicts. Tested by its examples and
// tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <vector>

#include "analysis/comment/duration_text.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Microseconds of T#1m30s, TIME#2.5s, T#-5s.
std::optional<std::int64_t> microseconds(std::string_view text) {
  double total = 0;
  std::size_t at = 0;
  while (at < text.size()) {
    std::string number;
    while (at < text.size() &&
           (std::isdigit(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.' || text[at] == '_')) {
      if (text[at] != '_') number += text[at];
      ++at;
    }
    std::string unit;
    while (at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0)
      unit += static_cast<char>(std::tolower(static_cast<unsigned char>(text[at++])));
    if (at < text.size() && text[at] == '_') ++at;
    const double each = unit == "d"    ? 86400e6
                        : unit == "h"  ? 3600e6
                        : unit == "m"  ? 60e6
                        : unit == "s"  ? 1e6
                        : unit == "ms" ? 1e3
                        : unit == "us" ? 1
                                       : 0;
    double value = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
    if (each == 0 || read.ec != std::errc() || read.ptr != number.data() + number.size()) return std::nullopt;
    total += value * each;
  }
  constexpr double longest = 9e18;
  if (total > longest) return std::nullopt;
  return static_cast<std::int64_t>(total + 0.5);
}

bool isDuration(const iec::Expr& expr) {
  const std::string prefix = iec::foldedName(expr.prefix);
  return expr.kind == iec::ExprKind::Literal &&
         (prefix == "T" || prefix == "TIME" || prefix == "LT" || prefix == "LTIME");
}

/// The comment that begins on the line of the place, behind it.
std::string_view commentBehind(const SourceSet& sources, Span span) {
  const std::string_view text = sources.file(span.file).text();
  const std::size_t from = std::min<std::size_t>(span.offset + span.length, text.size());
  const std::string_view line = text.substr(from, std::min(text.find('\n', from), text.size()) - from);
  const std::size_t begin = std::min(line.find("//"), line.find("(*"));
  if (begin == std::string_view::npos) return {};
  const std::string_view comment = line.substr(begin);
  return comment.starts_with("//@") || comment.starts_with("//!") ? std::string_view() : comment;
}

void checkIec017(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  const SourceSet& sources = *facts.program().sources;
  std::vector<const iec::Expr*> literals;
  iec::eachOwnBlock(uses.project(), [&](const iec::BlockSyntax& block) {
    for (const iec::VariableSyntax& variable : block.variables) {
      if (variable.initial != nullptr && variable.initial->value != nullptr && isDuration(*variable.initial->value))
        literals.push_back(variable.initial->value.get());
    }
    iec::eachWrittenStatement(block, [&](const iec::Statement& one, const iec::Statements&, std::size_t) {
      iec::eachExpression(one, [&](const iec::Expr& expr) {
        if (isDuration(expr)) literals.push_back(&expr);
      });
    });
  });
  for (const iec::Expr* literal : literals) {
    const std::optional<std::int64_t> us = microseconds(literal->text);
    const std::vector<WrittenDuration> said = durationsIn(commentBehind(sources, literal->span));
    const auto agrees = [&](const WrittenDuration& duration) { return duration.isTimeBase || duration.us == *us; };
    if (!us || said.empty() || std::ranges::any_of(said, agrees)) continue;
    Finding& finding = sink.report(literal->span, fmt::format("the comment says {}, the literal is {}",
                                                              said.front().text, sources.text(literal->span)));
    finding.help = "correct the one that is wrong";
  }
}

}  // namespace

extern constexpr Rule iec017_time_against_comment = {
    .id = "IEC017",
    .title = "TIME literal against its comment",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "a TIME literal with a comment behind it on the same line that names another duration",
    .why = "one of them was changed and the other was not: who reads the comment sets the machine up wrongly",
    .bad =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Delay : TON; END_VAR\nVAR_OUTPUT Run : BOOL; "
        "END_VAR\nDelay(IN := Start, PT := T#5s);  // runs after 3 s\nRun := Delay.Q;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Start : BOOL; END_VAR\nVAR Delay : TON; END_VAR\nVAR_OUTPUT Run : BOOL; "
        "END_VAR\nDelay(IN := Start, PT := T#3s);  // runs after 3 s\nRun := Delay.Q;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .dialects = dialect::Iec,
    .check = checkIec017,
};

}  // namespace rungproof
