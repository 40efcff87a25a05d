// How files of loggers, oscilloscopes and simulators are to be read, as options and configuration say it: which column
// holds the time, in which unit, which column is which address. Files in the project's own form (first column `scan`
// or `time_ms`) need nothing of this. Tested by tests/trace/logger_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "frontend/files/failure.hpp"

namespace rungproof {

class Settings;

/// A time unit as a number of nanoseconds, by its name in any case: "s", "ms", "min"; nothing for anything else.
std::optional<double> nanosecondsOf(std::string_view unit);
/// The same for what stands behind a heading: "Time [ms]", "Zeit (s)", "t/s", "time_us"; nothing without a unit.
std::optional<double> nanosecondsInHeading(std::string_view heading);

struct TraceImport {
  std::string timeColumn{};   ///< its heading, or its number from 1; empty: the first one
  std::string timeUnit{};     ///< "ms"; empty: the heading says it
  char separator = 0;         ///< 0: recognised
  bool dropsUnknown = false;  ///< columns that mean nothing in the program are passed over (--rename '*=-')
  /// Heading and what it means; "-" leaves the column out.
  std::vector<std::pair<std::string, std::string>> renames{};
  /// Indices of `renames` that some file has.
  std::shared_ptr<std::set<std::size_t>> used = std::make_shared<std::set<std::size_t>>();

  /// The new name of a column, or nothing; notes that the row was used.
  std::optional<std::string> nameFor(std::string_view heading) const;
};

/// What the options say; failures for rows without '='.
TraceImport traceImportOf(const Settings& settings, std::vector<Failure>& failures);

/// Failures for renamings of columns that none of the files has; `names`: the files.
void checkRenames(const TraceImport& import, const std::string& names, std::vector<Failure>& failures);

}  // namespace rungproof
