// Code of the program that nobody read: a body in a language that is not covered. What it may write is declared
// `hidden` and gets any value in any scan. That is not enough to believe a verdict: the code may also write in the
// middle of a scan. So nothing that depends on such a place is decided. Tested by tests/graphical/simatic_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "analysis/encoding/encoder.hpp"
#include "analysis/property.hpp"

namespace rungproof {

class HiddenCode {
 public:
  HiddenCode(const Program& program, const PropertySet& set);

  /// Why a verdict with these variables in its cone cannot be given, one line for each place; empty: it can.
  std::vector<std::string> reasons(const EncodedScan& encoding,
                                   const std::unordered_set<std::uint32_t>& variables) const;

 private:
  std::string placeOf(const ExternalRange& range) const;

  const Program& program_;
  std::vector<ExternalRange> ranges_;
  std::vector<std::string> shared_;  ///< places that code which is read writes too: then nothing is certain
};

/// Why no proof holds: an interrupt routine is attached whose events the encoding does not know.
std::optional<std::string> unfollowedRoutine(const Program& program, const EncodedScan& encoding);

}  // namespace rungproof
