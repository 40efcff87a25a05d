// Standard functions of IEC 61131-3 as instructions of the S7-200: logic, arithmetic, comparisons, selection, shifts,
// conversions. Functions of the standard that the S7-200 has no instruction for are findings, never guesses.
// Tested by tests/graphical/block_test.cpp.
#pragma once

#include <string_view>
#include <vector>

#include "frontend/graphical/drawn_lowering.hpp"

namespace rungproof {

class DrawnFunctions {
 public:
  DrawnFunctions(DrawnLowering& lowering, const DrawnElement& element, Wire enable)
      : l_(lowering), e_(element), enable_(enable) {}

  /// Whether a function of that name is known: "ADD", "add", "INT_TO_REAL", "GE".
  static bool isKnown(std::string_view name);
  /// The result; Nothing if something was reported. `target`: where a number may be left at once.
  DrawnValue run(const VariablePlace* target);

 private:
  bool logic(std::string_view name, DrawnValue& result);
  bool arithmetic(std::string_view name, DrawnValue& result);
  bool comparison(std::string_view name, DrawnValue& result);
  bool selection(std::string_view name, DrawnValue& result);
  bool shift(std::string_view name, DrawnValue& result);
  bool conversion(std::string_view name, DrawnValue& result);
  bool mathematics(std::string_view name, DrawnValue& result);

  DrawnValue boolGate(std::string_view name);
  DrawnValue bitwise(std::string_view name);
  void sum(char sign, Arithmetic kind, const Operand& number, const Operand& place, Wire enable);
  std::optional<DrawnValue> product(IecType type);
  /// The high word of a double word.
  static Operand highPart(Operand place);
  Operand longCopy(const Operand& from, Wire enable);
  Operand longProduct(const Operand& a, const Operand& b);
  std::optional<Operand> factor(DrawnValue value);
  DrawnValue modulo(const Operands& operands, Arithmetic kind, IecType type);
  DrawnValue converted(const DrawnValue& value, IecType to);
  Wire related(std::string_view relation, const DrawnValue& a, const DrawnValue& b, Wire input);

  bool readInputs(std::size_t least, std::size_t most);
  IecType commonType() const;
  /// A fresh place for a result, or the target if it has the type and none of the inputs lies there.
  Operand resultPlace(IecType type);
  DrawnValue moved(const DrawnValue& value, IecType type, Wire enable);
  void move(const Operand& from, const Operand& to, IecType type, Wire enable);

  DrawnLowering& l_;
  const DrawnElement& e_;
  Wire enable_;
  const VariablePlace* target_ = nullptr;
  std::vector<DrawnValue> in_;
};

}  // namespace rungproof
