// Rows and cells with their places, and the words that panels' editors use.
#include "frontend/input/tag_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "analysis/panel/panel_words.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof {

namespace {

struct TagCell {
  std::string_view text;
  std::uint32_t offset = 0;  ///< in the file
};
using TagCells = std::vector<TagCell>;

enum class TagColumn : std::uint8_t { Name, Address, Type, Access, Comment, count };

/// Words of headings, in small letters.
constexpr std::array<std::pair<TagColumn, std::string_view>, 29> headings = {{
    {TagColumn::Address, "address"}, {TagColumn::Address, "adresse"},   {TagColumn::Address, "addr"},
    {TagColumn::Address, "地址"},    {TagColumn::Address, "адрес"},     {TagColumn::Address, "Адрес"},
    {TagColumn::Type, "type"},       {TagColumn::Type, "typ"},          {TagColumn::Type, "类型"},
    {TagColumn::Type, "тип"},        {TagColumn::Type, "Тип"},          {TagColumn::Type, "format"},
    {TagColumn::Access, "access"},   {TagColumn::Access, "zugriff"},    {TagColumn::Access, "mode"},
    {TagColumn::Access, "读写"},     {TagColumn::Access, "доступ"},     {TagColumn::Access, "Доступ"},
    {TagColumn::Comment, "comment"}, {TagColumn::Comment, "kommentar"}, {TagColumn::Comment, "descr"},
    {TagColumn::Comment, "注释"},    {TagColumn::Comment, "коммент"},   {TagColumn::Name, "name"},
    {TagColumn::Name, "tag"},        {TagColumn::Name, "symbol"},       {TagColumn::Name, "名"},
    {TagColumn::Name, "имя"},        {TagColumn::Name, "Имя"},
}};

struct TypeWord {
  std::string_view word;
  TagType type;
};
/// The first that stands in a name decides.
constexpr std::array<TypeWord, 40> typeWords = {{
    {"string", TagType::Text},
    {"字符", TagType::Text},
    {"text", TagType::Text},
    {"real", TagType::Real},
    {"float", TagType::Real},
    {"浮点", TagType::Real},
    {"实数", TagType::Real},
    {"bool", TagType::Bool},
    {"bit array", TagType::Unknown},
    {"udint", TagType::Unsigned32},
    {"ulong", TagType::Unsigned32},
    {"uint32", TagType::Unsigned32},
    {"unsigned long", TagType::Unsigned32},
    {"unsigned int", TagType::Unsigned16},
    {"dword", TagType::Unsigned32},
    {"双字", TagType::Unsigned32},
    {"32-bit unsigned", TagType::Unsigned32},
    {"32-bit", TagType::Signed32},
    {"dint", TagType::Signed32},
    {"int32", TagType::Signed32},
    {"双整", TagType::Signed32},
    {"long", TagType::Signed32},
    {"usint", TagType::Byte},
    {"sint", TagType::Byte},
    {"byte", TagType::Byte},
    {"char", TagType::Byte},
    {"字节", TagType::Byte},
    {"int8", TagType::Byte},
    {"8-bit", TagType::Byte},
    {"uint", TagType::Unsigned16},
    {"ushort", TagType::Unsigned16},
    {"16-bit unsigned", TagType::Unsigned16},
    {"unsigned short", TagType::Unsigned16},
    {"word", TagType::Unsigned16},
    {"字", TagType::Unsigned16},
    {"16-bit", TagType::Signed16},
    {"int", TagType::Signed16},
    {"short", TagType::Signed16},
    {"整", TagType::Signed16},
    {"bit", TagType::Bool},
}};

std::string smallText(std::string_view text) {
  std::string result;
  for (const char c : text) result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

TagCells cellsOf(std::string_view text, std::uint32_t begin, std::uint32_t end, char separator) {
  TagCells cells;
  std::uint32_t at = begin;
  while (at <= end) {
    std::uint32_t stop = at;
    bool inQuotes = false;
    while (stop < end && (inQuotes || text[stop] != separator)) {
      if (text[stop] == '"') inQuotes = !inQuotes;
      ++stop;
    }
    std::string_view cell = trimmed(text.substr(at, stop - at));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.push_back({cell, cell.empty() ? at : static_cast<std::uint32_t>(cell.data() - text.data())});
    at = stop + 1;
  }
  return cells;
}

/// The separator that stands most often in the first lines.
char separatorIn(std::string_view text) {
  const std::string_view head = text.substr(0, std::min<std::size_t>(text.size(), 2000));
  char best = ',';
  std::ptrdiff_t most = 0;
  for (const char separator : {'\t', ';', ','}) {
    const auto count = std::count(head.begin(), head.end(), separator);
    if (count > most) {
      best = separator;
      most = count;
    }
  }
  return best;
}

/// VW100, "VW 100", %MW10, DB1.DBX0.0, or a symbol of the program.
std::optional<Operand> addressIn(const Program& program, std::string_view cell) {
  std::string text;
  for (const char c : cell) {
    if (c != ' ' && c != '%') text += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  if (text.starts_with("DB1") && text.size() > 4 && (text[3] == '.' || text[3] == ',' || text[3] == ':')) {
    std::string rest = text.substr(4);
    if (rest.starts_with("DB")) rest = rest.substr(2);
    text = rest.starts_with("X") ? "V" + rest.substr(1) : "V" + rest;
  }
  Operand operand;
  if (readAddress(text, Spelling::International, operand)) return operand;
  if (const Symbol* symbol = program.symbolNamed(cell);
      symbol != nullptr && symbol->address.kind == OperandKind::Direct)
    return symbol->address;
  if (readAddress(text, Spelling::German, operand)) return operand;
  return std::nullopt;
}

/// Only what says nothing else: "Cyclic in operation" is no access.
TagAccess accessNamed(std::string_view cell) {
  static constexpr std::array<std::string_view, 13> reads = {
      "r",  "ro",           "read",         "readonly", "nurlesen", "lesen",  "只读",
      "读", "толькочтение", "Толькочтение", "чтение",   "Чтение",   "display"};
  static constexpr std::array<std::string_view, 17> sets = {
      "w",         "wo",   "rw", "wr",     "write",        "writeonly",    "readwrite", "writeread", "lesenschreiben",
      "schreiben", "读写", "写", "可读写", "чтениезапись", "Чтениезапись", "запись",    "Запись"};
  std::string word;
  for (const char c : smallText(cell)) {
    if (c != ' ' && c != '-' && c != '_' && c != '/' && c != '&' && c != '+') word += c;
  }
  if (std::ranges::find(sets, word) != sets.end()) return TagAccess::Sets;
  return std::ranges::find(reads, word) != reads.end() ? TagAccess::Reads : TagAccess::Unknown;
}

class TagReader {
 public:
  TagReader(const Program& program, std::uint32_t file)
      : program_(program), file_(file), text_(program.sources->file(file).text()) {}

  std::vector<PanelTag> run() {
    columns_.fill(-1);
    const char separator = separatorIn(text_);
    StlLexer lexer(text_);
    std::uint32_t begin = 0, end = 0;
    bool mayBeHeading = true;
    while (lexer.nextRaw(begin, end)) {
      if (trimmed(text_.substr(begin, end - begin)).empty()) continue;
      const TagCells cells = cellsOf(text_, begin, end, separator);
      if (mayBeHeading && !row(cells)) heading(cells);
      if (!mayBeHeading) row(cells);
      mayBeHeading = mayBeHeading && tags_.empty() && at(TagColumn::Address) < 0;
    }
    return std::move(tags_);
  }

 private:
  int& at(TagColumn column) { return columns_[static_cast<std::size_t>(column)]; }
  std::string_view cellAt(const TagCells& cells, TagColumn column) {
    const int i = at(column);
    return i >= 0 && static_cast<std::size_t>(i) < cells.size() ? cells[static_cast<std::size_t>(i)].text
                                                                : std::string_view();
  }

  void heading(const TagCells& cells) {
    std::array<int, static_cast<std::size_t>(TagColumn::count)> found{};
    found.fill(-1);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string cell = smallText(cells[i].text);
      for (const auto& [column, word] : headings) {
        int& place = found[static_cast<std::size_t>(column)];
        if (place >= 0 || cell.find(word) == std::string::npos) continue;
        place = static_cast<int>(i);
        break;
      }
    }
    if (found[static_cast<std::size_t>(TagColumn::Address)] >= 0) columns_ = found;
  }

  /// Takes the row if it holds an address where one belongs.
  bool row(const TagCells& cells) {
    int place = at(TagColumn::Address);
    std::optional<Operand> address;
    if (place >= 0) {
      address = addressIn(program_, cellAt(cells, TagColumn::Address));
    } else {
      for (std::size_t i = 1; i < cells.size() && !address; ++i) {
        address = addressIn(program_, cells[i].text);
        place = static_cast<int>(i);
      }
    }
    if (!address) return false;
    const auto i = static_cast<std::size_t>(place);
    PanelTag tag;
    tag.span = {file_, cells[i].offset, static_cast<std::uint32_t>(cells[i].text.size())};
    tag.address = *std::move(address);
    tag.name = at(TagColumn::Address) < 0 ? cells[0].text : cellAt(cells, TagColumn::Name);
    if (tag.name.empty()) tag.name = cells[i].text;
    const bool hasHeading = at(TagColumn::Address) >= 0;
    tag.typeText = hasHeading ? cellAt(cells, TagColumn::Type) : i + 1 < cells.size() ? cells[i + 1].text : "";
    tag.type = tagTypeNamed(tag.typeText);
    tag.access = accessNamed(hasHeading             ? cellAt(cells, TagColumn::Access)
                             : i + 2 < cells.size() ? cells[i + 2].text
                                                    : "");
    if (tag.access == TagAccess::Unknown &&
        (speaksOfSetting(tag.name) || speaksOfSetting(cellAt(cells, TagColumn::Comment))))
      tag.access = TagAccess::Sets;
    tags_.push_back(std::move(tag));
    return true;
  }

  const Program& program_;
  std::uint32_t file_;
  std::string_view text_;
  std::array<int, static_cast<std::size_t>(TagColumn::count)> columns_{};
  std::vector<PanelTag> tags_;
};

}  // namespace

TagType tagTypeNamed(std::string_view text) {
  const std::string name = smallText(text);
  for (const TypeWord& row : typeWords) {
    if (name.find(row.word) != std::string::npos) return row.type;
  }
  return TagType::Unknown;
}

std::vector<PanelTag> readTagText(const Program& program, std::uint32_t file) { return TagReader(program, file).run(); }

std::vector<PanelTag> readTagList(Program& program, const std::string& file, TextEncoding encoding) {
  const auto& [bytes, problem] = inputBytes(file, longestProgram);
  const std::uint32_t index = program.sources->add(file, bytes ? decode(*bytes, encoding).text : std::string());
  if (bytes) return readTagText(program, index);
  SyntaxSink(program, index)
      .report(Syntax::FileUnreadable, {index, 0, 0}, fmt::format("cannot read {}: {}", file, problem));
  return {};
}

}  // namespace rungproof
