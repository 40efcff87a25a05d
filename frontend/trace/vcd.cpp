// Traces as value change dump (IEEE 1364, clause 18), for waveform viewers. Names are made of letters, digits and '_'
// because strict readers take nothing else; a $comment gives the address and symbol of each. Time 0 is power-up, where
// all values are unknown; every scan shows its values at its end. Tested by tests/trace/drawing_test.cpp.
#include <fmt/format.h>

#include <ostream>
#include <set>

#include "frontend/trace/format.hpp"

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

std::string change(const TraceSignal& signal, const std::optional<double>& value, const std::string& id) {
  if (signal.isReal()) return fmt::format("r{:.16g} {}\n", value.value_or(0), id);
  if (signal.width() == 1) return fmt::format("{}{}\n", !value ? 'x' : *value != 0 ? '1' : '0', id);
  if (!value) return fmt::format("bx {}\n", id);
  return fmt::format("b{:b} {}\n", valueOf(*value, signal.type, signal.width()), id);
}

std::string_view variableType(const TraceSignal& signal) { return signal.isReal() ? "real" : "wire"; }

void write(const Trace& trace, std::string_view title, std::ostream& out) {
  bool wholeMs = true;
  for (const TraceRow& row : trace.rows) wholeMs = wholeMs && row.timeUs % 1000 == 0;
  out << "$version rungproof $end\n$timescale 1 " << (wholeMs ? "ms" : "us") << " $end\n";
  std::set<std::string> taken;
  const std::string_view file = title.substr(title.find_last_of("/\\") + 1);
  const std::string scope = plainName(std::string(file.empty() ? "program" : file), taken);
  std::string names = "$comment\n", variables;
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    const TraceSignal& signal = trace.signals[i];
    const std::string plain = plainName(signal.name, taken);
    names += fmt::format("  {} = {}{}{}\n", plain, signal.name, signal.symbol.empty() ? "" : " ", signal.symbol);
    variables += fmt::format("$var {} {} {} {} $end\n", variableType(signal), signal.isReal() ? 64 : signal.width(),
                             identifier(i), plain);
  }
  out << names << "$end\n$scope module " << scope << " $end\n" << variables << "$upscope $end\n$enddefinitions $end\n";

  std::vector<std::string> last;
  out << "#0\n$dumpvars\n";
  const bool startsAtZero = !trace.rows.empty() && trace.rows[0].timeUs == 0;
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    last.push_back(change(trace.signals[i], startsAtZero ? trace.rows[0].values[i] : std::nullopt, identifier(i)));
    out << last.back();
  }
  out << "$end\n";
  std::uint64_t shown = 0;
  for (const TraceRow& row : trace.rows) {
    const std::uint64_t time = wholeMs ? row.timeUs / 1000 : row.timeUs;
    for (std::size_t i = 0; i < trace.signals.size(); ++i) {
      const std::string now = change(trace.signals[i], row.values[i], identifier(i));
      if (now == last[i]) continue;
      if (time != shown) out << '#' << time << '\n';
      shown = time;
      out << now;
      last[i] = now;
    }
  }
  const std::uint64_t end = trace.rows.empty() ? 0 : trace.rows.back().timeUs / (wholeMs ? 1000 : 1);
  if (end > shown) out << '#' << end << '\n';
}

}  // namespace

extern constexpr TraceFormat vcdTrace = {
    .ending = ".vcd", .summary = "value change dump for waveform viewers", .write = write};

}  // namespace rungproof
