// The corpus keeps its word: every program states in its head which findings and verdicts are expected,
//     //! options --cpu 222
//     //! finding ADR001 MAIN 1        rule, block, network
//     //! verdict NAME: PROVED
// Findings of level warning and error must be exactly those; every declared property must have its verdict.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "frontend/cli.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Expectation {
  std::vector<std::string> options;
  std::multiset<std::string> findings;
  std::map<std::string, std::string> verdicts;
};

Expectation expectationOf(const fs::path& file) {
  Expectation expectation;
  std::ifstream stream(file, std::ios::binary);
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
    } else if (kind == "verdict") {
      const std::size_t colon = rest.rfind(": ");
      expectation.verdicts[rest.substr(0, colon)] = rest.substr(colon + 2);
    } else {
      ADD_FAILURE() << file << ": unknown line " << line;
    }
  }
  return expectation;
}

std::vector<fs::path> programs() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(RUNGPROOF_SOURCE_DIR) / "corpus")) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".awl" || ending == ".stl" || ending == ".xml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
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

class Corpus : public testing::TestWithParam<fs::path> {};

TEST_P(Corpus, FindingsAreThoseExpected) {
  const Expectation expected = expectationOf(GetParam());
  const Json report = runJson("lint", GetParam(), expected.options);
  ASSERT_TRUE(report.is_object());
  std::multiset<std::string> found;
  std::string all;
  for (const Json& finding : report["findings"]) {
    if (finding["severity"] == "note") continue;
    found.insert(finding["rule"].get<std::string>() + " " + finding["pou"].get<std::string>() + " " + std::to_string(finding["network"].get<int>()));
    all += "\n  " + finding["rule"].get<std::string>() + ": " + finding["message"].get<std::string>();
  }
  EXPECT_EQ(found, expected.findings) << all;
}

TEST_P(Corpus, VerdictsAreThoseExpected) {
  const Expectation expected = expectationOf(GetParam());
  if (expected.verdicts.empty()) return;
  std::vector<std::string> options = expected.options;
  options.insert(options.end(), {"--timeout", "30s"});
  const Json report = runJson("prove", GetParam(), options);
  ASSERT_TRUE(report.is_object());
  std::map<std::string, std::string> found;
  for (const Json& property : report["properties"]) found[property["name"]] = property["verdict"];
  EXPECT_EQ(found, expected.verdicts);
}

INSTANTIATE_TEST_SUITE_P(Programs, Corpus, testing::ValuesIn(programs()), [](const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.parent_path().filename().string() + "_" + info.param.stem().string();
  std::replace_if(name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace rungproof
