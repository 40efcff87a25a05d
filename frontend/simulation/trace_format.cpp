// Look-up of trace forms.
#include "frontend/trace_format.hpp"

#include <fmt/format.h>

namespace rungproof {

const TraceFormat* traceFormatOf(std::string_view fileName) {
  for (const TraceFormat* format : allTraceFormats()) {
    if (fileName.size() > format->ending.size() && fileName.ends_with(format->ending)) return format;
  }
  return nullptr;
}

std::string millisecondsText(std::uint64_t us) {
  if (us % 1000 == 0) return fmt::format("{}", us / 1000);
  std::string text = fmt::format("{}.{:03}", us / 1000, us % 1000);
  text.erase(text.find_last_not_of('0') + 1);
  return text;
}

}  // namespace rungproof
