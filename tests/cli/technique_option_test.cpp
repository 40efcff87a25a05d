// --without and --verbose: techniques of the prover by name, and what each has done, for people and for programs.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/schedule/technique.hpp"
#include "schema_check.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

// Q0.0 follows I0.0 in the same scan, which one scan shows.
std::string follower(const TemporaryFolder& folder) {
  return folder.file("follower.awl", mainBlock("//@ prove follows: Q0.0 implies I0.0\nNetwork 1\nLD I0.0\n= Q0.0\n"));
}

TEST(TechniqueOption, AnUnknownNameListsAll) {
  const TemporaryFolder folder;
  const ProgramRun tried = run({"prove", "--isolated", "--without", "magic", follower(folder)});
  EXPECT_EQ(tried.exit, 2);
  EXPECT_NE(tried.err.find("no technique 'magic'"), std::string::npos) << tried.err;
  for (const TechniqueInfo& technique : techniqueTable())
    EXPECT_NE(tried.err.find(technique.name), std::string::npos) << technique.name;
}

TEST(TechniqueOption, IsInNoHelp) {
  for (const char* command : {"prove", "lint", "equiv"})
    EXPECT_EQ(run({command, "--help"}).out.find("--without"), std::string::npos) << command;
}

TEST(TechniqueOption, SwitchesOff) {
  const TemporaryFolder folder;
  const auto techniquesOf = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"prove", "--isolated", "--verbose", "--format", "json"});
    arguments.push_back(follower(folder));
    const nlohmann::json json = nlohmann::json::parse(run(arguments).out);
    const std::string schema = std::string(RUNGPROOF_SOURCE_DIR) + "/frontend/report/schema.json";
    EXPECT_EQ(schemaFaults(json, nlohmann::json::parse(contentOf(schema))), std::vector<std::string>());
    EXPECT_EQ(json["properties"][0]["verdict"], "PROVED");
    std::map<std::string, int> settled;
    for (const nlohmann::json& row : json["techniques"])
      settled[row["name"]] = row["settled"].is_null() ? -1 : row["settled"].get<int>();
    return settled;
  };
  EXPECT_EQ(techniquesOf({})["one-scan"], 1);
  const std::map<std::string, int> rest = techniquesOf({"--without", "one-scan,state-pairs"});
  EXPECT_FALSE(rest.contains("one-scan"));
  EXPECT_FALSE(rest.contains("state-pairs"));
}

TEST(TechniqueOption, VerbosePrintsATable) {
  const TemporaryFolder folder;
  const std::string file = follower(folder);
  const std::string plain = run({"prove", "--isolated", file}).out;
  const std::string verbose = run({"prove", "--isolated", "--verbose", file}).out;
  EXPECT_EQ(plain.find("technique "), std::string::npos) << plain;
  EXPECT_NE(verbose.find("technique              asked   settled    seconds\n"), std::string::npos) << verbose;
  // Asked of the property and of its premise, which can be met and is settled by a run.
  EXPECT_NE(verbose.find("\none-scan                   2         1 "), std::string::npos) << verbose;
}

}  // namespace
}  // namespace rungproof::test
