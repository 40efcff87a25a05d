// Cells of stimulus and trace files: numbers in the forms of the S7-200, checked against the signal they belong to.
// Tested by tests/trace/stimulus_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/trace.hpp"

namespace rungproof {

/// "1", "-20", "16#FF", "2#1010", "1.5", "true"; nothing if it is no number.
std::optional<TraceNumber> numberIn(std::string_view text);

/// The value of a cell as its signal shows it (16#FFFF in a word: -1), or nothing and the reason why it has none.
std::optional<TraceNumber> valueIn(std::string_view text, const TraceSignal& signal, std::string& reason);

/// ASCII letters in lower case.
std::string lowered(std::string_view text);

}  // namespace rungproof
