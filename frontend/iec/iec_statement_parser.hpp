// Statements and expressions of ST.
#pragma once

#include "frontend/iec/iec_parser_core.hpp"

namespace rungproof::iec {

class StatementParser : protected ParserCore {
 public:
  StatementParser(const SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives)
      : ParserCore(source, sink, directives) {}

  /// Everything up to the end of the text.
  Statements wholeBody();
  /// One expression that is all of the text.
  ExprPtr wholeExpression();

 protected:
  /// Up to a word that ends a list of statements: END_..., ELSE, UNTIL, a label of CASE if `inCase`.
  Statements statements(bool inCase = false);
  ExprPtr expression();
  Argument argument();
  std::vector<Argument> arguments();

 private:
  Statement statement();
  Statement plain();
  void expectAssignment();
  void tryStatement(Statement& made);
  void ifStatement(Statement& made);
  void caseStatement(Statement& made);
  void forStatement(Statement& made);
  bool isCaseLabel() const;
  bool endsStatements() const;
  void skipStatement();
  ExprPtr binary(int level);
  ExprPtr unary();
  ExprPtr primary();
  ExprPtr literal();
  ExprPtr path();
  PathPart indexPart();

  int caseDepth_ = 0;
};

}  // namespace rungproof::iec
