// Trace and stimulus files on disk: reading whole files with failures that name them, writing by file ending.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/trace.hpp"
#include "frontend/command.hpp"
#include "frontend/trace_page.hpp"

namespace rungproof {

/// The bytes of a file; "-" is standard input. A failure if it cannot be read or is no text.
std::optional<std::string> readFile(const Context& context, const std::string& name, std::vector<Failure>& failures);

/// A failure if no trace form has the ending of that file. "-" stands for CSV on standard output.
std::optional<Failure> checkTraceName(const std::string& name);
/// Writes in the form that the ending names.
bool writeTrace(const Context& context, const std::string& name, const Trace& trace, std::string_view title);

/// Writes the HTML page, with the networks of the program lit where there are drawings.
bool writePage(const Context& context, const std::string& name, const Trace& trace, std::string_view title,
               const TraceDrawings& drawings, const ExpectedLanes& expected = {});

/// Prints failures, the first ten of them, and gives the exit code for it.
Exit failAll(const Context& context, const std::vector<Failure>& failures);

}  // namespace rungproof
