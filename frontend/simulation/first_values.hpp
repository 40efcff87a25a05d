// `sim --set ADDRESS=VALUE`: what inputs and memory hold from the first scan on, without a file that says so.
// Tested by tests/trace/first_values_test.cpp.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/stimulus.hpp"
#include "frontend/files/failure.hpp"

namespace rungproof {

/// Puts the values in front of everything that the stimulus does. The name is that of a column of a stimulus.
void setFirst(Stimulus& stimulus, std::span<const std::string> given, const Program& program,
              std::vector<Failure>& failures);

}  // namespace rungproof
