// Tokens to variables and changes, changes to rows.
#include "frontend/logger/vcd_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "engine/trace.hpp"
#include "frontend/logger/trace_cell.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostCells = 20'000'000;  ///< of a table: about 1 GB
constexpr double largestUs = 1e15;
constexpr std::array<std::string_view, 9> opening = {"$date", "$version", "$timescale",      "$comment", "$scope",
                                                     "$var",  "$upscope", "$enddefinitions", "$dumpvars"};

struct Token {
  std::string_view text;
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

class TokenReader {
 public:
  explicit TokenReader(std::string_view text) : text_(text) {}
  bool next(Token& token) {
    while (at_ < text_.size() && isBlank(text_[at_])) {
      if (text_[at_] == '\n') {
        ++line_;
        lineBegin_ = at_ + 1;
      }
      ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
    token = {text_.substr(begin, at_ - begin), line_, static_cast<std::uint32_t>(begin - lineBegin_ + 1)};
    return at_ > begin;
  }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  std::string_view text_;
  std::size_t at_ = 0, lineBegin_ = 0;
  std::uint32_t line_ = 1;
};

struct VcdVariable {
  std::string path;  ///< scopes and name, with points between
  std::string name;  ///< without the scopes
  CsvCell place;     ///< of its name
  int width = 1;
  bool isReal = false;
  CsvCell now{};  ///< its value; open until it is told
};

class VcdReader {
 public:
  VcdReader(CsvTable& table, std::string_view text, const TraceImport& import, std::vector<Failure>& failures)
      : table_(table), tokens_(text), import_(import), failures_(failures) {}

  void run() {
    while (isReadable_ && tokens_.next(token_)) {
      const char sign = token_.text[0];
      if (sign == '$') {
        command();
      } else if (sign == '#') {
        moveTime();
      } else {
        change(sign);
      }
    }
    if (!isReadable_) return;
    if (variables_.empty()) return fail(Token{}, "the dump declares no variable", "export the signals again");
    endRow();
    nameColumns();
    finishScans();
  }

 private:
  void fail(const Token& token, std::string message, std::string help) {
    failures_.push_back(table_.at({{}, token.line, token.column}, std::move(message), std::move(help)));
    isReadable_ = isReadable_ && failures_.size() < mostFailures;
  }
  /// A failure behind which nothing can be understood.
  void stop(const Token& token, std::string message, std::string help) {
    fail(token, std::move(message), std::move(help));
    isReadable_ = false;
  }

  // Declarations ----------------------------------------------------------------------------------------------------

  /// The words up to $end.
  std::vector<Token> words() {
    const Token begin = token_;
    std::vector<Token> list;
    while (tokens_.next(token_)) {
      if (token_.text == "$end") return list;
      list.push_back(token_);
    }
    stop(begin, fmt::format("{} has no $end", begin.text), "the dump may be cut off; export it again");
    return list;
  }

  void command() {
    static constexpr std::array<std::string_view, 5> around = {"$dumpvars", "$dumpall", "$dumpon", "$dumpoff", "$end"};
    if (std::ranges::find(around, token_.text) != around.end()) return;  // the changes in it count as any other
    const Token begin = token_;
    const std::vector<Token> list = words();
    if (!isReadable_) return;
    if (begin.text == "$scope") {
      scopes_.emplace_back(list.size() < 2 ? std::string_view("scope") : list[1].text);
    } else if (begin.text == "$upscope") {
      if (!scopes_.empty()) scopes_.pop_back();
    } else if (begin.text == "$timescale") {
      readTimescale(begin, list);
    } else if (begin.text == "$version") {
      isOwn_ = !list.empty() && list[0].text == "rungproof";
    } else if (begin.text == "$comment") {
      readComment(list);
    } else if (begin.text == "$var") {
      declare(begin, list);
    }
  }

  void readTimescale(const Token& begin, const std::vector<Token>& list) {
    std::string text;
    for (const Token& word : list) text += word.text;
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    const std::optional<double> unit = nanosecondsOf(text.substr(digits));
    if (digits == 0 || digits > 4 || !unit)
      return fail(begin, fmt::format("'{}' is no time scale", text), "write for example $timescale 1 us $end");
    unitUs_ = *numberIn(text.substr(0, digits)) * *unit / 1000;
  }

  /// "Q0_0 = Q0.0 Motor": what rungproof calls its variables.
  void readComment(const std::vector<Token>& list) {
    if (!isOwn_) return;
    for (std::size_t i = 0; i + 2 < list.size(); ++i) {
      if (list[i + 1].text == "=" && list[i].line == list[i + 2].line)
        addresses_.emplace(list[i].text, list[i + 2].text);
    }
  }

