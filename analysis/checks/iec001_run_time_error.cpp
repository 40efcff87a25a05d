// IEC001: what the standard calls an error at run time can happen: a whole number divided by 0, an index outside its
// array, a scan that does not end. The prover answers. Tested by tests/iec.
#include "analysis/asking/asking.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr Hazard iec001Hazards[] = {Hazard::IecDivideByZero, Hazard::IecArrayRange, Hazard::IecEndless,
                                    Hazard::IecRange};

}  // namespace

extern constexpr Rule iec001_run_time_error = {
    .id = "IEC001",
    .title = "Error at run time",
    .severity = Severity::Error,
    .needs = Needs::Solver,
    .detects =
        "a division of whole numbers whose divisor can be 0, an index that can lie outside its array, a value that can "
        "lie outside its subrange, a loop that may not end",
    .why =
        "the standard calls it an error: some controllers stop, some go on with any value or with another variable's",
    .dialects = dialect::Iec,
    .ask = {.in = asked::Builtin,
            .turn = 30,
            .cost = 1,
            .whenNone = "no error at run time can happen",
            .hazards = iec001Hazards},
    .tell = {.advice = "ask first, or limit the value"},
};

}  // namespace rungproof
