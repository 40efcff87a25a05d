// Names and pins.
#include "frontend/drawing/box_form.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rungproof {

namespace {

using NamePair = std::pair<std::string_view, std::string_view>;

/// Mnemonic and the name in the box, sorted by mnemonic.
constexpr auto boxNames = std::to_array<NamePair>({
    {"*D", "MUL_DI"},     {"*I", "MUL_I"},        {"*R", "MUL_R"},      {"+D", "ADD_DI"},       {"+I", "ADD_I"},
    {"+R", "ADD_R"},      {"-D", "SUB_DI"},       {"-I", "SUB_I"},      {"-R", "SUB_R"},        {"/D", "DIV_DI"},
    {"/I", "DIV_I"},      {"/R", "DIV_R"},        {"ANDB", "WAND_B"},   {"ANDD", "WAND_DW"},    {"ANDW", "WAND_W"},
    {"ATT", "AD_T_TBL"},  {"BCDI", "BCD_I"},      {"BIR", "MOV_BIR"},   {"BITIM", "BGN_ITIME"}, {"BIW", "MOV_BIW"},
    {"BMB", "BLKMOV_B"},  {"BMD", "BLKMOV_D"},    {"BMW", "BLKMOV_W"},  {"BTI", "B_I"},         {"CEVNT", "CLR_EVNT"},
    {"CFND", "CHR_FIND"}, {"CITIM", "CAL_ITIME"}, {"DECB", "DEC_B"},    {"DECD", "DEC_DW"},     {"DECW", "DEC_W"},
    {"DLED", "DIAG_LED"}, {"DTI", "DI_I"},        {"DTR", "DI_R"},      {"DTS", "DI_S"},        {"FILL", "FILL_N"},
    {"GPA", "GET_ADDR"},  {"IBCD", "I_BCD"},      {"INCB", "INC_B"},    {"INCD", "INC_DW"},     {"INCW", "INC_W"},
    {"INVB", "INV_B"},    {"INVD", "INV_DW"},     {"INVW", "INV_W"},    {"ITB", "I_B"},         {"ITD", "I_DI"},
    {"ITS", "I_S"},       {"MOVB", "MOV_B"},      {"MOVD", "MOV_DW"},   {"MOVR", "MOV_R"},      {"MOVW", "MOV_W"},
    {"ORB", "WOR_B"},     {"ORD", "WOR_DW"},      {"ORW", "WOR_W"},     {"RLB", "ROL_B"},       {"RLD", "ROL_DW"},
    {"RLW", "ROL_W"},     {"RRB", "ROR_B"},       {"RRD", "ROR_DW"},    {"RRW", "ROR_W"},       {"RTS", "R_S"},
    {"SCAT", "STR_CAT"},  {"SCPY", "STR_CPY"},    {"SFND", "STR_FIND"}, {"SLB", "SHL_B"},       {"SLD", "SHL_DW"},
    {"SLEN", "STR_LEN"},  {"SLW", "SHL_W"},       {"SPA", "SET_ADDR"},  {"SRB", "SHR_B"},       {"SRD", "SHR_DW"},
    {"SRW", "SHR_W"},     {"SSCPY", "SSTR_CPY"},  {"STD", "S_DI"},      {"STI", "S_I"},         {"STR", "S_R"},
    {"TODR", "READ_RTC"}, {"TODRX", "READ_RTCX"}, {"TODW", "SET_RTC"},  {"TODWX", "SET_RTCX"},  {"XORB", "WXOR_B"},
    {"XORD", "WXOR_DW"},  {"XORW", "WXOR_W"},
});
static_assert(std::ranges::is_sorted(boxNames));

/// What stands in a coil where it is not the mnemonic.
constexpr auto coilSigns = std::to_array<NamePair>({
    {"=", " "},
    {"=I", "I"},
    {"CRET", "RET"},
    {"CRETI", "RETI"},
    {"CSCRE", "SCRE"},
    {"LSCR", "SCR"},
    {"MEND", "END"},
});
static_assert(std::ranges::is_sorted(coilSigns));

template <std::size_t n>
std::string_view secondOf(const std::array<NamePair, n>& rows, std::string_view key) {
  const auto found = std::ranges::lower_bound(rows, key, {}, &NamePair::first);
  return found != rows.end() && found->first == key ? found->second : std::string_view();
}

/// Subtraction and division: STL takes OUT as the first operand (001:4814), the box shows it as IN1.
bool takesOutFirst(const Desc& desc) {
  return desc.stl.starts_with('-') || desc.stl.starts_with('/') || desc.stl == "DIV";
}

bool standsAbove(const Desc& desc, const OperandDesc& operand) {
  if (operand.type == Type::Timer || operand.type == Type::Counter) return operand.direction == Direction::InOut;
  return desc.drawingOnly && operand.type == Type::Bool && operand.direction == Direction::InOut;
}

std::vector<OperandPin> callPins(std::size_t count, const Pou* callee) {
  std::vector<OperandPin> pins;
  std::size_t next = 1;
  if (callee != nullptr) {
    for (const LocalVariable& local : callee->locals) {
      if (local.section == VarSection::Temp || next >= count) continue;
      pins.push_back({next++, local.section == VarSection::Output ? PinSide::Right : PinSide::Left, local.name});
    }
  }
  for (; next < count; ++next) pins.push_back({next, PinSide::Left, "x" + std::to_string(next)});
  return pins;
}

}  // namespace

