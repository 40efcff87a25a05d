// The baseline: findings of an old project that are known and not to be reported again. A JSON file, one entry for
// each fingerprint with its count, so that it is readable in reviews and merges line by line. It only ever shrinks:
// entries that match nothing are findings (SUP003). Tested by tests/cli/baseline_test.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frontend/files/failure.hpp"
#include "frontend/report.hpp"

namespace rungproof {

struct BaselineEntry {
  std::string fingerprint;
  std::string rule;
  std::string file;
  std::string message;       ///< for the reader of the file; not compared
  std::size_t count = 1;     ///< findings with this fingerprint in this file
  std::uint32_t offset = 0;  ///< place of the entry in the text it was read from
};

struct Baseline {
  std::vector<BaselineEntry> entries;
};

Baseline baselineOf(const Report& report);
std::string toJson(const Baseline& baseline);
/// Reads a baseline text; `name` is for the failure.
std::optional<Failure> readBaseline(const std::string& text, const std::string& name, Baseline& baseline);

/// Reads the file of that name and gives its text too.
std::optional<Failure> readBaselineFile(const std::string& name, Baseline& baseline, std::string& text);

/// The entries that findings of the report match, with as many places.
Baseline prunedBaseline(const Baseline& baseline, const Report& report);

/// Removes the findings that the baseline lists, adds SUP003 for entries with too many, of rules that were
/// selected and files that were read;
/// `file` is the baseline's own file in `sources`, for the places of SUP003. Errors of the readers stay.
void applyBaseline(const Baseline& baseline, std::uint32_t file,
                   const std::function<bool(std::string_view)>& isSelected, Report& report);

}  // namespace rungproof
