// Traces as CSV: scan, time_ms at the end of the scan, scan_ms, event if interrupts are known (old.event and
// new.event where they come at different places of two programs), device if
// devices do only what stands there, then one column per signal. The file is a stimulus as well: having time_ms behind
// scan, it is known as a recording (frontend/simulation/stimulus_reader.hpp). Tested by tests/trace/csv_test.cpp.
#include <ostream>

#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

void write(const Trace& trace, std::string_view, std::ostream& out) {
  const bool hasEvents = !trace.isByTime && trace.hasEvents();
  const bool hasDevices = !trace.isByTime && trace.hasDevices;
  out << (trace.isByTime ? "time_ms" : "scan,time_ms,scan_ms")
      << (!hasEvents           ? ""
          : trace.hasTwoEvents ? ",old.event,new.event"
                               : ",event")
      << (hasDevices ? ",device" : "");
  for (const auto& [name, value] : trace.start) out << ',' << name;
  for (const TraceSignal& signal : trace.signals) out << ',' << quoted(signal.name);
  out << '\n';
  for (const TraceRow& row : trace.rows) {
    if (!trace.isByTime) out << row.scan << ',';
    out << millisecondsText(row.timeUs);
    if (!trace.isByTime) out << ',' << millisecondsText(row.scanUs);
    if (hasEvents) out << ',' << quoted(row.events);
    if (hasEvents && trace.hasTwoEvents) out << ',' << quoted(row.newEvents);
    if (hasDevices) out << ',' << quoted(row.devices);
    for (const auto& [name, value] : trace.start)
      out << ',' << (&row == trace.rows.data() ? std::to_string(value) : "");
    for (std::size_t i = 0; i < trace.signals.size(); ++i) {
      out << ',';
      if (row.values[i]) out << numberText(*row.values[i], trace.signals[i].type);
    }
    out << '\n';
  }
}

}  // namespace

extern constexpr TraceFormat csvTrace = {
    .ending = ".csv", .summary = "comma-separated values, also a stimulus", .write = write};

}  // namespace rungproof
