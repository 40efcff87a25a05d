// The list of the manual's worked examples (tests/data/manual-examples.tsv): each names a test that exists. The list
// follows the headings "example" of chapter 6, so that one without a test shows.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace rungproof::manual {
namespace {

std::set<std::string> testsOf(const std::vector<std::string>& folders) {
  std::set<std::string> names;
  const std::regex head(R"(^TEST\((\w+), (\w+)\))");
  for (const std::string& folder : folders) {
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(RUNGPROOF_SOURCE_DIR "/tests/") + folder)) {
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        if (std::smatch found; std::regex_search(line, found, head))
          names.insert(found[1].str() + "." + found[2].str());
      }
    }
  }
  return names;
}

}  // namespace

TEST(ManualExamples, EachHasATest) {
  const std::set<std::string> tests = testsOf({"manual", "engine"});
  std::ifstream file(RUNGPROOF_SOURCE_DIR "/tests/data/manual-examples.tsv");
  ASSERT_TRUE(file.is_open());
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    ++rows;
    const std::size_t what = line.find('\t'), test = line.find('\t', what + 1);
    ASSERT_NE(test, std::string::npos) << line;
    EXPECT_TRUE(std::regex_match(line.substr(0, what), std::regex("00[0-4]:[0-9]+"))) << line;
    EXPECT_TRUE(tests.contains(line.substr(test + 1))) << line;
  }
  EXPECT_GE(rows, 80) << "examples and tables of chapter 6";
}

}  // namespace rungproof::manual
