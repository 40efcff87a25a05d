// Finds the time column and its unit, names the columns, makes cells plain.
#include "frontend/logger/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "frontend/files/closest_word.hpp"
#include "frontend/files/encoding.hpp"
#include "frontend/logger/moment.hpp"
#include "frontend/logger/trace_cell.hpp"
#include "frontend/logger/vcd_reader.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {

constexpr double nanosecondsInUs = 1000, epochFrom = 1e18;  ///< ns: numbers from 2001-09-09 on are taken as dates
constexpr double largestTimeNs = 1e18;

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

bool areDigits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// "1.234,5" and "1,5" with points; nothing if the text is no such number.
std::optional<std::string> withoutDecimalComma(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || text.find(',', comma + 1) != std::string_view::npos) return std::nullopt;
  std::string whole;
  std::string_view front = text.substr(0, comma);
  if (!front.empty() && (front[0] == '-' || front[0] == '+')) {
    whole = front[0] == '-' ? "-" : "";
    front.remove_prefix(1);
  }
  const bool isGrouped = front.find('.') != std::string_view::npos;
  for (std::size_t begin = 0, group = 0; begin <= front.size(); ++group) {
    const std::size_t end = std::min(front.find('.', begin), front.size());
    const std::string_view part = front.substr(begin, end - begin);
    const bool fits = areDigits(part) && (!isGrouped || part.size() == 3 || (group == 0 && part.size() < 3));
    if (!fits) return std::nullopt;
    whole += part;
    begin = end + 1;
  }
  const std::string_view rest = text.substr(comma + 1);
  const std::string_view digits = rest.substr(0, rest.find_first_of("eE"));
  if (!areDigits(digits)) return std::nullopt;
  return whole + "." + std::string(rest);
}

/// What loggers write where they have no value.
bool isMissingValue(std::string_view text) {
  return isOneOf(lowered(text), {"-", "--", "---", "n/a", "na", "nan", "z"});
}

/// "(ms)" and "[V]" of a row of units, without the brackets.
std::string_view bare(std::string_view text) {
  const bool isBracketed =
      text.size() >= 2 && ((text.front() == '(' && text.back() == ')') || (text.front() == '[' && text.back() == ']'));
  return isBracketed ? text.substr(1, text.size() - 2) : text;
}

class Recording {
 public:
  Recording(CsvTable table, const TraceImport& import, std::vector<Failure>& failures)
      : table_(std::move(table)), import_(import), failures_(failures), hasDecimalComma_(table_.separator != ',') {}

  CsvTable read() {
    if (table_.heading.empty()) return std::move(table_);
    const bool isForeign = !isOwnForm();
    if (isForeign) dropEmptyColumn();
    table_.isRecording = isForeign;
    if (isForeign) {
      const std::optional<std::size_t> column = timeColumn();
      if (!column || !makeTimes(*column)) return std::move(table_);
    }
    for (std::vector<CsvCell>& row : table_.rows) {
      for (CsvCell& cell : row) {
        const bool isMissing = isForeign && isMissingValue(cell.text);
        cell.text = isMissing ? std::string() : plainCell(cell.text, cellHasDecimalComma(cell));
      }
    }
    nameColumns();
    return std::move(table_);
  }

 private:
  void fail(const CsvCell& cell, std::string message, std::string help) {
    failures_.push_back(table_.at(cell, std::move(message), std::move(help)));
  }

  /// Between commas a quoted "1,234" may be 1.234 or 1234: it is left to the reader, who refuses it.
  bool cellHasDecimalComma(const CsvCell& cell) const {
    const std::size_t comma = cell.text.find(',');
    return hasDecimalComma_ || (comma != std::string::npos && cell.text.size() - comma != 4);
  }

  /// A separator at the end of every line.
  void dropEmptyColumn() {
    const auto isOpenEnd = [](const std::vector<CsvCell>& row) { return row.back().text.empty(); };
    while (table_.heading.size() > 1 && isOpenEnd(table_.heading) && std::ranges::all_of(table_.rows, isOpenEnd)) {
      table_.heading.pop_back();
      for (std::vector<CsvCell>& row : table_.rows) row.pop_back();
    }
  }

  bool isOwnForm() const {
    const std::string first = lowered(table_.heading[0].text);
    if (first != "scan" && first != "time_ms") return false;
    return import_.timeColumn.empty() || !columnNamed(import_.timeColumn);
  }

