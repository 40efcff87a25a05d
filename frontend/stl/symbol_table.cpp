// Rows of symbol tables.
#include "frontend/stl/symbol_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/stl/stl_lexer.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {

namespace {

constexpr std::size_t maxCells = 8;

struct TableCell {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};
struct Row {
  std::array<TableCell, maxCells> cells{};
  std::size_t count = 0;
};

/// Cells between separators; quoted cells as in CSV lose their marks.
Row splitRow(std::string_view text, std::uint32_t begin, std::uint32_t end, char separator) {
  Row row;
  std::uint32_t at = begin;
  while (at <= end && row.count < maxCells) {
    std::uint32_t stop = row.count + 1 == maxCells ? end : at;
    bool inQuotes = false;
    while (stop < end && (inQuotes || text[stop] != separator)) {
      if (text[stop] == '"' && separator != '\t') inQuotes = !inQuotes;
      ++stop;
    }
    std::string_view cell = trimmed(text.substr(at, stop - at));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    const auto cellBegin = cell.empty() ? at : static_cast<std::uint32_t>(cell.data() - text.data());
    row.cells[row.count++] = {cellBegin, cellBegin + static_cast<std::uint32_t>(cell.size())};
    at = stop + 1;
  }
  return row;
}

char separatorOf(std::string_view line) {
  if (line.find('\t') != std::string_view::npos) return '\t';
  if (line.find(';') != std::string_view::npos) return ';';
  return line.find(',') != std::string_view::npos ? ',' : ' ';
}

bool readRoutine(std::string_view text, Operand& operand) {
  for (const std::string_view prefix : {std::string_view("SBR"), std::string_view("INT"), std::string_view("OB")}) {
    if (text.size() <= prefix.size() || !equalsIgnoringCase(text.substr(0, prefix.size()), prefix)) continue;
    std::string_view digits = text.substr(prefix.size());
    if (digits[0] == '_') digits.remove_prefix(1);
    if (digits.empty() || digits.size() > 4 || !std::all_of(digits.begin(), digits.end(), isDigit)) return false;
    std::int64_t value = 0;
    for (const char c : digits) value = value * 10 + (c - '0');
    operand = constant(value);
    operand.text = text;
    return true;
  }
  return false;
}

bool readSymbolAddress(std::string_view text, Spelling spelling, Operand& operand) {
  if (text.empty()) return false;
  if (readRoutine(text, operand)) return true;
  OperandResult result = readOperand(text, {spelling});
  if (result.fault != OperandFault::None) return false;
  if (result.operand.kind != OperandKind::Direct && result.operand.kind != OperandKind::Constant) return false;
  operand = std::move(result.operand);
  return true;
}

/// The cell that holds the address, and the name before it.
bool findRow(std::string_view text, const Row& row, Spelling spelling, std::size_t& name, std::size_t& address,
             Operand& operand) {
  const auto cell = [&](std::size_t i) {
    return text.substr(row.cells[i].begin, row.cells[i].end - row.cells[i].begin);
  };
  for (std::size_t i = 0; i + 1 < row.count; ++i) {
    if (!isName(cell(i))) continue;
    for (std::size_t k = i + 1; k < row.count && k <= i + 2; ++k) {
      if (!readSymbolAddress(cell(k), spelling, operand)) continue;
      name = i;
      address = k;
      return true;
    }
  }
  return false;
}

bool isHeader(std::string_view line) {
  static constexpr std::array<std::string_view, 8> words = {
      "Address", "Adresse", "Direccion", "\xE5\x9C\xB0\xE5\x9D\x80", "\xD0\x90\xD0\xB4\xD1\x80\xD0\xB5\xD1\x81",
      "ADDRESS", "address", "Symbol"};
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return line.find(word) != std::string_view::npos; });
}

bool isComment(std::string_view line) { return line.substr(0, 2) == "//" || line.substr(0, 2) == "##"; }

}  // namespace

bool readSymbolRow(std::string_view text, std::uint32_t begin, std::uint32_t end, Spelling spelling, SyntaxSink& sink) {
  const std::string_view line = text.substr(begin, end - begin);
  // In cells a comment may hold "//"; between blanks it begins the comment.
  const bool hasCells = separatorOf(line) != ' ' && line.find("//") > line.find_first_of("\t,;");
  const std::size_t comment = hasCells ? std::string_view::npos : line.find("//");
  const std::string_view head = line.substr(0, comment);
  const Row row = splitRow(text, begin, begin + static_cast<std::uint32_t>(head.size()), separatorOf(head));
  std::size_t name = 0, address = 0;
  Symbol symbol;
  if (!findRow(text, row, spelling, name, address, symbol.address)) return false;
  symbol.name = text.substr(row.cells[name].begin, row.cells[name].end - row.cells[name].begin);
  symbol.span = sink.span(row.cells[name].begin, row.cells[name].end);
  symbol.address.span = sink.span(row.cells[address].begin, row.cells[address].end);
  if (comment != std::string_view::npos) {
    symbol.comment = trimmed(line.substr(comment + 2));
  } else if (address + 1 < row.count) {
    const TableCell& last = row.cells[row.count - 1];
    std::string_view words =
        trimmed(text.substr(row.cells[address + 1].begin, last.end - row.cells[address + 1].begin));
    if (words.substr(0, 2) == "//") words = trimmed(words.substr(2));
    symbol.comment = words;
  }
  sink.program().symbols.push_back(std::move(symbol));
  return true;
}

void readSymbolTable(std::string_view text, Spelling spelling, SyntaxSink& sink) {
  StlLexer lexer(text);
  std::uint32_t begin = 0, end = 0;
  bool isFirst = true;
  while (lexer.nextRaw(begin, end)) {
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    if (line.empty() || isComment(line)) continue;
    const bool mayBeHeader = isFirst;
    isFirst = false;
    if (readSymbolRow(text, begin, end, spelling, sink)) continue;
    if (mayBeHeader && isHeader(line)) continue;
    // A number alone is an unused row of the editor's table.
    if (line.find_first_not_of("0123456789\t,; ") == std::string_view::npos) continue;
    sink.report(Syntax::SymbolRow, sink.span(begin, end),
                fmt::format("\"{}\" is not a row of name and address", excerpt(line)));
  }
}

int symbolRowShare(std::string_view text, Spelling spelling) {
  StlLexer lexer(text);
  std::uint32_t begin = 0, end = 0;
  int lines = 0, rows = 0;
  while (lines < 200 && lexer.nextRaw(begin, end)) {
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    if (line.empty() || isComment(line)) continue;
    ++lines;
    const std::string_view head = text.substr(begin, end - begin);
    const char separator = separatorOf(head);
    if (separator == ' ') continue;  // blanks separate instructions as well
    const Row row = splitRow(text, begin, end, separator);
    std::size_t name = 0, address = 0;
    Operand operand;
    const bool isInstruction =
        s7200Instructions().named(trimmed(head.substr(0, head.find_first_of("\t,; ")))) != nullptr;
    const bool isRow = !isInstruction && findRow(text, row, spelling, name, address, operand);
    if (isRow || (lines == 1 && isHeader(line))) ++rows;
  }
  return lines == 0 ? 0 : rows * 100 / lines;
}

}  // namespace rungproof
