// Parts of stored blocks.
#include "frontend/mc7/stored_block.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof::mc7 {

namespace {

using step7::BlockKind;

std::uint16_t littleWord(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint16_t>(static_cast<std::uint8_t>(bytes[at]) | static_cast<std::uint8_t>(bytes[at + 1])
                                                                               << 8);
}

struct BlockTypeRow {
  unsigned type;
  BlockKind kind;
};
constexpr std::array<BlockTypeRow, 9> blockTypeRows = {{{0, BlockKind::Udt},
                                                        {8, BlockKind::Ob},
                                                        {10, BlockKind::Db},
                                                        {11, BlockKind::Sdb},
                                                        {12, BlockKind::Fc},
                                                        {13, BlockKind::Sfc},
                                                        {14, BlockKind::Fb},
                                                        {15, BlockKind::Sfb},
                                                        {27, BlockKind::Vat}}};

std::string untilNul(std::string_view text) { return std::string(text.substr(0, text.find('\0'))); }

}  // namespace

TimeStamp timeStampOf(std::string_view sixBytes) {
  if (sixBytes.size() < 6) return 0;
  const auto byte = [&](std::size_t i) { return std::uint64_t{static_cast<std::uint8_t>(sixBytes[i])}; };
  const std::uint64_t ofDay = byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
  return (byte(4) << 8 | byte(5)) * 86'400'000 + ofDay;
}

std::string_view languageName(std::uint8_t code) {
  constexpr std::array<std::string_view, 7> names = {"", "STL", "LAD", "FBD", "SCL", "DB", "GRAPH"};
  return code < names.size() ? names[code] : "";
}

NetworkTable readNetworkTable(std::string_view table) {
  NetworkTable result;
  if (table.empty()) return result;
  std::size_t at = 0;
  const auto list = [&](std::vector<std::uint32_t>& into, std::uint32_t unit, std::string_view what) {
    if (table.size() < at + 2) return;
    const std::size_t count = littleWord(table, at);
    at += 2;
    if (table.size() < at + 2 * count) {
      result.fault = fmt::format("the table of networks ends before its {} {}", count, what);
      at = table.size();
      return;
    }
    for (std::size_t i = 0; i < count; ++i) into.push_back(littleWord(table, at + 2 * i) * unit);
    at += 2 * count;
  };
  list(result.lengths, 1, "networks");
  if (result.fault.empty()) list(result.jumpPositions, 2, "jumps");
  return result;
}

StoredBlock::NetworkText readTitleRecord(std::string_view record, char mark) {
  StoredBlock::NetworkText text;
  // A record of a network has length and a second mark; that of a block has the title right behind the offset.
  const std::size_t titleAt = mark == 6 ? 6 : 3;
  if (record.size() < titleAt || record[0] != mark) return text;
  const std::size_t commentAt = littleWord(record, 1);
  text.title = untilNul(record.substr(titleAt));
  if (commentAt > titleAt && commentAt < record.size()) text.comment = untilNul(record.substr(commentAt));
  return text;
}

std::vector<StoredBlock::LineText> readLineRecords(std::string_view section) {
  constexpr std::size_t titleLengthAt = 3, headBytes = 6;
  constexpr unsigned ofStatement = 0x80, apart = 0x40;
  std::vector<StoredBlock::LineText> lines;
  if (section.size() < headBytes) return lines;
  std::uint32_t line = 0;
  for (std::size_t at = littleWord(section, titleLengthAt); at + headBytes <= section.size();) {
    const std::size_t length = static_cast<std::uint8_t>(section[at]);
    if (at + headBytes + length > section.size()) break;
    line += littleWord(section, at + 2);
    const unsigned flags = static_cast<std::uint8_t>(section[at + 4]);
    const bool isOfStatement = (flags & ofStatement) != 0;
    std::string text = untilNul(section.substr(at + headBytes, length));
    if (!text.empty() || isOfStatement)
      lines.push_back({line, isOfStatement, isOfStatement && (flags & apart) != 0, std::move(text)});
    at += headBytes + length;
  }
  return lines;
}

std::uint16_t checksumOf(BlockKind kind, std::string_view code) {
  constexpr unsigned polynomial = 0x9003;
  unsigned sum = 0;
  const auto add = [&sum](std::uint8_t byte) {
    sum ^= static_cast<unsigned>(byte) << 8;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 0x8000U) != 0 ? (sum << 1 ^ polynomial) & 0xFFFFU : sum << 1;
  };
  add(static_cast<std::uint8_t>(typeOfKind(kind)));
  add(static_cast<std::uint8_t>(code.size() >> 8));
  add(static_cast<std::uint8_t>(code.size()));
  for (const char c : code) add(static_cast<std::uint8_t>(c));
  return static_cast<std::uint16_t>(sum);
}

std::optional<BlockKind> kindOfType(unsigned type) {
  const auto row = std::ranges::find(blockTypeRows, type, &BlockTypeRow::type);
  return row == blockTypeRows.end() ? std::nullopt : std::optional(row->kind);
}

unsigned typeOfKind(BlockKind kind) {
  const auto row = std::ranges::find(blockTypeRows, kind, &BlockTypeRow::kind);
  return row == blockTypeRows.end() ? 0xFF : row->type;
}

}  // namespace rungproof::mc7
