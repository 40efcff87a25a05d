// Limits are kept: time (encoding, searches and checks of certificates count), memory, and the user's interrupt, which
// leaves what was settled. The hard question is the factoring of a prime: no engine decides it within seconds. Stands
// here and not in tests/prover because the limits are of wall time, and nothing runs beside this test program.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "analysis/proof/proof_watch.hpp"
#include "analysis/recheck/z3_check.hpp"
#include "frontend/cli/cli.hpp"
#include "tests/machine_pace.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int attempts = 3;  ///< other work on the machine takes its share of the seconds

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Seconds until an answer: those it was given, and those it may need to stop, at the pace of this moment.
double within(double given, double stopping) { return given + stopping * machinePace(wallSeconds); }

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
  EXPECT_LE(since(begin), within(1, 1));
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
  EXPECT_LE(since(begin), within(3, 1));
  EXPECT_EQ(outcomeOf(run, "prime"), Outcome::Unknown);
  EXPECT_EQ(outcomeOf(run, "prime too"), Outcome::Unknown);
  EXPECT_EQ(outcomeOf(run, "easy"), Outcome::Proved);
}

/// Twenty pointers that walk through hundreds of bytes, and `networks` with an instruction behind each of them.
std::string walkingPointers(int networks, const char* instruction) {
  std::string text = "Network 1\nLD SM0.1\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("MOVD &VB{}, VD{}\n", 1000 + i * 10, 4 * i);
  text += "LD I0.0\n";
  for (int i = 0; i < 20; ++i)
    text += fmt::format("INCD VD{0}\nLDD> VD{0}, &VB{1}\nMOVD &VB{2}, VD{0}\n", 4 * i, 1400 + i * 10, 1000 + i * 10);
  for (int i = 0; i < networks; ++i)
    text += fmt::format("Network {}\nLD I1.{}\n", i + 2, i % 8) +
            fmt::format(fmt::runtime(instruction), 4 * (i % 20), 4 * ((i + 3) % 20)) + "\n";
  return text;
}

/// A block that is moved through a pointer is one instruction and may be a hundred thousand writes: the clock is looked
/// at within it.
TEST(Limits, PointersAreFollowedNoLongerThanTheTime) {
  for (const char* instruction : {"FILL 0, *VD{}, 255", "BMB *VD{}, *VD{}, 255", "BMW *VD{}, *VD{}, 120"}) {
    const ProgramInput input = inputOf("//@ prove off: never Q0.0\n", walkingPointers(50, instruction));
    double best = 1e9;
    for (int i = 0; i < attempts && best > 3; ++i) {
      const Clock::time_point begin = Clock::now();
      const ProofRun run = prove(input.program, input.properties, usualOptions(1));
      best = std::min(best, since(begin));
      ASSERT_EQ(run.results.size(), 1U);
    }
    EXPECT_LE(best, within(1, 2)) << instruction;
  }
}

TEST(Limits, FiveThousandPointersAreFollowedNoLongerThanTheTime) {
  const ProgramInput input = inputOf("//@ prove off: never Q0.0\n", walkingPointers(5000, "MOVB 1, *VD{}"));
  double best = 1e9;
  for (int i = 0; i < attempts && best > 3; ++i) {
    const Clock::time_point begin = Clock::now();
    prove(input.program, input.properties, usualOptions(1));
    best = std::min(best, since(begin));
  }
  EXPECT_LE(best, within(1, 2));
}

/// A polynomial by Horner's rule, with so many REAL operations that no scan is decided in any time.
std::string polynomial(int terms) {
  std::string text = "Network 1\nLD SM0.0\nITD AIW0, AC0\nDTR AC0, VD0\nMOVR VD0, VD4\n";
  for (int i = 1; i <= terms; ++i) text += "*R VD0, VD4\n+R " + std::to_string(i) + ".5, VD4\n";
  return text;
}

TEST(Limits, RealOperationsThatAreWrittenOut) {
  // Millions of gates: making and simulating them counts.
  std::string roots = "Network 1\nLD SM0.0\nITD AIW0, AC0\nDTR AC0, VD4\n";
  for (int i = 0; i < 20; ++i) roots += "SQRT VD4, VD8\n/R VD8, VD4\n+R 3.25, VD4\n";
  for (const std::string& networks : {polynomial(60), roots}) {
    const ProgramInput input = inputOf("//@ prove never so: VD4 <> 12345.678\n", networks);
    for (const int jobs : {1, 2}) {
      ProverOptions options = usualOptions(2);
      options.jobs = jobs;
      double seconds = 1e9;
      for (int i = 0; i < attempts && seconds > 3; ++i) {
        const Clock::time_point begin = Clock::now();
        const ProofRun run = prove(input.program, input.properties, options);
        seconds = std::min(seconds, since(begin));
        EXPECT_EQ(outcomeOf(run, "never so"), Outcome::Unknown);
      }
      EXPECT_LE(seconds, within(2, 1)) << jobs;
    }
  }
}

