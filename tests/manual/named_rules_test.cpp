// Rules that the manual states with a table of cases, one test for each case: the nine self-resetting timers, rotates
// by nothing, the limits of the down counter, local memory that nobody has set.
#include "example.hpp"

namespace rungproof::manual {
namespace {

constexpr int oneMs = 32, tenMs = 33, hundredMs = 37;  // numbers of TON by resolution (001:6597)

/// The timer resets itself through `contact`; `copy` follows its bit. Q0.0 of each scan; one tick passes before a scan
/// (100 ms: at the instruction), for 1 ms timers in front of the instruction with number `tickBefore`.
std::string selfResetting(int timer, const std::string& contact, const std::string& copy,
                          std::uint32_t tickBefore = 0) {
  const std::string t = "T" + std::to_string(timer);
  Plant plant("LDN " + contact + "; TON " + t + ", +3; LD " + t + "; = " + copy +
              (copy == "Q0.0" ? "" : "; LD " + copy + "; = Q0.0"));
  if (timer == oneMs) plant.ms = {{tickBefore, 1}};
  std::string trace;
  for (int scan = 0; scan < 12; ++scan)
    trace += plant.scan(timer == tenMs ? 1 : 0, timer == hundredMs ? 1 : 0).value("Q0.0") != 0 ? '1' : '0';
  return trace;
}

}  // namespace

// Wiring 1: the timer's own bit. Wiring 2: the output. Wiring 3: a bit memory, as in the manual's program (001:6623).
// 1 ms and 10 ms: enabled in scan 0, three ticks in scans 1 to 3, reset in scan 4, enabled again in scan 5.
// 100 ms: the instruction of scan 0 takes the tick of scan 0; one scan on, one scan to reset.

TEST(SelfResettingTimer, OneMsByItsOwnBit) {
  // The update falls in front of the first contact, which then resets the timer before the second one sees its bit.
  EXPECT_EQ(selfResetting(oneMs, "T32", "Q0.0", 0), "000000000000");
  // The update falls between the two contacts: on for one scan. Ticks come behind the TON here, so scan 0 has one too:
  // the third is that of scan 2; scan 3 resets, its tick finds the timer disabled, scans 4 to 6 count again.
  EXPECT_EQ(selfResetting(oneMs, "T32", "Q0.0", 2), "001000100010");
}
TEST(SelfResettingTimer, OneMsByTheOutput) { EXPECT_EQ(selfResetting(oneMs, "Q0.0", "Q0.0"), "000100001000"); }
TEST(SelfResettingTimer, OneMsByABitMemory) { EXPECT_EQ(selfResetting(oneMs, "M0.0", "M0.0"), "000100001000"); }
TEST(SelfResettingTimer, TenMsByItsOwnBitNeverShows) {
  // The bit stands from the start of the scan until the TON, which sees its own bit and clears it.
  EXPECT_EQ(selfResetting(tenMs, "T33", "Q0.0"), "000000000000");
}
TEST(SelfResettingTimer, TenMsByTheOutput) { EXPECT_EQ(selfResetting(tenMs, "Q0.0", "Q0.0"), "000100001000"); }
TEST(SelfResettingTimer, TenMsByABitMemory) { EXPECT_EQ(selfResetting(tenMs, "M0.0", "M0.0"), "000100001000"); }
TEST(SelfResettingTimer, HundredMsByItsOwnBit) { EXPECT_EQ(selfResetting(hundredMs, "T37", "Q0.0"), "000100001000"); }
TEST(SelfResettingTimer, HundredMsByTheOutput) { EXPECT_EQ(selfResetting(hundredMs, "Q0.0", "Q0.0"), "000100001000"); }
TEST(SelfResettingTimer, HundredMsByABitMemory) { EXPECT_EQ(selfResetting(hundredMs, "M0.0", "M0.0"), "000100001000"); }

TEST(Rotate, ByZeroLeavesValueAndLastBit) {
  // 001:5944-5946: N = 0 rotates nothing and leaves SM1.1; SM1.0 says whether the value is 0.
  check({
      {"RLB VB0, 0", "VB0=2#10000001", "SM1.0=0"},
      {"RRB VB0, 0", "VB0=2#10000001", "SM1.0=0"},
      {"RLW VW0, 0", "VW0=16#8001", "SM1.0=0"},
      {"RRW VW0, 0", "VW0=0", "SM1.0=1"},
      {"RLD VD0, 0", "VD0=16#80000001", "SM1.0=0"},
      {"RRD VD0, 0", "VD0=0", "SM1.0=1"},
  });
}

TEST(CountDown, StopsAtZero) {
  // 001:3999: the count input makes nothing of a current value of 0; the bit is on there.
  Plant plant("LD I0.0; LD I0.1; CTD C7, +2");
  plant.set("I0.1=1").scan();
  plant.set("I0.1=0");
  std::string values;
  for (int pulse = 0; pulse < 4; ++pulse) {
    plant.set("I0.0=0").scan();
    plant.set("I0.0=1").scan();
    values += std::to_string(plant.value("C.value[7]")) + (plant.value("C[7]") != 0 ? "+ " : " ");
  }
  EXPECT_EQ(values, "1 0+ 0+ 0+ ");
}

TEST(Call, LocalMemoryIsNotInitialised) {
  // 001:1373: what a block finds in its local memory is whatever was there; here 16#A5.
  Plant plant({{PouKind::Main, 0, "LD SM0.0; CALL 1"},
               {PouKind::Subroutine, 1, "LD SM0.0; MOVB LB0, VB0; MOVW LW62, VW2; MOVB 1, LB0"}});
  plant.freshLocal = 0xA5;
  for (int scan = 0; scan < 2; ++scan) {
    plant.scan();
    EXPECT_EQ(plant.value("VB0"), 0xA5U) << "nor is it kept from call to call";
    EXPECT_EQ(plant.value("VW2"), 0xA5A5U);
  }
}

}  // namespace rungproof::manual
