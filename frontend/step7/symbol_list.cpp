// Each form becomes a row of cells with places; a row has a name in one cell and its address in the next.
#include "frontend/step7/symbol_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/stl/stl_lexer.hpp"
#include "ir/dialect.hpp"

namespace rungproof::step7 {

namespace {

struct ListCell {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};
using ListRow = std::vector<ListCell>;

/// Without the blanks around.
ListCell tightened(std::string_view text, std::size_t begin, std::size_t end) {
  const std::string_view cell = trimmed(text.substr(begin, end - begin));
  const std::size_t at = cell.empty() ? begin : static_cast<std::size_t>(cell.data() - text.data());
  return {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + cell.size())};
}

/// Cells between separators; marks around a cell are taken away, and separators between marks count for nothing.
ListRow separatedRow(std::string_view text, std::size_t begin, std::size_t end, char separator) {
  ListRow row;
  std::size_t at = begin;
  while (at <= end) {
    std::size_t stop = at;
    bool isQuoted = false;
    while (stop < end && (isQuoted || text[stop] != separator)) isQuoted = isQuoted != (text[stop++] == '"');
    ListCell cell = tightened(text, at, stop);
    if (cell.end - cell.begin >= 2 && text[cell.begin] == '"' && text[cell.end - 1] == '"')
      cell = tightened(text, cell.begin + 1, cell.end - 1);
    row.push_back(cell);
    at = stop + 1;
  }
  return row;
}

/// The byte behind `count` characters of UTF-8 from `at` on, or `end`.
std::size_t behindCharacters(std::string_view text, std::size_t at, std::size_t end, std::size_t count) {
  for (; count > 0 && at < end; --count) {
    ++at;
    while (at < end && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80) ++at;
  }
  return at;
}

constexpr std::size_t columnsBeforeName = 4, nameColumns = 24, addressColumns = 12, typeColumns = 10;

/// `126,` name 24, address 12, type 10, comment.
ListRow columnRow(std::string_view text, std::size_t begin, std::size_t end) {
  ListRow row;
  std::size_t at = begin + columnsBeforeName;
  for (const std::size_t width : {nameColumns, addressColumns, typeColumns, std::size_t{80}}) {
    const std::size_t stop = behindCharacters(text, at, end, width);
    row.push_back(tightened(text, at, stop));
    at = stop;
  }
  return row;
}

template <class Visit>
void forEachLine(std::string_view text, Visit visit) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t newline = std::min(text.find('\n', at), text.size());
    std::size_t end = newline;
    while (end > at && (text[end - 1] == '\r' || text[end - 1] == '\x1A')) --end;
    visit(at, end);
    at = newline + 1;
  }
}

bool isDifText(std::string_view text) {
  const std::string_view start = trimmed(text.substr(0, 8));
  return start.starts_with("TABLE") && text.find("\nTUPLES") != std::string_view::npos &&
         text.find("\nDATA") != std::string_view::npos;
}

/// Tuples of the Data Interchange Format: `-1,0` and BOT begin one, `1,0` and a text in marks are a cell.
std::vector<ListRow> difRows(std::string_view text) {
  std::vector<ListRow> rows;
  bool isData = false;
  bool wantsText = false;
  bool wantsSign = false;
  forEachLine(text, [&](std::size_t begin, std::size_t end) {
    const ListCell cell = tightened(text, begin, end);
    const std::string_view line = text.substr(cell.begin, cell.end - cell.begin);
    if (!isData) {
      isData = line == "DATA";
    } else if (wantsText) {
      wantsText = false;
      if (rows.empty() || line.size() < 2) return;
      rows.back().push_back(tightened(text, cell.begin + 1, cell.end - 1));
    } else if (wantsSign) {
      wantsSign = false;
      if (line == "BOT") rows.emplace_back();
    } else if (line.starts_with("1,0")) {
      wantsText = true;
    } else if (line.starts_with("-1,0")) {
      wantsSign = true;
    }
  });
  std::erase_if(rows, [](const ListRow& row) { return row.empty(); });
  return rows;
}

