// Traces as CSV: scan, time_ms at the end of the scan, scan_ms, event if interrupts are known, device if devices do
// only what stands there, given and start where a witness says all that the surroundings did, then one column per
// signal. Of two programs old.event and new.event, and so on, where these do not agree. The file is a stimulus as well:
// having time_ms behind scan, it is known as a recording (frontend/simulation/stimulus_reader.hpp). Tested by
// tests/trace/csv_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ostream>

#include "frontend/text/safe_text.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {

/// In any case of letters.
bool isCalled(std::string_view name, std::string_view lower) {
  return std::ranges::equal(name, lower,
                            [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// A column that only a run has, of the first program or of both, and of the second one.
struct RunColumn {
  std::string_view name;
  const std::string& (*text)(const Trace&, const TraceRow&, bool isNew);
  bool isShown = false;
  bool isSplit = false;  ///< the programs do not agree
};

using RunColumns = std::array<RunColumn, 4>;

RunColumns runColumns(const Trace& trace) {
  RunColumns columns = {{
      {"event",
       [](const Trace&, const TraceRow& row, bool isNew) -> const std::string& {
         return isNew ? row.newEvents : row.events;
       }},
      {"device",
       [](const Trace&, const TraceRow& row, bool isNew) -> const std::string& {
         return isNew ? row.newDevices : row.devices;
       }},
      {"given",
       [](const Trace&, const TraceRow& row, bool isNew) -> const std::string& {
         return isNew ? row.newGiven : row.given;
       }},
      {"start",
       [](const Trace& of, const TraceRow& row, bool isNew) -> const std::string& {
         static const std::string nothing;
         return row.scan != 1 ? nothing : isNew ? of.newStartValues : of.startValues;
       }},
  }};
  // A variable called Event is one only where the column stands in front of it.
  const bool hasNamesake = trace.isWhole && std::ranges::any_of(trace.signals, [](const TraceSignal& signal) {
                             return isCalled(signal.name, "event");
                           });
  columns[0].isShown = !trace.isByTime && (trace.hasEvents() || hasNamesake);
  columns[1].isShown = !trace.isByTime && trace.hasDevices;
  columns[2].isShown = columns[3].isShown = trace.isWhole;
  for (RunColumn& column : columns) {
    column.isSplit = trace.hasTwoSides && std::ranges::any_of(trace.rows, [&](const TraceRow& row) {
                       return column.text(trace, row, false) != column.text(trace, row, true);
                     });
  }
  return columns;
}

void appendHead(const Trace& trace, const RunColumns& columns, std::string& text) {
  text += trace.isByTime ? "time_ms" : "scan,time_ms,scan_ms";
  for (const RunColumn& column : columns) {
    if (!column.isShown) continue;
    text += column.isSplit ? fmt::format(",old.{0},new.{0}", column.name) : fmt::format(",{}", column.name);
  }
  for (const auto& [name, value] : trace.start) text += ',' + csvCell(name);
  for (const TraceSignal& signal : trace.signals) text += ',' + csvCell(signal.name);
  text += '\n';
}

void appendRow(const Trace& trace, const TraceRow& row, const RunColumns& columns, bool isFirst, std::string& text) {
  if (!trace.isByTime) {
    const fmt::format_int scan(row.scan);
    text.append(scan.data(), scan.size()) += ',';
  }
  appendMilliseconds(row.timeUs, text);
  if (!trace.isByTime) appendMilliseconds(row.scanUs, text += ',');
  for (const RunColumn& column : columns) {
    if (!column.isShown) continue;
    text += ',' + csvCell(column.text(trace, row, false));
    if (column.isSplit) text += ',' + csvCell(column.text(trace, row, true));
  }
  for (const auto& [name, value] : trace.start) text += ',' + (isFirst ? std::to_string(value) : "");
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    text += ',';
    if (row.values[i]) appendNumber(*row.values[i], trace.signals[i].type, text);
  }
  text += '\n';
}

void appendPlainHead(const Trace& trace, std::string& text) { appendHead(trace, {}, text); }
void appendPlainRow(const Trace& trace, const TraceRow& row, std::string& text) {
  appendRow(trace, row, {}, row.scan == 1, text);
}

void writeCsvTrace(const Trace& trace, std::string_view, std::ostream& out) {
  const RunColumns columns = runColumns(trace);
  std::string text;
  appendHead(trace, columns, text);
  for (const TraceRow& row : trace.rows) {
    appendRow(trace, row, columns, &row == trace.rows.data(), text);
    out << text;
    text.clear();
  }
  out << text;
}

}  // namespace

extern constexpr TraceFormat csvTrace = {.ending = ".csv",
                                         .summary = "comma-separated values, also a stimulus",
                                         .write = writeCsvTrace,
                                         .appendHead = appendPlainHead,
                                         .appendRow = appendPlainRow};

}  // namespace rungproof
