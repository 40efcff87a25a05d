// The GitHub Action and the hooks for pre-commit name commands, options and forms that exist.
#include <gtest/gtest.h>

#include <regex>

#include "frontend/command.hpp"
#include "program_run.hpp"

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

}  // namespace
}  // namespace rungproof
