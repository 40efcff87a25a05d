// Look-up of trace forms.
#include "frontend/trace_format.hpp"

#include <fmt/format.h>

#include <iterator>

namespace rungproof {

const TraceFormat* traceFormatOf(std::string_view fileName) {
  for (const TraceFormat* format : allTraceFormats()) {
    if (fileName.size() > format->ending.size() && fileName.ends_with(format->ending)) return format;
  }
  return nullptr;
}

const TraceFormat* traceFormatFor(std::string_view outputName) {
  return traceFormatOf(outputName == "-" ? "-.csv" : outputName);
}

std::string millisecondsText(std::uint64_t us) {
  std::string text;
  appendMilliseconds(us, text);
  return text;
}

void appendMilliseconds(std::uint64_t us, std::string& text) {
  const fmt::format_int whole(us / 1000);
  text.append(whole.data(), whole.size());
  if (us % 1000 == 0) return;
  fmt::format_to(std::back_inserter(text), ".{:03}", us % 1000);
  text.erase(text.find_last_not_of('0') + 1);
}

}  // namespace rungproof