bool isColumnLine(std::string_view line) { return line.size() > 28 && line.starts_with("126,"); }

/// The separator of a row; what stands between marks, such as a comment, says nothing of it.
char listSeparator(std::string_view line) {
  constexpr std::string_view separators = "\t;,";
  std::size_t best = separators.size();
  bool isQuoted = false;
  for (const char c : line) {
    if (c == '"') isQuoted = !isQuoted;
    if (!isQuoted) best = std::min(best, separators.find(c));
  }
  return best < separators.size() ? separators[best] : '\0';
}

std::vector<ListRow> rowsOf(std::string_view text) {
  if (isDifText(text)) return difRows(text);
  std::vector<ListRow> rows;
  forEachLine(text, [&](std::size_t begin, std::size_t end) {
    const std::string_view line = text.substr(begin, end - begin);
    if (trimmed(line).empty()) return;
    if (isColumnLine(line)) {
      rows.push_back(columnRow(text, begin, end));
    } else if (const char separator = listSeparator(line); separator != '\0') {
      rows.push_back(separatedRow(text, begin, end, separator));
    } else {
      rows.push_back({tightened(text, begin, end)});
    }
  });
  return rows;
}

std::optional<Operand> addressOfRow(std::string_view text, ListCell cell, MnemonicSet set, std::uint32_t file) {
  if (cell.begin == cell.end) return std::nullopt;
  Cursor cursor(text.substr(0, cell.end), file);
  cursor.to(cell.begin);
  const Spelling7 spelling{set, TextEncoding::Utf8};
  const OperandOutcome outcome = readOperand7(cursor, spelling);
  const bool isWhole = outcome.fault.empty() && cursor.at() == cell.end;
  const bool isAddress = outcome.operand.form == OperandForm::Address || outcome.operand.form == OperandForm::Block;
  return isWhole && isAddress ? std::optional(outcome.operand) : std::nullopt;
}

/// Where characters of a row of fixed columns stand that are not in their columns, and what is wrong there.
struct Misalignment {
  ListCell place;
  std::string message;
};

/// Of the words of a line that are an address, whose number may stand apart from its letters, those nearest to `where`.
std::optional<ListCell> addressNear(std::string_view text, ListCell line, std::size_t where, MnemonicSet set,
                                    std::uint32_t file) {
  std::optional<ListCell> nearest;
  const auto distance = [&](std::size_t at) { return at > where ? at - where : where - at; };
  const auto isBlankAt = [&](std::uint32_t at) { return at >= line.end || text[at] == ' '; };
  for (std::uint32_t begin = line.begin; begin < line.end; ++begin) {
    if (isBlankAt(begin) || (begin > line.begin && !isBlankAt(begin - 1))) continue;
    std::uint32_t end = begin;
    for (int words = 0; words < 2 && end < line.end; ++words) {
      while (end < line.end && isBlankAt(end)) ++end;
      while (!isBlankAt(end)) ++end;
      const ListCell cell{begin, end};
      const bool isNearer = !nearest || distance(begin) < distance(nearest->begin);
      if (isNearer && addressOfRow(text, cell, set, file)) nearest = cell;
    }
  }
  return nearest;
}