  void declare(const Token& begin, const std::vector<Token>& list) {
    const std::optional<double> width = list.size() < 4 ? std::nullopt : numberIn(list[1].text);
    if (!width || *width < 1 || *width > 1e6 || *width != std::floor(*width))
      return fail(begin, "this $var does not name type, width, code and name", "write $var wire 1 ! start $end");
    VcdVariable variable;
    variable.name = list[3].text.substr(0, list[3].text.find('['));
    if (const auto found = addresses_.find(variable.name); found != addresses_.end()) variable.name = found->second;
    if (variable.name.starts_with("%QX") || variable.name.starts_with("%IX") || variable.name.starts_with("%MX"))
      variable.name = variable.name[1] + variable.name.substr(3);  // IEC 61131-3: %QX0.0 is Q0.0
    for (const std::string& scope : scopes_) variable.path += scope + ".";
    variable.path += variable.name;
    variable.place = {variable.name, list[3].line, list[3].column};
    variable.width = static_cast<int>(*width);
    variable.isReal = list[0].text == "real" || list[0].text == "realtime";
    byCode_[std::string(list[2].text)].push_back(variables_.size());
    variables_.push_back(std::move(variable));
  }

  // Changes ---------------------------------------------------------------------------------------------------------

  void moveTime() {
    const std::optional<double> number = numberIn(token_.text.substr(1));
    if (!number || *number < 0 || *number != std::floor(*number))
      return fail(token_, fmt::format("'{}' is no time", token_.text), "a time is # and a whole number");
    if (unitUs_ == 0 && !import_.timeUnit.empty()) unitUs_ = *nanosecondsOf(import_.timeUnit) / 1000;
    if (unitUs_ == 0) return stop(token_, "the dump has no $timescale", "give --time-unit, such as --time-unit us");
    const double us = std::floor(*number * unitUs_);
    if (us > largestUs) return stop(token_, fmt::format("'{}' is too late", token_.text), "the dump may be damaged");
    const auto time = static_cast<std::uint64_t>(us);
    if (hasTime_ && time < timeUs_)
      return fail(token_, fmt::format("the time '{}' is earlier than the one before", token_.text),
                  "times must stand in ascending order");
    if (hasTime_ && time > timeUs_) endRow();
    hasTime_ = true;
    timeUs_ = time;
    timePlace_ = {{}, token_.line, token_.column};
  }

  void change(char sign) {
    const Token value = token_;
    std::string_view text = value.text;
    Token code = value;
    const bool isVector = sign == 'b' || sign == 'B' || sign == 'r' || sign == 'R' || sign == 's' || sign == 'S';
    if (isVector) {
      text.remove_prefix(1);
      if (!tokens_.next(code)) return stop(value, "the dump ends within a change", "export it again");
    } else if (std::string_view("01xXzZuUwWlLhH-").find(sign) != std::string_view::npos && text.size() > 1) {
      code.text.remove_prefix(1);
      text = text.substr(0, 1);
    } else {
      return fail(
          value, fmt::format("'{}' is no change of a value", value.text),
          "a change is 0, 1, x or z and the code of a variable, or b1010 and r1.5 with the code behind a blank");
    }
    const auto found = byCode_.find(std::string(code.text));
    if (found == byCode_.end())
      return fail(code, fmt::format("no variable has the code '{}'", code.text), "declare it with $var");
    if (!hasTime_) hasTime_ = true;  // values before the first time stand at 0
    for (const std::size_t i : found->second) {
      VcdVariable& variable = variables_[i];
      variable.now = {cellText(value, text, sign, variable), value.line, value.column};
    }
  }

