// The GitHub Action and the hooks for pre-commit name commands, options and forms that exist.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "frontend/command.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

std::string fileText(const std::string& name) {
  return test::contentOf(std::string(RUNGPROOF_SOURCE_DIR) + "/" + name);
}

TEST(CiFiles, HooksNameCommandsAndOptions) {
  const std::string text = fileText(".pre-commit-hooks.yaml");
  const std::regex entry("entry: rungproof ([a-z]+)( --[a-z-]+)?");
  int hooks = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), entry), end; at != end; ++at, ++hooks) {
    const Command* command = commandNamed((*at)[1].str());
    ASSERT_NE(command, nullptr) << (*at)[0];
    if ((*at)[2].length() == 0) continue;
    ArgumentTable table;
    command->setup(table);
    const std::string option = (*at)[2].str().substr(1);
    EXPECT_TRUE(std::ranges::any_of(table.rows(), [&](const Argument& row) { return row.longName() == option; }))
        << option;
  }
  EXPECT_EQ(hooks, 4);
}

TEST(CiFiles, ActionWritesFormsThatExist) {
  const std::string text = fileText("frontend/ci/action.yml");
  const std::regex form("--format \"?([a-z]+)");
  int forms = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), form), end; at != end; ++at, ++forms)
    EXPECT_NE(reporterNamed((*at)[1].str()), nullptr) << (*at)[1];
  EXPECT_EQ(forms, 3);
  EXPECT_NE(text.find("bash .ci/install"), std::string::npos);
  EXPECT_FALSE(fileText(".ci/install").empty());
}

// The runner refuses '..' in a cache path, and hashFiles sees no file outside the workspace: the first step would fail,
// or keep an old program for ever.
TEST(CiFiles, ActionNamesItsSourcesWithoutLeavingTheWorkspace) {
  const std::string text = fileText("frontend/ci/action.yml");
  int lines = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t word = line.find_first_not_of(' ');
    if (word == std::string::npos || line[word] == '#') continue;
    if (!line.substr(word).starts_with("path:") && !line.substr(word).starts_with("key:")) continue;
    ++lines;
    EXPECT_EQ(line.find(".."), std::string::npos) << line;
    EXPECT_NE(line.find("steps.sources.outputs."), std::string::npos) << line;
    EXPECT_EQ(line.find("action_ref"), std::string::npos) << "a branch moves, its name stays: " << line;
  }
  EXPECT_EQ(lines, 2);
  EXPECT_EQ(text.find("hashFiles("), std::string::npos);
}

}  // namespace
}  // namespace rungproof
