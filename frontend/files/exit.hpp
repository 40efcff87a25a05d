// Exit codes: the whole contract with scripts and CI. If several apply, the first of Failed, Found, Undecided wins.
#pragma once

namespace rungproof {

enum class Exit : int {
  Clean = 0,     ///< nothing at or above the level, every property proved, traces agree
  Found = 1,     ///< findings, violated properties, differing traces
  Failed = 2,    ///< usage, unreadable or unparsable input, bad configuration, internal disagreement
  Undecided = 3  ///< nothing found, but UNKNOWN, HOLDS TO BOUND or NOT COVERED
};

constexpr Exit worse(Exit a, Exit b) {
  const auto rank = [](Exit e) { return e == Exit::Failed ? 3 : e == Exit::Found ? 2 : e == Exit::Undecided ? 1 : 0; };
  return rank(a) >= rank(b) ? a : b;
}

}  // namespace rungproof
