// Timing diagrams as the manual draws them: a lane per signal, bits as levels, numbers as labelled boxes, time from
// left to right, scans below. The SVG trace form and the HTML page use it. Tested by tests/trace/drawing_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "engine/trace.hpp"

namespace rungproof {

/// A whole SVG document. At most `maxScans` rows are drawn; when there are more, stretches in which no signal changes
/// are drawn as gaps, and what is still too long is cut with a remark.
std::string timingDiagram(const Trace& trace, std::string_view title, std::size_t maxScans = 400);

}  // namespace rungproof
