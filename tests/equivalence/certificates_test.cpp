// Every EQUAL comes with certificates that a second solver (the program cvc5) accepts, also where the graph of the two
// programs decides by itself; and the certificates of a pair do not hold of another one.
#include "analysis/portfolio/certificate.hpp"
#include "tests/corpus/command_output.hpp"
#include "tests/equivalence/pairs.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {

namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

Equivalence certified(const Pair& pair) {
  const ProgramInput before = pairSide("old.awl", exportOf(pair.before), pair.properties);
  const ProgramInput after = pairSide("new.awl", exportOf(pair.after), pair.properties);
  EquivalenceOptions options = optionsOf(pair, before.program, after.program);
  options.prover.certificates = true;
  return compareBehaviour({&before.program, before.properties}, {&after.program, after.properties}, options);
}

/// What is to be proved of the outputs of a pair in one scan from memory that corresponds, judged without invariants.
std::vector<CheckResult> judgedBySurface(const Pair& pair) {
  const ProgramInput before = pairSide("old.awl", exportOf(pair.before), "");
  const ProgramInput after = pairSide("new.awl", exportOf(pair.after), "");
  const ProgramMatch match = matchPrograms(before.program, after.program);
  ProductOptions options;
  options.trailBefore = std::make_shared<Trail>();
  options.trailAfter = std::make_shared<Trail>();
  const Side oldSide{&before.program, {}}, newSide{&after.program, {}};
  const ProgramProduct simplified(oldSide, newSide, match, options);
  options.trailBefore->isFollowed = options.trailAfter->isFollowed = true;
  ProgramProduct written(oldSide, newSide, match, options);
  std::vector<bool> merges;
  for (std::size_t i = 0; i < written.newStateCount(); ++i) merges.push_back(written.isMergeable(i));
  const JoinedSystem joined = written.merged(merges, true);
  const std::vector<Question> questions = outputQuestions(joined);
  CertificateWriter writer(joined.system);
  for (const Question& question : questions) writer.add(question, {});
  return writer.check({});
}

}  // namespace

class EqualPairs : public testing::TestWithParam<Pair> {};

TEST_P(EqualPairs, HaveCertificatesThatCvc5Accepts) {
  ASSERT_NE(outputOf("command -v cvc5"), "") << "the package cvc5 is missing; see .ci/install";
  const TemporaryFolder folder;
  const Equivalence found = certified(GetParam());
  ASSERT_EQ(equalityText(found.equality), "EQUAL");
  for (const std::string& name : found.uncertified) ADD_FAILURE() << "no certificate for " << name;
  ASSERT_GE(found.certificates.size(), found.outputs.size() + 1) << "memory, every output, RUN; then requests";
  EXPECT_EQ(found.certificates.front().first, "memory");
  for (std::size_t i = 0; i < found.certificates.size(); ++i) {
    const auto& [name, text] = found.certificates[i];
    if (i > 0) {
      if (i <= found.outputs.size())
        EXPECT_EQ(name, found.outputs[i - 1].name);
      else
        EXPECT_TRUE(name.starts_with("request") || name.starts_with("decisions_")) << name;
      EXPECT_EQ(countOf(text, "; safety of"), name.starts_with("decisions_") ? 0U : 1U);
    }
    const std::size_t asked = countOf(text, "(check-sat)");
    ASSERT_GT(asked, 0U) << name;
    const std::string answer =
        outputOf("cvc5 --incremental --lang smt2 --tlimit=60000 '" + folder.file("c.smt2", text) + "'");
    EXPECT_EQ(countOf(answer, "unsat\n"), asked) << name << ": " << answer;
    EXPECT_EQ(answer.size(), asked * 6) << name << ": " << answer;
  }
}

namespace {
std::vector<Pair> equalPairs() {
  std::vector<Pair> found;
  std::ranges::copy_if(pairs, std::back_inserter(found), [](const Pair& pair) { return pair.truth == equal; });
  return found;
}
}  // namespace

TEST(EqualityCertificate, OfOneProgramIsRefusedForAChangedOne) {
  struct Change {
    const char *before, *after, *changed;
  };
  // The obligations of `after` hold by themselves; those of `changed`, one instruction away, must be refused.
  for (const Change& c : std::initializer_list<Change>{
           {"LD I0.0;A I0.1;= Q0.0", "LD I0.1;A I0.0;= Q0.0", "LD I0.1;AN I0.0;= Q0.0"},
           {"LD I0.0;O Q0.0;AN I0.1;= Q0.0", "LDN I0.1;LD I0.0;O Q0.0;ALD;= Q0.0",
            "LDN I0.1;LD I0.0;O Q0.0;OLD;= Q0.0"},
           {"LD I0.0;TON T37,30|LD T37;= Q0.0", "LD I0.0;TON T37,30|LD T37;O T37;= Q0.0",
            "LD I0.0;TON T37,30|LDN T37;O T37;= Q0.0"},
           {"LD SM0.0;MOVW IW0,QW0", "LD SM0.0;MOVB IB0,QB0;MOVB IB1,QB1", "LD SM0.0;MOVB IB0,QB0;MOVB IB0,QB1"}}) {
    for (const CheckResult result : judgedBySurface({"same", c.before, c.after, equal, ""}))
      EXPECT_EQ(result, CheckResult::Valid) << c.after;
    const std::vector<CheckResult> refused = judgedBySurface({"changed", c.before, c.changed, different, ""});
    EXPECT_EQ(std::ranges::count(refused, CheckResult::Unknown), 0) << c.changed;
    EXPECT_GT(std::ranges::count(refused, CheckResult::Invalid), 0) << c.changed;
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, EqualPairs, testing::ValuesIn(equalPairs()),
                         [](const testing::TestParamInfo<Pair>& info) { return info.param.name; });

}  // namespace rungproof::test
