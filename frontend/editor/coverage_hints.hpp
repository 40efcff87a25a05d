// What the test tables beside a document cover, shown at its contacts and coils while it is edited. Tables are the
// files NAME.test.csv and NAME.*.test.csv in the folder of NAME. Tested by tests/editor/coverage_test.cpp.
#pragma once

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

/// Inlay hints for the whole document, which lies at `path`; none without tables, or where the program cannot be run.
Json coverageHints(const CheckedDocument& document, const std::string& path);

}  // namespace rungproof
