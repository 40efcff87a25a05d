// Table of system names; addresses by comparison of exports with and without names, meanings in Appendix D (001:14027).
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
constexpr std::array<SystemRow, 22> rows = {{
    {"Always_On", "SM0.0"},     {"First_Scan_On", "SM0.1"}, {"Clock_1s", "SM0.5"},     {"P0_Config", "SMB30"},
    {"Time_0_Intrvl", "SMB34"}, {"HSC0_Ctrl", "SMB37"},     {"HSC0_CV", "SMD38"},      {"HSC0_PV", "SMD42"},
    {"PLS0_Ctrl", "SMB67"},     {"PLS0_Cycle", "SMW68"},    {"PTO0_PC", "SMD72"},      {"PLS1_Ctrl", "SMB77"},
    {"PLS1_Cycle", "SMW78"},    {"PWM1_PW", "SMW80"},       {"P0_Stat_Rcv", "SMB86"},  {"P0_Ctrl_Rcv", "SMB87"},
    {"P0_Start_Char", "SMB88"}, {"P0_End_Char", "SMB89"},   {"P0_Idle_Time", "SMW90"}, {"P0_Timeout", "SMW92"},
    {"P0_Max_Char", "SMB94"},   {"Time_1_Intrvl", "SMB35"},
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
