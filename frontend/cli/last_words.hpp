// How the program ends where no command can answer any more: memory is over in a place that cannot give up, such as a
// destructor. Tested by tests/faults.
#pragma once

namespace rungproof {

/// What the program says when memory is over.
inline constexpr const char* outOfMemory = "ran out of memory";

/// From now on an exception that nobody catches ends the program: no part of a file is left, and where memory was over
/// it says so and ends with 2.
void prepareLastWords();

}  // namespace rungproof
