// What shares memory: V10.3 lies in VB10, VW9 in its bytes 9 and 10; VW11 begins behind it (001:1300, addressing by
// byte, word and double word).
#include "ir/overlap.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

TEST(Overlap, IsExactToTheBit) {
  const Operand bit = direct(Area::V, Width::Bit, 10, 3);
  EXPECT_TRUE(overlaps(bit, direct(Area::V, Width::Byte, 10, 0)));
  EXPECT_TRUE(overlaps(bit, direct(Area::V, Width::Word, 9, 0)));
  EXPECT_TRUE(overlaps(direct(Area::V, Width::DWord, 7, 0), bit));
  EXPECT_FALSE(overlaps(bit, direct(Area::V, Width::Bit, 10, 4)));
  EXPECT_FALSE(overlaps(bit, direct(Area::V, Width::Word, 11, 0)));
  EXPECT_FALSE(overlaps(bit, direct(Area::M, Width::Bit, 10, 3)));
}

TEST(Overlap, ATimerIsOneThingUnderBitAndValue) {
  EXPECT_TRUE(overlaps(direct(Area::T, Width::Bit, 37, 0), direct(Area::T, Width::Word, 37, 0)));
  EXPECT_FALSE(overlaps(direct(Area::T, Width::Word, 37, 0), direct(Area::T, Width::Word, 38, 0)));
}

}  // namespace
}  // namespace rungproof
