// PTR007: an index that is computed can lie outside the bounds of its array, in a body written in SCL. The prover
// answers. Tested by tests/scl/prove_test.cpp.
#include "analysis/asking/asking.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr Hazard ptr007Hazards[] = {Hazard::SclIndex};

}  // namespace

extern constexpr Rule ptr007_index_leaves_array = {
    .id = "PTR007",
    .title = "Index can leave its array",
    .severity = Severity::Error,
    .needs = Needs::Solver,
    .detects = "an index that is computed and can lie outside the bounds of its array, in SCL; the number of MUX too",
    .why = "the CPU does not compare it with the bounds: another variable is read or written in place of the element",
    .manual = "002:2068",
    .dialects = dialect::S7300,
    .ask = {.in = asked::Builtin,
            .turn = 30,
            .cost = 1,
            .whenNone = "no index can leave its array",
            .hazards = ptr007Hazards},
    .tell = {.advice = "limit the index, or compare it with the bounds first"},
};

}  // namespace rungproof
