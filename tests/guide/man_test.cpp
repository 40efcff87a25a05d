// Manual pages: one for the program and one for each command, and groff reads them without a warning.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "frontend/cli/cli.hpp"
#include "frontend/guide/man_page.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

std::string outputOf(const std::string& command) {
  FILE* pipe = ::popen(command.c_str(), "r");
  std::string out;
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) out.append(part.data(), n);
  ::pclose(pipe);
  return out;
}

TEST(ManPages, ThereIsOneForEachCommand) {
  const std::vector<GuideFile> pages = manPages();
  ASSERT_EQ(pages.size(), allCommands().size() + 1);
  EXPECT_EQ(pages.front().name, "rungproof.1");
  for (const Command* command : allCommands()) {
    EXPECT_NE(pages.front().text.find("rungproof\\-" + std::string(command->name)), std::string::npos) << command->name;
    const auto isOwn = [&](const GuideFile& page) {
      return page.name == "rungproof-" + std::string(command->name) + ".1";
    };
    EXPECT_EQ(std::count_if(pages.begin(), pages.end(), isOwn), 1) << command->name;
  }
  for (const GuideFile& page : pages) {
    for (const char* part : {".TH ", ".SH NAME\n", ".SH SYNOPSIS\n", ".SH DESCRIPTION\n", ".SH EXIT STATUS\n"})
      EXPECT_NE(page.text.find(part), std::string::npos) << page.name << part;
  }
}

TEST(ManPages, TextIsNoRequest) {
  EXPECT_EQ(roffText(".TH a"), "\\&.TH a");
  EXPECT_EQ(roffText("a-b\\c"), "a\\-b\\ec");
}

TEST(ManPages, GroffHasNothingToSay) {
  const bool hasGroff = outputOf("command -v groff") != "";
  if (!hasGroff) std::puts("no groff on this machine: pages are held to have their sections only");
  const test::TemporaryFolder folder;
  for (const GuideFile& page : manPages()) {
    EXPECT_TRUE(page.text.ends_with("\n")) << page.name;
    if (!hasGroff) continue;
    const std::string file = folder.file(page.name, page.text);
    EXPECT_EQ(outputOf("groff -ww -b -z -man -Tutf8 -K utf8 '" + file + "' 2>&1"), "") << page.name;
    const std::string shown = outputOf("groff -man -Tutf8 -K utf8 -P-cbou '" + file + "' 2>/dev/null");
    EXPECT_NE(shown.find("SYNOPSIS"), std::string::npos) << page.name;
  }
}

}  // namespace
}  // namespace rungproof
