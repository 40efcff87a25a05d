// By mnemonic.
#include "ir/iec/expression_role.hpp"

#include <array>
#include <string_view>
#include <unordered_map>

#include "ir/check.hpp"
#include "ir/iec/isa.hpp"

namespace rungproof {

namespace {

struct ExpressionRow {
  std::string_view mnemonic;
  ExpressionRole role;
  StackUse use;
};

using enum ExpressionRole;

/// Those that do not take two values and leave one.
constexpr auto expressionRows = std::to_array<ExpressionRow>({
    {"LOAD", Load, {0, 1}},
    {"LOAD.BIT", LoadBit, {0, 1}},
    {"CONST", Constant, {0, 1}},
    {"READING", Reading, {0, 1}},
    {"INDEX", Other, {1, 1}},
    {"LOAD.ELEMENT", Other, {1, 1}},
    {"NEG", Other, {1, 1}},
    {"ABS", Other, {1, 1}},
    {"NOT", Not, {1, 1}},
    {"RESIZE", Other, {1, 1}},
    {"TO.REAL", Other, {1, 1}},
    {"FROM.REAL", Other, {1, 1}},
    {"FUNC.REAL", Other, {1, 1}},
    {"NEG.REAL", Other, {1, 1}},
    {"ABS.REAL", Other, {1, 1}},
    {"NEG.LREAL", Other, {1, 1}},
    {"ABS.LREAL", Other, {1, 1}},
    {"FUNC.LREAL", Other, {1, 1}},
    {"TO.LREAL", Other, {1, 1}},
    {"FROM.LREAL", Other, {1, 1}},
    {"REAL.LREAL", Other, {1, 1}},
    {"LREAL.REAL", Other, {1, 1}},
    {"ANY", Other, {0, 0}},
    {"ANY.BIT", Other, {0, 0}},
    {"COPY.TEXT", Other, {0, 0}},
    {"CONCAT.TEXT", Other, {0, 0}},
    {"MID.TEXT", Other, {2, 0}},
    {"EQ.TEXT", Other, {0, 1}},
    {"LT.TEXT", Other, {0, 1}},
    {"LEN.TEXT", Other, {0, 1}},
    {"FIND.TEXT", Other, {0, 1}},
    {"STORE", Store, {1, 0}},
    {"STORE.BIT", StoreBit, {1, 0}},
    {"STORE.ELEMENT", Other, {2, 0}},
    {"FAULT", Other, {1, 0}},
    {"JMPCN", Other, {1, 0}},
    {"SEL", Select, {3, 1}},
    {"AND", And, {2, 1}},
    {"OR", Or, {2, 1}},
    {"XOR", Xor, {2, 1}},
    {"PASS", PassTime, {0, 0}},
    {"JMP", Other, {0, 0}},
    {"LBL", Other, {0, 0}},
    {"CAL", Other, {0, 0}},
    {"RET", Other, {0, 0}},
});

const ExpressionRow* expressionRowOf(const Instruction& instruction) {
  static const auto all = [] {
    std::unordered_map<const Desc*, const ExpressionRow*> rows;
    for (const ExpressionRow& row : expressionRows) {
      const Desc* desc = iecInstructions().named(row.mnemonic);
      CHECK(desc != nullptr, "a row names no instruction");
      rows.emplace(desc, &row);
    }
    return rows;
  }();
  const auto row = all.find(instruction.desc);
  return row == all.end() ? nullptr : row->second;
}

}  // namespace

ExpressionRole expressionRole(const Instruction& instruction) {
  const ExpressionRow* row = expressionRowOf(instruction);
  return row == nullptr ? Other : row->role;
}

bool isOfTruth(const Instruction& instruction) {
  const ExpressionRole role = expressionRole(instruction);
  const std::size_t width = role == Constant ? 1 : 0;  // behind the value
  return instruction.operands.size() > width && instruction.operands[width].value == 1;
}

StackUse stackUse(const Instruction& instruction) {
  const ExpressionRow* row = expressionRowOf(instruction);
  return row == nullptr ? StackUse{2, 1} : row->use;
}

}  // namespace rungproof
