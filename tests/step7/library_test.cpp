// Blocks of the libraries: their instances as the system lays them out, and calls of them.
#include "ir/s7300/library.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/step7/read7.hpp"

namespace rungproof {
namespace {

std::string instanceOf(std::uint32_t sfb) {
  std::string text;
  const auto structure = s7300::interfaceOf(*s7300::libraryBlock(BlockType::Sfb, sfb));
  for (const s7300::Field& field : structure->fields)
    text += fmt::format("{} {}.{} ", field.name, field.byte, field.bit);
  return text + fmt::format("= {}", structure->size);
}

TEST(Library, InstancesOfTimersAndCounters) {
  for (const std::uint32_t timer : {3U, 4U, 5U})
    EXPECT_EQ(instanceOf(timer), "IN 0.0 PT 2.0 Q 6.0 ET 8.0 STATE 12.0 STIME 14.0 ATIME 18.0 = 22");
  EXPECT_EQ(instanceOf(0), "CU 0.0 R 0.1 PV 2.0 Q 4.0 CV 6.0 CUO 8.0 = 10");
  EXPECT_EQ(instanceOf(1), "CD 0.0 LOAD 0.1 PV 2.0 Q 4.0 CV 6.0 CDO 8.0 = 10");
  EXPECT_EQ(instanceOf(2), "CU 0.0 CD 0.1 R 0.2 LOAD 0.3 PV 2.0 QU 4.0 QD 4.1 CV 6.0 CUO 8.0 CDO 8.1 = 10");
}

TEST(Library, EachBlockStandsOnceAndItsParametersCanBeRead) {
  std::set<std::pair<BlockType, int>> numbers;
  for (const s7300::LibraryBlock& block : s7300::libraryBlocks()) {
    EXPECT_TRUE(numbers.emplace(block.type, block.number).second) << block.name;
    EXPECT_EQ(s7300::libraryBlockNamed(block.name), &block);
    const auto structure = s7300::interfaceOf(block);
    ASSERT_NE(structure, nullptr);
    for (const s7300::Field& field : structure->fields) EXPECT_FALSE(field.name.empty()) << block.name;
  }
  EXPECT_GE(numbers.size(), 66u);
}

TEST(Library, AProgramsOwnBlockOfThatNumberIsMeant) {
  const Program program = read7(
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  mine : INT ;\nEND_VAR\nBEGIN\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\n"
      "NETWORK\nCALL FC 1 (mine := 4);\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(findings7(program), "");
}

TEST(Library, WhatIsNotModelledIsNotCovered) {
  const Program program = readOb1("CALL SFC 1 (RET_VAL := MW 0, CDT := #now);");
  EXPECT_EQ(findings7(program), "SYN046 4:38 nothing declares now");
  const Program other = readOb1("CALL SFC 61 (CIRCLE_ID := B#16#1, BLOCK_ID := B#16#1, RET_VAL := MW 4);\nSET;");
  EXPECT_EQ(findings7(other), "SYN052 4:6 what SFC61 does besides its parameters is not modelled");
  EXPECT_FALSE(other.pous.at(0).networks.at(0).complete);
}

}  // namespace
}  // namespace rungproof
