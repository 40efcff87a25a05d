// Certificates of the corpus, of declared properties and built-in checks, are read by a second solver (the program
// cvc5) and hold: each obligation is unsatisfiable. Of every program some are asked; RUNGPROOF_EVERY_CERTIFICATE=1 asks
// all. A certificate with a wrong invariant is refused by it and by Z3.
#include "analysis/portfolio/certificate.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/corpus/command_output.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/prover/proved_text.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

/// Certificates that must be there, so that a corpus without proofs does not pass unnoticed.
constexpr std::size_t leastChecked = 400;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// With cvc5's usual solver for words; where that takes its time (of nine hundred seven more than 20 s, all others less
/// than 4) with the other one, which needs a second; and where that does so too, with the usual one to its end.
std::string askCvc5(const std::string& file, std::size_t obligations) {
  const auto asked = [&](const std::string& options) {
    return outputOf("cvc5 --incremental --lang smt2 " + options + " '" + file + "' 2>/dev/null");
  };
  for (const std::string quick : {"--tlimit=6000", "--bv-solver=bitblast-internal --tlimit=40000"}) {
    const std::string answer = asked(quick);
    if (count(answer, "unsat\n") == obligations) return answer;
  }
  return asked("--tlimit=400000");
}

/// The first two of a program and every eighth of the others; which these are differs from program to program.
bool isAsked(std::size_t program, std::size_t certificate) {
  static const bool asksAll = std::getenv("RUNGPROOF_EVERY_CERTIFICATE") != nullptr;
  return asksAll || certificate < 2 || (certificate + program) % 8 == 0;
}

TEST(Certificate, Cvc5AgreesOnTheWholeCorpus) {
  ASSERT_NE(outputOf("command -v cvc5"), "") << "the package cvc5 is missing; see .ci/install";
  const TemporaryFolder folder;
  std::size_t checked = 0, obligations = 0, decidedByForm = 0, simplified = 0, programs = 0;
  for (const fs::path& path : corpusFiles()) {
    const std::size_t program = programs++;
    std::size_t certificates = 0;
    const ProgramInput input = corpusInput(path);
    ProverOptions options = proverOptions(path);
    options.timeout = 1;
    options.checks.builtin = true;
    options.certificates = true;
    const ProofRun run = prove(input.program, input.properties, options);
    for (const ProofResult& result : run.results) {
      if (result.outcome != Outcome::Proved && result.outcome != Outcome::Unreachable) continue;
      if (result.certificate.empty()) {
        // There is no call at all, or no push: nothing of the program could be said.
        ++decidedByForm;
        EXPECT_TRUE(result.builtin) << path << ": " << result.property.name;
        continue;
      }
      const std::string& text = result.certificate;
      if (text.find("; about the program after simplification") != std::string::npos) {
        ++simplified;
        std::printf("after simplification: %s, %s\n", path.filename().c_str(), result.property.name.c_str());
      }
      EXPECT_NE(text.find("(declare-fun |"), std::string::npos) << path << ": " << result.property.name;
      const std::string safety = text.substr(text.find("; safety of"));
      EXPECT_NE(safety.find('|'), std::string::npos) << path << ": " << result.property.name << ": " << safety;
      if (!isAsked(program, certificates++)) continue;
      const std::string file = folder.file("certificate.smt2", text);
      const std::size_t asked = count(text, "(check-sat)");
      const std::string answer = askCvc5(file, asked);
      // In front of its own: what the encoding was told.
      const std::size_t told = count(text, "; initiation of: what the encoding was told");
      EXPECT_LE(told, 3U);
      EXPECT_EQ(count(text, "; initiation of"), 1 + told);
      EXPECT_EQ(count(text, "; consecution of"), 1 + told);
      // Of what it was told, where an engine had to prove that.
      EXPECT_EQ(count(text, "; safety of"), 1U + count(text, "; safety of: what the encoding was told"));
      EXPECT_EQ(count(answer, "unsat\n"), asked) << path << ": " << result.property.name << ": " << answer;
      EXPECT_EQ(answer.size(), asked * 6) << answer;  // nothing else is said
      ++checked;
      obligations += asked;
    }
  }
  EXPECT_GE(checked, leastChecked);
  EXPECT_LT(decidedByForm, checked);
  // A division of REAL numbers, written out as gates, is more than Z3 can check in its time; on a machine with other
  // work a few long ones are.
  EXPECT_LE(simplified, 8U);
  std::printf(
      "cvc5 checked %zu certificates with %zu obligations; %zu questions are decided by the form of the program\n",
      checked, obligations, decidedByForm);
}

