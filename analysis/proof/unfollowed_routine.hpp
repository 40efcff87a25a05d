// Code that the encoding does not follow: a routine is attached whose events it does not know. Code that nobody read is
// analysis/unread/unread_code.hpp. Tested by tests/prover.
#pragma once

#include <optional>
#include <string>

#include "analysis/encoding/encoder.hpp"

namespace rungproof {

/// Why no proof holds: an interrupt routine is attached whose events the encoding does not know.
std::optional<std::string> unfollowedRoutine(const Program& program, const EncodedScan& encoding);

}  // namespace rungproof
