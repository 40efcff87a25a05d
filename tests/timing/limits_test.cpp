// Limits are kept: time (encoding, searches and checks of certificates count), memory, and the user's interrupt, which
// leaves what was settled. The hard question is the factoring of a prime: no engine decides it within seconds. Stands
// here and not in tests/prover because the limits are of wall time, and nothing runs beside this test program.
#include <fmt/ranges.h>
#include <malloc.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "analysis/proof/proof_watch.hpp"
#include "frontend/cli.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// The product of two numbers without overflow, never a certain prime: no scan can reach it, and no short argument says
/// so.
const char* const hardNetworks =
    "Network 1\n"
    "LD     SM0.0\n"
    "MOVD   ID0, VD10\n"
    "*D     ID4, VD10\n"
    "LD     I8.0\n"
    "=      Q0.0\n";
const char* const hardProperties =
    "//@ assume first factor: ID0 > 1 and ID0 < 1000000\n"
    "//@ assume second factor: ID4 > 1 and ID4 < 1000000\n"
    "//@ assume no overflow: not SM1.1\n"
    "//@ prove prime: VD10 <> 2147483647\n";
const char* const easyProperty = "//@ prove easy: Q0.0 implies I8.0\n";

TEST(Limits, TimeoutLeadsToUnknownWithTheBoundReached) {
  const ProgramInput input = inputOf(hardProperties, hardNetworks);
  const Clock::time_point begin = Clock::now();
  const ProofRun run = prove(input.program, input.properties, usualOptions(1));
  EXPECT_LE(since(begin), 2.0);
  const ProofResult* result = resultNamed(run, "prime");
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->outcome, Outcome::Unknown);
  EXPECT_TRUE(hasNote(*result, "no violation in the first"));
}

TEST(Limits, EveryQuestionHasItsOwnTime) {
  const ProgramInput input =
      inputOf(std::string(hardProperties) + "//@ prove prime too: VD10 <> 2147483629\n" + easyProperty, hardNetworks);
  const Clock::time_point begin = Clock::now();
  const ProofRun run = prove(input.program, input.properties, usualOptions(1));
  EXPECT_LE(since(begin), 4.0);
  EXPECT_EQ(outcomeOf(run, "prime"), Outcome::Unknown);
  EXPECT_EQ(outcomeOf(run, "prime too"), Outcome::Unknown);
  EXPECT_EQ(outcomeOf(run, "easy"), Outcome::Proved);
}

TEST(Limits, EncodingCountsAndCanBeStopped) {
  // 200 rounds of a loop with a division: far more work than the time allows.
  std::string networks = "Network 1\nLD SM0.0\nFOR VW0, +1, +200\nNetwork 2\nLD SM0.0\n";
  for (int i = 0; i < 200; ++i) networks += "/D ID0, VD10\n*D ID4, VD10\n";
  networks += "Network 3\nNEXT\n";
  const ProgramInput input = inputOf("//@ prove anything: VD10 <> 77\n", networks);
  const Clock::time_point begin = Clock::now();
  const ProofRun run = prove(input.program, input.properties, usualOptions(0.3));
  EXPECT_LE(since(begin), 1.3);
  EXPECT_EQ(outcomeOf(run, "anything"), Outcome::Unknown);
}

TEST(Limits, MemoryLeadsToUnknown) {
  const ProgramInput input = inputOf(std::string(hardProperties) + easyProperty, hardNetworks);
  ProverOptions options = usualOptions(60);
  malloc_trim(0);  // what earlier tests left would be used first
  options.memory = residentBytes() + 4'000'000;
  const Clock::time_point begin = Clock::now();
  const ProofRun run = prove(input.program, input.properties, options);
  EXPECT_LE(since(begin), 50.0);
  const ProofResult* result = resultNamed(run, "prime");
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->outcome, Outcome::Unknown);
  EXPECT_TRUE(hasNote(*result, "memory limit")) << fmt::format("{}", fmt::join(result->notes, "\n"));
}

TEST(Limits, CancellationKeepsWhatIsSettled) {
  const ProgramInput input = inputOf(std::string(hardProperties) + easyProperty, hardNetworks);
  std::atomic<bool> cancel{false};
  ProverOptions options = usualOptions(60);
  options.cancel = &cancel;
  const Clock::time_point begin = Clock::now();
  std::thread user([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(2000));
    cancel = true;
  });
  const ProofRun run = prove(input.program, input.properties, options);
  user.join();
  EXPECT_LE(since(begin), 3.5);
  EXPECT_TRUE(run.isInterrupted);
  EXPECT_EQ(outcomeOf(run, "prime"), Outcome::Unknown);
  EXPECT_EQ(outcomeOf(run, "easy"), Outcome::Proved);
}

TEST(Limits, ControlCPrintsWhatWasSettled) {
  const std::string file = testing::TempDir() + "rungproof_interrupted.awl";
  std::ofstream(file) << "ORGANIZATION_BLOCK MAIN:OB1\n"
                      << hardProperties << easyProperty << "BEGIN\n"
                      << hardNetworks << "END_ORGANIZATION_BLOCK\n";
  std::istringstream in;
  std::ostringstream out, err;
  const Clock::time_point begin = Clock::now();
  std::thread user([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(2000));
    std::raise(SIGINT);
  });
  const int exit = runProgram({"prove", file, "--isolated", "--timeout", "60s", "--format", "concise"}, {in, out, err});
  user.join();
  EXPECT_LE(since(begin), 3.5);
  EXPECT_EQ(exit, 3);  // something undecided
  EXPECT_NE(out.str().find("PROVED easy"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("UNKNOWN prime"), std::string::npos) << out.str();
  EXPECT_NE(err.str().find("interrupted"), std::string::npos) << err.str();
  std::remove(file.c_str());
}

}  // namespace
}  // namespace rungproof::test
