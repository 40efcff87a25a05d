// Splits a text into cells.
#include "frontend/logger/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

std::string trimmedCell(std::string text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  std::size_t begin = 0;
  while (begin < text.size() && blank(text[begin])) ++begin;
  return text.substr(begin);
}

class CsvReader {
 public:
  CsvReader(CsvTable& table, std::string_view text, std::vector<Failure>& failures, const CsvForm& form)
      : table_(table), text_(text), failures_(failures), helpIfEmpty_(form.helpIfEmpty) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    const std::string_view first = text_.substr(0, text_.find('\n'));
    const bool saysSeparator = first.size() >= 5 && equalsIgnoringCase(first.substr(0, 4), "sep=");
    if (saysSeparator) skipLine();
    passIntroduction(form.headingHas);
    separator_ = form.separator != 0 ? form.separator
                 : saysSeparator     ? first[4]
                                     : mostFrequent(text_.substr(at_, text_.find('\n', at_) - at_));
    table_.separator = separator_;
  }

  void run() {
    while (at_ < text_.size()) {
      std::vector<CsvCell> row = readRow();
      if (row.size() == 1 && row[0].text.empty()) continue;
      if (table_.heading.empty()) {
        table_.heading = std::move(row);
        continue;
      }
      if (row.size() == table_.heading.size() + 1 && row.back().text.empty()) row.pop_back();
      if (row.size() != table_.heading.size()) {
        failures_.push_back(table_.at(
            row.back(), fmt::format("this row has {} cells, the heading has {}", row.size(), table_.heading.size()),
            row.size() > table_.heading.size() && separator_ == ','
                ? "give every row one cell for each column; numbers with a decimal comma need quotes or another "
                  "separator"
                : "give every row one cell for each column; empty cells count"));
        continue;
      }
      table_.rows.push_back(std::move(row));
    }
    if (table_.heading.empty()) failures_.push_back({"the file is empty", table_.name + ":1:1", helpIfEmpty_});
  }

 private:
  void skipLine() {
    at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
    ++line_;
  }
  /// Lines of '#' and, where the heading is known by one of its cells, all in front of it.
  void passIntroduction(const std::string& headingHas) {
    while (at_ < text_.size() && text_[at_] == '#') skipLine();
    if (headingHas.empty()) return;
    std::uint32_t lines = 0;
    for (std::size_t at = at_; at < text_.size(); ++lines) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      if (hasCell(text_.substr(at, end - at), headingHas)) {
        at_ = at;
        line_ += lines;
        return;
      }
      at = end + 1;
    }
  }
  static bool hasCell(std::string_view line, std::string_view wanted) {
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find_first_of(",;\t|\r", begin), line.size());
      std::string cell = trimmedCell(std::string(line.substr(begin, end - begin)));
      if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
      if (equalsIgnoringCase(cell, wanted)) return true;
      begin = end + 1;
    }
    return false;
  }
  static char mostFrequent(std::string_view heading) {
    char best = ',';
    std::size_t most = 0;
    for (const char sign : {',', ';', '\t', '|'}) {
      std::size_t count = 0;
      bool isQuoted = false;
      for (const char c : heading) {
        if (c == '"') isQuoted = !isQuoted;
        if (c == sign && !isQuoted) ++count;
      }
      if (count > most) {
        most = count;
        best = sign;
      }
    }
    return best;
  }
  std::vector<CsvCell> readRow() {
    std::vector<CsvCell> row;
    column_ = 1;
    while (true) {
      row.push_back(readCell());
      if (at_ < text_.size() && text_[at_] == separator_) {
        advance();
        continue;
      }
      break;
    }
    if (at_ < text_.size()) ++at_;  // the line end
    ++line_;
    return row;
  }
  CsvCell readCell() {
    while (at_ < text_.size() && text_[at_] != separator_ && (text_[at_] == ' ' || text_[at_] == '\t')) advance();
    CsvCell cell{{}, line_, column_};
    const bool isQuoted = at_ < text_.size() && text_[at_] == '"';
    if (isQuoted) readQuoted(cell);
    while (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n') {
      if (text_[at_] != '\r') cell.text += text_[at_];
      advance();
    }
    cell.text = trimmedCell(cell.text);
    return cell;
  }
  void readQuoted(CsvCell& cell) {
    advance();
    while (at_ < text_.size()) {
      if (text_[at_] == '"') {
        advance();
        if (at_ >= text_.size() || text_[at_] != '"') return;
      }
      if (text_[at_] == '\n') ++line_;
      cell.text += text_[at_];
      advance();
    }
    failures_.push_back(
        table_.at(cell, "the quotes that begin here are not closed", "end the cell with the same quotes"));
  }
  void advance() {
    const bool isContinuation = (static_cast<unsigned char>(text_[at_]) & 0xC0) == 0x80;
    if (!isContinuation) ++column_;
    ++at_;
  }

  CsvTable& table_;
  std::string_view text_;
  std::vector<Failure>& failures_;
  const std::string& helpIfEmpty_;
  char separator_ = ',';
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
  std::uint32_t column_ = 1;
};

}  // namespace

Failure CsvTable::at(const CsvCell& cell, std::string message, std::string help) const {
  return {std::move(message), fmt::format("{}:{}:{}", name, cell.line, cell.column), std::move(help)};
}

CsvTable readCsv(std::string name, std::string_view text, std::vector<Failure>& failures, const CsvForm& form) {
  CsvTable table;
  table.name = std::move(name);
  CsvReader(table, text, failures, form).run();
  return table;
}

}  // namespace rungproof
