// Proofs of single properties.
#include "frontend/editor/proof.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/editor/diagnostics.hpp"
#include "frontend/rpc/command_output.hpp"

namespace rungproof {

namespace {

/// A pattern that the name fits; characters with a meaning in patterns or lists become '?'.
std::string patternOf(std::string name) {
  constexpr std::string_view special = "*?[]\\,";
  std::ranges::replace_if(
      name, [&](char c) { return special.find(c) != std::string_view::npos; }, '?');
  return name;
}

std::string textMember(const Json& row, std::string_view key) {
  const Json* const member = row.find(key);
  return member == nullptr ? std::string() : member->text();
}

std::string lensTitle(const ProofVerdict* verdict, std::int64_t version) {
  if (verdict == nullptr || verdict->word.empty()) return "prove this property";
  if (verdict->version != version) return fmt::format("{} before the last change; prove again", verdict->word);
  const std::string method = textMember(verdict->row, "method");
  return method.empty() ? verdict->word : fmt::format("{} by {}", verdict->word, method);
}

bool isGoodWord(std::string_view word) { return word == "PROVED" || word == "REACHABLE"; }

int runAskedCommand(const std::string& request, const GiveBytes& give) {
  const std::optional<Json> asked = takeJobRequest(request);
  if (!asked) return 1;
  std::vector<std::string> arguments;
  for (const Json& argument : asked->items()) arguments.push_back(argument.text());
  const CommandOutput output = outputOf(arguments);
  return give(Json{{"out", output.out}, {"err", output.err}}.dump()) ? 0 : 1;
}

}  // namespace

constinit const Worker commandWorker = {"command", runAskedCommand};

const Property* goalNamed(const CheckedDocument& document, std::string_view name) {
  for (const Property& property : document.properties().properties) {
    if (property.isGoal() && property.name == name) return &property;
  }
  return nullptr;
}

Json lensesOf(const CheckedDocument& document, const ProofVerdicts& verdicts) {
  Json lenses = Json::array();
  for (const Property& property : document.properties().properties) {
    if (!property.isGoal() || !document.isHere(property.span)) continue;
    const auto known = verdicts.find(property.name);
    Json command{{"title", lensTitle(known == verdicts.end() ? nullptr : &known->second, document.version())},
                 {"command", "rungproof.prove"},
                 {"arguments", Json::array({document.uri(), property.name})}};
    lenses.push_back({{"range", document.range(property.span)}, {"command", std::move(command)}});
  }
  return lenses;
}

JobRequest proofOf(const CheckedDocument& document, const std::string& name, const std::vector<std::string>& given) {
  std::vector<std::string> arguments = {"prove"};
  const std::vector<std::string>& files = document.files();
  arguments.insert(arguments.end(), files.begin(), files.end());
  for (const std::string& file : document.propertyFiles()) arguments.push_back("--props=" + file);
  arguments.insert(arguments.end(), given.begin(), given.end());
  arguments.push_back("--only=" + patternOf(name));
  arguments.push_back("--format=json");
  return {&commandWorker, arguments};
}

ProofVerdict verdictFrom(const std::optional<std::string>& printed, const std::string& name, std::int64_t version) {
  ProofVerdict verdict;
  verdict.version = version;
  const std::optional<Json> output = printed ? Json::read(*printed) : std::nullopt;
  const std::optional<Json> report = output ? Json::read(textMember(*output, "out")) : std::nullopt;
  const Json* const rows = report ? report->find("properties") : nullptr;
  for (const Json& row : rows == nullptr ? std::vector<Json>() : rows->items()) {
    if (textMember(row, "name") != name) continue;
    verdict.row = row;
    verdict.word = textMember(row, "verdict");
  }
  if (verdict.word.empty()) {
    verdict.message = fmt::format("'{}' could not be proved: {}", name,
                                  output ? textMember(*output, "err") : std::string("the run was ended"));
    return verdict;
  }
  const std::string method = textMember(verdict.row, "method");
  verdict.message = fmt::format("{} {}{}", verdict.word, name, method.empty() ? "" : ", by " + method);
  if (const Json* const notes = verdict.row.find("notes")) {
    for (const Json& note : notes->items()) verdict.message += "\n" + note.text();
  }
  return verdict;
}

void addVerdicts(const CheckedDocument& document, const ProofVerdicts& verdicts, Json& diagnostics) {
  for (const auto& [name, verdict] : verdicts) {
    const Property* const property = goalNamed(document, name);
    if (verdict.version != document.version() || property == nullptr || !document.isHere(property->span)) continue;
    if (verdict.word.empty() || isGoodWord(verdict.word)) continue;
    const bool isViolated = verdict.word == "VIOLATED" || verdict.word == "UNREACHABLE";
    diagnostics.push_back({{"range", document.range(property->span)},
                           {"severity", clientSeverity(isViolated ? Severity::Error : Severity::Warning)},
                           {"code", verdict.word},
                           {"source", "rungproof prove"},
                           {"message", verdict.message}});
  }
}

}  // namespace rungproof
