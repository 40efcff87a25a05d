// GRF003: what FBD forbids at the pins of a box. The number of inputs is judged in analysis/drawing/check.hpp; a
// negation on a pin that is not Boolean is seen by the readers of graphical files, which report it under this id.
// Tested by tests/drawing/drawing_check_test.cpp.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule grf003_fbd_pin_rule = {
    .id = "GRF003",
    .title = "FBD pin rule",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "an AND or OR box with more than 32 inputs; a negation circle on a pin that is not Boolean",
    .why = "the editor does not offer such a box: the network cannot be brought to the controller as it stands",
    .manual = "001:2268, 001:2727, 001:2249",
    .standsAlone = true,
};

}  // namespace rungproof
