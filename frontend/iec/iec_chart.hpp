// Sequential function charts: steps, transitions, actions, and the statements that they mean. A step becomes an
// instance of __STEP (iec_library.cpp) with X and T, a transition a variable that is TRUE in the scans in which it
// fires, an action the rows of its action control. Tested by tests/iec/chart_test.cpp.
#pragma once

#include "frontend/stl/syntax_sink.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

/// The qualifiers of an action: N non-stored, S stored, R reset, L limited, D delayed, P and P1 at the activation of
/// the step, P0 at its deactivation, SD stored and delayed, DS delayed and stored, SL stored and limited.
enum class Qualifier : std::uint8_t { N, S, R, L, D, P, P0, P1, SD, DS, SL };
std::optional<Qualifier> qualifierNamed(std::string_view name);
bool takesTime(Qualifier qualifier);

/// A step's association with an action.
struct ChartAction {
  std::string name;  ///< of a body, or a BOOL variable
  Qualifier qualifier = Qualifier::N;
  ExprPtr time;
  std::string timeText;  ///< as written
  Span span;
};

struct ChartStep {
  std::string name;
  bool isInitial = false;
  std::vector<ChartAction> actions;
  Span span;
};

struct ChartTransition {
  std::string name;                      ///< may be empty
  std::optional<std::int64_t> priority;  ///< the lowest number first, then those without
  std::vector<std::pair<std::string, Span>> from, to;
  /// An expression, or statements that compute the variable `result`, or a list of IL whose last result it is; none of
  /// them: the condition was not read.
  ExprPtr condition;
  Statements body;
  std::string result;
  Span span;
};

struct ChartSyntax;
struct ChartBody {
  std::string name;
  Statements body;
  std::unique_ptr<ChartSyntax> chart;  ///< an action that is a chart itself
  Span span;
};

struct ChartSyntax {
  std::vector<ChartStep> steps;
  std::vector<ChartTransition> transitions;  ///< from left to right
  std::vector<ChartBody> actions;
  Span span;
  bool isWhole = true;  ///< everything was read
};

/// Appends what the chart does to the body of the block, and its variables and routines to those of the block.
void chartStatements(ChartSyntax chart, BlockSyntax& block, SyntaxSink& sink);
/// What its actions do in a scan, on the situation at hand; nothing if it has none.
Statements actionStatements(const ChartSyntax& chart, BlockSyntax& block);

/// ms of a literal or of a constant of the block.
std::optional<std::int64_t> constantDuration(const BlockSyntax& block, const Expr& expr);
/// CLOCK of the step has to tell this duration from a longer one.
void countClockTo(BlockSyntax& block, const std::string& step, std::int64_t duration);
/// A variable of the block that its text does not name.
std::string hiddenVariable(BlockSyntax& block, std::string_view what, std::string_view type, Span span);

}  // namespace rungproof::iec
