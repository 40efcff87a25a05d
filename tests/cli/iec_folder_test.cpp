// Texts of IEC 61131-3 in a folder: each file with a program is a program of its own, beside it stand the files with
// blocks and types; a configuration that runs the programs of other files makes them one project.
#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using test::TemporaryFolder;

constexpr const char* follower =
    "FUNCTION_BLOCK Follower VAR_INPUT x : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR q := x; END_FUNCTION_BLOCK\n";

std::string programNamed(const std::string& name, const std::string& output) {
  return "PROGRAM " + name + " VAR a AT %IX0.0, b AT %QX0." + output +
         " : BOOL; one : Follower; END_VAR one(x := a, q => b); END_PROGRAM\n";
}

TEST(IecFolder, TextsAreRead) {
  const TemporaryFolder folder;
  folder.file("main.st", "PROGRAM m VAR a AT %IX0.0 : BOOL; END_VAR a := ; END_PROGRAM\n");
  const auto lint = test::run({"lint", "--isolated", folder.path("")});
  EXPECT_EQ(lint.exit, 2) << lint.out << lint.err;
  EXPECT_NE(lint.out.find("main.st:1:"), std::string::npos) << lint.out << lint.err;
}

TEST(IecFolder, BlocksStandBesideEachProgram) {
  const TemporaryFolder folder;
  folder.file("blocks.st", follower);
  folder.file("first.st", programNamed("First", "0"));
  folder.file("second.st", programNamed("Second", "1"));
  const auto lint = test::run({"lint", "--isolated", folder.path("")});
  EXPECT_EQ(lint.exit, 0) << lint.out << lint.err;
  // Two programs: one that proves would have to say which of them.
  const auto proof = test::run({"prove", "--isolated", "--builtin", folder.path("first.st"), folder.path("blocks.st")});
  EXPECT_EQ(proof.exit, 0) << proof.out << proof.err;
}

TEST(IecFolder, AConfigurationJoinsTheProgramsOfOtherFiles) {
  const TemporaryFolder folder;
  folder.file("blocks.st", follower);
  folder.file("first.st", programNamed("First", "0"));
  folder.file("second.st", programNamed("Second", "1"));
  folder.file("plant.st",
              "CONFIGURATION c RESOURCE r ON PLC\nTASK t(INTERVAL := T#10ms, PRIORITY := 1);\n"
              "PROGRAM one WITH t : First;\nPROGRAM two WITH t : Second;\nEND_RESOURCE\nEND_CONFIGURATION\n");
  folder.file("asked.prop", "prove both: %QX0.0 = %QX0.1\n");
  const auto proof = test::run({"prove", "--isolated", "--props", folder.path("asked.prop"), folder.path("plant.st"),
                                folder.path("first.st"), folder.path("second.st"), folder.path("blocks.st")});
  EXPECT_EQ(proof.exit, 0) << proof.out << proof.err;
  EXPECT_NE(proof.out.find("PROVED  both"), std::string::npos) << proof.out;
}

}  // namespace
}  // namespace rungproof
