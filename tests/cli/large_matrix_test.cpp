// Each reader and each command over long inputs: an answer or a refusal, no signal, and at most 2 GB of address space.
// Nothing looks at a clock but one generous limit of processor time, which only a program exceeds that does not end.
// The ordinary form takes 5,000 elements and one command for each program, another one for the next;
// RUNGPROOF_LARGE=all takes 100,000 and all commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "tests/cli/large_forms.hpp"
#include "tests/measured_process.hpp"

namespace rungproof::test {
namespace {

bool isWholeMatrix() { return std::getenv("RUNGPROOF_LARGE") != nullptr; }
std::size_t elementCount() { return isWholeMatrix() ? 100'000 : 5'000; }
constexpr double hangLimit = 120;  ///< seconds of processor time
constexpr std::uint64_t addressSpace = std::uint64_t{2} << 30;

void expectAnswer(const std::string& name, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), RUNGPROOF_BINARY_DIR "/rungproof");
  const ProcessRun made = runProcess(arguments, hangLimit, addressSpace);
  const std::string end = made.output.substr(made.output.size() - std::min<std::size_t>(made.output.size(), 500));
  EXPECT_FALSE(made.isCut) << name << '\n' << end;
  EXPECT_TRUE(made.exit >= 0 && made.exit <= 3) << name << ": exit " << made.exit << '\n' << end;
  EXPECT_FALSE(made.output.empty() && made.exit != 0) << name << ": exit " << made.exit << " without a word";
}

/// Each command with its options; "pair" stands for a program against itself.
struct LargeCommand {
  std::vector<std::string> words;
  bool isPair = false;
};
const std::vector<LargeCommand> largeCommands = {
    {{"lint", "--isolated"}},
    {{"show"}},
    {{"sim", "--isolated", "--scans", "2"}},
    {{"check", "--isolated"}},
    {{"xref", "--isolated"}},
    {{"prove", "--isolated", "--builtin", "--timeout", "2s"}},
    {{"export", "--isolated", "--builtin", "--format", "btor2"}},
    {{"equiv", "--isolated", "--timeout", "2s"}, true},
    {{"diff", "--isolated", "--timeout", "2s"}, true},
    {{"test", "--isolated", "--coverage"}},
};

std::vector<std::string> lineOf(const LargeCommand& command, std::vector<std::string> program,
                                const TemporaryFolder& folder) {
  std::vector<std::string> line = command.words;
  if (command.isPair) program = {program.front(), program.front()};
  if (line.front() == "test")
    line.insert(line.end(), {"--stimulus", folder.file("stimulus.csv", "scan,I0.0\n1,1\n2,0\n")});
  line.insert(line.end(), program.begin(), program.end());
  return line;
}

/// "contacts in series" as "contacts_in_series".
std::string testName(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return text;
}

class LargeProgram : public ::testing::TestWithParam<std::size_t> {};

TEST_P(LargeProgram, IsAnAnswerOrARefusal) {
  const LargeForm& form = largePrograms()[GetParam()];
  const TemporaryFolder folder;
  const std::vector<std::string> program = form.arguments(folder, elementCount());
  for (std::size_t c = 0; c < largeCommands.size(); ++c) {
    if (!isWholeMatrix() && c != GetParam() % largeCommands.size()) continue;
    const LargeCommand& command = largeCommands[c];
    expectAnswer(form.name + ", " + command.words.front(), lineOf(command, program, folder));
  }
}
INSTANTIATE_TEST_SUITE_P(Forms, LargeProgram, ::testing::Range(std::size_t{0}, largePrograms().size()),
                         [](const auto& info) { return testName(largePrograms()[info.param].name); });

class LargeInputFile : public ::testing::TestWithParam<std::size_t> {};

TEST_P(LargeInputFile, IsAnAnswerOrARefusal) {
  const LargeForm& form = largeInputs()[GetParam()];
  const TemporaryFolder folder;
  expectAnswer(form.name, form.arguments(folder, elementCount()));
}
INSTANTIATE_TEST_SUITE_P(Forms, LargeInputFile, ::testing::Range(std::size_t{0}, largeInputs().size()),
                         [](const auto& info) { return testName(largeInputs()[info.param].name); });

}  // namespace
}  // namespace rungproof::test
