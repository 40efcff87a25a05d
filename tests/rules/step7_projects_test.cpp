// Programs of the S7-300/400 without mistakes, as projects of all forms and as the editors and compilers write them:
// every rule that is on by default is silent, and what their comments ask for is understood.
#include <filesystem>

#include "analysis/lint/lint.hpp"
#include "frontend/input/program_input.hpp"
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

namespace fs = std::filesystem;

/// What readers and rules say at or above a warning.
std::vector<std::string> saidAbout(const std::vector<std::string>& files) {
  Program program = readProgram(files);
  const PropertySet properties = readProperties(program, {}, lookupIn(program));
  std::vector<std::string> said;
  for (const Finding& finding : program.findings) {
    if (finding.severity == Severity::Error) said.push_back(finding.rule + " " + finding.message);
  }
  const Facts facts(program, properties.externals);
  for (const Finding& finding : runRules(facts, RuleSelection(), {})) {
    if (finding.severity >= Severity::Warning) said.push_back(finding.rule + " " + finding.message);
  }
  return said;
}

TEST(Step7Projects, NothingIsSaidAboutThem) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(RUNGPROOF_SOURCE_DIR) / "tests/data/s7300_projects")) {
    EXPECT_EQ(saidAbout(expandFolders({entry.path().string()})), std::vector<std::string>()) << entry.path();
    ++count;
  }
  EXPECT_EQ(count, 10U);
}

TEST(Step7Projects, NorAboutWhatCompilersAndEditorsWrite) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(RUNGPROOF_SOURCE_DIR) / "tests/data/s7300_style")) {
    EXPECT_EQ(saidAbout({entry.path().string()}), std::vector<std::string>()) << entry.path();
    ++count;
  }
  EXPECT_EQ(count, 3U);
}

}  // namespace
}  // namespace rungproof::testing