/// A row that begins with `126,` and has its address elsewhere, or none.
std::optional<Misalignment> misalignmentOf(std::string_view text, ListCell line, MnemonicSet set, std::uint32_t file) {
  const std::string_view written = text.substr(line.begin, line.end - line.begin);
  if (!written.starts_with("126,") || trimmed(written.substr(columnsBeforeName)).empty()) return std::nullopt;
  const std::size_t name = line.begin + columnsBeforeName;
  const std::size_t address = behindCharacters(text, name, line.end, nameColumns);
  const std::size_t type = behindCharacters(text, address, line.end, addressColumns);
  const bool isTorn = type < line.end && type > address && text[type - 1] != ' ' && text[type] != ' ';
  const ListCell cell = tightened(text, address, type);
  if (!isTorn && addressOfRow(text, cell, set, file)) return std::nullopt;
  const auto column = [&](std::size_t at) {
    return 1 + std::ranges::count_if(text.substr(line.begin, at - line.begin),
                                     [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; });
  };
  constexpr std::size_t first = columnsBeforeName + nameColumns + 1, last = first + addressColumns - 1;
  if (const auto found = addressNear(text, {static_cast<std::uint32_t>(name), line.end}, address, set, file)) {
    const std::string_view address7 = text.substr(found->begin, found->end - found->begin);
    return Misalignment{
        *found, fmt::format("the address \"{}\" stands in columns {} to {}, not between {} and {}", excerpt(address7),
                            column(found->begin), column(found->end) - 1, first, last)};
  }
  return Misalignment{cell.begin < cell.end ? cell : line,
                      fmt::format("no address stands in columns {} to {}", first, last)};
}

bool isTypeCell(std::string_view cell) {
  return s7300::typeNamed(cell).has_value() || cell.starts_with("FB") || cell.starts_with("UDT") ||
         cell.starts_with("DB") || cell.starts_with("OB") || cell.starts_with("FC") || cell.starts_with("SF");
}

std::optional<SymbolRow> symbolOf(std::string_view text, const ListRow& row, MnemonicSet set, std::uint32_t file) {
  const auto cell = [&](std::size_t i) {
    return i < row.size() ? text.substr(row[i].begin, row[i].end - row[i].begin) : std::string_view();
  };
  // Name and address stand side by side, in this order; in .seq the address comes first; in a tag table of TIA the
  // path or the type may stand between.
  const auto make = [&](std::size_t name, std::size_t address, const Operand& operand) {
    SymbolRow symbol;
    symbol.name = {std::string(cell(name)), {file, row[name].begin, row[name].end - row[name].begin}};
    symbol.address = operand;
    std::size_t next = std::max(name, address) + 1;
    if (isTypeCell(cell(next))) {
      for (const char c : cell(next)) {
        if (c != ' ' || (!symbol.type.empty() && symbol.type.back() != ' ')) symbol.type += c;
      }
      ++next;
    } else if (address > name + 1 && isTypeCell(cell(address - 1))) {
      symbol.type = cell(address - 1);
    }
    for (; next < row.size() && symbol.comment.empty(); ++next) {
      if (cell(next) != "True" && cell(next) != "False") symbol.comment = cell(next);
    }
    return symbol;
  };
  for (std::size_t i = 1; i < row.size() && i <= 3; ++i) {
    const std::optional<Operand> operand = addressOfRow(text, row[i], set, file);
    if (!operand) continue;
    // .seq: an empty cell, the address, the name.
    if (i == 1 && cell(0).empty() && !cell(2).empty()) return make(2, 1, *operand);
    if (!cell(0).empty()) return make(0, i, *operand);
  }
  if (const std::optional<Operand> operand = row.empty() ? std::nullopt : addressOfRow(text, row[0], set, file);
      operand && !cell(1).empty() && !addressOfRow(text, row.size() > 1 ? row[1] : ListCell{}, set, file))
    return make(1, 0, *operand);
  return std::nullopt;
}

/// A line of column titles or of nothing but separators, or a variable table: reported by nobody.
bool isNoSymbol(std::string_view text, const ListRow& row, bool isFirst) {
  std::size_t filled = 0;
  for (const ListCell& cell : row) filled += cell.end > cell.begin ? 1U : 0U;
  if (filled == 0) return true;
  const std::string_view last = text.substr(row.back().begin, row.back().end - row.back().begin);
  if (filled == 1 && (last == "\x1A" || last.starts_with("//"))) return true;
  if (!isFirst) return false;
  return std::ranges::none_of(row, [&](const ListCell& cell) {
    const std::string_view word = text.substr(cell.begin, cell.end - cell.begin);
    return word.find_first_of("0123456789") != std::string_view::npos;
  });
}

}  // namespace

