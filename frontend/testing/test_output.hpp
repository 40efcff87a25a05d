// A report of tests in the forms of the reporters: text for people, JSON, one HTML page. Tested by
// tests/tables/test_command_test.cpp.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "frontend/files/json.hpp"
#include "frontend/test_results.hpp"
#include "frontend/text/excerpt.hpp"

namespace rungproof {

std::string testText(const TestReport& report, const Paint& paint, bool isQuiet);
Json testsJson(const TestReport& report);
/// Adds the measures to the JSON's `coverage` object.
void addMeasures(Json& json, const CoverageResult& coverage);
/// A page of its own: figures, what is not covered and why, each network with the colours of its contacts.
std::string coveragePage(const CoverageResult& coverage, const std::string& drawings, std::string_view title);
void writeTestPage(const Report& report, const TestReport& tests, std::ostream& out);
/// "step 3 (line 7): Q0.0 expected 1, actual 0".
std::string testFailureText(const TestResult& result);

}  // namespace rungproof
