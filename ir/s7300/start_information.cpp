// One row for each field of a kind of block.
#include "ir/s7300/start_information.hpp"

#include <array>
#include <charconv>

#include "ir/s7300/declaration.hpp"

namespace rungproof::s7300 {

namespace {

struct FieldRow {
  int first, last;  ///< blocks that have it
  std::string_view name;
  std::uint8_t byte;
  Width width;
  std::uint8_t bit = 0;
};

using enum Width;

constexpr auto fieldRows = std::to_array<FieldRow>({
    {1, 122, "EV_CLASS", 0, Byte},      {1, 1, "SCAN_1", 1, Byte},         {1, 122, "PRIORITY", 2, Byte},
    {1, 122, "OB_NUMBR", 3, Byte},      {1, 1, "PREV_CYCLE", 6, Word},     {1, 1, "MIN_CYCLE", 8, Word},
    {1, 1, "MAX_CYCLE", 10, Word},      {10, 17, "STRT_INFO", 1, Byte},    {10, 17, "PERIOD_EXE", 6, Word},
    {20, 47, "STRT_INF", 1, Byte},      {20, 23, "SIGN", 6, Word},         {20, 23, "DTIME", 8, DWord},
    {30, 38, "PHASE_OFFSET", 6, Word},  {30, 38, "EXC_FREQ", 10, Word},    {40, 47, "IO_FLAG", 5, Byte},
    {40, 47, "MDL_ADDR", 6, Word},      {40, 47, "POINT_ADDR", 8, DWord},  {80, 87, "FLT_ID", 1, Byte},
    {80, 80, "ERROR_INFO", 6, Word},    {80, 80, "ERR_EV_CLASS", 8, Byte}, {80, 80, "ERR_EV_NUM", 9, Byte},
    {80, 80, "OB_PRIORITY", 10, Byte},  {80, 80, "OB_NUM", 11, Byte},      {82, 82, "IO_FLAG", 5, Byte},
    {82, 82, "MDL_ADDR", 6, Word},      {82, 82, "MDL_DEFECT", 8, Bit, 0}, {82, 82, "INT_FAULT", 8, Bit, 1},
    {82, 82, "EXT_FAULT", 8, Bit, 2},   {82, 82, "PNT_INFO", 8, Bit, 3},   {82, 82, "EXT_VOLTAGE", 8, Bit, 4},
    {82, 82, "FLD_CONNCTR", 8, Bit, 5}, {82, 82, "NO_CONFIG", 8, Bit, 6},  {82, 82, "CONFIG_ERR", 8, Bit, 7},
    {83, 83, "MDL_ID", 5, Byte},        {83, 83, "MDL_ADDR", 6, Word},     {83, 83, "RACK_NUM", 8, Word},
    {83, 83, "MDL_TYPE", 10, Word},     {85, 85, "ERR_EV_CLASS", 8, Byte}, {85, 85, "ERR_EV_NUM", 9, Byte},
    {85, 85, "OB_PRIOR", 10, Byte},     {85, 85, "OB_NUM", 11, Byte},      {86, 86, "MDL_ADDR", 6, Word},
    {86, 86, "RACKS_FLTD", 8, DWord},   {100, 102, "STRTUP", 1, Byte},     {100, 102, "STOP", 6, Word},
    {100, 102, "STRT_INFO", 8, DWord},  {121, 122, "SW_FLT", 1, Byte},     {121, 122, "BLK_TYPE", 4, Byte},
    {121, 121, "FLT_REG", 6, Word},     {122, 122, "MEM_AREA", 5, Byte},   {122, 122, "MEM_ADDR", 6, Word},
    {121, 122, "BLK_NUM", 8, Word},     {121, 122, "PRG_ADDR", 10, Word},
});

}  // namespace

std::optional<StartField> startFieldNamed(std::string_view name) {
  const std::string folded = foldedName(name);
  const std::size_t end = folded.find('_');
  if (!folded.starts_with(foldedName("OB")) || end == std::string::npos) return std::nullopt;
  int block = 0;
  const auto [stop, error] = std::from_chars(folded.data() + 2, folded.data() + end, block);
  if (error != std::errc() || stop != folded.data() + end) return std::nullopt;
  for (const FieldRow& row : fieldRows) {
    if (row.first <= block && block <= row.last && foldedName(row.name) == folded.substr(end + 1))
      return StartField{block, row.byte, row.bit, row.width};
  }
  return std::nullopt;
}

}  // namespace rungproof::s7300
