// ABC (the program berkeley-abc), which knows nothing of this project, answers the questions of the corpus from the
// AIGER export. Where it comes to an answer within its time, the answer is the verdict that the corpus states: a bad
// state that can be asserted means VIOLATED or REACHABLE, one that cannot means PROVED, UNREACHABLE or VACUOUS.
#include <gtest/gtest.h>

#include <cstdio>
#include <set>

#include "analysis/export/system.hpp"
#include "analysis/proof/prover.hpp"
#include "analysis/proof/question_system.hpp"
#include "tests/corpus/command_output.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

/// Answers that must be there, so that an export which ABC cannot read does not pass unnoticed.
constexpr std::size_t leastDecided = 100;

struct AbcAnswers {
  std::set<std::size_t> asserted;
  bool isComplete = false;  ///< what is not asserted, is proved
  std::string text;
};

AbcAnswers askAbc(const std::string& file, int seconds) {
  AbcAnswers answers;
  answers.text = outputOf("berkeley-abc -q \"read_aiger " + file + "; pdr -a -T " + std::to_string(seconds) + "\"");
  std::size_t at = 0;
  while ((at = answers.text.find("Output", at)) != std::string::npos) {
    std::size_t number = 0;
    if (std::sscanf(answers.text.c_str() + at, "Output %zu was asserted", &number) == 1)
      answers.asserted.insert(number);
    ++at;
  }
  answers.isComplete = answers.text.find("Undecided = 0.") != std::string::npos;
  return answers;
}

TEST(Abc, AnswersTheCorpusAsItsVerdictsSay) {
  ASSERT_NE(outputOf("command -v berkeley-abc"), "") << "the package berkeley-abc is missing; see .ci/install";
  const TemporaryFolder folder;
  std::size_t decided = 0, asserted = 0;
  for (const fs::path& path : corpusFiles()) {
    const std::map<std::string, std::string> verdicts = trueVerdicts(path);
    if (verdicts.empty()) continue;
    const ProgramInput input = corpusInput(path);
    QuestionSystem side(input.program, input.properties, goalsOf(input.properties),
                        encoderOptionsOf(proverOptions(path)), CheckGroups{});
    const bool isExact = side.askedProperties().approximations().empty();
    const AbcAnswers answers = askAbc(folder.file("system.aig", exportAiger(side.system())), 1);
    ASSERT_NE(answers.text.find("Properties:"), std::string::npos) << path << ": " << answers.text;
    for (std::size_t i = 0; i < side.system().questions.size(); ++i) {
      const auto verdict = verdicts.find(side.system().questions[i].name);
      const bool isAsserted = answers.asserted.contains(i);
      if (verdict == verdicts.end() || (!isAsserted && !answers.isComplete) || (isAsserted && !isExact)) continue;
      if (verdict->second == "NOT COVERED") continue;  // code that was not read: the file says so, no answer counts
      ++decided;
      asserted += isAsserted ? 1 : 0;
      const bool canBe = verdict->second == "VIOLATED" || verdict->second == "REACHABLE";
      EXPECT_EQ(isAsserted, canBe) << path << ", " << verdict->first << " is " << verdict->second;
    }
  }
  EXPECT_GE(decided, leastDecided);
  EXPECT_GE(asserted, leastDecided / 4);
  RecordProperty("decided", static_cast<int>(decided));
  std::printf("ABC decided %zu questions, %zu of them asserted\n", decided, asserted);
}

}  // namespace
}  // namespace rungproof::test
