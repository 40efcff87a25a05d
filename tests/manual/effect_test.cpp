// Effects beside the result: what an instruction tells the devices, ENO after success, and signed numbers that a
// program has written into timers and counters.
#include "plant.hpp"

namespace rungproof::manual {
namespace {

using Signals = std::vector<std::pair<Signal, std::uint32_t>>;

Signals signalsOf(const std::string& statements, const std::string& given, bool powerFlow = true) {
  Plant plant((powerFlow ? "LD SM0.0; " : "LDN SM0.0; ") + statements);
  plant.set(given).scan();
  return plant.outside.signals;
}

}  // namespace

TEST(Effect, DevicesAreToldOnceAndOnlyWithPowerFlow) {
  struct Case {
    const char *statements, *given;
    Signals told;
  };
  const char* freeport = "SMB30=9 VB0=1 VB1=65";
  const std::vector<Case> cases = {
      {"XMT VB0, 0", freeport, {{Signal::TransmitStarted, 0}}},
      {"XMT VB0, 1", "SMB130=9 VB0=1", {{Signal::TransmitStarted, 1}}},
      {"RCV VB0, 0", "SMB30=9 SMB87=16#C0 SMB94=5", {{Signal::ReceiveStarted, 0}}},
      {"RCV VB0, 1", "SMB130=9 SMB187=16#C0 SMB194=5", {{Signal::ReceiveStarted, 1}}},
      {"RCV VB0, 0", "SMB30=9 SMB87=16#40 SMB94=5 port.busy[0]=2", {{Signal::ReceiveEnded, 0}}},
      {"NETR VB0, 0", "SMB30=2 VB6=1", {{Signal::NetworkStarted, 0}}},
      {"NETW VB0, 0; NETR VB40, 0", "SMB30=2 VB6=1 VB46=1", {{Signal::NetworkStarted, 0}, {Signal::NetworkStarted, 1}}},
      {"HDEF 0, 0; HSC 0", "SMB37=16#F8", {{Signal::HscLoaded, 0}}},
      {"HDEF 4, 0; HSC 4", "SMB147=16#F8", {{Signal::HscLoaded, 4}}},
      {"PLS 0", "SMB67=16#85 SMW68=100 SMD72=3", {{Signal::PulseCommand, 0}}},
      {"PLS 1", "SMB77=16#85 SMW78=100 SMD82=3", {{Signal::PulseCommand, 1}}},
      {"TODW VB0", "VB0=16#24 VB1=1 VB2=1 VB7=1", {{Signal::ClockSet, 8}}},
      {"TODWX VB0", "VB0=16#24 VB1=1 VB2=1 VB7=1", {{Signal::ClockSet, 19}}},
      {"WDR", "", {{Signal::WatchdogRestarted, 0}}},
      {"STOP", "", {{Signal::Stopped, 0}}},
      {"ATCH 3, 10", "", {{Signal::EventAttached, 10}}},
      {"DTCH 10", "", {{Signal::EventDetached, 10}}},
      {"CEVNT 12", "", {{Signal::EventsCleared, 12}}},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(signalsOf(c.statements, c.given), c.told) << c.statements;
    EXPECT_TRUE(signalsOf(c.statements, c.given, false).empty()) << c.statements;
  }
}

TEST(Effect, EnoIsOneAfterSuccess) {
  // 001:2276-2278.
  for (const char* statement :
       {"SI Q0.0, 1", "RI Q0.0, 1", "SPA 5, 0", "GPA VB0, 0", "ROUND VD0, VD4", "TRUNC VD0, VD4", "SCAT VB0, VB100",
        "BIR IB0, VB0", "BIW VB0, QB0", "CALL 1", "S Q0.0, 1", "R Q0.0, 1", "FOR VW0, 1, 2; NEXT", "DTR VD0, VD4"}) {
    Plant plant({{PouKind::Main, 0, std::string("LD SM0.0; ") + statement}, {PouKind::Subroutine, 1, "NOP 0"}});
    EXPECT_EQ(plant.scan().value("ENO[0]"), 1U) << statement;
    EXPECT_TRUE(plant.outside.hazards().empty()) << statement;
    EXPECT_EQ(plant.value("SM4.3"), 0U) << statement;
  }
}

TEST(Effect, TimersCountUpFromNegativeValues) {
  // The current value is a signed word that programs may write (001:1400); the preset is INT (001:6551).
  for (const char* box : {"TON T37", "TONR T5", "TON.IEC T38"}) {
    const std::string name(box);
    const auto number = static_cast<std::uint32_t>(std::atoi(name.c_str() + name.find(" T") + 2));
    const std::string value = "T.value[" + std::to_string(number) + "]";
    const std::string pins = name.find("IEC") != std::string::npos ? ", M0.0, MW2" : "";
    Plant plant("LD SM0.0; " + name + ", 2" + pins);
    plant.scan().set(value, 0xFFFD).scan(0, 1);
    EXPECT_EQ(plant.current(number), -2) << box;
    EXPECT_FALSE(plant.timerBit(number)) << box;
    plant.scan(0, 4);
    EXPECT_EQ(plant.current(number), 2) << box;
    EXPECT_TRUE(plant.timerBit(number)) << box;
    Plant below("LD SM0.0; " + name + ", -5" + pins);
    below.scan(0, 1);
    EXPECT_TRUE(below.timerBit(number)) << box << ": 0 is above -5";
  }
  Plant off("LD I0.0; TOF T37, 2");
  off.set("I0.0=1").scan().set("I0.0=0").scan().set("T.value[37]", 0xFFFD).scan(0, 1);
  EXPECT_EQ(off.current(37), -2);
  EXPECT_TRUE(off.timerBit(37));
  off.scan(0, 4);
  EXPECT_EQ(off.current(37), 2);
  EXPECT_FALSE(off.timerBit(37));
}

TEST(Effect, TimersTellTheMomentOfThePreset) {
  using Reached = std::vector<std::pair<std::uint32_t, bool>>;
  for (const char* box : {"TON T33, 2", "TONR T1, 2", "TON.IEC T33, 2, M0.0, MW2"}) {
    Plant plant(std::string("LD SM0.0; ") + box);
    plant.scan();
    const std::uint32_t number = std::string(box).find("T1,") != std::string::npos ? 1 : 33;
    EXPECT_EQ(plant.scan(1).reached, (Reached{{number, false}})) << box;
    EXPECT_EQ(plant.scan(1).reached, (Reached{{number, true}})) << box;
    EXPECT_EQ(plant.scan(1).reached, (Reached{{number, false}})) << box;
  }
  for (const char* box : {"TOF T33, 2", "TOF.IEC T33, 2, M0.0, MW2"}) {
    Plant plant(std::string("LD I0.0; ") + box);
    plant.set("I0.0=1").scan().set("I0.0=0").scan();
    EXPECT_EQ(plant.scan(1).reached, (Reached{{33, false}})) << box;
    EXPECT_EQ(plant.scan(1).reached, (Reached{{33, true}})) << box;
    EXPECT_EQ(plant.scan(1).reached, (Reached{{33, false}})) << box;
    EXPECT_FALSE(plant.timerBit(33)) << box;
  }
}

TEST(Effect, CountersCountFromNegativeValues) {
  const auto count = [](const char* statements, const char* start, int edges) {
    Plant plant(statements);
    plant.scan().set(start);
    for (int i = 0; i < edges; ++i) plant.set("I0.0=0").scan().set("I0.0=1").scan();
    return static_cast<std::int16_t>(plant.value("C.value[1]"));
  };
  EXPECT_EQ(count("LD I0.0; LD I0.1; CTU C1, 5", "C.value[1]=16#FFFB", 2), -3);
  EXPECT_EQ(count("LD I0.0; LD I0.1; LD I0.2; CTUD C1, 5", "C.value[1]=16#FFFB", 2), -3);
  EXPECT_EQ(count("LD I0.1; LD I0.0; LD I0.2; CTUD C1, 5", "C.value[1]=16#FFFB", 2), -7);
  EXPECT_EQ(count("LD I0.0; LD I0.1; CTD C1, 5", "C.value[1]=16#FFFB", 2), -5) << "stops at 0 and below";
}

}  // namespace rungproof::manual
