// The corpus keeps its word: every program states in its head which findings and verdicts are expected,
//     //! options --cpu 222            a project of many files has its expectations in its MAIN.stl
//     //! finding ADR001 MAIN 1        rule, block, network
//     //! verdict NAME: PROVED
//     //! open NAME: PROVED            what is true, but not yet decided in the time that this test gives
//     //! scans NAME: 3                length of the shortest run that breaks or reaches it; the head gives the reason
// Findings of level warning and error must be exactly those; every declared property must have its verdict.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/corpus/corpus_program.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Expectation {
  std::vector<std::string> options;
  std::multiset<std::string> findings;
  std::map<std::string, std::string> verdicts;
  std::map<std::string, std::string> open;
  std::map<std::string, int> scans;
};

/// True verdicts that the prover may still owe; the number may only go down.
constexpr std::size_t mostOpen = 0;

Expectation expectationOf(const fs::path& file) {
  Expectation expectation;
  std::ifstream stream(test::headOf(file), std::ios::binary);
  std::string line;
  while (std::getline(stream, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.rfind("//! ", 0) != 0) continue;
    std::istringstream words(line.substr(4));
    std::string kind;
    words >> kind;
    std::string rest;
    std::getline(words >> std::ws, rest);
    if (kind == "options") {
      std::istringstream options(rest);
      for (std::string option; options >> option;) expectation.options.push_back(option);
    } else if (kind == "finding") {
      expectation.findings.insert(rest);
    } else if (kind == "verdict" || kind == "open") {
      const std::size_t colon = rest.rfind(": ");
      (kind == "open" ? expectation.open : expectation.verdicts)[rest.substr(0, colon)] = rest.substr(colon + 2);
    } else if (kind == "scans") {
      const std::size_t colon = rest.rfind(": ");
      expectation.scans[rest.substr(0, colon)] = std::stoi(rest.substr(colon + 2));
    } else {
      ADD_FAILURE() << file << ": unknown line " << line;
    }
  }
  return expectation;
}

Json runJson(const std::string& command, const fs::path& file, const std::vector<std::string>& options) {
  std::vector<std::string> arguments{command, file.string(), "--isolated", "--format", "json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  std::istringstream in;
  std::ostringstream out, err;
  runProgram(arguments, {in, out, err});
  EXPECT_EQ(err.str(), "") << file;
  return Json::parse(out.str(), nullptr, false);
}

class CorpusProgram : public testing::TestWithParam<fs::path> {};

TEST_P(CorpusProgram, FindingsAreThoseExpected) {
  const Expectation expected = expectationOf(GetParam());
  const Json report = runJson("lint", GetParam(), expected.options);
  ASSERT_TRUE(report.is_object());
  std::multiset<std::string> found;
  std::string all;
  for (const Json& finding : report["findings"]) {
    if (finding["severity"] == "note") continue;
    found.insert(finding["rule"].get<std::string>() + " " + finding["pou"].get<std::string>() + " " +
                 std::to_string(finding["network"].is_null() ? 0 : finding["network"].get<int>()));
    all += "\n  " + finding["rule"].get<std::string>() + ": " + finding["message"].get<std::string>();
  }
  EXPECT_EQ(found, expected.findings) << all;
}

TEST_P(CorpusProgram, VerdictsAreThoseExpected) {
  const Expectation expected = expectationOf(GetParam());
  if (expected.verdicts.empty()) return;
  std::vector<std::string> options = expected.options;
  options.insert(options.end(), {"--timeout", expected.open.empty() ? "120s" : "4s"});
  const Json report = runJson("prove", GetParam(), options);
  ASSERT_TRUE(report.is_object());
  std::map<std::string, std::string> found;
  for (const Json& property : report["properties"]) {
    const std::string name = property["name"], verdict = property["verdict"];
    const auto owed = expected.open.find(name);
    if (owed == expected.open.end())
      found[name] = verdict;
    else
      EXPECT_TRUE(verdict == owed->second || verdict == "UNKNOWN" || verdict == "NOT COVERED")
          << name << " must not be " << verdict;
  }
  EXPECT_EQ(found, expected.verdicts);
}

/// Verdict and depth by name, of a search through so many scans at most.
std::map<std::string, std::pair<std::string, int>> boundedVerdicts(const fs::path& file,
                                                                   std::vector<std::string> options, int bound) {
  options.insert(options.end(), {"--timeout", "120s", "--bound", std::to_string(bound)});
  std::map<std::string, std::pair<std::string, int>> found;
  const Json report = runJson("prove", file, options);
  for (const Json& property : report["properties"]) found[property["name"]] = {property["verdict"], property["depth"]};
  return found;
}

// The shortest run was found by thinking: the prover must find one of that length, and none that is shorter.
TEST_P(CorpusProgram, ShortestRunsAreThoseStated) {
  const Expectation expected = expectationOf(GetParam());
  std::set<int> lengths;
  for (const auto& [name, scans] : expected.scans) lengths.insert(scans);
  for (const int length : lengths) {
    const auto found = boundedVerdicts(GetParam(), expected.options, length);
    const auto shorter = length > 1 ? boundedVerdicts(GetParam(), expected.options, length - 1) : decltype(found)();
    for (const auto& [name, scans] : expected.scans) {
      if (scans != length) continue;
      EXPECT_EQ(found.at(name), std::make_pair(expected.verdicts.at(name), length)) << name;
      if (length == 1) continue;
      EXPECT_EQ(shorter.at(name).first, "HOLDS TO BOUND " + std::to_string(length - 1)) << name;
    }
  }
}

TEST(Corpus, OwesNoMoreThanIsStated) {
  std::size_t open = 0, declared = 0, refuted = 0, withProperties = 0;
  for (const fs::path& file : test::corpusFiles()) {
    const Expectation expected = expectationOf(file);
    withProperties += expected.verdicts.empty() ? 0 : 1;
    open += expected.open.size();
    declared += expected.open.size() + expected.verdicts.size();
    for (const auto& [name, verdict] : expected.verdicts)
      refuted += verdict == "VIOLATED" || verdict == "UNREACHABLE" ? 1 : 0;
  }
  EXPECT_LE(open, mostOpen);
  EXPECT_GE(declared, 120U);
  EXPECT_GE(withProperties, 25U);
  EXPECT_GE(refuted * 3, declared) << refuted << " of " << declared << " are violated or unreachable";
}

INSTANTIATE_TEST_SUITE_P(Programs, CorpusProgram, testing::ValuesIn(test::corpusFiles()),
                         [](const auto& info) { return test::testNameOf(info.param); });

}  // namespace
}  // namespace rungproof
