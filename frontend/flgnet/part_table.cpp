// The tables.
#include "frontend/flgnet/part_table.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rungproof::flgnet {

namespace {

using enum Element;

constexpr auto elementRows = std::to_array<ElementPart>({
    {"Contact", Contact, "&"},
    {"PContact", EdgeContact, "POS"},
    {"NContact", EdgeContact, "NEG", true},
    {"Not", Not, "o"},
    {"PBox", EdgeBox, "P"},
    {"NBox", EdgeBox, "N", true},
    {"A", And, "&"},
    {"O", Or, ">=1"},
    {"X", Xor, "XOR"},
    {"Coil", Coil, "="},
    {"SCoil", SetCoil, "S"},
    {"RCoil", ResetCoil, "R"},
    {"PCoil", EdgeCoil, "P"},
    {"NCoil", EdgeCoil, "N", true},
    {"Sr", SetReset, "SR"},
    {"Rs", ResetSet, "RS"},
    {"Jump", Jump, "JMP"},
    {"JumpNot", JumpNot, "JMPN"},
    {"Return", Return, "RET"},
});

constexpr auto boxPartRows = std::to_array<BoxPart>({
    {"Add", "Int", "ADD_I"},
    {"Add", "DInt", "ADD_DI"},
    {"Add", "Real", "ADD_R"},
    {"Sub", "Int", "SUB_I"},
    {"Sub", "DInt", "SUB_DI"},
    {"Sub", "Real", "SUB_R"},
    {"Mul", "Int", "MUL_I"},
    {"Mul", "DInt", "MUL_DI"},
    {"Mul", "Real", "MUL_R"},
    {"Div", "Int", "DIV_I"},
    {"Div", "DInt", "DIV_DI"},
    {"Div", "Real", "DIV_R"},
    {"Mod", "DInt", "MOD"},
    {"Abs", "Real", "ABS"},
    {"ACos", "Real", "ACOS"},
    {"ASin", "Real", "ASIN"},
    {"ATan", "Real", "ATAN"},
    {"Cos", "Real", "COS"},
    {"Exp", "Real", "EXP"},
    {"Ln", "Real", "LN"},
    {"Sin", "Real", "SIN"},
    {"Sqr", "Real", "SQR"},
    {"Sqrt", "Real", "SQRT"},
    {"Tan", "Real", "TAN"},
    {"Move", "", "MOVE"},
    {"Convert", "Bcd32>DInt", "BCD_DI"},
    {"Convert", "Bcd16>Int", "BCD_I"},
    {"Convert", "DInt>Bcd32", "DI_BCD"},
    {"Convert", "DInt>Real", "DI_R"},
    {"Convert", "Int>Bcd16", "I_BCD"},
    {"Convert", "Int>DInt", "I_DI"},
    {"Ceil", "Real>DInt", "CEIL"},
    {"Floor", "Real>DInt", "FLOOR"},
    {"Round", "Real>DInt", "ROUND"},
    {"Trunc", "Real>DInt", "TRUNC"},
    {"Neg", "Int", "NEG_I"},
    {"Neg", "DInt", "NEG_DI"},
    {"Neg", "Real", "NEG_R"},
    {"Inv", "Int", "INV_I"},
    {"Inv", "DInt", "INV_DI"},
    {"And", "Word", "WAND_W"},
    {"And", "DWord", "WAND_DW"},
    {"Or", "Word", "WOR_W"},
    {"Or", "DWord", "WOR_DW"},
    {"Xor", "Word", "WXOR_W"},
    {"Xor", "DWord", "WXOR_DW"},
    {"Shl", "Word", "SHL_W"},
    {"Shl", "DWord", "SHL_DW"},
    {"Shr", "Word", "SHR_W"},
    {"Shr", "DWord", "SHR_DW"},
    {"Shr", "Int", "SHR_I"},
    {"Shr", "DInt", "SHR_DI"},
    {"Rol", "DWord", "ROL_DW"},
    {"Ror", "DWord", "ROR_DW"},
    {"S_PULSE", "", "S_PULSE"},
    {"S_PEXT", "", "S_PEXT"},
    {"S_ODT", "", "S_ODT"},
    {"S_ODTS", "", "S_ODTS"},
    {"S_OFFDT", "", "S_OFFDT"},
    {"S_CU", "", "S_CU"},
    {"S_CD", "", "S_CD"},
    {"S_CUD", "", "S_CUD"},
});

constexpr auto relations = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"Eq", "=="}, {"Ne", "<>"}, {"Gt", ">"}, {"Ge", ">="}, {"Lt", "<"}, {"Le", "<="}});
constexpr auto compared =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"Int", "I"}, {"DInt", "D"}, {"Real", "R"}});
struct IecRow {
  std::string_view part, block, input, output;
};
constexpr auto iecRows = std::to_array<IecRow>({{"CTU", "SFB 0", "cu", "q"},
                                                {"CTD", "SFB 1", "cd", "q"},
                                                {"CTUD", "SFB 2", "cu", "qu"},
                                                {"TP", "SFB 3", "in", "q"},
                                                {"TON", "SFB 4", "in", "q"},
                                                {"TOF", "SFB 5", "in", "q"}});

const IecRow* iecRow(std::string_view part) {
  const auto row = std::ranges::find(iecRows, part, &IecRow::part);
  return row == iecRows.end() ? nullptr : &*row;
}

std::string_view secondOf(std::span<const std::pair<std::string_view, std::string_view>> rows, std::string_view first) {
  const auto row = std::ranges::find(rows, first, &std::pair<std::string_view, std::string_view>::first);
  return row == rows.end() ? std::string_view() : row->second;
}

}  // namespace

std::span<const ElementPart> elementParts() { return elementRows; }
std::span<const BoxPart> boxParts() { return boxPartRows; }

const ElementPart* elementPart(std::string_view part) {
  const auto row = std::ranges::find(elementRows, part, &ElementPart::part);
  return row == elementRows.end() ? nullptr : &*row;
}

const s7300::FbdBox* boxOf(std::string_view part, std::string_view type) {
  const auto row = std::ranges::find_if(
      boxPartRows, [&](const BoxPart& each) { return each.part == part && (each.type.empty() || each.type == type); });
  if (row == boxPartRows.end()) return nullptr;
  for (const s7300::FbdBox* box : s7300::fbdBoxesNamed(row->box)) {
    if (box->name == row->box) return box;
  }
  return nullptr;
}

bool isBoxPart(std::string_view part) {
  return std::ranges::find(boxPartRows, part, &BoxPart::part) != boxPartRows.end();
}

std::string_view relationOf(std::string_view part) { return secondOf(relations, part); }
std::string_view compareSuffix(std::string_view type) { return secondOf(compared, type); }

std::string_view iecBlock(std::string_view part) {
  const IecRow* row = iecRow(part);
  return row == nullptr ? std::string_view() : row->block;
}
std::string_view iecFlowInput(std::string_view part) {
  const IecRow* row = iecRow(part);
  return row == nullptr ? std::string_view() : row->input;
}
std::string_view iecFlowOutput(std::string_view part) {
  const IecRow* row = iecRow(part);
  return row == nullptr ? std::string_view() : row->output;
}

}  // namespace rungproof::flgnet
