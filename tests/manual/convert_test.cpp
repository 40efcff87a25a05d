// Standard conversions, SEG, ENCO, DECO.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plant.hpp"

namespace rungproof::manual {
namespace {

TEST(Convert, ByteToIntExtendsWithZeros) {
  Bench bench({"LD I0.0", "BTI VB0, VW10"});
  bench.set("VB0", 0x80);
  bench.set("VW10", -1);
  EXPECT_EQ(bench.scan().value("VW10"), 0xFFFFU) << "no power flow";
  bench.set("I0.0", 1);
  EXPECT_EQ(bench.scan().value("VW10"), 0x0080U);
  bench.set("VB0", 255);
  EXPECT_EQ(bench.scan().value("VW10"), 255U);
  EXPECT_TRUE(bench.eno());
}

TEST(Convert, IntToByteTakes0To255) {
  for (const auto& [value, fits] : std::vector<std::pair<int, bool>>{
           {0, true}, {200, true}, {255, true}, {256, false}, {-1, false}, {-32768, false}}) {
    Bench bench({"LD SM0.0", "ITB VW0, VB10"});
    bench.set("VW0", value);
    bench.set("VB10", 0x5A);
    bench.set("SM1.1", fits);
    bench.scan();
    EXPECT_EQ(bench.value("VB10"), fits ? static_cast<unsigned>(value) : 0x5AU) << value;
    EXPECT_EQ(bench.value("SM1.1"), fits ? 0U : 1U) << value;
    EXPECT_EQ(bench.eno(), fits);
    EXPECT_EQ(bench.met(Hazard::Overflow), !fits);
    EXPECT_FALSE(bench.errorBit()) << "SM1.1 is a status, no logged error";
  }
}

TEST(Convert, IntToDIntExtendsTheSign) {
  Bench bench({"LD SM0.0", "ITD VW0, VD10"});
  bench.set("VW0", -2);
  EXPECT_EQ(bench.scan().value("VD10"), 0xFFFFFFFEU);
  bench.set("VW0", 32767);
  EXPECT_EQ(bench.scan().value("VD10"), 32767U);
  EXPECT_TRUE(bench.eno());
}

TEST(Convert, DIntToIntTakesTheRangeOfInt) {
  for (const auto& [value, fits] : std::vector<std::pair<std::int64_t, bool>>{{0, true},
                                                                              {32767, true},
                                                                              {-32768, true},
                                                                              {32768, false},
                                                                              {-32769, false},
                                                                              {65535, false},
                                                                              {-2147483648LL, false}}) {
    Bench bench({"LD SM0.0", "DTI VD0, VW10"});
    bench.set("VD0", value);
    bench.set("VW10", 0x1234);
    bench.set("SM1.1", fits);
    bench.scan();
    EXPECT_EQ(bench.value("VW10"), fits ? static_cast<std::uint16_t>(value) : 0x1234U) << value;
    EXPECT_EQ(bench.value("SM1.1"), fits ? 0U : 1U);
    EXPECT_EQ(bench.eno(), fits);
  }
}

TEST(Convert, DIntToReal) {
  // 16777217 = 2^24 + 1 and 33554431 = 2^25 - 1 do not fit 24 binary digits: nearest is 2^24 (even) and 2^25.
  for (const auto& [value, nearest, truncated] :
       std::vector<std::tuple<std::int64_t, float, float>>{{101, 101.0F, 101.0F},
                                                           {-101, -101.0F, -101.0F},
                                                           {0, 0.0F, 0.0F},
                                                           {16777217, 16777216.0F, 16777216.0F},
                                                           {33554431, 33554432.0F, 33554430.0F},
                                                           {-33554431, -33554432.0F, -33554430.0F},
                                                           {2147483647, 2147483648.0F, 2147483520.0F},
                                                           {-2147483648LL, -2147483648.0F, -2147483648.0F}}) {
    for (const bool truncates : {false, true}) {
      Bench bench({"LD SM0.0", "DTR VD0, VD10"});
      ASSERT_TRUE(bench.choices.set("dtr-rounding", truncates ? "truncated" : "nearest"));
      bench.set("VD0", value);
      bench.scan();
      EXPECT_EQ(bench.real("VD10"), truncates ? truncated : nearest) << value;
      EXPECT_TRUE(bench.eno());
    }
  }
}

TEST(Convert, InchesToCentimetres) {
  // 001:3510-3540 without the multiplication: 101 inches; 256.54 cm rounds to 257.
  Bench bench({"LD I0.0", "ITD C10, AC1", "DTR AC1, VD0", "ROUND VD8, VD12"});
  bench.store.set(Reg::CounterCurrent, 10, 101, true);
  bench.setReal("VD8", 256.54F);
  bench.set("I0.0", 1);
  bench.scan();
  EXPECT_EQ(bench.real("VD0"), 101.0F);
  EXPECT_EQ(bench.value("VD12"), 257U);
}

TEST(Convert, RoundAndTruncate) {
  for (const auto& [real, rounded, truncated] :
       std::vector<std::tuple<float, int, int>>{{0.5F, 1, 0},
                                                {0.25F, 0, 0},
                                                {2.5F, 3, 2},
                                                {2.75F, 3, 2},
                                                {-0.25F, 0, 0},
                                                {-2.75F, -3, -2},
                                                {1234567.0F, 1234567, 1234567},
                                                {-2147483648.0F, -2147483647 - 1, -2147483647 - 1},
                                                {2147483520.0F, 2147483520, 2147483520}}) {
    Bench bench({"LD SM0.0", "ROUND VD0, VD10", "TRUNC VD0, VD20"});
    bench.setReal("VD0", real);
    bench.set("SM1.1", 1);
    bench.scan();
    EXPECT_EQ(static_cast<std::int32_t>(bench.value("VD10")), rounded) << real;
    EXPECT_EQ(static_cast<std::int32_t>(bench.value("VD20")), truncated) << real;
    EXPECT_EQ(bench.value("SM1.1"), 0U);
    EXPECT_TRUE(bench.eno());
  }
}

TEST(Convert, NegativeHalvesFollowTheChoice) {
  for (const auto& [real, away, up] : std::vector<std::tuple<float, int, int>>{
           {-2.5F, -3, -2}, {-0.5F, -1, 0}, {-3.5F, -4, -3}, {2.5F, 3, 3}, {-2.75F, -3, -3}}) {
    for (const bool upward : {false, true}) {
      Bench bench({"LD SM0.0", "ROUND VD0, VD10", "TRUNC VD0, VD20"});
      ASSERT_TRUE(bench.choices.set("round-half", upward ? "up" : "away-from-zero"));
      bench.setReal("VD0", real);
      bench.scan();
      EXPECT_EQ(static_cast<std::int32_t>(bench.value("VD10")), upward ? up : away) << real;
      EXPECT_EQ(static_cast<std::int32_t>(bench.value("VD20")), static_cast<int>(real)) << "TRUNC is not concerned";
    }
  }
}

TEST(Convert, RealsThatDoNotFitLeaveTheOutput) {
  for (const float bad :
       {2147483648.0F, -2147483904.0F, 1e30F, -1e30F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    for (const char* line : {"ROUND VD0, VD10", "TRUNC VD0, VD10"}) {
      Bench bench({"LD SM0.0", line});
      bench.setReal("VD0", bad);
      bench.set("VD10", 77);
      bench.scan();
      EXPECT_EQ(bench.value("VD10"), 77U) << line << bad;
      EXPECT_EQ(bench.value("SM1.1"), 1U);
      EXPECT_FALSE(bench.eno());
    }
  }
}

TEST(Convert, BcdToInt) {
  for (const auto& [bcd, number] :
       std::vector<std::pair<int, int>>{{0x1234, 1234}, {0x0000, 0}, {0x9999, 9999}, {0x0070, 70}, {0x8000, 8000}}) {
    Bench bench({"LD I0.3", "BCDI AC0"});
    bench.set("AC0", bcd);
    bench.set("SM1.6", 1);
    bench.set("I0.3", 1);
    bench.scan();
    EXPECT_EQ(bench.value("AC0"), static_cast<unsigned>(number)) << "001:3540: 1234 becomes 04D2";
    EXPECT_EQ(bench.value("SM1.6"), 0U);
    EXPECT_TRUE(bench.eno());
  }
  for (const int bad : {0x000A, 0x00A0, 0x0A00, 0xA000, 0xFFFF}) {
    for (const bool unknown : {false, true}) {
      Bench bench({"LD SM0.0", "BCDI VW0"});
      ASSERT_TRUE(bench.choices.set("bcd-error-result", unknown ? "unknown" : "unchanged"));
      bench.outside.values[{External::UnknownResult, 0}] = 0xBEEF;
      bench.set("VW0", bad);
      bench.scan();
      EXPECT_EQ(bench.value("VW0"), unknown ? 0xBEEFU : static_cast<unsigned>(bad));
      EXPECT_EQ(bench.value("SM1.6"), 1U);
      EXPECT_FALSE(bench.eno());
      EXPECT_TRUE(bench.met(Hazard::NotBcd));
    }
  }
}

TEST(Convert, IntToBcd) {
  for (const auto& [number, bcd] :
       std::vector<std::pair<int, int>>{{1234, 0x1234}, {0, 0}, {9999, 0x9999}, {10, 0x10}, {9070, 0x9070}}) {
    Bench bench({"LD SM0.0", "IBCD VW0"});
    bench.set("VW0", number);
    bench.set("SM1.6", 1);
    bench.scan();
    EXPECT_EQ(bench.value("VW0"), static_cast<unsigned>(bcd));
    EXPECT_EQ(bench.value("SM1.6"), 0U);
    EXPECT_TRUE(bench.eno());
  }
  for (const int bad : {10000, -1, 32767}) {
    Bench bench({"LD SM0.0", "IBCD VW0"});
    bench.set("VW0", bad);
    bench.scan();
    EXPECT_EQ(bench.value("VW0"), static_cast<std::uint16_t>(bad));
    EXPECT_EQ(bench.value("SM1.6"), 1U);
    EXPECT_FALSE(bench.eno());
  }
}

TEST(Convert, SegmentTable) {
  // 000:2560-2605; 9 has no lowest segment. The upper nibble of IN is not looked at.
  const std::vector<unsigned> patterns = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07,
                                          0x7F, 0x67, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71};
  Bench bench({"LD I1.0", "SEG VB48, AC1"});
  bench.set("VB48", 5);
  EXPECT_EQ(bench.scan().value("AC1"), 0U);
  bench.set("I1.0", 1);
  for (unsigned digit = 0; digit < 16; ++digit) {
    for (const unsigned upper : {0x00U, 0x50U, 0xF0U}) {
      bench.set("VB48", digit | upper);
      EXPECT_EQ(bench.scan().value("AC1"), patterns[digit]) << digit;
      EXPECT_TRUE(bench.eno());
    }
  }
}

TEST(Convert, EncodeFindsTheLowestOne) {
  Bench bench({"LD I0.0", "ENCO VW0, VB10"});
  bench.set("I0.0", 1);
  for (unsigned bit = 0; bit < 16; ++bit) {
    for (const unsigned above : {0U, 0xFFFFU}) {
      bench.set("VW0", ((1U << bit) | (above << bit)) & 0xFFFF);
      bench.set("VB10", 0xA5);
      EXPECT_EQ(bench.scan().value("VB10"), bit);
      EXPECT_TRUE(bench.eno());
    }
  }
  EXPECT_EQ(bench.value("SMB1"), 0U);
}

TEST(Convert, EncodeChoices) {
  for (const bool keepsNibble : {false, true}) {
    for (const bool keepsForZero : {false, true}) {
      Bench bench({"LD SM0.0", "ENCO VW0, VB10"});
      ASSERT_TRUE(bench.choices.set("enco-high-nibble", keepsNibble ? "kept" : "cleared"));
      ASSERT_TRUE(bench.choices.set("enco-zero", keepsForZero ? "unchanged" : "zero"));
      bench.set("VW0", 0x8200);
      bench.set("VB10", 0xA5);
      EXPECT_EQ(bench.scan().value("VB10"), keepsNibble ? 0xA9U : 0x09U) << "000:3312-3325: the byte shows 9";
      bench.set("VW0", 0);
      EXPECT_EQ(bench.scan().value("VB10"), (keepsNibble ? 0xA0U : 0U) | (keepsForZero ? 9U : 0U));
    }
  }
}

TEST(Convert, DecodeSetsOneBit) {
  Bench bench({"LD I3.1", "DECO AC2, VW40"});
  bench.set("VW40", -1);
  EXPECT_EQ(bench.scan().value("VW40"), 0xFFFFU);
  bench.set("I3.1", 1);
  bench.set("AC2", 3);
  EXPECT_EQ(bench.scan().value("VW40"), 0x0008U) << "example 001:3972";
  for (unsigned n = 0; n < 32; ++n) {
    bench.set("AC2", n);
    EXPECT_EQ(bench.scan().value("VW40"), 1U << (n % 16)) << "low nibble only";
  }
  EXPECT_TRUE(bench.eno());
}

TEST(Convert, BadPointersAreError0006) {
  for (const char* line :
       {"BTI *AC1, VW0", "ITB VW0, *AC1", "ITD *AC1, VD0", "DTI *AC1, VW0", "DTR VD0, *AC1", "BCDI *AC1", "IBCD *AC1",
        "ROUND *AC1, VD0", "TRUNC VD0, *AC1", "SEG *AC1, VB0", "ENCO *AC1, VB0", "DECO VB0, *AC1"}) {
    Bench bench({"LD SM0.0", line});
    bench.set("AC1", 0x07000000);
    const Concrete::Store before = bench.store;
    bench.scan();
    EXPECT_EQ(bench.outside.hazards(), std::vector<Hazard>{Hazard::BadIndirectAddress}) << line;
    EXPECT_FALSE(bench.eno());
    EXPECT_TRUE(bench.errorBit());
    EXPECT_EQ(bench.store.area(Area::V) == before.area(Area::V), true) << "nothing is written";
  }
}

}  // namespace
}  // namespace rungproof::manual
