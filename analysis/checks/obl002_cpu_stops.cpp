// OBL002: a synchronous error, or the program itself, sends the CPU into STOP. The prover answers; where OB121 is
// there, it takes the errors. Tested by tests/prover/step7_rules_test.cpp.
#include "analysis/asking/asking.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr Hazard obl002Hazards[] = {
    Hazard::S7Bcd,           Hazard::S7AreaLength, Hazard::S7AreaUnknown,    Hazard::S7TimerNumber,
    Hazard::S7CounterNumber, Hazard::S7Alignment,  Hazard::S7WriteProtected, Hazard::S7BlockMissing,
    Hazard::S7Stop,          Hazard::S7ErrorTwice};

}  // namespace

extern constexpr Rule obl002_cpu_stops = {
    .id = "OBL002",
    .title = "CPU goes to STOP",
    .severity = Severity::Error,
    .needs = Needs::Solver,
    .detects =
        "an access that can leave its area or data block, a digit that is no BCD, a block or element that does not "
        "exist, a write into a protected block, where no OB121 takes the error; a call of SFC 46",
    .why = "the CPU stops in the middle of the scan and all outputs go off",
    .manual = "002:1278-1290, 002:2343",
    .dialects = dialect::S7300,
    .ask = {.in = asked::Builtin, .turn = 30, .cost = 1, .hazards = obl002Hazards},
    .tell = {.advice = "limit what decides the place, or load OB121"},
};

}  // namespace rungproof
