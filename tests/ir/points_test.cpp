// The points on the CPUs: 001:11612-11622 (S7-200), system manual (S7-200 SMART).
#include "ir/points.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

TEST(Points, EndOfTheInputsAndOutputs) {
  struct Row {
    Cpu cpu;
    std::uint32_t inputs, outputs;
  };
  for (const Row& row : {Row{Cpu::Cpu221, 6, 4}, Row{Cpu::Cpu222, 8, 6}, Row{Cpu::Cpu224, 14, 10},
                         Row{Cpu::Cpu224XP, 14, 10}, Row{Cpu::Cpu226, 24, 16}, Row{Cpu::St20, 12, 8},
                         Row{Cpu::Sr30, 18, 12}, Row{Cpu::Cr40, 24, 16}, Row{Cpu::Cr60s, 36, 24}}) {
    const Target target{row.cpu, usualEdition(row.cpu)};
    EXPECT_EQ(onBoardEnd(target, Area::I), row.inputs) << cpuName(row.cpu);
    EXPECT_EQ(onBoardEnd(target, Area::Q), row.outputs) << cpuName(row.cpu);
  }
}

TEST(Points, OnlyThe224XPHasAnalogueOnes) {
  const Target xp{Cpu::Cpu224XP, Edition::Edition2004}, other{Cpu::Cpu226, Edition::Edition2004};
  EXPECT_EQ(onBoardEnd(xp, Area::AI), 32U) << "AIW0 and AIW2 (001:1228)";
  EXPECT_EQ(onBoardEnd(xp, Area::AQ), 16U) << "AQW0";
  EXPECT_EQ(onBoardEnd(other, Area::AI), 0U);
}

}  // namespace
}  // namespace rungproof
