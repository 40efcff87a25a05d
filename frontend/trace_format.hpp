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
};

std::span<const TraceFormat* const> allTraceFormats();
/// The form for a file name, by its ending; nullptr: no form has that ending.
const TraceFormat* traceFormatOf(std::string_view fileName);

/// "12.5": a time in ms without superfluous zeros.
std::string millisecondsText(std::uint64_t us);

}  // namespace rungproof
