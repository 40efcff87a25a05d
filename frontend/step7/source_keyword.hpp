// Words that frame blocks and their parts in STEP 7 sources. They end whatever stands open before them.
// Tested by tests/step7/parser_test.cpp.
#pragma once

#include <cstdint>
#include <string_view>

namespace rungproof::step7 {

enum class SourceKeyword : std::uint8_t {
  None,
  OrganizationBlock,
  Function,
  FunctionBlock,
  DataBlock,
  Type,
  EndOrganizationBlock,
  EndFunction,
  EndFunctionBlock,
  EndDataBlock,
  EndType,
  VarInput,
  VarOutput,
  VarInOut,
  Var,
  VarTemp,
  EndVar,
  Begin,
  Network,
  EndStruct
};

SourceKeyword sourceKeywordOf(std::string_view word);
inline bool isSourceKeyword(std::string_view word) { return sourceKeywordOf(word) != SourceKeyword::None; }
/// ORGANIZATION_BLOCK to TYPE.
constexpr bool opensBlock(SourceKeyword keyword) {
  return keyword >= SourceKeyword::OrganizationBlock && keyword <= SourceKeyword::Type;
}
constexpr bool endsBlock(SourceKeyword keyword) {
  return keyword >= SourceKeyword::EndOrganizationBlock && keyword <= SourceKeyword::EndType;
}
constexpr bool opensSection(SourceKeyword keyword) {
  return keyword >= SourceKeyword::VarInput && keyword <= SourceKeyword::VarTemp;
}
/// The end that belongs to a heading.
constexpr SourceKeyword endOf(SourceKeyword heading) {
  return static_cast<SourceKeyword>(static_cast<int>(heading) + static_cast<int>(SourceKeyword::EndOrganizationBlock) -
                                    static_cast<int>(SourceKeyword::OrganizationBlock));
}
/// "END_FUNCTION"; of Network its international word.
std::string_view keywordText(SourceKeyword keyword);

}  // namespace rungproof::step7
