// Table of system names; addresses by comparison of exports with and without names, meanings in
// Appendix D (001:14027) and, for the S7-200 SMART, in its own table.
#include "frontend/stl/system_symbol.hpp"

#include <algorithm>
#include <array>

#include "frontend/stl/operand_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

struct SystemRow {
  std::string_view name;
  std::string_view address;
};
constexpr std::array<SystemRow, 78> rows = {{
    {"Always_On", "SM0.0"},      {"First_Scan_On", "SM0.1"},
    {"Retentive_Lost", "SM0.2"}, {"RUN_Power_Up", "SM0.3"},
    {"Clock_60s", "SM0.4"},      {"Clock_1s", "SM0.5"},
    {"Clock_Scan", "SM0.6"},     {"RTC_Lost", "SM0.7"},
    {"Result_0", "SM1.0"},       {"Overflow_Illegal", "SM1.1"},
    {"Table_Overflow", "SM1.4"}, {"Table_Empty", "SM1.5"},
    {"Not_Hex", "SM1.7"},        {"Receive_Char", "SMB2"},
    {"Parity_Err", "SM3.0"},     {"Comm_Int_Ovr", "SM4.0"},
    {"Input_Int_Ovr", "SM4.1"},  {"Timed_Int_Ovr", "SM4.2"},
    {"RUN_Err", "SM4.3"},        {"Int_Enable", "SM4.4"},
    {"Xmit0_Idle", "SM4.5"},     {"Xmit1_Idle", "SM4.6"},
    {"Force_On", "SM4.7"},       {"IO_Err", "SM5.0"},
    {"CPU_ID", "SMB6"},          {"CPU_IO", "SMB7"},
    {"P0_Config", "SMB30"},      {"Time_0_Intrvl", "SMB34"},
    {"HSC0_Ctrl", "SMB37"},      {"HSC0_CV", "SMD38"},
    {"HSC0_PV", "SMD42"},        {"HSC1_Ctrl", "SMB47"},
    {"HSC1_CV", "SMD48"},        {"HSC1_PV", "SMD52"},
    {"HSC2_Ctrl", "SMB57"},      {"HSC2_CV", "SMD58"},
    {"HSC2_PV", "SMD62"},        {"HSC3_Ctrl", "SMB137"},
    {"HSC3_CV", "SMD138"},       {"HSC3_PV", "SMD142"},
    {"HSC4_Ctrl", "SMB147"},     {"HSC4_CV", "SMD148"},
    {"HSC4_PV", "SMD152"},       {"HSC5_Ctrl", "SMB157"},
    {"HSC5_CV", "SMD158"},       {"HSC5_PV", "SMD162"},
    {"PLS0_Ctrl", "SMB67"},      {"PLS0_Cycle", "SMW68"},
    {"PWM0_PW", "SMW70"},        {"PTO0_PC", "SMD72"},
    {"PLS1_Ctrl", "SMB77"},      {"PLS1_Cycle", "SMW78"},
    {"PWM1_PW", "SMW80"},        {"PTO1_PC", "SMD82"},
    {"PLS2_Ctrl", "SMB567"},     {"PLS2_Cycle", "SMW568"},
    {"PWM2_PW", "SMW570"},       {"PTO2_PC", "SMD572"},
    {"PLS3_Ctrl", "SMB581"},     {"PLS3_Cycle", "SMW582"},
    {"PWM3_PW", "SMW584"},       {"PTO3_PC", "SMD586"},
    {"P0_Stat_Rcv", "SMB86"},    {"P0_Ctrl_Rcv", "SMB87"},
    {"P0_Start_Char", "SMB88"},  {"P0_End_Char", "SMB89"},
    {"P0_Idle_Time", "SMW90"},   {"P0_Timeout", "SMW92"},
    {"P0_Max_Char", "SMB94"},    {"P1_Stat_Rcv", "SMB186"},
    {"P1_Ctrl_Rcv", "SMB187"},   {"P1_Start_Char", "SMB188"},
    {"P1_End_Char", "SMB189"},   {"P1_Idle_Time", "SMW190"},
    {"P1_Timeout", "SMW192"},    {"P1_Max_Char", "SMB194"},
    {"P1_Config", "SMB130"},     {"Time_1_Intrvl", "SMB35"},
}};

struct PointName {
  std::string_view prefix;
  Area area;
};
constexpr std::array<PointName, 4> points = {{{"CPU_\xE8\xBE\x93\xE5\x85\xA5", Area::I},
                                              {"CPU_\xE8\xBE\x93\xE5\x87\xBA", Area::Q},
                                              {"CPU_Input", Area::I},
                                              {"CPU_Output", Area::Q}}};

}  // namespace

std::optional<Operand> systemSymbol(std::string_view name) {
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const SystemRow& entry) { return equalsIgnoringCase(entry.name, name); });
  Operand operand;
  if (row != rows.end() && readAddress(row->address, Spelling::International, operand)) return operand;
  for (const PointName& point : points) {
    if (name.size() <= point.prefix.size() || name.size() > point.prefix.size() + 3 ||
        !equalsIgnoringCase(name.substr(0, point.prefix.size()), point.prefix))
      continue;
    const std::string_view digits = name.substr(point.prefix.size());
    if (!std::all_of(digits.begin(), digits.end(), isDigit)) continue;
    std::uint32_t number = 0;
    for (const char c : digits) number = number * 10 + static_cast<std::uint32_t>(c - '0');
    return direct(point.area, Width::Bit, number / 8, number % 8);
  }
  return std::nullopt;
}

}  // namespace rungproof
