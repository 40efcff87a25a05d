// The points on the CPUs: 001:11612-11622 (S7-200), system manual (S7-200 SMART).
#include "ir/s7200/points.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

TEST(Points, EndOfTheInputsAndOutputs) {
  struct Row {
    Cpu cpu;
    std::uint32_t inputs, outputs;
  };
  for (const Row& row :
       {Row{s7200Cpu("221"), 6, 4}, Row{s7200Cpu("222"), 8, 6}, Row{s7200Cpu("224"), 14, 10},
        Row{s7200Cpu("224XP"), 14, 10}, Row{s7200Cpu("226"), 24, 16}, Row{s7200Cpu("ST20"), 12, 8},
        Row{s7200Cpu("SR30"), 18, 12}, Row{s7200Cpu("CR40"), 24, 16}, Row{s7200Cpu("CR60s"), 36, 24}}) {
    const Target target{row.cpu, usualEdition(row.cpu)};
    EXPECT_EQ(onBoardEnd(target, Area::I), row.inputs) << cpuName(row.cpu);
    EXPECT_EQ(onBoardEnd(target, Area::Q), row.outputs) << cpuName(row.cpu);
  }
}

TEST(Points, OnlyThe224XPHasAnalogueOnes) {
  const Target xp{s7200Cpu("224XP"), Edition::Edition2004}, other{s7200Cpu("226"), Edition::Edition2004};
  EXPECT_EQ(onBoardEnd(xp, Area::AI), 32U) << "AIW0 and AIW2 (001:1228)";
  EXPECT_EQ(onBoardEnd(xp, Area::AQ), 16U) << "AQW0";
  EXPECT_EQ(onBoardEnd(other, Area::AI), 0U);
}

}  // namespace
}  // namespace rungproof