  std::optional<std::size_t> columnNamed(std::string_view name) const {
    const std::string lower = lowered(name);
    for (std::size_t i = 0; i < table_.heading.size(); ++i) {
      if (lowered(table_.heading[i].text) == lower) return i;
    }
    if (!areDigits(name) || name.size() > 4) return std::nullopt;
    const auto number = static_cast<std::size_t>(*numberIn(name));
    return number >= 1 && number <= table_.heading.size() ? std::optional(number - 1) : std::nullopt;
  }

  std::optional<std::size_t> timeColumn() {
    if (!import_.timeColumn.empty()) {
      if (const auto column = columnNamed(import_.timeColumn)) return column;
      std::vector<std::string> names;
      for (const CsvCell& cell : table_.heading) names.push_back(cell.text);
      const std::string_view meant = closest(import_.timeColumn, names);
      fail(table_.heading[0], fmt::format("no column is called '{}'", import_.timeColumn),
           meant.empty() ? fmt::format("give --time-column one of the {} headings, or its number", names.size())
                         : fmt::format("did you mean '{}'?", meant));
      return std::nullopt;
    }
    const std::string first = lowered(table_.heading[0].text);
    for (const std::string_view word : {"time", "zeit", "date", "datum", "timestamp", "uhrzeit", "t [", "t/", "t ("}) {
      if (first.starts_with(word)) return 0;
    }
    fail(table_.heading[0], fmt::format("the first column is '{}'", table_.heading[0].text),
         "name it 'scan' or 'time_ms', or say with --time-column which one holds the time");
    return std::nullopt;
  }

  /// Puts `time_ms` in front of the other columns. False: it cannot be read.
  bool makeTimes(std::size_t column) {
    std::optional<double> unit = unitOf(column);
    if (!table_.rows.empty() && isUnitRow(table_.rows.front(), column)) {
      if (!unit) unit = nanosecondsOf(bare(table_.rows.front()[column].text));
      table_.rows.erase(table_.rows.begin());
    }
    std::size_t taken = 1;
    std::vector<std::optional<double>> times;
    const bool isNumber = table_.rows.empty() || timeNumber(table_.rows.front()[column].text).has_value();
    if (isNumber) {
      if (!unit && !table_.rows.empty()) {
        fail(table_.heading[column], fmt::format("the column '{}' does not say its unit", table_.heading[column].text),
             "give --time-unit, such as --time-unit s");
        return false;
      }
      times = fromNumbers(column, unit.value_or(1));
    } else {
      taken = isSplitMoment(column) ? 2 : 1;
      times = fromMoments(column, taken == 2);
    }
    return keepTimes(column, taken, times);
  }

  std::optional<double> unitOf(std::size_t column) const {
    if (!import_.timeUnit.empty()) return nanosecondsOf(import_.timeUnit);
    return nanosecondsInHeading(table_.heading[column].text);
  }

  bool isUnitRow(const std::vector<CsvCell>& row, std::size_t column) const {
    if (nanosecondsOf(bare(row[column].text))) return true;
    return std::ranges::all_of(
        row, [](const CsvCell& cell) { return cell.text.empty() || bare(cell.text).size() != cell.text.size(); });
  }

  std::optional<double> timeNumber(const std::string& text) const { return numberIn(plainCell(text, true)); }

  std::vector<std::optional<double>> fromNumbers(std::size_t column, double unit) {
    std::vector<std::optional<double>> times;
    for (const std::vector<CsvCell>& row : table_.rows) {
      const std::optional<double> number = timeNumber(row[column].text);
      if (!number || !std::isfinite(*number))
        fail(row[column], fmt::format("'{}' is no time", row[column].text), "write a number, as in the rows above");
      times.push_back(number ? std::optional(*number * unit) : std::nullopt);
    }
    return times;
  }

  /// A date in this column and the time of day in the next one.
  bool isSplitMoment(std::size_t column) const {
    if (table_.rows.empty() || column + 1 >= table_.heading.size()) return false;
    const std::optional<Moment> date = momentIn(table_.rows.front()[column].text);
    const std::optional<Moment> time = momentIn(table_.rows.front()[column + 1].text);
    return date && date->hasDate && !date->hasTime && time && !time->hasDate;
  }

