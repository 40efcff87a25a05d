// Traces as value change dump (IEEE 1364, clause 18), for waveform viewers. Names are made of letters, digits and '_'
// because strict readers take nothing else; a $comment gives the address and symbol of each. The values of a scan are
// shown from its beginning to its end, the variable `scan` counts them, and the last time is the end of the last scan.
// frontend/logger/vcd_reader.hpp reads it back. Tested by tests/trace/drawing_test.cpp and tests/trace/vcd_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <set>

#include "frontend/text/safe_text.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {

/// Short identifier of the n-th variable: printable characters '!' to '~'.
std::string identifier(std::size_t n) {
  std::string text;
  do {
    text += static_cast<char>('!' + n % 94);
    n /= 94;
  } while (n != 0);
  return text;
}

std::string plainName(const std::string& name, std::set<std::string>& taken) {
  std::string plain;
  for (const char c : name) {
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    plain += isPlain ? c : '_';
  }
  if (plain.empty() || (plain[0] >= '0' && plain[0] <= '9')) plain = "_" + plain;
  while (!taken.insert(plain).second) plain += "_";
  return plain;
}

std::string change(const TraceSignal& signal, const std::optional<TraceNumber>& value, const std::string& id) {
  if (signal.isReal())
    return value ? fmt::format("r{:.{}g} {}\n", static_cast<double>(*value),
                               signal.type == SignalType::LongReal ? 17 : 16, id)
                 : fmt::format("rnan {}\n", id);
  if (signal.width() == 1) return fmt::format("{}{}\n", !value ? 'x' : *value != 0 ? '1' : '0', id);
  if (!value) return fmt::format("bx {}\n", id);
  return fmt::format("b{:b} {}\n", valueOf(*value, signal.type, signal.width()), id);
}

std::string_view variableType(const TraceSignal& signal) { return signal.isReal() ? "real" : "wire"; }

/// "Q0.0 Motor" for the list of names; what the signal is called if no program explains it.
std::string meaningOf(const TraceSignal& signal) {
  if (!signal.operand.isMemory()) return signal.name;
  const bool isValue = hasBitAndWord(signal.operand.area) && signal.operand.width != Width::Bit;
  const std::string address = toString(signal.operand) + (isValue ? ".value" : "");
  const std::string& symbol = signal.symbol.empty() && signal.name != address ? signal.name : signal.symbol;
  return address + (symbol.empty() ? "" : " ") + symbol;
}

/// A name within $comment, which the word $end ends.
std::string commentText(const std::string& text) {
  std::string line = lineText(text);
  for (std::size_t at = line.find("$end"); at != std::string::npos; at = line.find("$end", at))
    line.insert(at + 1, 1, '_');
  return line;
}

/// The variables, their changes, and the times at which scans begin; a trace keyed by time has no scans.
class Dump {
 public:
  Dump(const Trace& trace, std::ostream& out) : trace_(trace), out_(out) {
    for (std::size_t r = 0; r < trace.rows.size(); ++r) {
      const TraceRow& row = trace.rows[r];
      const std::uint64_t length = row.scanUs == 0 ? row.timeUs : std::min<std::uint64_t>(row.scanUs, row.timeUs);
      const std::uint64_t before = r == 0 ? row.timeUs - length : trace.rows[r - 1].timeUs;
      starts_.push_back(trace.isByTime ? row.timeUs : before);
      wholeMs_ = wholeMs_ && starts_.back() % 1000 == 0 && row.timeUs % 1000 == 0;
    }
  }

  void write(std::string_view title) {
    declare(title);
    const bool startsAtZero = !starts_.empty() && starts_[0] == 0;
    out_ << "#0\n$dumpvars\n";
    if (!trace_.isByTime) put(0, startsAtZero ? std::optional<std::size_t>(0) : std::nullopt);
    for (std::size_t i = 0; i < trace_.signals.size(); ++i) putSignal(i, startsAtZero ? 0 : none);
    out_ << "$end\n";
    std::uint64_t shown = 0;
    for (std::size_t r = startsAtZero ? 1 : 0; r < trace_.rows.size(); ++r) {
      time_ = starts_[r] / (wholeMs_ ? 1000 : 1);
      isTimeShown_ = time_ == shown;
      if (!trace_.isByTime) put(0, r);
      for (std::size_t i = 0; i < trace_.signals.size(); ++i) putSignal(i, r);
      if (isTimeShown_) shown = time_;
    }
    const std::uint64_t end = trace_.rows.empty() ? 0 : trace_.rows.back().timeUs / (wholeMs_ ? 1000 : 1);
    if (end > shown) out_ << '#' << end << '\n';
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  void declare(std::string_view title) {
    out_ << "$version rungproof $end\n$timescale 1 " << (wholeMs_ ? "ms" : "us") << " $end\n";
    std::set<std::string> taken{"scan"};
    const std::string_view file = title.substr(title.find_last_of("/\\") + 1);
    const std::string scope = plainName(std::string(file.empty() ? "program" : file), taken);
    std::string names = "$comment\n", variables;
    if (!trace_.isByTime) variables = fmt::format("$var wire 32 {} scan $end\n", identifier(0));
    for (std::size_t i = 0; i < trace_.signals.size(); ++i) {
      const TraceSignal& signal = trace_.signals[i];
      const std::string plain = plainName(signal.name, taken);
      names += fmt::format("  {} = {}\n", plain, commentText(meaningOf(signal)));
      variables += fmt::format("$var {} {} {} {} $end\n", variableType(signal), signal.isReal() ? 64 : signal.width(),
                               codeOf(i), plain);
    }
    out_ << names << "$end\n$scope module " << scope << " $end\n"
         << variables << "$upscope $end\n$enddefinitions $end\n";
    last_.assign(trace_.signals.size() + 1, "");
  }

  std::string codeOf(std::size_t signal) const { return identifier(signal + (trace_.isByTime ? 0 : 1)); }
  void putText(std::size_t slot, const std::string& now) {
    if (now == last_[slot]) return;
    if (!isTimeShown_) out_ << '#' << time_ << '\n';
    isTimeShown_ = true;
    out_ << now;
    last_[slot] = now;
  }
  /// The number of the scan.
  void put(std::size_t slot, std::optional<std::size_t> row) {
    putText(slot, row ? fmt::format("b{:b} {}\n", trace_.rows[*row].scan, identifier(0))
                      : fmt::format("bx {}\n", identifier(0)));
  }
  void putSignal(std::size_t i, std::size_t row) {
    putText(i + 1, change(trace_.signals[i], row == none ? std::nullopt : trace_.rows[row].values[i], codeOf(i)));
  }

  const Trace& trace_;
  std::ostream& out_;
  std::vector<std::uint64_t> starts_;  ///< by row: from when on its values are shown, in us
  std::vector<std::string> last_;
  bool wholeMs_ = true;
  bool isTimeShown_ = true;
  std::uint64_t time_ = 0;
};

void writeVcdTrace(const Trace& trace, std::string_view title, std::ostream& out) { Dump(trace, out).write(title); }

}  // namespace

extern constexpr TraceFormat vcdTrace = {
    .ending = ".vcd", .summary = "value change dump for waveform viewers", .write = writeVcdTrace};

}  // namespace rungproof