std::vector<std::string> callPowerPins(const std::vector<Operand>& operands, const Pou* callee) {
  std::vector<std::string> names = {"EN"};
  for (const OperandPin& pin : callPins(operands.size(), callee)) {
    if (operands[pin.operand].kind == OperandKind::Missing) names.push_back(pin.name);
  }
  return names;
}

std::string boxName(const Desc& desc) {
  if (const std::string_view name = secondOf(boxNames, desc.stl); !name.empty()) return std::string(name);
  if (desc.stl.starts_with("FND")) return "TBL_FIND " + std::string(desc.stl.substr(3));
  return std::string(desc.stl.substr(0, desc.stl.find(".IEC")));
}

std::string contactSign(const Desc& desc) {
  if (desc.execution == Execution::Compare) {
    const std::size_t sign = desc.stl.find_first_of("<>=");
    const std::string relation(desc.stl.substr(sign));
    const char letter = desc.stl[sign - 1];
    return (relation == "=" ? "==" : relation) + (letter == 'W' ? 'I' : letter);
  }
  if (desc.stl == "EU") return "P";
  if (desc.stl == "ED") return "N";
  if (desc.stl == "NOT") return "NOT";
  std::string sign = isNegatedContact(desc) ? "/" : "";
  if (desc.stl.ends_with('I')) sign += "I";
  return sign.empty() ? " " : sign;
}

std::string coilSign(const Desc& desc) {
  const std::string_view sign = secondOf(coilSigns, desc.stl);
  return std::string(sign.empty() ? desc.stl : sign);
}

bool isBracket(const Desc& desc) { return desc.control == Control::LabelMark || desc.control == Control::Lscr; }

bool isNegatedContact(const Desc& desc) { return desc.stl == "LDN" || desc.stl == "LDNI"; }

std::vector<OperandPin> operandPins(const Desc& desc, std::size_t count, const Pou* callee) {
  if (desc.control == Control::Call) return callPins(count, callee);
  std::vector<OperandPin> pins;
  const bool hasIn1 = desc.operandCount > 0 && desc.operands[0].name == "IN1";
  for (std::size_t i = 0; i < std::min<std::size_t>(count, desc.operandCount); ++i) {
    const OperandDesc& operand = desc.operands[i];
    const std::string name(operand.name);
    if (standsAbove(desc, operand)) {
      pins.push_back({i, PinSide::Above, name});
    } else if (operand.direction == Direction::Out) {
      pins.push_back({i, PinSide::Right, name});
    } else if (operand.direction == Direction::InOut && name == "OUT") {
      pins.push_back({i, PinSide::Left, !hasIn1 ? "IN" : takesOutFirst(desc) ? "IN1" : "IN2"});
      pins.push_back({i, PinSide::Right, name});
    } else {
      pins.push_back({i, PinSide::Left, takesOutFirst(desc) && name == "IN1" ? "IN2" : name});
    }
  }
  if (takesOutFirst(desc)) std::ranges::stable_sort(pins, {}, [](const OperandPin& pin) { return pin.name; });
  return pins;
}

std::vector<std::string> powerPins(const Desc& desc, std::size_t count) {
  const std::string name = boxName(desc);
  if (name == "TON" || name == "TOF" || name == "TONR" || name == "TP") return {"IN"};
  if (name == "CTU") return {"CU", "R"};
  if (name == "CTD") return {"CD", "LD"};
  if (name == "CTUD" && count == 4) return {"CU", "CD", "R", "LD"};
  if (name == "CTUD") return {"CU", "CD", "R"};
  if (name == "SR") return {"S1", "R"};
  if (name == "RS") return {"S", "R1"};
  return {"EN"};
}

std::string powerOutput(const Desc& desc) {
  if (desc.eno) return "ENO";
  if (!desc.drawingOnly) return {};
  return desc.operands[0].type == Type::Bool ? "OUT" : "Q";
}

}  // namespace rungproof
