// The rest of a scan in which no tick of the 1 ms clock makes a difference passes at once: the state after every scan
// is that of a run which an observer makes go tick by tick, until the watchdog ends both.
#include <gtest/gtest.h>

#include <random>

#include "engine/simulator.hpp"
#include "frontend/input/project.hpp"

namespace rungproof {
namespace {

class Nobody final : public InstructionObserver {
 public:
  void before(const Machine<Concrete>&, const Instruction&) override {}
  void external(const ExternalSite&, std::uint64_t) override {}
  void programEnded(const Machine<Concrete>&) override {}
};

/// Scans of 0.3 ms to `longestMs`; gives how many were made in RUN.
int compareRuns(const std::string& text, std::uint32_t longestMs, const SimulatorOptions& options = {}) {
  const Program program = readText("quiet.awl", text);
  EXPECT_TRUE(program.findings.empty()) << program.findings.front().message;
  Simulator atOnce(program, options), byTicks(program, options);
  Nobody nobody;
  byTicks.observe(&nobody);
  constexpr std::uint32_t seed = 20261;
  std::mt19937 random(seed);
  int scans = 0;
  for (; scans < 400 && atOnce.isRunning(); ++scans) {
    ScanRequest request;
    request.lengthUs = 300 + random() % (longestMs * 1000);
    const bool input = random() % 8 != 0;
    for (Simulator* simulator : {&atOnce, &byTicks}) {
      Operand operand;
      operand.kind = OperandKind::Direct;
      operand.area = Area::I;
      operand.width = Width::Bit;
      simulator->write(operand, input ? 1 : 0);
      simulator->scan(request);
    }
    EXPECT_TRUE(atOnce.store() == byTicks.store()) << "scan " << scans << ", seed " << seed;
    EXPECT_EQ(atOnce.timeUs(), byTicks.timeUs());
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(atOnce.isRunning(), byTicks.isRunning());
  return scans;
}

TEST(QuietRest, TimersOfAllBasesCountTheSame) {
  EXPECT_EQ(compareRuns("LD I0.0\nTON T32, 700\nTON T33, 20\nTON T37, 3\nLDN I0.0\nTOF T96, 45\nLD I0.0\nTONR T0, 90\n"
                        "LD T32\n= Q0.0\nLD T96\n= Q0.1\nLD T0\n= Q0.2\nR T0, 1\n",
                        40),
            400);
}

TEST(QuietRest, InterruptsOfTheClockTakeEveryTick) {
  EXPECT_EQ(compareRuns("LD SM0.1\nMOVB 7, SMB34\nATCH 0, 10\nATCH 1, 21\nENI\nLD I0.0\nTON T32, 25\nEND\n"
                        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW0\nEND_INTERRUPT_BLOCK\n"
                        "INTERRUPT_BLOCK INT_1:INT1\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW2\nR T32, 1\n"
                        "END_INTERRUPT_BLOCK\n",
                        60),
            400);
}

TEST(QuietRest, S5TimersCountTheSameInBothReadings) {
  for (const char* reading : {"synchronous", "any"}) {
    SimulatorOptions options;
    options.choices.set("s5-time", reading);
    EXPECT_EQ(compareRuns("ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nL S5T#300MS;\nSD T 1;\nA I 0.0;\n"
                          "L S5T#70MS;\nSF T 2;\nAN T 1;\nL S5T#2S;\nSP T 3;\nA T 1;\n= Q 0.0;\nA T 2;\n= Q 0.1;\n"
                          "A T 3;\n= Q 0.2;\nEND_ORGANIZATION_BLOCK\n",
                          60, options),
              400)
        << reading;
  }
}

TEST(QuietRest, TheWatchdogStrikesInTheSameScan) {
  const int scans = compareRuns("LD I0.0\nTON T32, 700\n= Q0.0\n", 520);  // more than 500 ms is fatal (001:5697)
  EXPECT_GT(scans, 0);
  EXPECT_LT(scans, 400);
}

}  // namespace
}  // namespace rungproof
