// Cells to steps, and back.
#include "frontend/testing/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "frontend/files/encoding.hpp"
#include "frontend/logger/csv_table.hpp"
#include "frontend/logger/recording.hpp"
#include "frontend/logger/trace_cell.hpp"
#include "frontend/settings/options.hpp"
#include "frontend/simulation/run_limits.hpp"
#include "frontend/simulation/stimulus_column.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

constexpr std::string_view setPrefix = "set ", expectPrefix = "expect ";
constexpr std::uint64_t longestWaitUs = 86'400'000'000;  // a day

std::string_view strippedCell(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool isOpenCell(std::string_view text) { return text.empty() || text == "x" || text == "X"; }

/// "2,5s" of a table whose cells are not separated by commas.
std::string withDecimalPoint(std::string text) {
  if (std::ranges::count(text, ',') == 1) std::ranges::replace(text, ',', '.');
  return text;
}

class TestTableReader {
 public:
  TestTableReader(CsvTable table, const Program& program, std::vector<Failure>& failures)
      : table_(std::move(table)), program_(program), failures_(failures) {}

  TestTable read() {
    result_.file = table_.name;
    const std::size_t before = failures_.size();
    readHeading();
    if (failures_.size() > before) return std::move(result_);
    for (const std::vector<CsvCell>& cells : table_.rows) readRow(cells);
    if (table_.rows.empty())
      failures_.push_back({"the test table has no step", table_.name, "write a row for each step below the heading"});
    return std::move(result_);
  }

 private:
  void fail(const CsvCell& cell, std::string message, std::string help) {
    failures_.push_back(table_.at(cell, std::move(message), std::move(help)));
  }
  /// The same, with the heading of the column.
  void failIn(std::size_t column, const CsvCell& cell, const std::string& message, std::string help) {
    fail(cell, fmt::format("column '{}': {}", table_.heading[column].text, message), std::move(help));
  }

  void readHeading() {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < table_.heading.size(); ++i) {
      const CsvCell& cell = table_.heading[i];
      const std::string name = lowered(strippedCell(cell.text));
      if (!seen.insert(name).second) {
        fail(cell, fmt::format("column '{}' stands here twice", cell.text), "take one of the two out");
      } else if (name == "test" || name == "step" || name == "wait" || name == "note") {
        own_[name] = i;
      } else if (name.starts_with(setPrefix)) {
        addSet(i, strippedCell(std::string_view(cell.text).substr(setPrefix.size())));
      } else if (name.starts_with(expectPrefix)) {
        addExpect(i, strippedCell(std::string_view(cell.text).substr(expectPrefix.size())));
      } else {
        fail(cell,
             name.empty() ? "this column has no heading" : fmt::format("'{}' is no column of a test table", cell.text),
             "columns are: test, step, wait, set ADDRESS, expect ADDRESS, note");
      }
    }
    if (!own_.contains("test") && !table_.heading.empty())
      fail(table_.heading[0], "the table has no column 'test'", "name the tests in a column 'test'");
    if (setColumns_.empty() && expectColumns_.empty() && !table_.heading.empty() && failures_.empty())
      fail(table_.heading[0], "the table sets nothing and expects nothing",
           "add columns such as 'set I0.0' and 'expect Q0.0'");
  }

  void addSet(std::size_t index, std::string_view name) {
    Failure failure;
    std::optional<StimulusColumn> column = stimulusColumn(program_, std::string(name), false, failure);
    if (column && column->target == StimulusTarget::Characters) {
      column.reset();
      failure = {fmt::format("{} cannot be set by a test table", name), {}, "give characters in a stimulus of 'sim'"};
    }
    if (!column) {
      Failure unnamed;
      const std::optional<TraceSignal> signal = signalNamed(program_, name, unnamed);
      if (signal && isOutputColumn(signal->operand))
        failure = {fmt::format("{} is an output: the program drives it, a test does not", name),
                   {},
                   fmt::format("write 'expect {}' to compare it", name)};
      return fail(table_.heading[index], failure.message, failure.help);
    }
    if (const StimulusColumn* const other = sharedWith(result_.sets, *column)) {
      const auto at = static_cast<std::size_t>(other - result_.sets.data());
      fail(table_.heading[index], samePlaceText(table_.heading[setColumns_[at]].text, table_.heading[index].text),
           "take one of the two out");
    }
    result_.sets.push_back(std::move(*column));
    setColumns_.push_back(index);
  }

  void addExpect(std::size_t index, std::string_view name) {
    Failure failure;
    const std::optional<TraceSignal> signal = signalNamed(program_, name, failure);
    if (!signal) return fail(table_.heading[index], failure.message, failure.help);
    result_.expects.push_back(*signal);
    expectColumns_.push_back(index);
  }

  std::string cell(const std::vector<CsvCell>& cells, const char* column) const {
    const auto at = own_.find(column);
    return at == own_.end() ? std::string() : std::string(strippedCell(cells[at->second].text));
  }

  void readRow(const std::vector<CsvCell>& cells) {
    const std::string name = cell(cells, "test");
    if (name.empty() && result_.tests.empty())
      return failIn(own_.at("test"), cells[own_.at("test")], "the first step has no test",
                    "write the name of the test");
    if (!name.empty() && (result_.tests.empty() || result_.tests.back().name != name))
      result_.tests.push_back({name, {}});
    TestRow row;
    row.line = cells[0].line;
    row.step = cell(cells, "step");
    row.note = cell(cells, "note");
    if (const std::string wait = cell(cells, "wait"); !wait.empty()) {
      if (const auto read = waitNamed(table_.separator == ',' ? wait : withDecimalPoint(wait)))
        row.wait = *read;
      else
        failIn(own_.at("wait"), cells[own_.at("wait")], fmt::format("'{}' is no wait", wait),
               "write '1 scan', '5 scans' or a time such as '500ms', at most a day");
    }
    for (std::size_t i = 0; i < setColumns_.size(); ++i)
      row.sets.push_back(value(setColumns_[i], cells[setColumns_[i]], result_.sets[i].signal));
    for (std::size_t i = 0; i < expectColumns_.size(); ++i)
      row.expects.push_back(range(expectColumns_[i], cells[expectColumns_[i]], result_.expects[i]));
    result_.tests.back().rows.push_back(std::move(row));
  }

  std::optional<TraceNumber> number(std::size_t column, const CsvCell& cell, std::string_view text,
                                    const TraceSignal& signal) {
    std::string reason;
    const std::string plain = plainCell(strippedCell(text), table_.separator != ',');
    std::optional<TraceNumber> result = valueIn(plain, signal, reason);
    if (!result)
      failIn(column, cell, reason,
             signal.type == SignalType::Bool ? "write 0 or 1, or leave the cell empty"
                                             : "write a number of its type, or leave the cell empty");
    // A REAL is compared as the controller holds it.
    if (result && (signal.type == SignalType::Real || signal.type == SignalType::LongReal))
      result = numberOf(valueOf(*result, signal.type, signal.width()), signal.type, signal.width());
    return result;
  }

  std::optional<TraceNumber> value(std::size_t column, const CsvCell& cell, const TraceSignal& signal) {
    return isOpenCell(cell.text) ? std::nullopt : number(column, cell, cell.text, signal);
  }

  std::optional<TestRange> range(std::size_t column, const CsvCell& cell, const TraceSignal& signal) {
    if (isOpenCell(cell.text)) return std::nullopt;
    const std::size_t dots = cell.text.find("..");
    if (dots == std::string::npos) {
      const std::optional<TraceNumber> one = number(column, cell, cell.text, signal);
      return one ? std::optional(TestRange{*one, *one}) : std::nullopt;
    }
    const std::optional<TraceNumber> low = number(column, cell, std::string_view(cell.text).substr(0, dots), signal);
    const std::optional<TraceNumber> high = number(column, cell, std::string_view(cell.text).substr(dots + 2), signal);
    if (!low || !high) return std::nullopt;
    if (*low > *high) {
      failIn(column, cell, fmt::format("the range {} is empty", cell.text), "write the lower end first: 100..200");
      return std::nullopt;
    }
    return TestRange{*low, *high};
  }

  CsvTable table_;
  const Program& program_;
  std::vector<Failure>& failures_;
  TestTable result_;
  std::map<std::string, std::size_t> own_;
  std::vector<std::size_t> setColumns_, expectColumns_;
};

}  // namespace

