// What a simulated run has to say beside its trace: run-time errors as findings, how it ended, what it rests on.
// Tested by tests/trace/sim_command_test.cpp.
#pragma once

#include "engine/simulator.hpp"
#include "frontend/report.hpp"
#include "frontend/settings/options.hpp"

namespace rungproof {

/// "the CPU went to STOP at press.awl:41" after a STOP; empty while it runs or if a fatal error has stopped it.
std::string stopText(const Simulator& simulator);

/// Adds findings RUN001 (non-fatal run-time error), RUN002 (fatal error, STOP), RUN003 (interrupt queue overflow) and
/// RUN004 (an event of the stimulus that nothing could cause), and the assumptions of the run.
/// `countsLastScan`: whether what the last scan has met is told.
void describeRun(Report& report, const Simulator& simulator, const ScanTime& scanTime, bool countsLastScan = true);

}  // namespace rungproof
