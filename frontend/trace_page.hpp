// The HTML page of a trace, with the networks of the program lit for every scan where the caller has them.
// Tested by tests/show/trace_page_test.cpp.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "engine/trace.hpp"

namespace rungproof {

/// Drawings of the networks in the scans of a trace; equal ones are kept once.
struct TraceDrawings {
  std::vector<std::string> pages{};  ///< HTML elements of class "drawn", hidden
  std::vector<std::vector<std::size_t>>
      pagesOf{};        ///< by row of the trace: indices in `pages`; rows behind the end have none
  std::string style{};  ///< rules that the elements need
};

/// An expected trace beside the actual one: lanes of the same trace, each behind the lane it belongs to.
struct ExpectedLanes {
  std::vector<int> of{};                          ///< by signal: the lane that it says the value of, or -1
  std::vector<std::vector<std::size_t>> wrong{};  ///< by signal: rows where the actual value is another
};

void writeTracePage(const Trace& trace, std::string_view title, const TraceDrawings& drawings, std::ostream& out,
                    const ExpectedLanes& expected = {});

}  // namespace rungproof
