// Checks a JSON value against a JSON schema: the keywords that frontend/report/schema.json uses, and an error for any
// other, so that the schema cannot grow beyond what is checked.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rungproof::test {

/// What is wrong, one line each with the path of the value; empty if it conforms.
std::vector<std::string> schemaFaults(const nlohmann::json& value, const nlohmann::json& schema,
                                      const std::string& path = "$");

}  // namespace rungproof::test
