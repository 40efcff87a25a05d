// The sheet that is signed at the machine: for each test its purpose, its steps with what is to be done, how long to
// wait and what must be seen, with a box to tick; requirements with the tests that exercise them; the hash of the
// program and the tool. As an HTML page for A4, as
// Markdown and as CSV. Tested by tests/tables/generate_command_test.cpp.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/property.hpp"
#include "engine/coverage/coverage_map.hpp"
#include "engine/testing/test_table.hpp"
#include "frontend/test_results.hpp"

namespace rungproof {

/// A requirement of a property file and the tests that exercise it.
struct SheetRequirement {
  std::string name, text;
  std::vector<std::string> tests;  ///< names; empty: no test does
};

/// An input or output of the tests.
struct SheetSignal {
  std::string symbol, address, comment;
};

struct TestSheet {
  std::string title;               ///< first file of the program
  std::string hash;                ///< SHA-256 of its text
  std::vector<std::string> basis;  ///< CPU, scan times, how expectations were checked
  std::vector<SheetSignal> signals;
  TestTable table;
  double lowMs = 1, highMs = 100;                  ///< scans for which the tests hold
  std::vector<std::vector<bool>> countsScans;      ///< by test and row: only so many scans show what is expected
  std::vector<std::string> purposes;               ///< by test
  std::vector<std::vector<std::string>> networks;  ///< by test: "MAIN:4"
  std::map<std::string, std::string> links;        ///< of networks, into the coverage page
  std::vector<SheetRequirement> requirements;
  CoverageResult coverage;
};

std::string sheetHtml(const TestSheet& sheet);
std::string sheetMarkdown(const TestSheet& sheet);
/// One line a step, for a spreadsheet.
std::string sheetCsv(const TestSheet& sheet);

}  // namespace rungproof
