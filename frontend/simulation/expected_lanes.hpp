// The expected curve beside the actual one: one trace with a lane for each expected signal behind the lane of what
// came, for pages and drawings. Tested by tests/trace/expected_lanes_test.cpp.
#pragma once

#include "engine/trace_comparison.hpp"
#include "frontend/trace_page.hpp"

namespace rungproof {

struct TraceBeside {
  Trace trace;
  ExpectedLanes lanes;
};

/// Expected values stand in the row that they are compared with; where nothing is expected the lane is open.
TraceBeside besideExpected(const Trace& expected, const Trace& actual, const CompareOptions& options);

/// How signals are called in a written trace: by address, by symbol where there is one, or by both ("Q0.0 Motor").
enum class SignalNames : std::uint8_t { Address, Symbol, Both };
Trace named(Trace trace, SignalNames names);

}  // namespace rungproof