namespace {

/// A, tab, I 0.0 is a statement, and so is LD, tab, I0.0.
bool isMnemonicOfAnyFamily(std::string_view name) {
  return std::ranges::any_of(dialects(), [&](const Dialect* dialect) {
    return dialect->instructions().named(name) != nullptr || dialect->instructions().namedGerman(name) != nullptr;
  });
}

}  // namespace

namespace {

ListCell lineAround(std::string_view text, ListCell cell) {
  const std::size_t before = text.substr(0, cell.begin).rfind('\n');
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  std::size_t end = std::min(text.find('\n', cell.begin), text.size());
  while (end > begin && text[end - 1] == '\r') --end;
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

}  // namespace

std::vector<SymbolRow> readSymbolList(std::string_view text, MnemonicSet set, SyntaxSink& sink) {
  std::vector<SymbolRow> symbols;
  bool isFirst = true;
  for (const ListRow& row : rowsOf(text)) {
    std::optional<SymbolRow> symbol = symbolOf(text, row, set, sink.file());
    const bool mayBeHeading = isFirst;
    isFirst = false;
    if (const auto misaligned = misalignmentOf(text, lineAround(text, row.front()), set, sink.file())) {
      sink.report(Syntax::SymbolColumns, sink.span(misaligned->place.begin, misaligned->place.end),
                  misaligned->message);
    } else if (symbol) {
      symbols.push_back(std::move(*symbol));
    } else if (!isNoSymbol(text, row, mayBeHeading)) {
      const Span span = sink.span(row.front().begin, row.back().end);
      sink.report(
          Syntax::SymbolRow, span,
          fmt::format("\"{}\" is not a row of name and address", excerpt(text.substr(span.offset, span.length))));
    }
  }
  return symbols;
}

namespace {

struct RowCount {
  int rows = 0;
  int symbols = 0;
};

RowCount countRows(std::string_view text, MnemonicSet set) {
  constexpr int enough = 300;  // rows
  RowCount count;
  for (const ListRow& row : rowsOf(text)) {
    if (isNoSymbol(text, row, count.rows == 0)) continue;
    if (++count.rows == enough) break;
    if (row.size() < 2) continue;
    const std::optional<SymbolRow> symbol = symbolOf(text, row, set, 0);
    if (symbol && !isMnemonicOfAnyFamily(symbol->name.text)) ++count.symbols;
  }
  return count;
}

}  // namespace

int symbolListShare(std::string_view text, MnemonicSet set) {
  constexpr std::size_t enough = 32768, beginning = 256;  // bytes that tell what the rest is like
  constexpr int fewRows = 8;                              // that need not be like the rest
  if (text.size() > 2 * beginning) {
    const RowCount first = countRows(text.substr(0, text.rfind('\n', beginning)), set);
    if (first.rows > fewRows && first.symbols == 0) return 0;
  }
  const RowCount count = countRows(text.substr(0, enough), set);
  return count.rows == 0 ? 0 : count.symbols * 100 / count.rows;
}

bool isSymbolList(std::string_view text) {
  return hasSymbolListForm(text) ||
         std::max(symbolListShare(text, MnemonicSet::International), symbolListShare(text, MnemonicSet::German)) >= 50;
}

bool hasSymbolListForm(std::string_view text) {
  if (isDifText(text)) return true;
  const std::string_view line = text.substr(0, text.find('\n'));
  if (isColumnLine(line)) return true;
  // "name ... ","FC     1 ","FC     1 ","..."
  return line.starts_with('"') && line.find(" \",\"") != std::string_view::npos && std::ranges::count(line, '"') >= 6;
}

}  // namespace rungproof::step7