/// Three bins that give pieces to each other, and a book in which each entry is one of debit and one of credit: what a
/// scan makes of their sums is an obligation of its own, about any words.
TEST(Certificate, SumsAreKeptByArithmetic) {
  const std::string bins =
      "//@ prove pieces: first_scan or VW0 + VW2 + VW4 = 500\nORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n"
      "NETWORK 1\nLD SM0.1\nMOVW 500, VW0\nNETWORK 2\nLD I0.0\nEU\nAW> VW0, 0\nDECW VW0\nINCW VW2\n"
      "NETWORK 3\nLD I0.1\nEU\nAW> VW2, 0\nDECW VW2\nINCW VW4\n"
      "NETWORK 4\nLD I0.2\nEU\nAW> VW4, 0\nDECW VW4\nINCW VW0\nEND_ORGANIZATION_BLOCK\n";
  const std::string book =
      "//@ prove totals: VW0 + VW2 = VW100\nORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n"
      "NETWORK 1\nLD I0.0\nEU\nAW< VW0, 1000\nINCW VW0\nINCW VW100\n"
      "NETWORK 2\nLD I0.1\nEU\nAW< VW2, 1000\nINCW VW2\nINCW VW100\nEND_ORGANIZATION_BLOCK\n";
  const TemporaryFolder folder;
  for (const std::string& source : {bins, book}) {
    const ProgramInput input = inputOfSource(source);
    ProverOptions options = usualOptions();
    options.certificates = true;
    const ProofRun run = prove(input.program, input.properties, options);
    ASSERT_EQ(run.results.size(), 1U);
    ASSERT_EQ(run.results[0].outcome, Outcome::Proved);
    const std::string& text = run.results[0].certificate;
    EXPECT_EQ(count(text, "; arithmetic of"), 1U) << text;
    const std::size_t asked = count(text, "(check-sat)");
    EXPECT_EQ(count(askCvc5(folder.file("certificate.smt2", text), asked), "unsat\n"), asked);
  }
}

/// A bit x that starts with 0 and stays; y follows x. Bad is y.
struct Pair {
  Pair() {
    x = graph.variable("x", 1, true);
    y = graph.variable("y", 1, true);
    system.graph = &graph;
    system.states = {{x, graph.constantNode(0, 1), x}, {y, graph.constantNode(0, 1), x}};
    system.questions = {{"y", y}};
  }
  Graph graph;
  Node x{}, y{};
  TransitionSystem system;
};

TEST(Certificate, WrongOnesAreRefused) {
  Pair pair;
  const Node notX = pair.graph.make(Op::Not, 1, pair.x), notY = pair.graph.make(Op::Not, 1, pair.y);
  const TemporaryFolder folder;
  // {not x, not y} is inductive; {not y} is not kept by a scan; {} does not exclude bad; {x} does not hold initially.
  const std::vector<std::pair<std::vector<Node>, CheckResult>> cases = {{{notX, notY}, CheckResult::Valid},
                                                                        {{notY}, CheckResult::Invalid},
                                                                        {{}, CheckResult::Invalid},
                                                                        {{pair.x, notY}, CheckResult::Invalid}};
  for (const auto& [invariant, expected] : cases) {
    WordCertificate certificate;
    certificate.invariant = invariant;
    CertificateWriter writer(pair.system);
    writer.add(pair.system.questions[0], certificate);
    EXPECT_EQ(writer.check({}), std::vector<CheckResult>{expected});
    const std::string file = folder.file("pair.smt2", writer.text());
    const std::string answer = askCvc5(file, 3);
    EXPECT_EQ(count(answer, "unsat\n") == 3, expected == CheckResult::Valid) << answer;
  }
}

TEST(Certificate, InductionOfTwoScans) {
  // Without an invariant, y after two scans without y: x is not 1, else y would have followed it.
  Pair pair;
  WordCertificate certificate;
  certificate.k = 1;
  EXPECT_EQ(CertificateWriter(pair.system).check({}), std::vector<CheckResult>{});
  CertificateWriter one(pair.system), two(pair.system);
  one.add(pair.system.questions[0], certificate);
  EXPECT_EQ(one.check({}), std::vector<CheckResult>{CheckResult::Invalid});
  certificate.k = 2;
  two.add(pair.system.questions[0], certificate);
  EXPECT_EQ(two.check({}), std::vector<CheckResult>{CheckResult::Valid});
}

TEST(Certificate, CheckEndsWhenCancelled) {
  Pair pair;
  CertificateWriter writer(pair.system);
  writer.add(pair.system.questions[0], {});
  const std::atomic<bool> cancel{true};
  CheckLimits limits;
  limits.cancel = &cancel;
  EXPECT_EQ(writer.check(limits), std::vector<CheckResult>{CheckResult::Unknown});
}

}  // namespace
}  // namespace rungproof::test
