// What the chapters of the guide show is what happens: their files are written, their commands run in the order of the
// text, and each line of output that they show comes, in that order; "..." stands for lines that are left out.
#include "frontend/guide/chapter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <regex>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "frontend/guide/markdown.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

struct Ran {
  int exit = 0;
  std::string out;
};

std::vector<std::string> words(const std::string& line) {
  std::vector<std::string> found;
  std::string word;
  bool isQuoted = false;
  for (const char c : line + " ") {
    if (c == '"') {
      isQuoted = !isQuoted;
    } else if (c == ' ' && !isQuoted) {
      if (!word.empty()) found.push_back(word);
      word.clear();
    } else {
      word += c;
    }
  }
  return found;
}

/// A command of the text; one of another program through the shell.
Ran ran(const std::string& line) {
  std::vector<std::string> arguments = words(line);
  if (arguments.front() == "rungproof") {
    arguments.erase(arguments.begin());
    std::istringstream in;
    std::ostringstream out;
    const int exit = runProgram(arguments, {in, out, out});
    return {exit, out.str()};
  }
  Ran result;
  FILE* pipe = ::popen((line + " 2>&1").c_str(), "r");
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) result.out.append(part.data(), n);
  result.exit = ::pclose(pipe) / 256;
  return result;
}

std::string withoutTimes(const std::string& text) {
  return std::regex_replace(text, std::regex("in [0-9]+\\.[0-9]+ s\\b"), "in * s");
}

/// Why the output does not show what the text says; empty: it does. A line that ends in a space may go on.
std::string contradiction(const std::vector<std::string>& shown, const std::string& out) {
  std::istringstream lines(withoutTimes(out));
  std::string line;
  bool mayPass = false;
  for (const std::string& wanted : shown) {
    if (wanted == "...") {
      mayPass = true;
      continue;
    }
    const std::string text = withoutTimes(wanted);
    for (bool isFound = false; !isFound; mayPass = mayPass && !isFound) {
      if (!std::getline(lines, line)) return "'" + wanted + "' does not come";
      isFound = line == text || (text.ends_with(" ") && line.starts_with(text));
      if (!isFound && !mayPass) return "'" + wanted + "' is wanted, '" + line + "' comes";
    }
  }
  return !mayPass && std::getline(lines, line) ? "'" + line + "' is not shown" : "";
}

class ChapterTest : public testing::TestWithParam<Chapter> {};

TEST_P(ChapterTest, ShowsWhatHappens) {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.folder());
  int lastExit = 0;
  for (const CodeBlock& block : codeBlocksOf(GetParam().text)) {
    if (block.kind.starts_with("file ")) folder.file(block.kind.substr(5), block.text);
    if (block.kind != "console") continue;
    std::istringstream lines(block.text);
    std::vector<std::pair<std::string, std::vector<std::string>>> commands;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("$ "))
        commands.push_back({line.substr(2), {}});
      else if (!commands.empty())
        commands.back().second.push_back(line);
    }
    for (const auto& [command, shown] : commands) {
      const Ran result = command == "echo $?" ? Ran{lastExit, std::to_string(lastExit) + "\n"} : ran(command);
      EXPECT_EQ(contradiction(shown, result.out), "") << command << "\n" << result.out;
      lastExit = result.exit;
    }
  }
  std::filesystem::current_path(before);
}

INSTANTIATE_TEST_SUITE_P(Guide, ChapterTest, testing::ValuesIn(chapters().begin(), chapters().end()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Contradiction, IsSeen) {
  EXPECT_EQ(contradiction({"a", "b"}, "a\nb\n"), "");
  EXPECT_EQ(contradiction({"a", "..."}, "a\nb\nc\n"), "");
  EXPECT_EQ(contradiction({"...", "c"}, "a\nb\nc\n"), "");
  EXPECT_EQ(contradiction({"in 0.01 s"}, "in 3.20 s\n"), "");
  EXPECT_NE(contradiction({"a"}, "a\nb\n"), "");
  EXPECT_NE(contradiction({"b"}, "a\nb\n"), "");
  EXPECT_NE(contradiction({"...", "d"}, "a\nb\n"), "");
  EXPECT_NE(contradiction({"...", "b", "d"}, "a\nb\nc\nd\n"), "") << "between two lines nothing may be left out";
}

}  // namespace
}  // namespace rungproof::test
