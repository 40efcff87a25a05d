// Look-ups in the instruction table.
#include "ir/isa.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "ir/isa_list.hpp"

namespace rungproof {

namespace {

/// Mnemonics sorted for binary search, each with the index of its descriptor.
using Index = std::vector<std::pair<std::string_view, const Desc*>>;

Index makeIndex(std::string_view Desc::*name) {
  Index index;
  for (const Desc& desc : isa::instructionTable) {
    if (!(desc.*name).empty()) index.emplace_back(desc.*name, &desc);
  }
  std::sort(index.begin(), index.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return index;
}

const Desc* lookUp(const Index& index, std::string_view name) {
  const auto found = std::lower_bound(index.begin(), index.end(), name,
                                      [](const auto& entry, std::string_view key) { return entry.first < key; });
  return found != index.end() && found->first == name ? found->second : nullptr;
}

/// Ladder box names and misprints that stand in the manual's own STL examples (001:1523, 3098, 6118, 6201, 6235), and
/// spellings that sources on the S7-200 SMART give beside the usual ones.
constexpr std::pair<std::string_view, std::string_view> aliases[] = {
    {"CHR_FIND", "CFND"}, {"FILL_N", "FILL"}, {"MOV_B", "MOVB"},   {"MOV_D", "MOVD"},  {"MOV_DW", "MOVD"},
    {"MOV_R", "MOVR"},    {"MOV_W", "MOVW"},  {"STRCPY", "SCPY"},  {"STRLEN", "SLEN"}, {"STR_FIND", "SFND"},
    {"S_R", "STR"},       {"ABSD", "ABSDI"},  {"CEVENT", "CEVNT"},
};

}  // namespace

std::span<const Desc> instructionTable() { return isa::instructionTable; }

const Desc* instructionNamed(std::string_view mnemonic) {
  static const Index index = makeIndex(&Desc::stl);
  return lookUp(index, mnemonic);
}

const Desc* instructionNamedGerman(std::string_view mnemonic) {
  static const Index index = makeIndex(&Desc::german);
  const Desc* desc = lookUp(index, mnemonic);
  return desc != nullptr ? desc : instructionNamed(mnemonic);
}

const Desc* instructionAlias(std::string_view mnemonic) {
  for (const auto& [alias, name] : aliases) {
    if (alias == mnemonic) return instructionNamed(name);
  }
  return nullptr;
}

}  // namespace rungproof
