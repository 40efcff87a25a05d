// From statements to instructions: mnemonics of either set, the operands that each takes, labels, and calls with their
// parameter lists. A statement that cannot be bound is reported and makes its network incomplete.
// Tested by tests/step7/bind_test.cpp.
#pragma once

#include "frontend/step7/constant_parser.hpp"
#include "frontend/step7/operand_binder.hpp"

namespace rungproof::step7 {

class StatementBinder {
 public:
  StatementBinder(const BlockCatalogue& catalogue, TypeTable& types, Reports& reports)
      : catalogue_(catalogue), operands_(catalogue, types), types_(types), reports_(reports) {}

  /// The labels of a block; those that stand twice are reported.
  void findLabels(const BlockSyntax& block, BlockScope& scope);
  /// Appends the instructions of a network; Network::complete says whether all of them could be bound.
  void bind(const NetworkSyntax& syntax, MnemonicSet set, BlockScope& scope, Network& network);

  /// The parameters that calls have given an SFC or SFB that no table describes; nullptr: no call did.
  std::shared_ptr<const s7300::Structure> undescribedInterface(BlockKey callee) const;

 private:
  bool statement(const Statement& statement);
  const Desc* instruction(const Statement& statement, const BoundOperand& operand);
  bool operandFits(const Desc& desc, const Statement& statement, const BoundOperand& operand);
  bool isMissing(const BoundOperand& bound) const;
  std::optional<rungproof::Operand> condition(const Statement& statement) const;
  bool jump(const Desc& desc, const Statement& statement);
  bool call(const Desc& desc, const Statement& statement);
  bool indirectCall(const Desc& desc, const Statement& statement, BoundOperand target);
  std::optional<rungproof::Operand> instanceOf(const Statement& statement, BlockKey callee);
  std::shared_ptr<const s7300::Structure> parametersOf(BlockKey callee);
  bool arguments(const Statement& statement, BlockKey callee, const s7300::Structure& parameters,
                 Instruction& instruction);
  std::optional<rungproof::Operand> actual(const Argument& argument, const s7300::Field& formal, BlockKey callee);
  std::optional<rungproof::Operand> placeOfPointer(const BoundOperand& bound, const s7300::Field& formal,
                                                   BlockKey callee, Span span);
  /// `mayBeValue`: the parameter of a block that no table describes, which may be a value as well.
  std::optional<rungproof::Operand> pointerActual(const Argument& argument, const BoundOperand& bound,
                                                  const s7300::Field& formal, bool mayBeValue);
  bool isUndescribed(BlockKey callee) const;
  bool refuseOpaque(const BoundOperand& operand, Span span);
  void noteParameters(BlockKey callee, const Statement& statement);
  void append(const Desc& desc, const Statement& statement, rungproof::Operands operands);
  bool refuse(Syntax code, Span span, std::string message, std::string_view help = {});
  bool refuse(const BoundOperand& operand);
  /// The same for something that no file defines: one finding for all its uses.
  bool miss(Syntax code, Span span, std::string message, std::string_view help = {});
  /// Keeps a statement whose operand nobody knows, so that what it does to registers and which network it stands in are
  /// known; false.
  bool keep(const Statement& statement, const BoundOperand& operand);

  const BlockCatalogue& catalogue_;
  OperandBinder operands_;
  TypeTable& types_;
  Reports& reports_;
  std::map<BlockKey, std::shared_ptr<s7300::Structure>> undescribed_;
  MnemonicSet set_ = MnemonicSet::International;
  BlockScope* scope_ = nullptr;
  Network* network_ = nullptr;
  bool isStructured_ = false;  ///< the statements were made of SCL
  bool isKept_ = false;        ///< the statement that could not be bound stands among the instructions
};

}  // namespace rungproof::step7
