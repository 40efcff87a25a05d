// What a program of the S7-300/400 costs who lints it or proves one interlock in it: 20,000 statements in 200 blocks
// with 100 data blocks are read and checked by every rule in half a second of a quiet machine, whatever the length of
// the data blocks, and a proof that needs two networks takes a few seconds, though all is encoded.
#include <gtest/gtest.h>

#include "analysis/lint/lint.hpp"
#include "frontend/input/project.hpp"
#include "tests/bench/step7_program.hpp"
#include "tests/machine_pace.hpp"
#include "tests/timing/measured_proof.hpp"

namespace rungproof::test {
namespace {

constexpr double most = 0.5, mostToProve = 3;  // s

struct Lint7 {
  std::size_t statements = 0, errors = 0, findings = 0;
};

Lint7 lintStep7(const std::string& text) {
  const Program program = readText("plant.awl", text);
  const Facts facts(program);
  const std::vector<Finding> findings = runRules(facts, RuleSelection(), {});
  return {program.instructionCount(), program.findings.size(), findings.size()};
}

double secondsOf(const Step7Size& size) {
  const std::string text = step7Program(size);
  Lint7 result;
  const double seconds = quietSeconds([&] { result = lintStep7(text); }, most / 2, 5);
  EXPECT_GE(result.statements, 20000U);
  EXPECT_EQ(result.errors, 0U);
  EXPECT_GT(result.findings, 0U);
  std::printf("%zu statements, %zu findings: %.0f ms of %.0f ms\n", result.statements, result.findings, seconds * 1000,
              most * 1000);
  return seconds;
}

TEST(Step7Lint, TwentyThousandStatementsInHalfASecond) { EXPECT_LE(secondsOf({}), most); }

TEST(Step7Lint, LongDataBlocksCostLittle) { EXPECT_LE(secondsOf({.unusedBytes = 16000}), most); }

// OB1 of the program calls all its blocks; the two outputs are written in networks that stand beside these calls.
TEST(Step7Proof, BlocksThatDoNotMatterCostLittle) {
  std::string text = step7Program({});
  const std::string end = "END_ORGANIZATION_BLOCK";
  const std::size_t at = text.rfind(end);
  ASSERT_NE(at, std::string::npos);
  text.insert(
      at,
      "NETWORK\n      A     I 900.0;\n      AN    Q 900.1;\n      =     Q 900.0;\nNETWORK\n      A     I 900.1;\n"
      "      AN    Q 900.0;\n      =     Q 900.1;\n//@ prove apart: never Q900.0 and Q900.1\n");
  const MeasuredProof proof = measureProof(text, {}, 3, mostToProve / 2);
  EXPECT_EQ(proof.verdicts, (std::map<std::string, std::string>{{"apart", "PROVED"}}));
  std::printf("%.0f ms of %.0f ms\n", proof.cpuSeconds * 1000, mostToProve * 1000);
  EXPECT_LE(proof.cpuSeconds, mostToProve);
}

}  // namespace
}  // namespace rungproof::test
