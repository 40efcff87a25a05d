// GRF001: a ladder or FBD network that is no closed circuit. What can be judged on the elements is in
// analysis/drawing/check.hpp; what only the file shows (crossed or missing connections) the readers of graphical files
// report under the same id. Tested by tests/drawing/drawing_check_test.cpp.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule grf001_circuit_not_well_formed = {
    .id = "GRF001",
    .title = "Circuit not well formed",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "in a ladder or FBD network: an open end, a branch without contacts around others (short circuit), power "
        "flow from right to left, an element in the middle that must stand at the left rail",
    .why = "a network is one closed circuit; the editor does not compile anything else, so what it does is not defined",
    .manual = "001:2230, 001:2304",
    .peers = "Mitsubishi compile error 6602 (reverse flow)",
    .standsAlone = true,
};

}  // namespace rungproof
