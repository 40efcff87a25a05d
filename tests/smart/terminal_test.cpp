// The images of an S7-200 SMART: 32 bytes with terminals, PROFINET data behind them, immediate access, edges of the
// signal board, and pulse outputs whose numbers are not those of their points.
#include <gtest/gtest.h>

#include "engine/simulator.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/environment/asked.hpp"

namespace rungproof::test {
namespace {

constexpr Target withTerminals{s7200Cpu("ST40"), Edition::Smart28};

/// A program on a CPU ST40 that runs by the reference engine.
class SmartRun {
 public:
  SmartRun(const std::string& networks, const std::string& blocks = "")
      : program_(readText("a.awl",
                          "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\n" + linesOf(networks) +
                              "END_ORGANIZATION_BLOCK\n" + linesOf(blocks),
                          {.target = withTerminals})),
        simulator(program_, {}) {}

  void input(std::uint32_t byte, unsigned bit, bool value) {
    simulator.write(direct(Area::I, Width::Bit, byte, bit), value ? 1 : 0);
  }
  bool image(std::uint32_t byte, unsigned bit) { return simulator.read(direct(Area::Q, Width::Bit, byte, bit)) != 0; }

 private:
  Program program_;

 public:
  Simulator simulator;
};

TEST(SmartTerminals, InputsOfModulesAndDevicesReachTheProgram) {
  SmartRun run("LD I20.0;= Q0.0;LDI I20.1;= Q0.1;LD I130.0;= Q0.2;LDI I130.1;= Q0.3;LD I1279.7;= Q0.4");
  run.simulator.scan();
  for (unsigned bit = 0; bit < 5; ++bit) EXPECT_FALSE(run.image(0, bit)) << bit;
  for (const auto& [byte, bit] :
       {std::pair{20U, 0U}, std::pair{20U, 1U}, std::pair{130U, 0U}, std::pair{130U, 1U}, std::pair{1279U, 7U}})
    run.input(byte, bit, true);
  run.simulator.scan();
  for (unsigned bit = 0; bit < 5; ++bit) EXPECT_TRUE(run.image(0, bit)) << bit;
}

TEST(SmartTerminals, ImmediateOutputsGoOutAtOnceWhereThereAreTerminals) {
  SmartRun run("LD SM0.0;=I Q20.0;=I Q200.0;SI Q10.0,176;MOVB 16#FF,VB0;BIW VB0,QB30");
  run.simulator.scan();
  EXPECT_TRUE(run.simulator.physicalOutput(20, 0));
  EXPECT_TRUE(run.simulator.physicalOutput(31, 7)) << "the last of 176 points from Q10.0 on";
  EXPECT_TRUE(run.image(200, 0)) << "no terminal: it goes with the image";
}

TEST(SmartTerminals, ProofsKnowThem) {
  const std::string program = "LD I20.0;= Q0.0;LDI I20.1;=I Q20.0;LD I130.0;= Q0.2;LDI I130.1;= Q0.3";
  for (const char* reached : {"reach Q0.0", "reach Q20.0", "reach Q0.2", "reach Q0.3", "reach Q0.2 and not Q0.3"})
    EXPECT_EQ(verdict({.program = program, .property = reached, .target = withTerminals}), Outcome::Reachable)
        << reached;
  for (const char* proved : {"Q0.0 = I20.0", "Q0.2 = I130.0"})
    EXPECT_EQ(verdict({.program = program, .property = proved, .target = withTerminals}), Outcome::Proved) << proved;
}

// I7.0 and I7.1 are on a signal board: rising edges are events 35 and 37, falling ones 36 and 38.
TEST(SmartTerminals, EdgesOfTheSignalBoardAreEvents) {
  SmartRun run("LD SM0.1;ATCH INT_0,35;ATCH INT_1,38;ENI",
               "INTERRUPT_BLOCK INT_0:INT0;BEGIN;Network 1;LD SM0.0;INCB VB0;END_INTERRUPT_BLOCK;"
               "INTERRUPT_BLOCK INT_1:INT1;BEGIN;Network 1;LD SM0.0;INCB VB1;END_INTERRUPT_BLOCK");
  const auto count = [&](std::uint32_t byte) { return run.simulator.read(direct(Area::V, Width::Byte, byte)); };
  run.simulator.scan();
  run.input(7, 0, true);
  run.input(7, 1, true);
  run.simulator.scan();
  EXPECT_EQ(count(0), 1U) << "I7.0 has risen";
  EXPECT_EQ(count(1), 0U) << "I7.1 has not fallen";
  run.input(7, 0, false);
  run.input(7, 1, false);
  run.simulator.scan();
  EXPECT_EQ(count(0), 1U);
  EXPECT_EQ(count(1), 1U);
}

// Pulse output 2 is Q0.3, not Q0.2; while it pulses, the image does not reach the terminal (001:4528).
TEST(SmartTerminals, AGeneratorOwnsItsPoint) {
  SmartRun run("LD SM0.1;MOVB 16#C5,SMB567;MOVW 10,SMW568;MOVD 100000,SMD572;PLS 2;LD SM0.0;= Q0.2;= Q0.3");
  run.simulator.scan();
  run.simulator.scan();
  EXPECT_TRUE(run.simulator.physicalOutput(0, 2)) << "no generator drives it";
  EXPECT_FALSE(run.simulator.physicalOutput(0, 3)) << "the generator's, not the image's";
}

// 100 pulses of 1 kHz last 100 ms: at 10 ms a scan the train ends in the tenth.
TEST(SmartTerminals, ATrainLastsAsItsFrequencySays) {
  SmartRun run("LD SM0.1;MOVB 16#C5,SMB67;MOVW 1000,SMW68;MOVD 100,SMD72;PLS 0");
  const auto isIdle = [&] { return run.simulator.read(direct(Area::SM, Width::Bit, 66, 7)) != 0; };
  for (int scan = 0; scan < 9; ++scan) run.simulator.scan();
  EXPECT_FALSE(isIdle()) << "90 ms";
  for (int scan = 0; scan < 3; ++scan) run.simulator.scan();
  EXPECT_TRUE(isIdle()) << "120 ms";
}

}  // namespace
}  // namespace rungproof::test
