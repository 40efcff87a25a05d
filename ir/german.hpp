// SIMATIC German mnemonics of the S7-200: only those that differ from the international ones. UND forms begin with
// U instead of A; comparisons follow the same pattern. The manuals of this project are written with the international
// set, so this table is the one statement of the German spelling. Tested by tests/reader/german_test.cpp.
#pragma once

#include <array>
#include <string_view>

namespace rungproof {

struct GermanMnemonic {
  std::string_view international;
  std::string_view german;
};

inline constexpr std::array<GermanMnemonic, 44> germanMnemonics = {{
    {"A", "U"},         {"AN", "UN"},       {"AI", "UI"},       {"ANI", "UNI"},     {"ALD", "ULD"},     {"AENO", "UENO"},
    {"AB=", "UB="},     {"AB<>", "UB<>"},   {"AB<", "UB<"},     {"AB<=", "UB<="},   {"AB>", "UB>"},     {"AB>=", "UB>="},
    {"AW=", "UW="},     {"AW<>", "UW<>"},   {"AW<", "UW<"},     {"AW<=", "UW<="},   {"AW>", "UW>"},     {"AW>=", "UW>="},
    {"AD=", "UD="},     {"AD<>", "UD<>"},   {"AD<", "UD<"},     {"AD<=", "UD<="},   {"AD>", "UD>"},     {"AD>=", "UD>="},
    {"AR=", "UR="},     {"AR<>", "UR<>"},   {"AR<", "UR<"},     {"AR<=", "UR<="},   {"AR>", "UR>"},     {"AR>=", "UR>="},
    {"AS=", "US="},     {"AS<>", "US<>"},   {"ANDB", "UNDB"},   {"ANDW", "UNDW"},   {"ANDD", "UNDD"},   {"ORB", "ODERB"},
    {"ORW", "ODERW"},   {"ORD", "ODERD"},   {"XORB", "XODERB"}, {"XORW", "XODERW"}, {"XORD", "XODERD"}, {"CTU", "ZV"},
    {"CTD", "ZR"},      {"CTUD", "ZVR"},
}};

}  // namespace rungproof
