// Rows to blocks.
#include "frontend/s7project/block_container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "frontend/s7project/dbase.hpp"

namespace rungproof::s7project {

namespace {

using mc7::StoredBlock;
using step7::BlockKind;

/// What the rows of SUBBLK.DBF are to a block, by SUBBLKTYP.
enum class PartRole : std::uint8_t { Code, Declaration, Comments, Used, Other };
struct PartRow {
  std::int64_t type;
  PartRole role;
};
constexpr std::array<PartRow, 26> partRows = {{
    {8, PartRole::Code},        {12, PartRole::Code},       {14, PartRole::Code},       {13, PartRole::Code},
    {15, PartRole::Code},       {10, PartRole::Code},       {3, PartRole::Declaration}, {5, PartRole::Declaration},
    {4, PartRole::Declaration}, {7, PartRole::Declaration}, {9, PartRole::Declaration}, {6, PartRole::Declaration},
    {1, PartRole::Declaration}, {17, PartRole::Comments},   {19, PartRole::Comments},   {18, PartRole::Comments},
    {22, PartRole::Comments},   {21, PartRole::Comments},   {20, PartRole::Comments},   {39, PartRole::Comments},
    {67, PartRole::Used},       {65, PartRole::Used},       {64, PartRole::Used},       {70, PartRole::Used},
    {71, PartRole::Used},       {66, PartRole::Used},
}};

PartRole roleOf(std::int64_t type) {
  const auto row = std::ranges::find(partRows, type, &PartRow::type);
  return row == partRows.end() ? PartRole::Other : row->role;
}

std::uint16_t containerWord(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint16_t>(static_cast<std::uint8_t>(bytes[at]) | static_cast<std::uint8_t>(bytes[at + 1])
                                                                               << 8);
}

class ContainerReader {
 public:
  ContainerReader(const ProjectFiles& files, const std::string& folder,
                  const std::function<std::string(std::string_view)>& text)
      : files_(files), folder_(folder), text_(text) {}

  BlockContainer read() {
    const std::optional<DbaseTable> rows = table("BAUSTEIN");
    parts_ = table("SUBBLK");
    if (!rows) return std::move(result_);
    if (!parts_) {
      result_.losses.push_back(
          fmt::format("{}/SUBBLK.DBF: it is missing, so the blocks have no code: the old layout "
                      "of STEP 7 V1 and V2 is not read",
                      folder_));
      return std::move(result_);
    }
    for (std::size_t i = 0; i < parts_->rows(); ++i) {
      if (const auto id = parts_->number(i, "OBJECTID")) ofBlock_[*id].push_back(i);
    }
    for (std::size_t row = 0; row < rows->rows(); ++row) block(*rows, row);
    if (parts_->lacksMemos() && !result_.blocks.empty())
      result_.faults.push_back(
          fmt::format("{}/SUBBLK.DBT: it is missing, so {} blocks have no code, names and comments", folder_,
                      result_.blocks.size()));
    return std::move(result_);
  }

 private:
  std::optional<DbaseTable> table(std::string_view name) {
    const std::string path = fmt::format("{}/{}.DBF", folder_, name);
    std::optional<std::string> bytes = files_.bytes(path);
    if (!bytes) return std::nullopt;
    std::vector<std::string> found;
    DbaseTable table(std::move(*bytes), files_.bytes(fmt::format("{}/{}.DBT", folder_, name)), found);
    for (const std::string& fault : found)
      result_.losses.push_back(fmt::format("{}, {}", files_.spelling(path), fault));
    return table;
  }

