// The row in which the data blocks lie: every byte has one place, the way there and the way back are the same way, and
// what lies behind a block is of no other block.
#include "ir/block_map.hpp"

#include <gtest/gtest.h>

#include <set>

namespace rungproof {
namespace {

Program withBlocks(std::initializer_list<std::pair<std::uint32_t, std::size_t>> blocks) {
  Program program;
  for (const auto& [number, bytes] : blocks) {
    DataBlock block;
    block.number = number;
    block.bytes.resize(bytes);
    program.dataBlocks.push_back(std::move(block));
  }
  return program;
}

TEST(BlockMap, EveryByteHasItsOwnPlaceAndComesBack) {
  const BlockMap map(withBlocks({{10, 7}, {2, 1}, {8191, 300}}));
  std::set<std::uint32_t> places;
  for (const auto& [block, length] : {std::pair{10U, 7U}, std::pair{2U, 1U}, std::pair{8191U, 300U}}) {
    EXPECT_EQ(map.length(block), length);
    for (std::uint32_t byte = 0; byte < length; ++byte) {
      const std::uint32_t place = map.place(dataByte(block, byte));
      EXPECT_LT(place, map.size());
      EXPECT_TRUE(places.insert(place).second) << "DB" << block << ".DBB" << byte;
      EXPECT_EQ(map.dataByteAt(place), dataByte(block, byte));
    }
  }
}

TEST(BlockMap, AnAccessOfFourBytesAtTheEndReachesIntoNoOtherBlock) {
  const BlockMap map(withBlocks({{1, 4}, {2, 4}}));
  EXPECT_GE(map.place(dataByte(2, 0)), map.place(dataByte(1, 3)) + 4);
}

TEST(BlockMap, WhatDoesNotExistLiesBehindEverything) {
  const BlockMap map(withBlocks({{1, 4}, {3, 0}}));
  for (const std::uint32_t block : {0U, 2U, 3U, 4U, 9000U}) {
    EXPECT_EQ(map.length(block), 0U);
    EXPECT_EQ(map.place(dataByte(block, 0)), map.size());
  }
  EXPECT_EQ(map.place(dataByte(1, 40)), map.size());
}

TEST(BlockMap, BitsAreCountedEightToAByte) {
  const BlockMap map(withBlocks({{5, 4}}));
  EXPECT_EQ(map.bitPlace(dataByte(5, 2) * 8 + 3), map.place(dataByte(5, 2)) * 8 + 3);
}

}  // namespace
}  // namespace rungproof
