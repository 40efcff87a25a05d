// The table of the S7-200's instructions, and their other names.
#include "ir/s7200/error_codes.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7200/isa/list.hpp"

namespace rungproof {

namespace {

/// Ladder box names and misprints that stand in the manual's own STL examples (001:1523, 3098, 6118, 6201, 6235), and
/// spellings that sources on the S7-200 SMART give beside the usual ones.
constexpr InstructionTable::Alias aliases[] = {
    {"CHR_FIND", "CFND"}, {"FILL_N", "FILL"}, {"MOV_B", "MOVB"},   {"MOV_D", "MOVD"},  {"MOV_DW", "MOVD"},
    {"MOV_R", "MOVR"},    {"MOV_W", "MOVW"},  {"STRCPY", "SCPY"},  {"STRLEN", "SLEN"}, {"STR_FIND", "SFND"},
    {"S_R", "STR"},       {"ABSD", "ABSDI"},  {"CEVENT", "CEVNT"},
};

}  // namespace

const InstructionTable& s7200Instructions() {
  static const InstructionTable table(isa::instructionTable, aliases);
  return table;
}

bool readsErrorStatus(const Desc& desc) { return desc.stl == isa::GetError::desc.stl; }

}  // namespace rungproof