  std::string cellText(const Token& token, std::string_view text, char sign, const VcdVariable& variable) {
    if (sign == 's' || sign == 'S') return "";
    if (sign == 'r' || sign == 'R') {
      const std::optional<TraceNumber> number = numberIn(text);
      if (!number)
        fail(token, fmt::format("'{}' is no number", token.text), "write r and a decimal number, such as r1.5");
      return number && !std::isnan(*number) ? numberText(*number, SignalType::LongReal) : "";
    }
    if (text.empty() || text.find_first_not_of("01xXzZuUwWlLhH-") != std::string_view::npos) {
      fail(token, fmt::format("'{}' holds something else than 0, 1, x and z", token.text), "export the dump again");
      return "";
    }
    if (text.size() > static_cast<std::size_t>(variable.width) && text.find('1') != std::string_view::npos &&
        text.size() - text.find('1') > static_cast<std::size_t>(variable.width)) {
      fail(token, fmt::format("the value has more bits than {}, which has {}", variable.name, variable.width),
           "export the dump again");
      return "";
    }
    std::uint64_t bits = 0;
    for (const char c : text) {
      const char bit = c == 'H' || c == 'h' ? '1' : c == 'L' || c == 'l' ? '0' : c;
      if (bit != '0' && bit != '1') return "";
      if (bits >> 63 != 0) return "";
      bits = bits << 1 | static_cast<unsigned>(bit - '0');
    }
    const bool isSigned = variable.width == 16 || variable.width == 32;
    if (isSigned && bits >> (variable.width - 1) != 0)
      return std::to_string(static_cast<std::int64_t>(bits) - (std::int64_t{1} << variable.width));
    return std::to_string(bits);
  }

  // Rows --------------------------------------------------------------------------------------------------------------

  void endRow() {
    if (!hasTime_) return;
    if ((table_.rows.size() + 1) * (variables_.size() + 1) > mostCells)
      return stop(Token{}, "the dump is too large", "export fewer signals, or a shorter time");
    std::vector<CsvCell> row = {{millisecondsText(timeUs_), timePlace_.line, timePlace_.column}};
    for (const VcdVariable& variable : variables_) row.push_back(variable.now);
    table_.rows.push_back(std::move(row));
    times_.push_back(timeUs_);
  }

  void nameColumns() {
    std::map<std::string, int> uses;
    for (const VcdVariable& variable : variables_) ++uses[variable.name];
    table_.heading = {{"time_ms", 1, 1}};
    for (const VcdVariable& variable : variables_) {
      CsvCell cell = variable.place;
      if (uses[variable.name] > 1 || import_.nameFor(variable.path)) cell.text = variable.path;
      table_.heading.push_back(std::move(cell));
    }
  }

  /// What rungproof wrote: the variable `scan` counts them, and a scan lasts until the next one begins.
  void finishScans() {
    const auto counter = std::ranges::find(variables_, "scan", &VcdVariable::name);
    if (!isOwn_ || counter == variables_.end()) return;
    const auto column = static_cast<std::size_t>(counter - variables_.begin()) + 1;
    std::vector<std::vector<CsvCell>> scans;
    for (std::size_t i = 0; i + 1 < table_.rows.size(); ++i) {
      std::vector<CsvCell> row = std::move(table_.rows[i]);
      if (row[column].text.empty()) continue;
      const CsvCell scan = row[column];
      const CsvCell length{millisecondsText(times_[i + 1] - times_[i]), row[0].line, row[0].column};
      row[0].text = millisecondsText(times_[i + 1]);
      row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
      row.insert(row.begin(), scan);
      row.insert(row.begin() + 2, length);
      scans.push_back(std::move(row));
    }
    table_.rows = std::move(scans);
    table_.heading.erase(table_.heading.begin() + static_cast<std::ptrdiff_t>(column));
    table_.heading.insert(table_.heading.begin(), {"scan", 1, 1});
    table_.heading.insert(table_.heading.begin() + 2, {"scan_ms", 1, 1});
  }

  static constexpr std::size_t mostFailures = 100;
  CsvTable& table_;
  TokenReader tokens_;
  const TraceImport& import_;
  std::vector<Failure>& failures_;
  Token token_;
  std::vector<std::string> scopes_;
  std::vector<VcdVariable> variables_;
  std::unordered_map<std::string, std::vector<std::size_t>> byCode_;
  std::map<std::string, std::string, std::less<>> addresses_;  ///< of variables that rungproof named
  std::vector<std::uint64_t> times_;                           ///< of the rows, in us
  CsvCell timePlace_{};
  double unitUs_ = 0;  ///< of one step of time; 0: not known
  std::uint64_t timeUs_ = 0;
  bool hasTime_ = false, isOwn_ = false, isReadable_ = true;
};

}  // namespace

bool looksLikeVcd(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || text[begin] != '$') return false;
  const std::string_view word = text.substr(begin, text.find_first_of(" \t\r\n", begin) - begin);
  return std::ranges::find(opening, word) != opening.end();
}

CsvTable readVcd(const std::string& name, std::string_view text, const TraceImport& import,
                 std::vector<Failure>& failures) {
  CsvTable table;
  table.name = name;
  VcdReader(table, text, import, failures).run();
  return table;
}

}  // namespace rungproof