TEST(Limits, MultiplicationsWithMemory) {
  std::string networks = "Network 1\nLD SM0.0\n";
  for (int i = 0; i < 12; ++i) networks += "*D VD0, VD0\n+D ID0, VD0\n/D 3, VD0\n";
  const ProgramInput input =
      inputOf("//@ prove never so: VD0 <> 123456789\n//@ prove nor so: VD0 <> -987654321\n", networks);
  for (const int jobs : {1, 2}) {
    ProverOptions options = usualOptions(2);
    options.jobs = jobs;
    const Clock::time_point begin = Clock::now();
    const ProofRun run = prove(input.program, input.properties, options);
    EXPECT_LE(since(begin), within(4, 1)) << jobs;
    EXPECT_EQ(run.results.size(), 2U);
  }
}

TEST(Limits, CheckOfACertificateThatTakesTooLong) {
  // That multiplication is commutative takes a SAT solver forever; Z3 does not know the word level any more when it
  // asks one. The other formula is done before.
  const std::string text =
      "(declare-fun a () (_ BitVec 64))\n(declare-fun b () (_ BitVec 64))\n(declare-fun c () (_ BitVec 64))\n"
      "(declare-fun obligations (Bool Bool Bool) Bool)\n"
      "(assert (obligations true (and (bvult a b) (bvult b a))"
      " (not (= (bvmul a (bvmul b (bvadd c a))) (bvadd (bvmul (bvmul a b) c) (bvmul b (bvmul a a)))))))\n";
  for (const double limit : {0.5, 1.5}) {
    CheckLimits limits;
    limits.each = 100;
    limits.total = limit;
    const Clock::time_point begin = Clock::now();
    const std::vector<CheckResult> results = checkApart(text, {0, 1}, 2, limits);
    EXPECT_LE(since(begin), within(limit, 0.3));
    EXPECT_EQ(results, (std::vector<CheckResult>{CheckResult::Valid, CheckResult::Unknown}));
  }
}

TEST(Limits, EncodingCountsAndCanBeStopped) {
  // 200 rounds of a loop with a division: far more work than the time allows.
  std::string networks = "Network 1\nLD SM0.0\nFOR VW0, +1, +200\nNetwork 2\nLD SM0.0\n";
  for (int i = 0; i < 200; ++i) networks += "/D ID0, VD10\n*D ID4, VD10\n";
  networks += "Network 3\nNEXT\n";
  const ProgramInput input = inputOf("//@ prove anything: VD10 <> 77\n", networks);
  const Clock::time_point begin = Clock::now();
  const ProofRun run = prove(input.program, input.properties, usualOptions(0.3));
  EXPECT_LE(since(begin), within(0.3, 1));
  EXPECT_EQ(outcomeOf(run, "anything"), Outcome::Unknown);
}

TEST(Limits, MemoryLeadsToUnknown) {
  const ProgramInput input = inputOf(std::string(hardProperties) + easyProperty, hardNetworks);
  ProverOptions options = usualOptions(60);
  returnUnusedMemory();  // what earlier tests left would be used first
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
  EXPECT_LE(since(begin), within(2, 1.5));
  EXPECT_TRUE(run.isInterrupted);
  EXPECT_EQ(outcomeOf(run, "prime"), Outcome::Unknown);
  EXPECT_EQ(outcomeOf(run, "easy"), Outcome::Proved);
}

TEST(Limits, ControlCEndsTheSelfCheckWithAReport) {
  // Each fault in the multiplication is looked at until its time is over.
  const std::string file = ::testing::TempDir() + "rungproof_self_check.awl";
  std::ofstream(file) << "ORGANIZATION_BLOCK MAIN:OB1\n"
                      << hardProperties << easyProperty << "BEGIN\n"
                      << hardNetworks << "Network 2\nLD I8.1\nA I8.2\nA I8.3\nA I8.4\nMOVD VD10, VD14\n*D ID4, VD14\n"
                      << "MOVD VD14, QD4\nEND_ORGANIZATION_BLOCK\n";
  std::istringstream in;
  std::ostringstream out, err;
  const Clock::time_point begin = Clock::now();
  std::thread user([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    std::raise(SIGINT);
  });
  runProgram({"prove", file, "--isolated", "--timeout", "1s", "--self-check"}, {in, out, err});
  user.join();
  EXPECT_LE(since(begin), within(2.5, 1.5));
  EXPECT_NE(out.str().find("self-check"), std::string::npos) << out.str();
  EXPECT_NE(err.str().find("faults were not tried"), std::string::npos) << err.str();
  std::remove(file.c_str());
}

TEST(Limits, ControlCPrintsWhatWasSettled) {
  const std::string file = ::testing::TempDir() + "rungproof_interrupted.awl";
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
  EXPECT_LE(since(begin), within(2, 1.5));
  EXPECT_EQ(exit, 3);  // something undecided
  EXPECT_NE(out.str().find("PROVED easy"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("UNKNOWN prime"), std::string::npos) << out.str();
  EXPECT_NE(err.str().find("interrupted"), std::string::npos) << err.str();
  std::remove(file.c_str());
}

}  // namespace
}  // namespace rungproof::test
