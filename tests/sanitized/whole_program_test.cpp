// Every command over programs of the corpus, whole and damaged, in a copy of the program under the address and
// undefined-behaviour sanitizers: what they find ends this process. The verdicts are the business of other tests; here
// a command must come to an end with one of its exit codes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

using Arguments = std::vector<std::string>;

/// Every `step`-th program of each folder of the corpus, so that every kind is among them.
std::vector<std::string> corpusSample(std::size_t step) {
  std::vector<std::string> all, sample;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(RUNGPROOF_SOURCE_DIR) / "corpus")) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".awl" || ending == ".stl" || ending == ".xml") all.push_back(entry.path().string());
  }
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); i += step) sample.push_back(all[i]);
  return sample;
}

/// What each command is asked for; `file` is a program.
std::vector<Arguments> commandsOn(const std::string& file, const std::string& seconds) {
  return {{"lint", "--isolated", file},
          {"lint", "--isolated", "--prove", "--timeout", seconds, "--format", "json", file},
          {"prove", "--isolated", "--builtin", "--timeout", seconds, file},
          {"sim", "--isolated", "--scans", "5", "--trace", "-", file},
          {"export", "--isolated", "--format", "btor2", file},
          {"export", "--isolated", "--format", "smv", file},
          {"export", "--isolated", "--format", "aiger", file},
          {"export", "--isolated", "--format", "smt2", file},
          {"show", "--isolated", "--as", "lad", file},
          {"show", "--isolated", "--as", "fbd", file},
          {"show", "--isolated", "--as", "stl", file},
          {"xref", "--isolated", file}};
}

void runAll(const std::string& file, const std::string& seconds) {
  for (const Arguments& arguments : commandsOn(file, seconds)) {
    const ProgramRun result = run(arguments);
    EXPECT_GE(result.exit, 0) << arguments[0] << " " << file;
    EXPECT_LE(result.exit, 3) << arguments[0] << " " << file;
  }
}

TEST(WholeProgram, CommandsOnTheCorpus) {
  for (const std::string& file : corpusSample(27)) runAll(file, "200ms");
}

TEST(WholeProgram, CommandsOnDamagedPrograms) {
  const TemporaryFolder folder;
  const unsigned seed = 41;
  std::mt19937 random(seed);
  for (const std::string& file : corpusSample(31)) {
    std::string text = contentOf(file);
    for (int k = 0; k < 4 && !text.empty(); ++k) {
      const std::size_t at = random() % text.size();
      if (k % 2 == 0)
        text[at] = static_cast<char>('0' + random() % 75);
      else
        text.erase(at, random() % 12);
    }
    runAll(folder.file("damaged" + fs::path(file).extension().string(), text), "100ms");
  }
}

TEST(WholeProgram, EveryExitIsItsOwn) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", mainBlock("Network 1\nLD I0.0\n= Q0.0\n"));
  EXPECT_EQ(run({"prove", "--isolated", folder.path("missing.awl")}).exit, 2);
  EXPECT_EQ(run({"nonsense"}).exit, 2);
  EXPECT_EQ(run({"sim", "--isolated", "--scans", "3", file}).exit, 0);
}

}  // namespace
}  // namespace rungproof::test
