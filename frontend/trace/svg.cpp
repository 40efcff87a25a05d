// Traces as a drawing: a timing diagram in the look of the manual. Tested by tests/trace/drawing_test.cpp.
#include <ostream>

#include "frontend/picture/timing_diagram.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {

void writeSvgTrace(const Trace& trace, std::string_view title, std::ostream& out) {
  out << timingDiagram(trace, title);
}

}  // namespace

extern constexpr TraceFormat svgTrace = {.ending = ".svg", .summary = "timing diagram", .write = writeSvgTrace};

}  // namespace rungproof