  void block(const DbaseTable& rows, std::size_t row) {
    const std::optional<std::int64_t> id = rows.number(row, "ID"), type = rows.number(row, "TYP"),
                                      number = rows.number(row, "NUMMER");
    const std::string place =
        fmt::format("{}, record {}", files_.spelling(folder_ + "/BAUSTEIN.DBF"), rows.record(row));
    if (!id || !type || !number || *number < 0 || *number > 65535) {
      result_.losses.push_back(place + ": the block has no number or type");
      return;
    }
    constexpr std::int64_t variableTable = 27;
    if (*type == variableTable) {
      ++result_.variableTables;
      return;
    }
    const std::optional<BlockKind> kind = mc7::kindOfType(static_cast<unsigned>(*type));
    if (!kind) {
      result_.faults.push_back(fmt::format("{}: blocks of type {} are not known", place, *type));
      return;
    }
    StoredBlock block;
    block.key = {*kind, static_cast<std::uint32_t>(*number)};
    block.place = place;
    bool hasCode = false;
    for (const std::size_t part : ofBlock_[*id]) {
      switch (roleOf(parts_->number(part, "SUBBLKTYP").value_or(-1))) {
        case PartRole::Code:
          code(part, block);
          hasCode = true;
          break;
        case PartRole::Declaration: declaration(part, block); break;
        case PartRole::Comments: comments(part, block); break;
        case PartRole::Used: used(part, block); break;
        case PartRole::Other: break;
      }
    }
    if (!hasCode && (block.isCode() || block.key.kind == BlockKind::Db))
      block.damage = "no row of SUBBLK.DBF holds its code";
    block.isLostWithOthers = parts_->lacksMemos();
    result_.blocks.push_back(std::move(block));
  }

  /// The memo, cut to the length that the row gives. What is wrong with one goes to `fault`.
  std::string memo(std::size_t part, std::string_view field, std::string_view lengthField, std::string& fault) const {
    DbaseTable::Memo memo = parts_->memo(part, field);
    const std::optional<std::int64_t> length = parts_->number(part, lengthField);
    const auto place = [&] {
      return fmt::format("{}, record {}", files_.spelling(folder_ + "/SUBBLK.DBF"), parts_->record(part));
    };
    if (!memo.fault.empty() && fault.empty()) fault = fmt::format("{}: {}", place(), memo.fault);
    if (!length || *length < 0) return std::move(memo.bytes);
    const auto wanted = static_cast<std::size_t>(*length);
    if (memo.bytes.size() < wanted && memo.fault.empty() && fault.empty())
      fault = fmt::format("{}: {} has {} bytes, {} says {}", place(), field, memo.bytes.size(), lengthField, wanted);
    memo.bytes.resize(std::min(memo.bytes.size(), wanted));
    return std::move(memo.bytes);
  }

  void code(std::size_t part, StoredBlock& block) {
    block.code = memo(part, "MC5CODE", "MC5LEN", block.damage);
    block.declaration = memo(part, "SSBPART", "SSBLEN", block.damage);
    block.table = memo(part, "ADDINFO", "ADDLEN", block.damage);
    block.language = static_cast<std::uint8_t>(parts_->numberOrByte(part, "BLKLANG"));
    constexpr std::int64_t knowHowProtect = 3, nonRetain = 0x20;
    block.isProtected = parts_->numberOrByte(part, "PASSWORD") == knowHowProtect;
    block.isNonRetain = (parts_->numberOrByte(part, "ATTRIBUTE") & nonRetain) != 0;
    block.localBytes = static_cast<std::uint16_t>(parts_->number(part, "LOCDATALEN").value_or(0));
    block.version = static_cast<std::uint8_t>(parts_->numberOrByte(part, "VERSION"));
    block.author = text_(parts_->text(part, "USERNAME"));
    block.family = text_(parts_->text(part, "BLOCKFNAME"));
    block.name = text_(parts_->text(part, "BLOCKNAME"));
    block.codeTime = mc7::timeStampOf(parts_->raw(part, "TIMESTAMP1"));
    block.interfaceTime = mc7::timeStampOf(parts_->raw(part, "TIMESTAMP2"));
    const auto sum = static_cast<std::uint16_t>(parts_->number(part, "CHECKSUM").value_or(0));
    // The column has the two bytes of the checksum swapped. Actual values may have changed since it was computed.
    if (sum != 0 && block.isCode()) block.checksum = static_cast<std::uint16_t>(sum << 8 | sum >> 8);
  }

  void lose(std::string_view what, const StoredBlock& block, const std::string& fault) {
    if (!parts_->lacksMemos())
      result_.faults.push_back(fmt::format("{}: its {} are lost: {}", toString(block.key), what, fault));
  }

