// Scans of the transition system of an S7-300/400 program with random inputs, the engine beside it.
#pragma once

#include <functional>
#include <string>

#include "analysis/encoding/encoder.hpp"
#include "analysis/encoding/symbolic_store.hpp"

namespace rungproof::agreement7 {

struct EncoderOutcome {
  std::string difference;     ///< empty: the engine is in the same state after every scan
  int scans = 0;              ///< that were compared
  bool isExact = true;        ///< false: the encoding is an estimate in the first scan already
  std::string approximation;  ///< why
};

/// `seen` hears each place with its value at the end of the first scan; may be empty.
EncoderOutcome compareWithEngine(const Program& program, std::uint64_t seed, int scans,
                                 const std::function<void(const Place&, std::uint64_t)>& seen = {},
                                 const Choices& choices = {});

}  // namespace rungproof::agreement7
