// Loops of gates in a drawing (AND, OR, XOR, NOT without a block that keeps anything): the wire that closes the loop
// carries the value of the evaluation before, first FALSE. Which wire that is depends on the order of evaluation.
// Tested by tests/iec/vendor_readings_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "frontend/graphical/drawn_model.hpp"

namespace rungproof::iec {

/// Variables that keep such a value; a number follows.
inline constexpr std::string_view feedbackName = "__feedback_";

/// The drawing with that wire replaced by a variable, which keeps the value. `stated`: gates in the order of their
/// numbers, without numbers as the results need them; `byPlace`: from left to right.
struct FeedbackNetworks {
  DrawnNetwork stated, byPlace;
  bool isSame = false;  ///< both orders give the same wire
};
/// Nothing: no loop is there, or not one that a single variable of that kind cuts.
std::optional<FeedbackNetworks> withFeedback(const DrawnNetwork& network, const std::string& variable);

}  // namespace rungproof::iec
