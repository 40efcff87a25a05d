// Where in a scan an interrupt comes or a device writes, as stimulus files and tables of witnesses have it:
// "10@17" is event 10 in front
// of the instruction in line 17, "10@17/2" in front of the second instruction that stands in that line, "10@17*3" in
// front of the third execution of it in that scan, "10@door.awl:17" where the line is of another file than the first
// instruction, "10@end" after the program; "3x10@17" are three at once. Tested by tests/trace/stimulus_test.cpp and
// tests/prover/witness_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scan_script.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// The events that come, separated by blanks; "3x10@17" are three at once. What runs out of the queue needs no mention.
/// `withQueue`: all the same, as "q10@17"; and "&10@17" for one that comes together with the next.
std::string eventsText(const Program& program, const std::vector<ScanScript::Event>& events, bool withQueue = false);
/// "@17", and nothing for the start of the scan.
std::string placeText(const Program& program, const ScanPlace& place);
/// "VB101=83" at the start of the scan, "SMB86=2@17" at another place.
std::string writeText(const Program& program, const ScanScript::Write& write);
/// The place that the text behind '@' names; nothing if no instruction stands there.
std::optional<ScanPlace> scanPlaceNamed(const Program& program, std::string_view text);

}  // namespace rungproof
