// The words.
#include "frontend/step7/source_keyword.hpp"

#include <algorithm>
#include <array>

#include "frontend/step7/cursor.hpp"

namespace rungproof::step7 {

namespace {

struct SourceKeywordRow {
  std::string_view text;
  SourceKeyword keyword;
};
constexpr std::array<SourceKeywordRow, 20> sourceKeywords = {{
    {"ORGANIZATION_BLOCK", SourceKeyword::OrganizationBlock},
    {"FUNCTION", SourceKeyword::Function},
    {"FUNCTION_BLOCK", SourceKeyword::FunctionBlock},
    {"DATA_BLOCK", SourceKeyword::DataBlock},
    {"TYPE", SourceKeyword::Type},
    {"END_ORGANIZATION_BLOCK", SourceKeyword::EndOrganizationBlock},
    {"END_FUNCTION", SourceKeyword::EndFunction},
    {"END_FUNCTION_BLOCK", SourceKeyword::EndFunctionBlock},
    {"END_DATA_BLOCK", SourceKeyword::EndDataBlock},
    {"END_TYPE", SourceKeyword::EndType},
    {"VAR_INPUT", SourceKeyword::VarInput},
    {"VAR_OUTPUT", SourceKeyword::VarOutput},
    {"VAR_IN_OUT", SourceKeyword::VarInOut},
    {"VAR", SourceKeyword::Var},
    {"VAR_TEMP", SourceKeyword::VarTemp},
    {"END_VAR", SourceKeyword::EndVar},
    {"BEGIN", SourceKeyword::Begin},
    {"NETWORK", SourceKeyword::Network},
    {"NETZWERK", SourceKeyword::Network},
    {"END_STRUCT", SourceKeyword::EndStruct},
}};

}  // namespace

SourceKeyword sourceKeywordOf(std::string_view word) {
  if (word.size() < 3) return SourceKeyword::None;
  const auto row =
      std::ranges::find_if(sourceKeywords, [&](const SourceKeywordRow& r) { return equalsWord(word, r.text); });
  return row == sourceKeywords.end() ? SourceKeyword::None : row->keyword;
}

std::string_view keywordText(SourceKeyword keyword) {
  const auto row = std::ranges::find(sourceKeywords, keyword, &SourceKeywordRow::keyword);
  return row == sourceKeywords.end() ? std::string_view() : row->text;
}

}  // namespace rungproof::step7
