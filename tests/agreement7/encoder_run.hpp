// Scans of the transition system of an S7-300/400 program with random inputs, the engine beside it.
#pragma once

#include <functional>
#include <string>

#include "analysis/encoding/encoder.hpp"
#include "tests/differential/scan_agreement.hpp"

namespace rungproof::agreement7 {

/// `seen` hears each place with its value at the end of the first scan; may be empty.
AgreementOutcome compareWithEngine(const Program& program, std::uint64_t seed, int scans,
                                   const std::function<void(const Place&, std::uint64_t)>& seen = {},
                                   const Choices& choices = {});

}  // namespace rungproof::agreement7
