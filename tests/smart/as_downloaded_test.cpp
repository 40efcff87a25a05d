// --as-downloaded: what the editor leaves out of the download does not run, exactly that and nothing else; without it
// such a network is an error.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using Json = nlohmann::json;

/// Network 2 has an unknown name, 4 a wrong operand, 5 two rungs; each drives an output of its own.
constexpr const char* text =
    "ORGANIZATION_BLOCK MAIN:OB1\n//@ prove p: Q0.0 = I0.0\n//@ prove unknown name: Q0.1 = I0.1\n"
    "//@ prove wrong operand: VW0 = 5\n//@ prove two rungs: Q0.4 = I0.4\nBEGIN\n"
    "Network 1\nLD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\n"
    "Network 2\nLD Feeder_Full\n= Q0.1\n"
    "Network 3\nLD I0.2\n= Q0.2\nLD SM0.0\nMOVW 5, VW0\n"
    "Network 4\nLD SM0.0\nMOVW VW20480, VW0\n"
    "Network 5\nLD I0.3\n= Q0.3\nLD I0.4\n= Q0.4\n"
    "END_ORGANIZATION_BLOCK\n";

std::vector<std::string> command(const std::string& name, const std::string& file) {
  return {name, "--isolated", "--cpu", "ST40", file};
}

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(AsDownloaded, ProveLeavesOutWhatCheckCallsInvalid) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("a.awl", text);
  const Json checked =
      Json::parse(test::run(with(command("check", file), {"--language", "stl", "--format", "json"})).out);
  std::vector<int> invalid;
  for (const Json& network : checked["networks"]) {
    if (!network["valid"].get<bool>()) invalid.push_back(network["network"].get<int>());
  }
  ASSERT_EQ(invalid, (std::vector<int>{2, 4}));

  EXPECT_EQ(test::run(command("prove", file)).exit, 2) << "such a network is an error";
  const test::ProgramRun run = test::run(with(command("prove", file), {"--as-downloaded", "--format", "json"}));
  EXPECT_EQ(run.exit, 0) << run.out;
  const Json report = Json::parse(run.out);
  for (const Json& property : report["properties"]) EXPECT_EQ(property["verdict"], "PROVED") << property["name"];
  const Json leftOut = report["coverage"]["left_out"];
  ASSERT_EQ(leftOut.size(), 2U);
  EXPECT_NE(leftOut[0].get<std::string>().find("MAIN, network 2 ("), std::string::npos);
  EXPECT_NE(leftOut[0].get<std::string>().find("Feeder_Full"), std::string::npos);
  EXPECT_NE(leftOut[1].get<std::string>().find("MAIN, network 4 ("), std::string::npos);
  EXPECT_NE(test::run(with(command("prove", file), {"--as-downloaded"})).out.find("left out: MAIN, network 2"),
            std::string::npos);
}

TEST(AsDownloaded, SimRunsTheRest) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("a.awl", text);
  const std::string stimulus = folder.file("a.csv", "scan,I0.0,I0.2\n1,1,1\n");
  const std::vector<std::string> scan{"--stimulus", stimulus,         "--scans", "1",
                                      "--signals",  "Q0.0,Q0.1,Q0.2", "--trace", "-"};
  EXPECT_EQ(test::run(with(command("sim", file), scan)).exit, 2);
  const test::ProgramRun run = test::run(with(with(command("sim", file), scan), {"--as-downloaded"}));
  EXPECT_EQ(run.exit, 0) << run.err;
  EXPECT_NE(run.out.find("1,0,1"), std::string::npos) << run.out;
  EXPECT_NE((run.out + run.err).find("MAIN, network 2"), std::string::npos) << run.err;
}

/// What only ladder refuses is in the program when it is written as STL; what is damaged outside of networks is no
/// matter of the download.
TEST(AsDownloaded, OtherErrorsStayErrors) {
  const test::TemporaryFolder folder;
  const std::string damaged = folder.file("b.awl", std::string(text) + "SUBROUTINE_BLOCK\nBEGIN\nNetwork 1\nLD I0.0\n");
  EXPECT_EQ(test::run(with(command("prove", damaged), {"--as-downloaded"})).exit, 2);
  // A label that goes with its network takes the jump's meaning away: the rest is refused as it stands.
  const std::string jump = folder.file(
      "c.awl",
      "ORGANIZATION_BLOCK MAIN:OB1\n//@ prove p: never Q0.0\nBEGIN\nNetwork 1\nLD I0.0\nJMP 1\nNetwork 2\nLBL 1\nLD "
      "Nobody\n= Q0.0\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(test::run(with(command("prove", jump), {"--as-downloaded"})).exit, 2);
}

TEST(AsDownloaded, OtherCommandsTakeItToo) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("a.awl", text);
  EXPECT_EQ(test::run(with(command("export", file), {"--format", "btor2"})).exit, 2);
  const test::ProgramRun exported = test::run(with(command("export", file), {"--format", "btor2", "--as-downloaded"}));
  EXPECT_EQ(exported.exit, 0);
  EXPECT_NE(exported.out.find("left out: MAIN, network 2"), std::string::npos);
  EXPECT_EQ(test::run(with(command("equiv", file), {file})).exit, 2);
  const test::ProgramRun compared =
      test::run(with(command("equiv", file), {file, "--as-downloaded", "--format", "json"}));
  EXPECT_EQ(compared.exit, 0) << compared.out << compared.err;
  EXPECT_EQ(Json::parse(compared.out)["coverage"]["left_out"].size(), 2U);
}

}  // namespace
}  // namespace rungproof
