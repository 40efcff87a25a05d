// SUP002: an allow-comment without a rule id or without a reason. Spoken by analysis/lint/suppress.cpp; tested by
// tests/cli/suppress_test.cpp.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule sup002_suppression_without_reason = {
    .id = "SUP002",
    .title = "Suppression without code or reason",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "an allow-comment that names no rule, or gives no text after the rule ids; it silences nothing",
    .why = "whoever reads the program later must see what was silenced and why that is safe",
    .peers = "ruff (code required); hadolint (reason text)",
    .dialects = dialect::Every | dialect::Iec,
};

}  // namespace rungproof
