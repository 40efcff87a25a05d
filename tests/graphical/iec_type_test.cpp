// Literals and addresses of IEC 61131-3, and the places that variables, timers and counters get.
#include "frontend/graphical/iec_type.hpp"

#include <gtest/gtest.h>

#include "frontend/graphical/drawn_memory.hpp"

namespace rungproof {
namespace {

std::int64_t ms(std::string_view text) {
  const auto literal = iecLiteral(text);
  return literal && literal->type == IecType::Time ? literal->value : -1;
}

TEST(IecLiterals, Durations) {
  EXPECT_EQ(ms("T#500ms"), 500);
  EXPECT_EQ(ms("t#1s"), 1000);
  EXPECT_EQ(ms("TIME#1m30s"), 90'000);
  EXPECT_EQ(ms("T#1h2m3s4ms"), 3'723'004);
  EXPECT_EQ(ms("T#1.5s"), 1500);
  EXPECT_EQ(ms("T#24d"), 2'073'600'000);
  EXPECT_EQ(ms("T#25d"), -1);    // beyond 31 bits of ms
  EXPECT_EQ(ms("T#0.5ms"), -1);  // no such time on the S7-200
  EXPECT_EQ(ms("T#"), -1);
  EXPECT_EQ(ms("T#5"), -1);
}

TEST(IecLiterals, Numbers) {
  const auto value = [](std::string_view text) { return iecLiteral(text) ? iecLiteral(text)->value : -999; };
  EXPECT_EQ(value("1_000"), 1000);
  EXPECT_EQ(value("-5"), -5);
  EXPECT_EQ(value("16#FF"), 255);
  EXPECT_EQ(value("2#1010"), 10);
  EXPECT_EQ(value("8#17"), 15);
  EXPECT_EQ(value("INT#7"), 7);
  EXPECT_EQ(value("BYTE#300"), -999);
  EXPECT_EQ(value("TRUE"), 1);
  EXPECT_EQ(value("1.5"), 0x3FC00000);
  EXPECT_EQ(value("speed"), -999);
  EXPECT_EQ(value("12x"), -999);
}

TEST(LocatedAddresses, CountBytes) {
  const auto address = [](std::string_view text) {
    return locatedAddress(text) ? toString(*locatedAddress(text)) : std::string("none");
  };
  EXPECT_EQ(address("%IX0.3"), "I0.3");
  EXPECT_EQ(address("%QX1.7"), "Q1.7");
  EXPECT_EQ(address("%I2.0"), "I2.0");
  EXPECT_EQ(address("%IX11"), "I1.3");
  EXPECT_EQ(address("%IW4"), "IW4");
  EXPECT_EQ(address("%MD8"), "MD8");
  EXPECT_EQ(address("%AIW2"), "AIW2");
  EXPECT_EQ(address("%IX0.8"), "I0.8");  // left to rule ADR001
  EXPECT_EQ(address("%QX0.0.0"), "none");
  EXPECT_EQ(address("IX0.0"), "none");
}

TEST(DrawnMemory, PlacesDoNotOverlap) {
  DrawnMemory memory{Program{}};
  EXPECT_EQ(toString(*memory.allocate(IecType::Bool)), "V0.0");
  EXPECT_EQ(toString(*memory.allocate(IecType::Int)), "VW2");
  EXPECT_EQ(toString(*memory.allocate(IecType::Bool)), "V0.1");
  EXPECT_EQ(toString(*memory.allocate(IecType::Byte)), "VB1");
  EXPECT_EQ(toString(*memory.allocate(IecType::Time)), "VD4");
  memory.reserve(direct(Area::V, Width::Word, 8));
  EXPECT_EQ(toString(*memory.allocate(IecType::Word)), "VW10");
}

TEST(DrawnMemory, TimersDivideTheirPresets) {
  DrawnMemory memory{Program{}};
  const auto resolution = [&](std::int64_t time) {
    const auto chosen = memory.timerFor(time);
    return chosen ? chosen->resolution : 0;
  };
  EXPECT_EQ(resolution(5000), 100);
  EXPECT_EQ(resolution(250), 10);
  EXPECT_EQ(resolution(7), 1);
  EXPECT_EQ(resolution(3'276'700), 100);  // 32767 steps
  EXPECT_EQ(resolution(3'276'800), 0);
  EXPECT_EQ(resolution(32'768'0 + 5), 0);  // would need steps of 1 or 5 ms beyond 32767
  EXPECT_EQ(resolution(9), 1);
  EXPECT_EQ(resolution(9), 0);  // T32 and T96 are all there are (001:6597)
}

}  // namespace
}  // namespace rungproof
