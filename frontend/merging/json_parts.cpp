// Parts in the JSON form: properties beside each other, findings and remarks once, sums anew.
#include <fmt/format.h>

#include <map>
#include <set>

#include "frontend/files/json.hpp"
#include "frontend/merging/report_parts.hpp"

namespace rungproof {

namespace {

/// The items that are not there yet.
void addNew(Json& list, const Json* more) {
  if (more == nullptr) return;
  std::set<std::string> known;
  for (const Json& item : list.items()) known.insert(item.dump());
  for (const Json& item : more->items()) {
    if (known.insert(item.dump()).second) list.push_back(item);
  }
}

/// All parts as values in the order of their numbers, or what is wrong. `markIn`: where a value keeps its mark.
std::variant<std::vector<Json>, Failure> partsIn(const std::vector<PartFile>& files, const Json* (*markIn)(const Json&),
                                                 std::vector<std::optional<PartMark>>& marks) {
  std::vector<Json> values;
  for (const PartFile& file : files) {
    std::optional<Json> value = Json::read(file.text);
    if (!value) return Failure{fmt::format("'{}' is no JSON", file.name), {}, "join files of one form"};
    const Json* const place = markIn(*value);
    const Json* const mark = place == nullptr ? nullptr : place->find("shard");
    marks.push_back(mark == nullptr ? std::nullopt : markOf(*mark));
    values.push_back(std::move(*value));
  }
  auto order = orderOfParts(files, marks);
  if (Failure* failure = std::get_if<Failure>(&order)) return std::move(*failure);
  std::vector<Json> sorted;
  for (const std::size_t i : std::get<std::vector<std::size_t>>(order)) sorted.push_back(std::move(values[i]));
  return sorted;
}

std::string textAt(const Json& json, std::string_view key) {
  const Json* const value = json.find(key);
  return value == nullptr ? std::string() : value->text();
}

Json summaryOf(const Json& whole) {
  std::uint64_t errors = 0, warnings = 0, notes = 0, proved = 0, violated = 0, undecided = 0;
  for (const Json& finding : whole.find("findings")->items()) {
    const std::string severity = textAt(finding, "severity");
    ++(severity == "error" ? errors : severity == "warning" ? warnings : notes);
  }
  for (const Json& property : whole.find("properties")->items()) {
    const std::string verdict = textAt(property, "verdict");
    const bool isGood = verdict == "PROVED" || verdict == "REACHABLE";
    const bool isBad = verdict == "VIOLATED" || verdict == "UNREACHABLE" || verdict == "VACUOUS";
    ++(isGood ? proved : isBad ? violated : undecided);
  }
  return {{"errors", errors}, {"warnings", warnings}, {"notes", notes},
          {"proved", proved}, {"violated", violated}, {"undecided", undecided}};
}

const Json* runOf(const Json& log) {
  const Json* const runs = log.find("runs");
  return runs == nullptr || runs->empty() ? nullptr : &runs->items().front();
}

}  // namespace

JoinResult joinJson(const std::vector<PartFile>& files) {
  std::vector<std::optional<PartMark>> marks;
  auto parts = partsIn(
      files, [](const Json& value) { return &value; }, marks);
  if (Failure* failure = std::get_if<Failure>(&parts)) return std::move(*failure);
  std::vector<Json>& values = std::get<std::vector<Json>>(parts);
  Json whole = Json::object();
  for (const std::string_view key : {"tool", "version", "command"}) {
    for (const Json& value : values) {
      if (textAt(value, key) != textAt(values.front(), key))
        return Failure{fmt::format("the parts differ in '{}': '{}' and '{}'", key, textAt(values.front(), key),
                                   textAt(value, key)),
                       {},
                       "join the parts of one run"};
    }
    whole[key] = textAt(values.front(), key);
  }
  whole["findings"] = Json::array();
  whole["properties"] = Json::array();
  whole["comparison"] = nullptr;
  const Json* const coverage = values.front().find("coverage");
  whole["coverage"] = coverage == nullptr ? Json::object() : *coverage;
  for (const Json& value : values) {
    addNew(whole["findings"], value.find("findings"));
    addNew(whole["properties"], value.find("properties"));
    const Json* const seen = value.find("coverage");
    for (const std::string_view key : {"approximated", "left_out"}) {
      if (seen != nullptr && seen->find(key) != nullptr) addNew(whole["coverage"][key], seen->find(key));
    }
  }
  whole["summary"] = summaryOf(whole);
  return JoinedReport{whole.dump(2) + "\n", worstExit(marks)};
}

JoinResult joinSarif(const std::vector<PartFile>& files) {
  std::vector<std::optional<PartMark>> marks;
  const auto properties = [](const Json& value) {
    const Json* const run = runOf(value);
    return run == nullptr ? nullptr : run->find("properties");
  };
  auto parts = partsIn(files, properties, marks);
  if (Failure* failure = std::get_if<Failure>(&parts)) return std::move(*failure);
  Json rules = Json::array(), results = Json::array(), basis = Json::array();
  std::set<std::string> known;
  std::map<std::string, std::size_t> ruleIndex;
  for (const Json& value : std::get<std::vector<Json>>(parts)) {
    const Json& run = *runOf(value);
    const Json* const tool = run.find("tool");
    const Json* const driver = tool == nullptr ? nullptr : tool->find("driver");
    const Json* const own = driver == nullptr ? nullptr : driver->find("rules");
    if (own == nullptr || run.find("results") == nullptr)
      return Failure{"a part has no rules or no results", {}, "join the files that --format sarif wrote"};
    for (const Json& rule : own->items()) {
      if (ruleIndex.emplace(textAt(rule, "id"), rules.size()).second) rules.push_back(rule);
    }
    for (Json result : run.find("results")->items()) {
      result["ruleIndex"] = ruleIndex[textAt(result, "ruleId")];
      if (known.insert(result.dump()).second) results.push_back(std::move(result));
    }
    addNew(basis, run.find("properties")->find("basis"));
  }
  Json log = std::get<std::vector<Json>>(parts).front();
  Json run = *runOf(log);
  run["tool"]["driver"]["rules"] = std::move(rules);
  run["results"] = std::move(results);
  run["properties"] = {{"basis", std::move(basis)}};
  log["runs"] = Json::array({std::move(run)});
  return JoinedReport{log.dump(2) + "\n", worstExit(marks)};
}

}  // namespace rungproof
