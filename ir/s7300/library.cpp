// One row for each block.
#include "ir/s7300/library.hpp"

#include <algorithm>
#include <array>

#include "ir/check.hpp"

namespace rungproof::s7300 {

namespace {

using enum BlockType;

// clang-format off
constexpr auto libraryRows = std::to_array<LibraryBlock>({
    {Sfb, 0, "CTU", "CU:BOOL R:BOOL PV:INT|Q:BOOL CV:INT||CUO:BOOL"},
    {Sfb, 1, "CTD", "CD:BOOL LOAD:BOOL PV:INT|Q:BOOL CV:INT||CDO:BOOL"},
    {Sfb, 2, "CTUD", "CU:BOOL CD:BOOL R:BOOL LOAD:BOOL PV:INT|QU:BOOL QD:BOOL CV:INT||CUO:BOOL CDO:BOOL"},
    {Sfb, 3, "TP", "IN:BOOL PT:TIME|Q:BOOL ET:TIME||STATE:BYTE STIME:TIME ATIME:TIME"},
    {Sfb, 4, "TON", "IN:BOOL PT:TIME|Q:BOOL ET:TIME||STATE:BYTE STIME:TIME ATIME:TIME"},
    {Sfb, 5, "TOF", "IN:BOOL PT:TIME|Q:BOOL ET:TIME||STATE:BYTE STIME:TIME ATIME:TIME"},
    {Sfc, 0, "SET_CLK", "PDT:DT|RET_VAL:INT"},
    {Sfc, 1, "READ_CLK", "|RET_VAL:INT CDT:DT"},
    {Sfc, 15, "DPWR_DAT", "LADDR:WORD RECORD:ANY|RET_VAL:INT"},
    {Sfc, 20, "BLKMOV", "SRCBLK:ANY|RET_VAL:INT DSTBLK:ANY"},
    {Sfc, 21, "FILL", "BVAL:ANY|RET_VAL:INT BLK:ANY"},
    {Sfc, 26, "UPDAT_PI", "PART:BYTE|RET_VAL:INT FLADDR:WORD"},
    {Sfc, 27, "UPDAT_PO", "PART:BYTE|RET_VAL:INT FLADDR:WORD"},
    {Sfc, 28, "SET_TINT", "OB_NR:INT SDT:DT PERIOD:WORD|RET_VAL:INT"},
    {Sfc, 29, "CAN_TINT", "OB_NR:INT|RET_VAL:INT"},
    {Sfc, 30, "ACT_TINT", "OB_NR:INT|RET_VAL:INT"},
    {Sfc, 31, "QRY_TINT", "OB_NR:INT|RET_VAL:INT STATUS:WORD"},
    {Sfc, 32, "SRT_DINT", "OB_NR:INT DTIME:TIME SIGN:WORD|RET_VAL:INT"},
    {Sfc, 33, "CAN_DINT", "OB_NR:INT|RET_VAL:INT"},
    {Sfc, 34, "QRY_DINT", "OB_NR:INT|RET_VAL:INT STATUS:WORD"},
    {Sfc, 36, "MSK_FLT", "PRGFLT_SET_MASK:DWORD ACCFLT_SET_MASK:DWORD|RET_VAL:INT PRGFLT_MASKED:DWORD ACCFLT_MASKED:DWORD"},
    {Sfc, 37, "DMSK_FLT", "PRGFLT_RESET_MASK:DWORD ACCFLT_RESET_MASK:DWORD|RET_VAL:INT PRGFLT_MASKED:DWORD ACCFLT_MASKED:DWORD"},
    {Sfc, 38, "READ_ERR", "PRGFLT_QUERY:DWORD ACCFLT_QUERY:DWORD|RET_VAL:INT PRGFLT_CLR:DWORD ACCFLT_CLR:DWORD"},
    {Sfc, 39, "DIS_IRT", "MODE:BYTE OB_NR:INT|RET_VAL:INT"},
    {Sfc, 40, "EN_IRT", "MODE:BYTE OB_NR:INT|RET_VAL:INT"},
    {Sfc, 41, "DIS_AIRT", "|RET_VAL:INT"},
    {Sfc, 42, "EN_AIRT", "|RET_VAL:INT"},
    {Sfc, 43, "RE_TRIGR", ""},
    {Sfc, 44, "REPL_VAL", "VAL:DWORD|RET_VAL:INT"},
    {Sfc, 46, "STP", ""},
    {Sfc, 47, "WAIT", "WT:INT"},
    {Sfc, 64, "TIME_TCK", "|RET_VAL:TIME"},
    {Sfc, 79, "SET", "N:INT SA:POINTER|RET_VAL:INT"},
    {Sfc, 80, "RSET", "N:INT SA:POINTER|RET_VAL:INT"},
    {Fc, 1, "AD_DT_TM", "T:DT D:TIME|RET_VAL:DT"},
    {Fc, 2, "CONCAT", "IN1:STRING IN2:STRING|RET_VAL:STRING"},
    {Fc, 3, "D_TOD_DT", "IN1:DATE IN2:TOD|RET_VAL:DT"},
    {Fc, 4, "DELETE", "IN:STRING L:INT P:INT|RET_VAL:STRING"},
    {Fc, 5, "DI_STRNG", "I:DINT|RET_VAL:STRING"},
    {Fc, 6, "DT_DATE", "IN:DT|RET_VAL:DATE"},
    {Fc, 7, "DT_DAY", "IN:DT|RET_VAL:INT"},
    {Fc, 8, "DT_TOD", "IN:DT|RET_VAL:TOD"},
    {Fc, 9, "EQ_DT", "DT1:DT DT2:DT|RET_VAL:BOOL"},
    {Fc, 10, "EQ_STRNG", "S1:STRING S2:STRING|RET_VAL:BOOL"},
    {Fc, 11, "FIND", "IN1:STRING IN2:STRING|RET_VAL:INT"},
    {Fc, 12, "GE_DT", "DT1:DT DT2:DT|RET_VAL:BOOL"},
    {Fc, 13, "GE_STRNG", "S1:STRING S2:STRING|RET_VAL:BOOL"},
    {Fc, 14, "GT_DT", "DT1:DT DT2:DT|RET_VAL:BOOL"},
    {Fc, 15, "GT_STRNG", "S1:STRING S2:STRING|RET_VAL:BOOL"},
    {Fc, 16, "I_STRNG", "I:INT|RET_VAL:STRING"},
    {Fc, 17, "INSERT", "IN1:STRING IN2:STRING P:INT|RET_VAL:STRING"},
    {Fc, 18, "LE_DT", "DT1:DT DT2:DT|RET_VAL:BOOL"},
    {Fc, 19, "LE_STRNG", "S1:STRING S2:STRING|RET_VAL:BOOL"},
    {Fc, 20, "LEFT", "IN:STRING L:INT|RET_VAL:STRING"},
    {Fc, 21, "LEN", "S:STRING|RET_VAL:INT"},
    {Fc, 22, "LIMIT", "MN:ANY IN:ANY MX:ANY|RET_VAL:ANY"},
    {Fc, 23, "LT_DT", "DT1:DT DT2:DT|RET_VAL:BOOL"},
    {Fc, 24, "LT_STRNG", "S1:STRING S2:STRING|RET_VAL:BOOL"},
    {Fc, 25, "MAX", "IN1:ANY IN2:ANY IN3:ANY|RET_VAL:ANY"},
    {Fc, 26, "MID", "IN:STRING L:INT P:INT|RET_VAL:STRING"},
    {Fc, 27, "MIN", "IN1:ANY IN2:ANY IN3:ANY|RET_VAL:ANY"},
    {Fc, 28, "NE_DT", "DT1:DT DT2:DT|RET_VAL:BOOL"},
    {Fc, 29, "NE_STRNG", "S1:STRING S2:STRING|RET_VAL:BOOL"},
    {Fc, 30, "R_STRNG", "IN:REAL|RET_VAL:STRING"},
    {Fc, 31, "REPLACE", "IN1:STRING IN2:STRING L:INT P:INT|RET_VAL:STRING"},
    {Fc, 32, "RIGHT", "IN:STRING L:INT|RET_VAL:STRING"},
    {Fc, 33, "S5TI_TIM", "IN:S5TIME|RET_VAL:TIME"},
    {Fc, 34, "SB_DT_DT", "DT1:DT DT2:DT|RET_VAL:TIME"},
    {Fc, 35, "SB_DT_TM", "T:DT D:TIME|RET_VAL:DT"},
    {Fc, 36, "SEL", "G:BOOL IN0:ANY IN1:ANY|RET_VAL:ANY"},
    {Fc, 37, "STRNG_DI", "S:STRING|RET_VAL:DINT"},
    {Fc, 38, "STRNG_I", "S:STRING|RET_VAL:INT"},
    {Fc, 39, "STRNG_R", "S:STRING|RET_VAL:REAL"},
    {Fc, 40, "TIM_S5TI", "IN:TIME|RET_VAL:S5TIME"},
    {Fc, 105, "SCALE", "IN:INT HI_LIM:REAL LO_LIM:REAL BIPOLAR:BOOL|RET_VAL:WORD OUT:REAL"},
    {Fc, 106, "UNSCALE", "IN:REAL HI_LIM:REAL LO_LIM:REAL BIPOLAR:BOOL|RET_VAL:WORD OUT:INT"},
});
// clang-format on

}  // namespace

std::span<const LibraryBlock> libraryBlocks() { return libraryRows; }

const LibraryBlock* libraryBlock(BlockType type, std::uint32_t number) {
  const auto row =
      std::ranges::find_if(libraryRows, [&](const LibraryBlock& r) { return r.type == type && r.number == number; });
  return row == libraryRows.end() ? nullptr : &*row;
}

const LibraryBlock* libraryBlockNamed(std::string_view name) {
  const auto row = std::ranges::find_if(libraryRows, [&](const LibraryBlock& r) { return isSameName(r.name, name); });
  return row == libraryRows.end() ? nullptr : &*row;
}

std::span<const std::uint16_t> functionsBeyondParameters() {
  // CREAT_DB, DEL_DB, GD_RCV, CREA_DBL, READ_DBL, WRIT_DBL, CREA_DB, SYNC_PI, SYNC_PO (002:2342-2358, general
  // knowledge)
  static constexpr auto numbers = std::to_array<std::uint16_t>({22, 23, 61, 82, 83, 84, 85, 126, 127});
  return numbers;
}

std::span<const std::uint16_t> blocksBeyondParameters() {
  // HS_COUNT, FREQ_MES, HSC_A_B, POS, ANALOG, DIGITAL (002:2367, general knowledge)
  static constexpr auto numbers = std::to_array<std::uint16_t>({29, 30, 38, 39, 44, 46});
  return numbers;
}

bool isBuiltIn(const LibraryBlock& block) {
  constexpr int lastOfIec = 40;
  constexpr std::array<int, 5> functions = {0, 1, 20, 21, 64};  // SET_CLK, READ_CLK, BLKMOV, FILL, TIME_TCK
  if (block.type == Fc) return block.number <= lastOfIec;
  return block.type == Sfc && std::ranges::find(functions, block.number) != functions.end();
}

bool actsOnCpu(const LibraryBlock& block) {
  // SRT_DINT, CAN_DINT, MSK_FLT, DMSK_FLT, DIS_IRT, EN_IRT, DIS_AIRT, EN_AIRT, RE_TRIGR, REPL_VAL
  constexpr std::array<int, 10> functions = {32, 33, 36, 37, 39, 40, 41, 42, 43, 44};
  return block.type == Sfc && std::ranges::find(functions, block.number) != functions.end();
}

std::shared_ptr<const Structure> interfaceOf(const LibraryBlock& block) {
  auto structure = std::make_shared<Structure>();
  auto section = static_cast<int>(Section::Input);
  for (std::string_view rest = block.parameters; !rest.empty();) {
    if (rest[0] == '|' || rest[0] == ' ') {
      section += rest[0] == '|' ? 1 : 0;
      rest.remove_prefix(1);
      continue;
    }
    const std::string_view parameter = rest.substr(0, rest.find_first_of(" |"));
    rest.remove_prefix(parameter.size());
    const std::size_t colon = parameter.find(':');
    const std::optional<Type> type = typeNamed(parameter.substr(colon + 1));
    CHECK(type.has_value(), "the rows name types that exist");
    Field field;
    field.name = parameter.substr(0, colon);
    field.type = *type;
    field.section = static_cast<Section>(section);
    structure->fields.push_back(std::move(field));
  }
  if (block.type == Sfb) layOutInstance(*structure);  // parameters of functions stand where the call says
  return structure;
}

}  // namespace rungproof::s7300
