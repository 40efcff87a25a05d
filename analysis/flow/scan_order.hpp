// The order of instructions within a scan: whether all runs of one precede all runs of another, told from their places
// and from where their blocks are called. Tested by tests/rules/facts_test.cpp.
#pragma once

#include "analysis/flow/facts.hpp"

namespace rungproof {

/// Whether `earlier` runs before `later` whenever both run in a scan. False where that is not certain: in loops,
/// in interrupt routines, in blocks that are called on both sides.
bool runsBefore(const Facts& facts, std::uint32_t earlier, std::uint32_t later);

}  // namespace rungproof
