// Durations that people write in comments and names: "5 s", "1,5 sec", "50x100ms", "2 Minuten", "100 мс", "5秒", and
// whether they speak of a time base ("10 ms timer", "Zeitbasis", "база времени", "时基"). English, German, Russian and
// Chinese. What is written together with letters ("S5", "T37", "3rd") is none. Tested by tests/rules/duration_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof {

struct WrittenDuration {
  std::int64_t us = 0;      ///< microseconds
  std::string text;         ///< as it is written: "50x100ms"
  std::size_t offset = 0;   ///< in the text
  bool isTimeBase = false;  ///< a word beside it says that it is the resolution of a timer
};

/// The durations of a text in UTF-8, in its order.
std::vector<WrittenDuration> durationsIn(std::string_view text);
/// The durations in a name such as Delay_5s or T_500ms: a part between underscores, or its end.
std::vector<WrittenDuration> durationsInName(std::string_view name);

}  // namespace rungproof
