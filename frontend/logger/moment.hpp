// Moments as loggers write them: ISO 8601, German and US dates with a time of day, or a time of day alone.
// Tested by tests/trace/logger_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rungproof {

struct Moment {
  std::int64_t us = 0;  ///< with a date: since 1970-01-01 00:00, as the clock on the wall shows it, or UTC if the text
                        ///< names its offset; without: since midnight
  bool hasDate = false;
  bool hasTime = false;
};

/// "2026-03-01T08:15:30.250+01:00", "2026/03/01 08:15:30", "01.03.2026 08:15:30,250", "3/1/2026 8:15:30.250 AM",
/// "08:15:30,250". Of "3/1/2026" the month comes first unless it cannot be one, or `dayFirst` is given. Nothing for
/// anything else, or a day or an hour that does not exist.
std::optional<Moment> momentIn(std::string_view text, bool dayFirst = false);
/// Whether a date with strokes can only be read with its day first: 31/12/2026.
bool needsDayFirst(std::string_view text);

}  // namespace rungproof
