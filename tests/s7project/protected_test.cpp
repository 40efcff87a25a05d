// Know-how protected blocks are run and analysed, and no command prints a statement of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using test::TemporaryFolder;

/// Spellings of what stands in FC 3 and nowhere else, in any set of mnemonics.
constexpr const char* secrets[] = {"77.3", "4711", "MW78", "MW 78", "Secret of the house"};

void expectSecret(const test::ProgramRun& run, const std::string& what) {
  for (const char* secret : secrets)
    EXPECT_FALSE(run.says(secret)) << what << ": " << secret << "\n" << run.out << run.err;
}

/// Runs that take long are made in one format only: all formats print one report.
bool secondsLong(const std::vector<std::string>& arguments) {
  return std::ranges::find(arguments, "--self-check") != arguments.end() ||
         std::ranges::find(arguments, "--builtin") != arguments.end();
}

TEST(S7Protected, NoCommandPrintsAStatement) {
  const TemporaryFolder folder;
  const std::string project = writeFiles(folder, test::writeProject({test::plantPart()}, 1252));
  const std::string properties = folder.file("p.props", "prove stop: I0.1 implies not Q0.0\n");
  const std::string changed = folder.file("other.awl", test::plantSource());
  const std::vector<std::vector<std::string>> commands = {
      {"lint"},
      {"lint", "--prove"},
      {"lint", "--select", "ALL"},
      {"check"},
      {"check", "--format", "json"},
      {"show"},
      {"show", "--as", "stl"},
      {"show", "--as", "awl"},
      {"show", "--as", "fbd"},
      {"show", "--svg"},
      {"show", "--list"},
      {"xref"},
      {"xref", "--format", "json"},
      {"diff", changed},
      {"diff", changed, "--show", "stl"},
      {"equiv", changed},
      {"sim", "--scans", "5"},
      {"prove", "--props", properties, "--show", "stl"},
      {"prove", "--props", properties, "--self-check"},
      {"prove", "--props", properties},
      {"prove", "--props", properties, "--show", "ladder"},
      {"prove", "--props", properties, "--builtin"},
      {"prove", "--props", properties, "--certificate", folder.path("certificates")},
  };
  for (std::vector<std::string> arguments : commands) {
    arguments.insert(arguments.begin() + 1, "--isolated");
    arguments.push_back(project);
    std::string what;
    for (const std::string& argument : arguments) what += argument + " ";
    const bool hasFormats = arguments[0] == "lint" || (arguments[0] == "prove" && !secondsLong(arguments));
    for (const char* format : {"human", "concise", "json", "sarif", "github", "gitlab", "html", "junit"}) {
      std::vector<std::string> given = arguments;
      if (hasFormats) given.insert(given.end(), {"--format", format});
      expectSecret(test::run(given), what + format);
      if (!hasFormats) break;
    }
  }
  for (const char* format : {"btor2", "smt2", "smv", "aiger-ascii"})
    expectSecret(test::run({"export", "--isolated", "--props", properties, "--format", format, project}), format);
  EXPECT_EQ(test::run({"export", "--isolated", "--props", properties, "--format", "smt2", project}).exit, 2);
  std::error_code error;
  EXPECT_TRUE(!std::filesystem::exists(folder.path("certificates"), error) ||
              std::filesystem::is_empty(folder.path("certificates"), error));
}

// Without its body the block would leave M77.4 alone: that it is written shows that the code counts.
TEST(S7Protected, CodeCountsForVerdicts) {
  const TemporaryFolder folder;
  const std::string project = writeFiles(folder, test::writeProject({test::plantPart()}, 1252));
  const std::string properties = folder.file("p.props", "prove both: M77.4 implies M77.3\nreach value: MW78 == 4711\n");
  const test::ProgramRun run = test::run({"prove", "--isolated", "--external", "MB77", "--props", properties, project});
  EXPECT_TRUE(run.says("REACHABLE")) << run.out << run.err;
  EXPECT_FALSE(run.says("NOT COVERED")) << run.out << run.err;
  const test::ProgramRun contract =
      test::run({"prove", "--isolated", "--protected", "contract", "--props", properties, project});
  EXPECT_TRUE(contract.says("NOT COVERED")) << contract.out << contract.err;
  EXPECT_TRUE(contract.says("FC3")) << contract.out << contract.err;
}

TEST(S7Protected, FindingNamesBlockAndNetwork) {
  const TemporaryFolder folder;
  test::ProjectPart part = test::plantPart();
  for (mc7::StoredBlock& block : part.blocks) {
    if (block.key == step7::BlockKey{step7::BlockKind::Fc, 5}) block.isProtected = true;
  }
  const test::ProgramRun run = test::run({"lint", "--isolated", "--select", "ALL", "--format", "json",
                                          writeFiles(folder, test::writeProject({part}, 1252))});
  EXPECT_FALSE(run.says("M92.0")) << run.out;
}

}  // namespace
}  // namespace rungproof
