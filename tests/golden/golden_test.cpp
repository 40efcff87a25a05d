// Everything that the program prints is pinned by the *.test files below this folder: help pages, reports, pages of
// rules, errors. See golden_file.hpp for their form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "child_process.hpp"
#include "golden_file.hpp"
#include "tests/temporary_folder.hpp"

namespace golden {
namespace {

namespace fs = std::filesystem;

bool rewrite = false;

std::string contentOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string nameOf(const fs::path& file) {
  std::string name = fs::relative(file, GOLDEN_DIR).replace_extension().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

class GoldenTest : public testing::TestWithParam<fs::path> {};

TEST_P(GoldenTest, PrintsWhatTheFileSays) {
  const std::string text = contentOf(GetParam());
  const GoldenFile expected = readTest(text);
  ASSERT_EQ(expected.fault, "") << GetParam();
  const rungproof::test::TemporaryFolder folder;
  for (const NamedText& file : expected.files) {
    folder.file(file.name, file.text);
  }
  GoldenFile actual = expected;
  for (CommandRun& run : actual.runs) {
    const Outcome outcome =
        runChild(GOLDEN_PROGRAM, splitArguments(run.arguments), folder.folder().string(), run.input);
    run.exit = outcome.exit;
    run.out = normalised(outcome.out);
    run.err = normalised(outcome.err);
    for (NamedText& file : run.written) file.text = normalised(contentOf(folder.folder() / file.name));
  }
  if (rewrite && toText(actual) != text) {
    std::ofstream(GetParam(), std::ios::binary) << toText(actual);
    return;
  }
  for (std::size_t i = 0; i < expected.runs.size(); ++i) {
    const CommandRun& wanted = expected.runs[i];
    const CommandRun& got = actual.runs[i];
    SCOPED_TRACE("rungproof " + wanted.arguments + "\n(test_golden --rewrite writes what it prints into the file)");
    EXPECT_EQ(got.out, wanted.out);
    EXPECT_EQ(got.err, wanted.err);
    EXPECT_EQ(got.exit, wanted.exit);
    for (std::size_t k = 0; k < wanted.written.size(); ++k)
      EXPECT_EQ(got.written[k].text, wanted.written[k].text) << wanted.written[k].name;
  }
}

std::vector<fs::path> testFiles() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(GOLDEN_DIR)) {
    if (entry.path().extension() == ".test") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

INSTANTIATE_TEST_SUITE_P(All, GoldenTest, testing::ValuesIn(testFiles()),
                         [](const auto& parameter) { return nameOf(parameter.param); });

}  // namespace
}  // namespace golden

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i) golden::rewrite |= std::strcmp(argv[i], "--rewrite") == 0;
  return RUN_ALL_TESTS();
}
