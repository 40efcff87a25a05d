#include "schema_check.hpp"

#include <algorithm>
#include <regex>

namespace rungproof::test {

namespace {

using nlohmann::json;

bool hasType(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

void add(std::vector<std::string>& faults, const std::vector<std::string>& more) {
  faults.insert(faults.end(), more.begin(), more.end());
}

}  // namespace

std::vector<std::string> schemaFaults(const json& value, const json& schema, const std::string& path) {
  std::vector<std::string> faults;
  for (const auto& [key, rule] : schema.items()) {
    if (key == "type") {
      const json types = rule.is_array() ? rule : json::array({rule});
      const bool fits = std::any_of(types.begin(), types.end(),
                                    [&](const json& type) { return hasType(value, type.get<std::string>()); });
      if (!fits) faults.push_back(path + ": is not " + rule.dump());
    } else if (key == "enum") {
      if (std::find(rule.begin(), rule.end(), value) == rule.end())
        faults.push_back(path + ": " + value.dump() + " is not in " + rule.dump());
    } else if (key == "pattern") {
      if (value.is_string() && !std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())))
        faults.push_back(path + ": " + value.dump() + " does not match");
    } else if (key == "minimum") {
      if (value.is_number() && value.get<double>() < rule.get<double>()) faults.push_back(path + ": is too small");
    } else if (key == "required") {
      for (const json& name : rule) {
        if (value.is_object() && !value.contains(name.get<std::string>()))
          faults.push_back(path + ": lacks " + name.dump());
      }
    } else if (key == "properties") {
      for (const auto& [name, member] : rule.items()) {
        if (value.is_object() && value.contains(name))
          add(faults, schemaFaults(value[name], member, path + "." + name));
      }
    } else if (key == "additionalProperties") {
      for (const auto& [name, member] : value.items()) {
        if (!value.is_object()) break;
        if (!schema["properties"].contains(name))
          faults.push_back(path + ": has " + name + ", which the schema does not know");
      }
    } else if (key == "items") {
      for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
        add(faults, schemaFaults(value[i], rule, path + "[" + std::to_string(i) + "]"));
    } else if (key != "$schema" && key != "title" && key != "description") {
      faults.push_back(path + ": the schema uses '" + key + "', which is not checked");
    }
  }
  return faults;
}

}  // namespace rungproof::test
