// A small trace with a bit, numbers of both signs, a REAL, an unknown value and a scan of another length.
#pragma once

#include <gtest/gtest.h>

#include <sstream>

#include "engine/trace.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

inline Trace sampleTrace() {
  Trace trace;
  const Program program;
  trace.signals = {
      signalOf(program, direct(Area::I, Width::Bit, 0, 0)), signalOf(program, direct(Area::Q, Width::Bit, 0, 0)),
      signalOf(program, direct(Area::V, Width::Word, 10)), signalOf(program, direct(Area::V, Width::DWord, 20)),
      signalOf(program, direct(Area::T, Width::Word, 37))};
  trace.signals[1].symbol = "Motor";
  trace.signals[3].type = SignalType::Real;
  trace.rows = {{1, 10000, 10000, {0, 0, -5, 1.5, std::nullopt}},
                {2, 20500, 10500, {1, 0, -5, 1.5, 3}},
                {3, 30500, 10000, {1, 1, 12, 0.1, 3}}};
  return trace;
}

inline std::string written(const Trace& trace, std::string_view ending, std::string_view title = "press.awl") {
  const TraceFormat* format = traceFormatOf("out" + std::string(ending));
  EXPECT_NE(format, nullptr);
  std::ostringstream out;
  if (format != nullptr) format->write(trace, title, out);
  return out.str();
}

}  // namespace rungproof
