// Blocks of the CPU and the libraries, run from their statement lists. Expected values follow from the behaviour of the
// IEC blocks (002:2516-2532); the time of a scan reaches a timer when the next
// scan begins, so that a time of three scans is up in the third scan after the one that started it.
#include <gtest/gtest.h>

#include "engine/simulator.hpp"
#include "tests/step7/read7.hpp"

namespace rungproof {
namespace {

constexpr std::uint32_t scanUs = 100000;

struct LibraryRun {
  explicit LibraryRun(const std::string& text) : program(read7(text)), simulator(program) {
    EXPECT_EQ(findings7(program), "");
  }
  void scan(bool input) {
    simulator.write(direct(Area::I, Width::Bit, 0, 0), input ? 1 : 0);
    simulator.scan({.lengthUs = scanUs});
    EXPECT_TRUE(simulator.isRunning());
  }
  bool q() const { return simulator.read(direct(Area::Q, Width::Bit, 0, 0)) != 0; }
  std::uint64_t number(Width width, std::uint32_t byte) const { return simulator.read(direct(Area::M, width, byte)); }

  Program program;
  Simulator simulator;
};

std::string timerOf(int number) {
  return fmt::format(
      "DATA_BLOCK DB 4\nSFB {0}\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
      "CALL SFB {0}, DB 4 (IN := I 0.0, PT := T#300MS, Q := Q 0.0, ET := MD 0);\nEND_ORGANIZATION_BLOCK\n",
      number);
}

struct TimerStep {
  bool input, q;
  std::uint64_t elapsed;  ///< ms
};

void expectTimer(int number, const std::vector<TimerStep>& steps) {
  LibraryRun run(timerOf(number));
  int scan = 0;
  for (const TimerStep& step : steps) {
    run.scan(step.input);
    ++scan;
    EXPECT_EQ(run.q(), step.q) << "SFB " << number << ", scan " << scan;
    EXPECT_EQ(run.number(Width::DWord, 0), step.elapsed) << "SFB " << number << ", scan " << scan;
  }
}

TEST(LibrarySource, OnDelay) {
  expectTimer(4, {{false, false, 0},
                  {true, false, 0},
                  {true, false, 100},
                  {true, false, 200},
                  {true, true, 300},
                  {true, true, 300},
                  {false, false, 0},
                  {true, false, 0}});
}

TEST(LibrarySource, PulseIsNotStartedAgainWhileItRuns) {
  expectTimer(3, {{true, true, 0},
                  {false, true, 100},
                  {true, true, 200},
                  {true, false, 300},
                  {true, false, 300},
                  {false, false, 0},
                  {true, true, 0}});
}

TEST(LibrarySource, OffDelay) {
  expectTimer(5, {{false, false, 0},
                  {true, true, 0},
                  {true, true, 0},
                  {false, true, 0},
                  {false, true, 100},
                  {false, true, 200},
                  {false, false, 300},
                  {true, true, 0}});
}

TEST(LibrarySource, CounterCountsRisingInputs) {
  LibraryRun run(
      "DATA_BLOCK DB 4\nSFB 0\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
      "CALL SFB 0, DB 4 (CU := I 0.0, R := I 0.1, PV := 2, Q := Q 0.0, CV := MW 0);\nEND_ORGANIZATION_BLOCK\n");
  const bool inputs[] = {true, true, false, true, false};
  const std::uint64_t counts[] = {1, 1, 1, 2, 2};
  for (int i = 0; i < 5; ++i) {
    run.scan(inputs[i]);
    EXPECT_EQ(run.number(Width::Word, 0), counts[i]) << i;
    EXPECT_EQ(run.q(), counts[i] >= 2) << i;
  }
  run.simulator.write(direct(Area::I, Width::Bit, 0, 1), 1);
  run.scan(false);
  EXPECT_EQ(run.number(Width::Word, 0), 0U);
}

TEST(LibrarySource, StopEndsTheRun) {
  const Program program = readOb1("A I 0.0; JCN on; CALL SFC 46; on: SET; = Q 0.0;");
  Simulator simulator(program);
  simulator.scan();
  EXPECT_TRUE(simulator.isRunning());
  simulator.write(direct(Area::I, Width::Bit, 0, 0), 1);
  simulator.scan();
  EXPECT_FALSE(simulator.isRunning());
}

// (IN - k1) / (27648 - k1) * (HI_LIM - LO_LIM) + LO_LIM with powers of two, so that every step is exact (002:2625).
TEST(LibrarySource, ScaleIsALine) {
  struct Case {
    int in;
    const char* high;
    const char* low;
    bool isBipolar;
    float out;
    unsigned result;
  };
  for (const Case& c : {Case{0, "100.0", "0.0", false, 0.0F, 0}, Case{27648, "100.0", "0.0", false, 100.0F, 0},
                        Case{13824, "100.0", "0.0", false, 50.0F, 0}, Case{6912, "64.0", "-64.0", false, -32.0F, 0},
                        Case{0, "64.0", "-64.0", true, 0.0F, 0}, Case{-27648, "64.0", "-64.0", true, -64.0F, 0},
                        Case{13824, "64.0", "-64.0", true, 32.0F, 0}, Case{27649, "64.0", "8.0", false, 64.0F, 8},
                        Case{-1, "64.0", "8.0", false, 8.0F, 8}, Case{-27649, "64.0", "8.0", true, 8.0F, 8}}) {
    LibraryRun run(
        fmt::format("ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n{} M 20.0;\n"
                    "CALL FC 105 (IN := {}, HI_LIM := {}, LO_LIM := {}, BIPOLAR := M 20.0, "
                    "RET_VAL := MW 10, OUT := MD 4);\nA BR; = Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
                    c.isBipolar ? "SET; =" : "CLR; =", c.in, c.high, c.low));
    run.scan(false);
    EXPECT_EQ(run.number(Width::DWord, 4), Concrete::pattern(c.out)) << c.in;
    EXPECT_EQ(run.number(Width::Word, 10), c.result) << c.in;
    EXPECT_EQ(run.q(), c.result == 0) << c.in;
  }
}

// STOP while an S5 timer runs: the outputs are off and the scan still has its end (002:1278). The timer runs from the
// first scan on, the program stops in the second.
TEST(LibrarySource, StopTurnsTheOutputsOffThoughATimerRuns) {
  LibraryRun run(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nSET;\n= Q 0.0;\nA I 0.0;\nL S5T#10S;\nSE T 1;\nA I 0.1;\n"
      "JCN on;\nCALL SFC 46;\non: NOP 0;\nEND_ORGANIZATION_BLOCK\n");
  run.scan(true);
  EXPECT_TRUE(run.simulator.physicalOutput(0, 0));
  run.simulator.write(direct(Area::I, Width::Bit, 0, 1), 1);
  run.simulator.scan({.lengthUs = scanUs});
  EXPECT_FALSE(run.simulator.isRunning());
  EXPECT_FALSE(run.simulator.physicalOutput(0, 0));
  EXPECT_EQ(run.simulator.store().get(Reg::LastScan, 0), scanUs / 1000);
}

}  // namespace
}  // namespace rungproof
