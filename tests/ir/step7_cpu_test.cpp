// The rows of the CPUs of the S7-300 and S7-400 against what the documents and the family's data sheets say of them.
#include <gtest/gtest.h>

#include <set>

#include "ir/s7300/cpu.hpp"
#include "ir/target.hpp"

namespace rungproof {
namespace {

TEST(Step7Cpu, EveryNameIsFoundAndStandsOnce) {
  std::set<std::string_view> names;
  for (const Step7CpuRow& row : cpu_rows::step7) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    const auto cpu = cpuNamed(row.name);
    ASSERT_TRUE(cpu.has_value()) << row.name;
    EXPECT_TRUE(isStep7(*cpu));
    EXPECT_EQ(&step7Row(*cpu), &row);
  }
  EXPECT_EQ(names.size(), 11U);
}

TEST(Step7Cpu, OnlyThe318OfTheS7300HasFourAccumulatorsAndShowsTheWholeStatusWord) {
  for (const Step7CpuRow& row : cpu_rows::step7) {
    const bool isFull = row.is400 || row.name == "318-2";
    EXPECT_EQ(row.accumulators, isFull ? 4 : 2) << row.name;  // 002:1424-1426
    EXPECT_EQ(row.hidesStatus, !isFull) << row.name;          // 002:1603
  }
}

TEST(Step7Cpu, NamesOfAreasEndWhereTheDataSheetsSay) {
  const auto size = [](std::string_view cpu, Area area) {
    return step7AreaSize(step7Row(cpuNamed(cpu).value()), area);
  };
  EXPECT_EQ(size("312", Area::M), 256U);
  EXPECT_EQ(size("315-2", Area::M), 2048U);
  EXPECT_EQ(size("417", Area::M), 16384U);
  EXPECT_EQ(size("314", Area::T), 256U);  // 002:502-503
  EXPECT_EQ(size("317-2", Area::C), 512U);
  EXPECT_EQ(size("319-3", Area::I), 4096U);
  EXPECT_EQ(size("416", Area::Q), 16384U);
  EXPECT_EQ(step7Row(cpuNamed("318-2").value()).lastBlock, 2047U);
  EXPECT_EQ(step7Row(cpuNamed("414").value()).lastBlock, 6000U);
}

}  // namespace
}  // namespace rungproof
