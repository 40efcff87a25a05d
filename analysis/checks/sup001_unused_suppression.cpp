// SUP001: an allow-comment that silences nothing. Spoken by analysis/lint/suppress.cpp, which knows what each comment
// silenced; tested by tests/cli/suppress_test.cpp.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule sup001_unused_suppression = {
    .id = "SUP001",
    .title = "Unused or unknown suppression",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "an allow-comment that silences no finding, or that names a rule which does not exist; the former only where "
        "all of the program could be read, as rules hold back beside what could not",
    .why = "a suppression that outlived its cause would silence the next, real finding at that place",
    .peers = "ruff RUF100; eslint --report-unused-disable-directives; cppcheck unmatchedSuppression",
    .dialects = dialect::Every | dialect::Iec,
    .surplus = true,
};

}  // namespace rungproof
