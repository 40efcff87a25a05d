// The page of a rule, from its descriptor, as text, JSON and Markdown. Used by `explain`, `rules` and the SARIF report.
#pragma once

#include <string>

#include "analysis/rule.hpp"
#include "frontend/files/json.hpp"
#include "frontend/text/excerpt.hpp"

namespace rungproof {

std::string rulePage(const Rule& rule, const Paint& paint);
Json ruleJson(const Rule& rule);
/// "text and tables", "data flow", ... what Needs means in words.
std::string_view needsText(Needs needs);
/// "S7-200, S7-300/400".
std::string dialectsText(Dialects dialects);

}  // namespace rungproof
