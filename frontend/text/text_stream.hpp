// A stream into a string. Tested by tests/faults.
#pragma once

#include <sstream>

namespace rungproof {

/// Throws where memory ends: a usual stream drops the rest of its text in silence.
class TextStream : public std::ostringstream {
 public:
  TextStream() { exceptions(std::ios::badbit); }
};

}  // namespace rungproof
