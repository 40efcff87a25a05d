// By mnemonic.
#include "ir/instruction_slip.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace rungproof {

namespace {

using Slip = std::pair<std::string_view, std::string_view>;

/// IEC 61131-3 and S7-300/400.
constexpr auto namedSlips = std::to_array<Slip>(
    {{"AND", "OR"},  {"OR", "AND"},  {"EQ", "NE"},   {"NE", "EQ"},  {"LT", "LE"},  {"LE", "LT"},   {"GT", "GE"},
     {"GE", "GT"},   {"ADD", "SUB"}, {"SUB", "ADD"}, {"A", "AN"},   {"AN", "A"},   {"O", "ON"},    {"ON", "O"},
     {"X", "O"},     {"S", "R"},     {"R", "S"},     {"FP", "FN"},  {"FN", "FP"},  {"==I", "<>I"}, {"<>I", "==I"},
     {">I", ">=I"},  {">=I", ">I"},  {"<I", "<=I"},  {"<=I", "<I"}, {"A(", "O("},  {"O(", "A("},   {"SD", "SE"},
     {"==D", "<>D"}, {">D", ">=D"},  {">=D", ">D"},  {"<D", "<=D"}, {"<=D", "<D"}, {"+I", "-I"},   {"-I", "+I"}});

/// S7-200: the sign behind the letters, as in LDW>=.
constexpr auto signSlips =
    std::to_array<Slip>({{">=", ">"}, {"<=", "<"}, {"<>", "="}, {">", ">="}, {"<", "<="}, {"=", "<>"}});

}  // namespace

std::vector<const Desc*> slipsOf(const Desc& desc, const Dialect& of) {
  std::vector<const Desc*> slips;
  const auto add = [&](std::string_view mnemonic) {
    if (const Desc* other = of.instructions().named(mnemonic)) slips.push_back(other);
  };
  if (of.form == StatementForm::Rungs) {
    if (desc.relation == Relation::None) return slips;
    const std::string name(desc.stl);
    const std::size_t sign = std::min(name.find_first_of("<>="), name.size());
    for (const auto& [from, to] : signSlips) {
      if (name.substr(sign) == from) add(name.substr(0, sign) + std::string(to));
    }
    return slips;
  }
  for (const auto& [from, to] : namedSlips) {
    if (desc.stl == from) add(to);
  }
  return slips;
}

}  // namespace rungproof
