// What verdicts rest on, as lines that every output form shows. Covered by tests/cli/record_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "frontend/report.hpp"

namespace rungproof {

/// What a verdict says beside itself, a line each: what was tried, what it shows, what of it is taken for granted or
/// has any value, the networks that it rests on.
std::vector<std::string> remarksOf(const PropertyResult& property);
/// The same without the table of the run, for forms that show it in their own way.
std::vector<std::string> remarksBesideRun(const PropertyResult& property);
/// What all verdicts of the report rest on: "assumes: CPU 224, ...", "approximated: PID at press.awl:41: ...". Of a
/// run what was not computed. Empty where nothing is asked.
std::vector<std::string> basisOf(const Report& report);

}  // namespace rungproof