std::optional<TestWait> waitNamed(std::string_view text) {
  const std::string lower = lowered(strippedCell(text));
  const std::size_t digits = std::min(lower.find_first_not_of("0123456789"), lower.size());
  const std::string_view unit = strippedCell(std::string_view(lower).substr(digits));
  if (digits > 0 && (unit == "scan" || unit == "scans")) {
    std::uint64_t scans = 0;
    const auto [end, error] = std::from_chars(lower.data(), lower.data() + digits, scans);
    if (error != std::errc() || scans < 1 || scans > mostScans) return std::nullopt;
    return TestWait{scans, 0};
  }
  std::string joined = lower;
  std::erase(joined, ' ');
  const std::optional<Duration> time = durationNamed(joined);
  if (!time || time->count() <= 0 || static_cast<std::uint64_t>(time->count()) > longestWaitUs) return std::nullopt;
  return TestWait{1, static_cast<std::uint64_t>(time->count())};
}

TestTable readTestTable(const std::string& name, std::string_view bytes, const Program& program, char separator,
                        std::vector<Failure>& failures) {
  const std::size_t before = failures.size();
  CsvTable table = readCsv(name, decode(bytes, TextEncoding::Auto).text, failures,
                           {.separator = separator,
                            .helpIfEmpty = "begin with a heading: 'test', 'step', 'wait', 'set ADDRESS' and 'expect "
                                           "ADDRESS'"});
  if (failures.size() > before) return {};
  return TestTableReader(std::move(table), program, failures).read();
}

std::string testTableText(const TestTable& table) {
  std::string text = "test,step,wait";
  for (const StimulusColumn& column : table.sets) text += "," + csvCell("set " + column.signal.name);
  for (const TraceSignal& signal : table.expects) text += "," + csvCell("expect " + signal.name);
  text += ",note\n";
  for (const TestCase& test : table.tests) {
    for (const TestRow& row : test.rows) {
      text += csvCell(test.name) + "," + csvCell(row.step) + "," + waitText(row.wait);
      for (std::size_t i = 0; i < table.sets.size(); ++i)
        text += "," + (row.sets[i] ? numberText(*row.sets[i], table.sets[i].signal.type) : std::string());
      for (std::size_t i = 0; i < table.expects.size(); ++i)
        text += "," + (row.expects[i] ? rangeText(*row.expects[i], table.expects[i].type) : std::string());
      text += "," + csvCell(row.note) + "\n";
    }
  }
  return text;
}

}  // namespace rungproof
