// Whether two parts are about the same programs under the same options.
#include <fmt/format.h>

#include <map>
#include <set>

#include "frontend/merging/report_parts.hpp"

namespace rungproof {

namespace {

const std::vector<Json>& rowsIn(const Json& json, std::string_view key) {
  static const std::vector<Json> none;
  const Json* const rows = json.find(key);
  return rows == nullptr ? none : rows->items();
}

std::string wordIn(const Json& json, std::string_view key) {
  const Json* const value = json.find(key);
  return value == nullptr ? std::string() : value->text();
}

constexpr const char* oneProgram = "make all parts from the same files";

/// Machines may have the files in folders of their own: what counts is the texts.
std::optional<Failure> differenceOfTexts(const NamedPart& a, const NamedPart& b, const Json& one, const Json& other) {
  std::multiset<std::string> ofOne, ofOther;
  for (const Json& file : rowsIn(one, "files")) ofOne.insert(wordIn(file, "sha256"));
  for (const Json& file : rowsIn(other, "files")) ofOther.insert(wordIn(file, "sha256"));
  if (ofOne == ofOther) return std::nullopt;
  const auto firstMissing = [](const Json& program, const std::multiset<std::string>& there) {
    for (const Json& file : rowsIn(program, "files")) {
      if (!there.contains(wordIn(file, "sha256"))) return wordIn(file, "name");
    }
    return std::string();
  };
  const std::string inOne = firstMissing(one, ofOther), inOther = firstMissing(other, ofOne);
  if (!inOne.empty() && inOne == inOther)
    return Failure{
        fmt::format("'{}' of '{}' has another text than that of '{}'", inOne, a.file, b.file), {}, oneProgram};
  const auto reading = [](const std::string& part, const std::string& name) {
    return name.empty() ? fmt::format("'{}' has read less", part) : fmt::format("'{}' has read '{}'", part, name);
  };
  return Failure{
      fmt::format("the parts are about different texts: {}, {}", reading(a.file, inOne), reading(b.file, inOther)),
      {},
      oneProgram};
}

std::map<std::string, std::string> optionsIn(const Json& program) {
  std::map<std::string, std::string> options;
  for (const Json& option : rowsIn(program, "options")) {
    std::string& value = options[wordIn(option, "name")];
    value += (value.empty() ? "" : " ") + wordIn(option, "value");
  }
  return options;
}

std::optional<Failure> differenceOfOptions(const NamedPart& a, const NamedPart& b, const Json& one, const Json& other) {
  constexpr const char* sameOptions = "make all parts with the same options";
  if (wordIn(one, "cpu") != wordIn(other, "cpu"))
    return Failure{fmt::format("'{}' is for a CPU {}, '{}' for a CPU {}", a.file, wordIn(one, "cpu"), b.file,
                               wordIn(other, "cpu")),
                   {},
                   sameOptions};
  auto ofOne = optionsIn(one), ofOther = optionsIn(other);
  std::set<std::string> names;
  for (const auto& [name, value] : ofOne) names.insert(name);
  for (const auto& [name, value] : ofOther) names.insert(name);
  const auto given = [](const std::string& name, const std::map<std::string, std::string>& options) {
    const auto found = options.find(name);
    return found == options.end() ? fmt::format("without --{}", name)
                                  : fmt::format("with --{}{}{}", name, found->second.empty() ? "" : " ", found->second);
  };
  for (const std::string& name : names) {
    const std::string inOne = given(name, ofOne), inOther = given(name, ofOther);
    if (inOne != inOther)
      return Failure{fmt::format("'{}' was made {}, '{}' {}", a.file, inOne, b.file, inOther), {}, sameOptions};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Failure> differenceOfRuns(const NamedPart& a, const NamedPart& b) {
  const std::vector<Json>& ofA = a.programs.items();
  const std::vector<Json>& ofB = b.programs.items();
  if (ofA.empty() || ofB.empty())
    return Failure{fmt::format("'{}' does not say which program it is about", ofA.empty() ? a.file : b.file),
                   {},
                   "make the parts anew with this version of rungproof"};
  for (std::size_t i = 0; i < std::min(ofA.size(), ofB.size()); ++i) {
    if (auto failure = differenceOfTexts(a, b, ofA[i], ofB[i])) return failure;
    if (auto failure = differenceOfOptions(a, b, ofA[i], ofB[i])) return failure;
  }
  if (ofA.size() == ofB.size()) return std::nullopt;
  return Failure{fmt::format("the parts are about different programs: '{}' about {}, '{}' about {}", a.file, ofA.size(),
                             b.file, ofB.size()),
                 {},
                 oneProgram};
}

}  // namespace rungproof
