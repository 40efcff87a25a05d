// Statements and expressions of ST, lines of IL.
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
  /// Lines of IL up to the end of the text.
  Statements wholeList();

 protected:
  /// Up to a word that ends a list of statements: END_..., ELSE, UNTIL, a label of CASE if `inCase`.
  Statements statements(bool inCase = false);
  ExprPtr expression();
  Argument argument();
  std::vector<Argument> arguments();
  /// Whether IL begins here: a line with an operator in front and nothing that a statement would have behind it.
  bool beginsList() const;
  /// Lines of IL up to a word that ends a body.
  Statements listLines();
  bool endsStatements() const;
  /// METHOD or PROPERTY with its name, and not a variable of that name.
  bool beginsMember() const {
    return !source_.isScl && isAny({"METHOD", "PROPERTY"}) && peek(1).kind == TokenKind::Word;
  }

 private:
  Statement listLine();
  void listOperator(ListLine& line);
  void listOperands(ListLine& line);
  Argument listOperand();
  bool beginsWithCall(std::size_t open) const;
  bool isLabel() const;
  bool isLineEnd() const;
  bool isNewLine(std::size_t ahead) const;
  void skipLine();
  Statement statement();
  Statement plain();
  void expectAssignment();
  void chain(Statement& first);
  ExprPtr withTarget(std::size_t first);
  void tryStatement(Statement& made);
  void ifStatement(Statement& made);
  void caseStatement(Statement& made);
  void forStatement(Statement& made);
  bool isCaseLabel() const;
  void skipStatement();
  ExprPtr binary(int level);
  ExprPtr unary();
  ExprPtr primary();
  ExprPtr literal();
  ExprPtr path();
  PathPart indexPart();

  int caseDepth_ = 0;
  Statements chained_;  ///< assignments in front of the one that was read last
  struct Operators;
  int operators_ = -1;  ///< of the expression that is being read; -1: none is
};

}  // namespace rungproof::iec
