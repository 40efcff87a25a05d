// Instructions that are taken for one another: what a hand that slips, or a mutant, writes in place of one.
// Tested by tests/ir/instruction_slip_test.cpp.
#pragma once

#include <vector>

#include "ir/dialect.hpp"

namespace rungproof {

/// What may stand there by mistake, with the same operands; of comparisons the neighbouring relation. Nothing for those
/// that nobody mistakes.
std::vector<const Desc*> slipsOf(const Desc& desc, const Dialect& of);

}  // namespace rungproof