  std::vector<std::optional<double>> fromMoments(std::size_t column, bool isSplit) {
    constexpr double day = 86400e9;
    const bool dayFirst = std::ranges::any_of(
        table_.rows, [&](const std::vector<CsvCell>& row) { return needsDayFirst(row[column].text); });
    std::vector<std::optional<double>> times;
    double midnight = 0, last = 0;
    for (const std::vector<CsvCell>& row : table_.rows) {
      const std::string text = isSplit ? row[column].text + " " + row[column + 1].text : row[column].text;
      const std::optional<Moment> moment = momentIn(text, dayFirst);
      if (!moment || (moment->hasDate && !moment->hasTime && isSplit)) {
        fail(row[column], fmt::format("'{}' is no time", text),
             "write a number, or a date and time such as 2026-03-01 08:15:30.250 or 01.03.2026 08:15:30,250");
        times.emplace_back();
        continue;
      }
      double time = static_cast<double>(moment->us) * nanosecondsInUs + midnight;
      if (!moment->hasDate && time + day / 2 < last) {  // past midnight
        midnight += day;
        time += day;
      }
      last = time;
      times.emplace_back(time);
    }
    isDated_ = true;
    return times;
  }

  /// Dates, and times that begin before zero or long after it, count from the first row.
  bool keepTimes(std::size_t column, std::size_t taken, const std::vector<std::optional<double>>& times) {
    if (std::ranges::any_of(times, [](const std::optional<double>& time) { return !time; })) return false;
    const double first = times.empty() ? 0 : *times.front();
    const double zero = isDated_ || first < 0 || first >= epochFrom ? first : 0;
    const auto move = [&](std::vector<CsvCell>& row, std::string text) {
      CsvCell cell{std::move(text), row[column].line, row[column].column};
      row.erase(row.begin() + static_cast<std::ptrdiff_t>(column),
                row.begin() + static_cast<std::ptrdiff_t>(column + taken));
      row.insert(row.begin(), std::move(cell));
    };
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double ns = *times[i] - zero;
      if (ns < 0 || ns > largestTimeNs) {
        fail(table_.rows[i][column],
             ns < 0 ? fmt::format("'{}' is earlier than the first row", table_.rows[i][column].text)
                    : fmt::format("'{}' is too late", table_.rows[i][column].text),
             "rows must stand in ascending order, and a recording lasts at most eleven days");
        return false;
      }
      move(table_.rows[i], millisecondsText(static_cast<std::uint64_t>(std::llround(ns / nanosecondsInUs))));
    }
    move(table_.heading, "time_ms");
    return true;
  }

  void nameColumns() {
    std::vector<bool> isLeftOut(table_.heading.size(), false);
    for (std::size_t i = 0; i < table_.heading.size(); ++i) {
      const std::optional<std::string> name = import_.nameFor(table_.heading[i].text);
      if (!name) continue;
      isLeftOut[i] = *name == "-";
      if (!isLeftOut[i]) table_.heading[i].text = *name;
    }
    const auto thin = [&](std::vector<CsvCell>& row) {
      std::size_t at = 0;
      std::erase_if(row, [&](const CsvCell&) { return isLeftOut[at++]; });
    };
    for (std::vector<CsvCell>& row : table_.rows) thin(row);
    thin(table_.heading);
  }

  CsvTable table_;
  const TraceImport& import_;
  std::vector<Failure>& failures_;
  bool hasDecimalComma_;
  bool isDated_ = false;
};

}  // namespace

std::string plainCell(std::string_view text, bool hasDecimalComma) {
  const std::string lower = lowered(text);
  if (isOneOf(lower, {"on", "true", "high", "yes", "ein", "wahr", "ja"})) return "1";
  if (isOneOf(lower, {"off", "false", "low", "no", "aus", "falsch", "nein"})) return "0";
  if (lower.starts_with("0x")) return "16#" + std::string(text.substr(2));
  if (lower.starts_with("0b")) return "2#" + std::string(text.substr(2));
  if (lower.starts_with('$') && lower.size() > 1) return "16#" + std::string(text.substr(1));
  if (hasDecimalComma) return withoutDecimalComma(text).value_or(std::string(text));
  return std::string(text);
}

CsvTable readRecording(const std::string& name, std::string_view bytes, const TraceImport& import,
                       std::vector<Failure>& failures) {
  const DecodedText decoded = decode(bytes, TextEncoding::Auto);
  if (looksLikeVcd(decoded.text)) {
    CsvTable table = readVcd(name, decoded.text, import, failures);
    if (!table.heading.empty()) table.separator = ',';
    return Recording(std::move(table), import, failures).read();
  }
  const bool isNumber = areDigits(import.timeColumn);
  CsvTable table = readCsv(name, decoded.text, failures, {import.separator, isNumber ? "" : import.timeColumn});
  return Recording(std::move(table), import, failures).read();
}

}  // namespace rungproof
