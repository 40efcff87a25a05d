// IEC005: a function whose result a path leaves out, and outputs that nothing writes. Tested by its examples and
// tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"
#include "ir/iec/walk.hpp"

namespace rungproof {

namespace {

/// Whether a list of statements gives the result on every path.
class ResultPaths {
 public:
  explicit ResultPaths(const std::string& name) : name_(iec::foldedName(name)) {}

  /// Whether the paths that go on behind the list have given it; nothing if none goes on.
  std::optional<bool> list(const iec::Statements& statements, bool isGiven) {
    for (const iec::Statement& one : statements) {
      const std::optional<bool> behind = statement(one, isGiven);
      if (!behind) return std::nullopt;
      isGiven = *behind;
    }
    return isGiven;
  }
  /// A RETURN in front of the result, or nullptr.
  const iec::Statement* leftAt() const { return leftAt_; }

 private:
  std::optional<bool> statement(const iec::Statement& one, bool isGiven) {
    switch (one.kind) {
      case iec::StatementKind::Assign: return isGiven || isResult(*one.target);
      case iec::StatementKind::Call: return isGiven || isOutput(*one.target);
      case iec::StatementKind::Return:
        if (!isGiven && leftAt_ == nullptr) leftAt_ = &one;
        return std::nullopt;
      case iec::StatementKind::If:
      case iec::StatementKind::Case: {
        std::optional<bool> all;
        const auto join = [&](std::optional<bool> end) {
          if (end) all = all ? *all && *end : *end;
        };
        for (const iec::Branch& branch : one.branches) join(list(branch.body, isGiven));
        join(one.hasElse ? list(one.otherwise, isGiven) : isGiven);
        return all;
      }
      case iec::StatementKind::For:
      case iec::StatementKind::While:
      case iec::StatementKind::Repeat: {
        for (const iec::Branch& branch : one.branches) isGiven = loop(one, branch.body, isGiven);
        return loop(one, one.otherwise, isGiven);
      }
      default: return isGiven;
    }
  }

  bool loop(const iec::Statement& one, const iec::Statements& body, bool isGiven) {
    const bool behind = list(body, isGiven).value_or(isGiven);
    return one.kind == iec::StatementKind::Repeat || runsOnce(one) ? behind : isGiven;
  }

  /// FOR with limits that let at least one pass run, and nothing in it that ends a pass.
  static bool runsOnce(const iec::Statement& one) {
    if (one.kind != iec::StatementKind::For || one.by != nullptr || one.last == nullptr) return false;
    const auto first = numberOf(*one.value), last = numberOf(*one.last);
    bool leaves = false;
    iec::eachStatement(one.otherwise, [&](const iec::Statement& inner, const iec::Statements&, std::size_t) {
      leaves = leaves || inner.kind == iec::StatementKind::Exit || inner.kind == iec::StatementKind::Continue;
    });
    return first && last && *first <= *last && !leaves;
  }
  static std::optional<std::int64_t> numberOf(const iec::Expr& expr) {
    std::int64_t number = 0;
    const char* const end = expr.text.data() + expr.text.size();
    const auto read = std::from_chars(expr.text.data(), end, number);
    const bool isNumber = expr.kind == iec::ExprKind::Literal && expr.prefix.empty() && read.ptr == end;
    return isNumber && read.ec == std::errc() ? std::optional(number) : std::nullopt;
  }

  bool isResult(const iec::Expr& target) const {
    return target.kind == iec::ExprKind::Path && !target.parts.empty() &&
           iec::foldedName(target.parts[0].name) == name_;
  }
  bool isOutput(const iec::Expr& call) const {
    for (const iec::Argument& argument : call.arguments) {
      if (argument.isOutput && argument.value != nullptr && isResult(*argument.value)) return true;
    }
    return false;
  }

  std::string name_;
  const iec::Statement* leftAt_ = nullptr;
};

void checkIec005(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  iec::eachOwnBlock(uses.project(), [&](const iec::BlockSyntax& block) {
    if (block.kind != iec::BlockKind::Function || iec::isList(block.body)) return;
    const auto check = [&](const std::string& name, Span place, std::string message) {
      ResultPaths paths(name);
      const std::optional<bool> end = paths.list(block.body, false);
      if (end.value_or(true) && paths.leftAt() == nullptr) return;
      Finding& finding = sink.report(place, std::move(message));
      finding.address = name;
      if (paths.leftAt() != nullptr) finding.related.push_back({paths.leftAt()->span, "the function can be left here"});
      finding.help = fmt::format("begin with '{} := ...;'", name);
    };
    if (block.result != nullptr)
      check(block.name, block.span, fmt::format("function {} does not give its result on every path", block.name));
    for (const iec::VariableSyntax& variable : block.variables) {
      const iec::DeclaredVariable* row = uses.find(block, variable.name);
      const bool isOutput = variable.section == iec::Section::Output && variable.initial == nullptr;
      if (isOutput && row != nullptr && row->isWritten())
        check(variable.name, variable.span,
              fmt::format("function {} does not write its output {} on every path", block.name, variable.name));
    }
  });
  for (const iec::DeclaredVariable& row : uses.all()) {
    const bool isOutput = row.block != nullptr && row.variable->section == iec::Section::Output;
    if (!isOutput || row.isWritten() || row.isCalled() || uses.blockOf(*row.variable) != nullptr) continue;
    Finding& finding =
        iec::reportOn(sink, row, row.variable->span,
                      fmt::format("output {} of {} is never written", row.variable->name, row.block->name));
    finding.help = "write it, or remove it";
  }
}

}  // namespace

extern constexpr Rule iec005_result_not_assigned = {
    .id = "IEC005",
    .title = "Result or output not written",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a function that can end without giving its result or one of its outputs; an output that no statement writes",
    .why = "the caller gets the initial value of the type, mostly 0, and takes it for a result",
    .bad =
        "PROGRAM Main\nVAR_INPUT x : INT; END_VAR\nVAR_OUTPUT y : INT; END_VAR\ny := Half(x);\nEND_PROGRAM\nFUNCTION "
        "Half : INT\nVAR_INPUT x : INT; END_VAR\nIF x > 1 THEN\n  Half := x / 2;\nEND_IF;\nEND_FUNCTION\n",
    .good =
        "PROGRAM Main\nVAR_INPUT x : INT; END_VAR\nVAR_OUTPUT y : INT; END_VAR\ny := Half(x);\nEND_PROGRAM\nFUNCTION "
        "Half : INT\nVAR_INPUT x : INT; END_VAR\nHalf := 0;\nIF x > 1 THEN\n  Half := x / 2;\nEND_IF;\nEND_FUNCTION\n",
    .exampleCpu = "IEC-4K",
    .peers = "SA0022",
    .dialects = dialect::Iec,
    .check = checkIec005,
};

}  // namespace rungproof
