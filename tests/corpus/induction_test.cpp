// The corpus has proofs that bounded search alone does not give. For every property whose head says PROVED or
// UNREACHABLE the test asks whether one scan from any state, or from any state after one good scan, settles it; what
// is left needs longer induction or invariants about the states that can be reached.
#include <gtest/gtest.h>

#include "analysis/portfolio/portfolio.hpp"
#include "analysis/proof/question_system.hpp"
#include "tests/corpus/corpus_program.hpp"

namespace rungproof::test {
namespace {

TEST(CorpusInduction, TwentyPropertiesNeedMoreThanOneScan) {
  std::size_t settled = 0, deeper = 0;
  for (const std::filesystem::path& path : corpusFiles()) {
    const std::map<std::string, std::string> verdicts = trueVerdicts(path);
    if (verdicts.empty()) continue;
    const ProgramInput input = corpusInput(path);
    QuestionSystem side(input.program, input.properties, goalsOf(input.properties),
                        encoderOptionsOf(proverOptions(path)), {});
    PortfolioOptions options;
    options.effort = Effort::Together;
    options.check = false;
    const std::vector<QuestionAnswer> answers = answerQuestions(side.system(), options);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const auto verdict = verdicts.find(side.system().questions[i].name);
      if (verdict == verdicts.end() || (verdict->second != "PROVED" && verdict->second != "UNREACHABLE")) continue;
      ++(answers[i].answer == Answer::Proved ? settled : deeper);
    }
  }
  EXPECT_GE(deeper, 20U);
  std::printf("%zu proofs need one scan, %zu need longer induction or invariants\n", settled, deeper);
}

}  // namespace
}  // namespace rungproof::test
