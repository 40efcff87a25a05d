// One obligation put to all provers, turn by turn, so that what else the machine does meets all of them.
#pragma once

#include "tests/bench/peers/comparison.hpp"

namespace rungproof::peers {

struct Measurement {
  std::string rungproof;         ///< the program
  std::filesystem::path folder;  ///< for exports
  double limit = 20;             ///< s of processor time for each run
  int rounds = 3;                ///< for provers that take little time; the least counts
  /// Peers are cut at so many times the time in which we have settled the obligation (but not below 1 s), and charged
  /// that, which favours them; 0: at the limit only.
  double patience = 0;
};

/// Nothing if the obligation cannot be exported.
std::optional<Row> measure(const Obligation& obligation, const Measurement& measurement);

}  // namespace rungproof::peers
