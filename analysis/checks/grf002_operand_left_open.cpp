// GRF002: a contact, coil or pin of a drawing that was left with question marks. Spoken by the readers of graphical
// files; in STL a missing operand is a syntax finding. Tested by tests/cli/rule_table_test.cpp.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule grf002_operand_left_open = {
    .id = "GRF002",
    .title = "Operand left open",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "a contact, coil or box of a ladder or FBD network without an operand that it needs: ??.? or ????",
    .why = "the editor marks it in red and refuses the download; whatever the network should do is not decided yet",
    .manual = "001:2228",
    .peers = "the editor's own check",
};

}  // namespace rungproof
