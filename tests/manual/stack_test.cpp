// Logic stack, contacts, NOT and NOP: the instructions of 001:2825-2872 and the example 001:2768.
#include <gtest/gtest.h>

#include "example.hpp"

namespace rungproof::manual {
namespace {

using Levels = std::array<bool, 9>;

/// Every start stack of nine bits, so that each level's way is seen for both values.
template <class Check>
void forEveryStack(Check check) {
  for (unsigned pattern = 0; pattern < 512; ++pattern) {
    Levels iv;
    for (unsigned i = 0; i < 9; ++i) iv[i] = (pattern >> i & 1U) != 0;
    check(iv);
  }
}

/// Runs one statement on `iv`; the unknown level shifted in from below is `bottom`.
Levels after(const std::string& line, const Levels& iv, bool bottom = false) {
  Bench bench({line});
  bench.outside.values[{External::StackBottom, 0}] = bottom ? 1 : 0;
  return bench.scanWithStack(iv).stack;
}

TEST(Stack, AldAndsTheUpperLevelsAndPops) {
  forEveryStack([](const Levels& iv) {
    for (const bool x : {false, true}) {
      EXPECT_EQ(after("ALD", iv, x), (Levels{iv[0] && iv[1], iv[2], iv[3], iv[4], iv[5], iv[6], iv[7], iv[8], x}));
      EXPECT_EQ(after("OLD", iv, x), (Levels{iv[0] || iv[1], iv[2], iv[3], iv[4], iv[5], iv[6], iv[7], iv[8], x}));
      EXPECT_EQ(after("LPP", iv, x), (Levels{iv[1], iv[2], iv[3], iv[4], iv[5], iv[6], iv[7], iv[8], x}));
    }
  });
}

TEST(Stack, PushReadAndLoadLevel) {
  forEveryStack([](const Levels& iv) {
    EXPECT_EQ(after("LPS", iv), (Levels{iv[0], iv[0], iv[1], iv[2], iv[3], iv[4], iv[5], iv[6], iv[7]}));
    EXPECT_EQ(after("LRD", iv), (Levels{iv[1], iv[1], iv[2], iv[3], iv[4], iv[5], iv[6], iv[7], iv[8]}));
    EXPECT_EQ(after("NOP 30", iv), iv);
    EXPECT_EQ(after("NOT", iv), (Levels{!iv[0], iv[1], iv[2], iv[3], iv[4], iv[5], iv[6], iv[7], iv[8]}));
    for (unsigned n = 0; n <= 8; ++n) {
      EXPECT_EQ(after("LDS " + std::to_string(n), iv),
                (Levels{iv[n], iv[0], iv[1], iv[2], iv[3], iv[4], iv[5], iv[6], iv[7]}))
          << n;
    }
  });
}

TEST(Stack, ContactsPushOrCombine) {
  forEveryStack([](const Levels& iv) {
    for (const bool nv : {false, true}) {
      const auto with = [&](const std::string& line) {
        Bench bench({line});
        bench.set("M3.5", nv);
        return bench.scanWithStack(iv).stack;
      };
      const Levels pushed{nv, iv[0], iv[1], iv[2], iv[3], iv[4], iv[5], iv[6], iv[7]};
      Levels notPushed = pushed, anded = iv, andedNot = iv, ored = iv, oredNot = iv;
      notPushed[0] = !nv;
      anded[0] = iv[0] && nv;
      andedNot[0] = iv[0] && !nv;
      ored[0] = iv[0] || nv;
      oredNot[0] = iv[0] || !nv;
      EXPECT_EQ(with("LD M3.5"), pushed);
      EXPECT_EQ(with("LDN M3.5"), notPushed);
      EXPECT_EQ(with("A M3.5"), anded);
      EXPECT_EQ(with("AN M3.5"), andedNot);
      EXPECT_EQ(with("O M3.5"), ored);
      EXPECT_EQ(with("ON M3.5"), oredNot);
    }
  });
}

TEST(Stack, ImmediateContactsReadTheTerminalNotTheImage) {
  const auto top = [](const std::string& line, bool start, bool terminal, bool image) {
    Bench bench({line});
    bench.outside.values[{External::ImmediateInput, 1 * 8 + 3}] = terminal ? 1 : 0;
    bench.set("I1.3", image);
    Levels iv{};
    iv[0] = start;
    const bool result = bench.scanWithStack(iv).stack[0];
    EXPECT_EQ(bench.value("I1.3"), image) << "the image register stays as it was (001:2731)";
    return result;
  };
  for (const bool start : {false, true}) {
    for (const bool pin : {false, true}) {
      for (const bool image : {false, true}) {
        EXPECT_EQ(top("LDI I1.3", start, pin, image), pin);
        EXPECT_EQ(top("LDNI I1.3", start, pin, image), !pin);
        EXPECT_EQ(top("AI I1.3", start, pin, image), start && pin);
        EXPECT_EQ(top("ANI I1.3", start, pin, image), start && !pin);
        EXPECT_EQ(top("OI I1.3", start, pin, image), start || pin);
        EXPECT_EQ(top("ONI I1.3", start, pin, image), start || !pin);
      }
    }
  }
  Levels iv{true, false, true};
  Bench pushes({"LDI I0.0"});
  EXPECT_EQ(pushes.scanWithStack(iv).stack, (Levels{false, true, false, true}));
  Bench pushesNot({"LDNI I0.0"});
  EXPECT_EQ(pushesNot.scanWithStack(iv).stack, (Levels{true, true, false, true}));
}

TEST(Stack, WhatOnlyChangesTheTopLeavesTheOtherLevels) {
  for (const char* line : {"AI I0.0", "ANI I0.0", "OI I0.0", "ONI I0.0", "EU", "ED", "NOT", "AENO", "AB= 1, 2",
                           "OW> VW0, 1", "AR< VD0, 1.0"}) {
    forEveryStack([&](const Levels& iv) {
      Levels result = after(line, iv);
      result[0] = iv[0];
      EXPECT_EQ(result, iv) << line;
    });
  }
}

TEST(Stack, AenoReadsTheEnoBit) {
  // ITB of 300 fails, of 200 succeeds (001:3485).
  for (const int value : {200, 300}) {
    Bench bench({"LD SM0.0", "ITB VW0, VB10", "AENO", "= Q0.0"});
    bench.set("VW0", value);
    bench.scan();
    EXPECT_EQ(bench.value("Q0.0"), value == 200 ? 1U : 0U) << value;
    EXPECT_EQ(bench.met(Hazard::Overflow), value == 300);
  }
  // Without power flow AENO gives 0 even when an earlier box left ENO at 1.
  Bench bench({"LD SM0.0", "BTI VB0, VW10", "LD I0.0", "AENO", "= Q0.0"});
  EXPECT_EQ(bench.scan().value("Q0.0"), 0U);
  EXPECT_TRUE(bench.eno());
  EXPECT_EQ(Bench({"AENO"}).scanWithStack({true, true}).stack, (Levels{false, true}))
      << "ENO is 0 before any box has run";
}

TEST(Stack, ExampleOfContacts) {
  // 001:2768, networks 1 and 2: Q0.0 = I0.0 & I0.1 and its opposite; Q0.2 = I0.2 | !I0.3.
  for (unsigned inputs = 0; inputs < 16; ++inputs) {
    Bench bench({"LD I0.0", "A I0.1", "= Q0.0", "NOT", "= Q0.1", "LD I0.2", "ON I0.3", "= Q0.2"});
    bench.set("IB0", inputs);
    bench.scan();
    const bool i0 = (inputs & 1) != 0, i1 = (inputs & 2) != 0, i2 = (inputs & 4) != 0, i3 = (inputs & 8) != 0;
    EXPECT_EQ(bench.value("Q0.0"), i0 && i1 ? 1U : 0U) << inputs;
    EXPECT_EQ(bench.value("Q0.1"), i0 && i1 ? 0U : 1U) << inputs;
    EXPECT_EQ(bench.value("Q0.2"), i2 || !i3 ? 1U : 0U) << inputs;
  }
}

TEST(Stack, ContactsOfTimersAndCountersReadTheBit) {
  Bench bench({"LD T37", "= Q0.0", "LD C4", "= Q0.1"});
  bench.store.set(Reg::TimerBit, 37, 1, true);
  bench.store.set(Reg::CounterCurrent, 4, 5, true);
  bench.scan();
  EXPECT_EQ(bench.value("QB0"), 1U);
  bench.store.set(Reg::TimerBit, 37, 0, true);
  bench.store.set(Reg::CounterBit, 4, 1, true);
  EXPECT_EQ(bench.scan().value("QB0"), 2U);
}

}  // namespace
}  // namespace rungproof::manual