  void declaration(std::size_t part, StoredBlock& block) {
    std::string fault;
    const std::string bytes = memo(part, "MC5CODE", "MC5LEN", fault);
    if (!fault.empty()) return lose("names", block, fault);
    if (!bytes.empty()) block.declarationText = text_(bytes.substr(0, bytes.find('\0')));
  }

  void comments(std::size_t part, StoredBlock& block) {
    std::string fault;
    const std::string texts = memo(part, "MC5CODE", "MC5LEN", fault), head = memo(part, "SSBPART", "SSBLEN", fault),
                      table = memo(part, "ADDINFO", "ADDLEN", fault);
    if (!fault.empty()) return lose("comments", block, fault);
    const StoredBlock::NetworkText ofBlock = mc7::readTitleRecord(head, 3);
    block.title = text_(ofBlock.title);
    block.comment = text_(ofBlock.comment);
    if (table.size() < 2) return;
    const std::size_t networks = containerWord(table, 0);
    std::size_t at = 2, section = 0;
    for (std::size_t i = 0; i < networks && at + 2 <= table.size(); ++i, at += 2) {
      const std::size_t length = containerWord(table, at);
      if (section > texts.size()) break;
      const std::string_view record = std::string_view(texts).substr(section, length);
      const StoredBlock::NetworkText network = mc7::readTitleRecord(record, 6);
      block.networkTexts.push_back({text_(network.title), text_(network.comment), mc7::readLineRecords(record)});
      for (StoredBlock::LineText& line : block.networkTexts.back().lines) line.text = text_(line.text);
      section += length;
    }
    if (at + 2 > table.size()) return;
    constexpr std::size_t labelBytes = 5;
    const std::size_t jumps = containerWord(table, at);
    at += 2;
    for (std::size_t i = 0; i < jumps && at + labelBytes <= table.size(); ++i, at += labelBytes) {
      const std::string label = table.substr(at, labelBytes - 1);
      block.labels.push_back(label.substr(0, std::min(label.find('\0'), label.find(' '))));
    }
  }

  /// FB20,<12 bytes>; with two time stamps, first that of the interface, which may hold any byte.
  void used(std::size_t part, StoredBlock& block) {
    std::string fault;
    for (const std::string& list : {memo(part, "MC5CODE", "MC5LEN", fault), memo(part, "ADDINFO", "ADDLEN", fault)}) {
      constexpr std::size_t stampBytes = 12;
      for (std::size_t at = 0; at < list.size();) {
        const std::size_t comma = list.find(',', at);
        if (comma == std::string::npos || comma + 1 + stampBytes > list.size()) break;
        std::string_view name = std::string_view(list).substr(at, comma - at);
        std::size_t letters = 0;
        while (letters < name.size() && name[letters] >= 'A' && name[letters] <= 'Z') ++letters;
        for (const BlockKind kind :
             {BlockKind::Fb, BlockKind::Fc, BlockKind::Sfb, BlockKind::Sfc, BlockKind::Db, BlockKind::Udt}) {
          if (name.substr(0, letters) != step7::blockKindName(kind)) continue;
          std::uint32_t number = 0;
          for (const char c : name.substr(letters)) number = number * 10 + static_cast<std::uint32_t>(c - '0');
          block.used.push_back({{kind, number}, mc7::timeStampOf(std::string_view(list).substr(comma + 1, 6))});
        }
        at = comma + 1 + stampBytes;
        if (at < list.size() && list[at] == ';') ++at;
      }
    }
  }

  const ProjectFiles& files_;
  const std::string& folder_;
  const std::function<std::string(std::string_view)>& text_;
  std::optional<DbaseTable> parts_;
  std::map<std::int64_t, std::vector<std::size_t>> ofBlock_;
  BlockContainer result_;
};

}  // namespace

BlockContainer readBlockContainer(const ProjectFiles& files, const std::string& folder,
                                  const std::function<std::string(std::string_view)>& text) {
  return ContainerReader(files, folder, text).read();
}

}  // namespace rungproof::s7project
