// A form in which traces are written; one file of this folder each, chosen by file ending.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "engine/trace.hpp"

namespace rungproof {

struct TraceFormat {
  std::string_view ending;   ///< ".csv"
  std::string_view summary;  ///< for the help
  void (*write)(const Trace& trace, std::string_view title, std::ostream& out);
  /// Of a form that can be written while the run goes on: what stands in front of the rows of a trace without events
  /// and devices, and one row. nullptr: the whole trace has to be known.
  void (*appendHead)(const Trace& trace, std::string& text) = nullptr;
  void (*appendRow)(const Trace& trace, const TraceRow& row, std::string& text) = nullptr;
};

std::span<const TraceFormat* const> allTraceFormats();
/// The form for a file name, by its ending; nullptr: no form has that ending.
const TraceFormat* traceFormatOf(std::string_view fileName);
/// The same for the name of an output: "-", standard output, takes CSV.
const TraceFormat* traceFormatFor(std::string_view outputName);

/// "12.5": a time in ms without superfluous zeros.
std::string millisecondsText(std::uint64_t us);
void appendMilliseconds(std::uint64_t us, std::string& text);

}  // namespace rungproof
