// Charts as text: INITIAL_STEP, STEP, TRANSITION FROM .. TO, ACTION.
#pragma once

#include "frontend/iec/iec_chart.hpp"
#include "frontend/iec/iec_statement_parser.hpp"

namespace rungproof::iec {

class ChartParser : protected StatementParser {
 protected:
  using StatementParser::StatementParser;

  /// Whether a body is a chart: not where a variable has such a name.
  bool beginsChart() const {
    const bool isNamed = peek(1).kind == TokenKind::Word;
    return is("INITIAL_STEP") || (is("STEP") && isNamed) ||
           (is("TRANSITION") && (isNamed || (peek(1).text == "(" && isWord(peek(2), "PRIORITY"))));
  }
  /// A word that begins something of a file: what is open before it has lost its end.
  bool beginsDeclaration() const {
    return isAny({"TYPE", "FUNCTION", "FUNCTION_BLOCK", "PROGRAM", "CONFIGURATION", "VAR_GLOBAL"});
  }
  /// Statements or lines up to `end` or a method, which are not taken; what does not belong there leaves a statement
  /// that was not read.
  void bodyUntil(std::string_view end, Statements& body);
  /// Steps, transitions and actions up to `end`, which is not taken.
  ChartSyntax chart(std::string_view end);

 private:
  bool beginsPart() const { return isAny({"INITIAL_STEP", "STEP", "TRANSITION", "ACTION"}); }
  ChartStep step();
  void association(ChartStep& step);
  ChartTransition transition();
  void condition(ChartTransition& made);
  std::vector<std::pair<std::string, Span>> stepNames();
  ChartBody action();
};

}  // namespace rungproof::iec
