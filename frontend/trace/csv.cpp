// Traces as CSV: scan, time_ms at the end of the scan, scan_ms, event if interrupts are known (old.event and
// new.event where they come at different places of two programs), device if
// devices do only what stands there, given and start where a witness says all that the surroundings did, then one
// column per signal. The file is a stimulus as well: having time_ms behind scan, it is known as a recording
// (frontend/simulation/stimulus_reader.hpp). Tested by tests/trace/csv_test.cpp.
#include <fmt/format.h>

#include <ostream>

#include "frontend/text/safe_text.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {

void appendHead(const Trace& trace, std::string& text) {
  text += trace.isByTime ? "time_ms" : "scan,time_ms,scan_ms";
  if (!trace.isByTime && trace.hasEvents()) text += trace.hasTwoEvents ? ",old.event,new.event" : ",event";
  if (!trace.isByTime && trace.hasDevices) text += ",device";
  if (trace.isWhole) text += ",given,start";
  for (const auto& [name, value] : trace.start) text += ',' + csvCell(name);
  for (const TraceSignal& signal : trace.signals) text += ',' + csvCell(signal.name);
  text += '\n';
}

/// What a run alone tells stands between the times and the signals.
struct BesideSignals {
  bool hasEvents = false, hasDevices = false, isFirst = false;
};

void appendRow(const Trace& trace, const TraceRow& row, const BesideSignals& beside, std::string& text) {
  if (!trace.isByTime) {
    const fmt::format_int scan(row.scan);
    text.append(scan.data(), scan.size()) += ',';
  }
  appendMilliseconds(row.timeUs, text);
  if (!trace.isByTime) appendMilliseconds(row.scanUs, text += ',');
  if (beside.hasEvents) text += ',' + csvCell(row.events);
  if (beside.hasEvents && trace.hasTwoEvents) text += ',' + csvCell(row.newEvents);
  if (beside.hasDevices) text += ',' + csvCell(row.devices);
  if (trace.isWhole) text += ',' + csvCell(row.given) + ',' + (beside.isFirst ? csvCell(trace.startValues) : "");
  for (const auto& [name, value] : trace.start) text += ',' + (beside.isFirst ? std::to_string(value) : "");
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    text += ',';
    if (row.values[i]) appendNumber(*row.values[i], trace.signals[i].type, text);
  }
  text += '\n';
}

void appendPlainRow(const Trace& trace, const TraceRow& row, std::string& text) {
  appendRow(trace, row, {.isFirst = row.scan == 1}, text);
}

void write(const Trace& trace, std::string_view, std::ostream& out) {
  BesideSignals beside{!trace.isByTime && trace.hasEvents(), !trace.isByTime && trace.hasDevices};
  std::string text;
  appendHead(trace, text);
  for (const TraceRow& row : trace.rows) {
    beside.isFirst = &row == trace.rows.data();
    appendRow(trace, row, beside, text);
    out << text;
    text.clear();
  }
  out << text;
}

}  // namespace

extern constexpr TraceFormat csvTrace = {.ending = ".csv",
                                         .summary = "comma-separated values, also a stimulus",
                                         .write = write,
                                         .appendHead = appendHead,
                                         .appendRow = appendPlainRow};

}  // namespace rungproof
