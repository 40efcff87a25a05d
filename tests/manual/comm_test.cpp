// Communication: XMT, RCV, NETR, NETW, GPA, SPA.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "plant.hpp"

namespace rungproof::manual {
namespace {

/// Special memory of a port (001:14169-14179, 001:3217-3233).
struct Port {
  int number;
  std::string mode, status, control, maximum, idle;
  Hazard clash;
};
const std::vector<Port> ports = {{0, "SMB30", "SMB86", "SMB87", "SMB94", "SM4.5", Hazard::SimultaneousPort0},
                                 {1, "SMB130", "SMB186", "SMB187", "SMB194", "SM4.6", Hazard::SimultaneousPort1}};

Bench on(const Port& port, const std::string& line, int mode) {
  Bench bench({"LD I5.0", line + ", " + std::to_string(port.number)});
  bench.set("I5.0", 1);
  bench.set(port.mode, mode);
  bench.set(port.idle, 1);
  bench.set(port.status, 0x20);
  bench.set(port.control, 0xC0);  // enabled, start character
  bench.set(port.maximum, 10);
  bench.set("VB100", 4);
  return bench;
}
std::uint32_t index(const Port& port) { return static_cast<std::uint32_t>(port.number); }

TEST(Freeport, TransmitStarts) {
  for (const Port& port : ports) {
    Bench bench = on(port, "XMT VB100", 0x09);  // 9600 baud, Freeport
    bench.set("I5.0", 0);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::PortBusy, index(port)), 0U) << "no power flow";
    bench.set("I5.0", 1);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::PortBusy, index(port)), 1U);
    EXPECT_EQ(bench.reg(Reg::PortBusy, 1 - index(port)), 0U);
    EXPECT_EQ(bench.value(port.idle), 0U);
    EXPECT_EQ(bench.reg(Reg::PortTable, 2 * index(port)), pointer::encode(Area::V, 100));
    EXPECT_TRUE(bench.eno());
    EXPECT_TRUE(bench.quiet());
  }
}

TEST(Freeport, ModeMustBeFreeport) {
  for (const Port& port : ports) {
    for (int mode = 0; mode < 4; ++mode) {
      for (const char* line : {"XMT VB100", "RCV VB100"}) {
        Bench bench = on(port, line, mode);
        bench.scan();
        EXPECT_EQ(bench.met(Hazard::PortMode), mode != 1) << line << mode;
        EXPECT_EQ(bench.reg(Reg::PortBusy, index(port)), mode != 1 ? 0U : line[0] == 'X' ? 1U : 2U);
        EXPECT_EQ(bench.eno(), mode == 1);
        EXPECT_FALSE(bench.errorBit());
      }
    }
  }
}

TEST(Freeport, OneDirectionAtATime) {
  for (const Port& port : ports) {
    for (const char* line : {"XMT VB100", "RCV VB100"}) {
      const bool transmits = line[0] == 'X';
      for (const unsigned state : {1U, 2U}) {
        for (const bool error : {false, true}) {
          Bench bench = on(port, line, 1);
          ASSERT_TRUE(bench.choices.set("port-again", error ? "error" : "ignored"));
          bench.store.set(Reg::PortBusy, index(port), state, true);
          bench.scan();
          const bool same = (state == 1) == transmits;
          EXPECT_EQ(bench.outside.hazards(), same && !error ? std::vector<Hazard>{} : std::vector<Hazard>{port.clash})
              << line << state;
          EXPECT_EQ(bench.reg(Reg::PortBusy, index(port)), state);
          EXPECT_EQ(bench.value(port.idle), 1U) << "nothing was started";
          EXPECT_EQ(bench.value(port.status), 0x20U);
        }
      }
    }
  }
}

TEST(Freeport, ReceiveStarts) {
  for (const Port& port : ports) {
    Bench bench = on(port, "RCV VB100", 1);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::PortBusy, index(port)), 2U);
    EXPECT_EQ(bench.value(port.status), 0U) << "0 while a reception runs (001:3207)";
    EXPECT_EQ(bench.reg(Reg::PortTable, 2 * index(port) + 1), pointer::encode(Area::V, 100));
    EXPECT_EQ(bench.value(port.idle), 1U);
    EXPECT_TRUE(bench.eno());
  }
}

TEST(Freeport, ReceiveNeedsStartAndEnd) {
  // il bit 4, sc bit 6, bk bit 1 are start conditions (001:3223); the maximum count must be set (001:3233).
  for (const Port& port : ports) {
    for (unsigned control = 0x80; control < 0x100; ++control) {
      for (const int maximum : {0, 1, 255}) {
        Bench bench = on(port, "RCV VB100", 1);
        bench.set(port.control, control);
        bench.set(port.maximum, maximum);
        bench.scan();
        const bool works = (control & 0b01010010U) != 0 && maximum != 0;
        EXPECT_EQ(bench.met(Hazard::PortParameter), !works) << control << " " << maximum;
        EXPECT_EQ(bench.value(port.status), works ? 0U : 0x40U);
        EXPECT_EQ(bench.eno(), works);
        EXPECT_EQ(bench.reg(Reg::PortBusy, index(port)), works ? 2U : 0U);
      }
    }
  }
}

TEST(Freeport, ReceiveWithTheEnableBitOffEndsIt) {
  for (const Port& port : ports) {
    Bench bench = on(port, "RCV VB100", 1);
    bench.scan();
    bench.set(port.control, 0x40);
    bench.scan();
    EXPECT_EQ(bench.reg(Reg::PortBusy, index(port)), 0U);
    EXPECT_EQ(bench.value(port.status), 0x80U) << "ended by the user";
    bench.set(port.status, 0x20);
    bench.scan();
    EXPECT_EQ(bench.value(port.status), 0x20U) << "nothing runs";
    EXPECT_TRUE(bench.quiet());
  }
}

TEST(Freeport, BuffersMustFit) {
  // From VB10239 - 4: five bytes, the count and four characters.
  for (const auto& [line, count, fits] : std::vector<std::tuple<const char*, int, bool>>{{"XMT VB10235, 0", 4, true},
                                                                                         {"XMT VB10235, 0", 5, false},
                                                                                         {"RCV VB10235, 0", 4, true},
                                                                                         {"RCV VB10235, 0", 5, false},
                                                                                         {"XMT VB10239, 0", 0, true}}) {
    Bench bench({"LD SM0.0", line});
    bench.set("SMB30", 1);
    bench.set("SMB87", 0xC0);
    bench.set("SMB94", count);
    if (line[0] == 'X') bench.store.area(Area::V)[count == 0 ? 10239 : 10235] = static_cast<std::uint8_t>(count);
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::OutOfRange), !fits) << line << count;
    EXPECT_EQ(bench.reg(Reg::PortBusy, 0) != 0, fits);
  }
}

TEST(Port, OneOnlyOnLargeCpus) {
  for (const Cpu cpu :
       {s7200Cpu("221"), s7200Cpu("222"), s7200Cpu("224"), s7200Cpu("224XP"), s7200Cpu("226"), s7200Cpu("226XM")}) {
    const bool two = cpu == s7200Cpu("224XP") || cpu == s7200Cpu("226") || cpu == s7200Cpu("226XM");
    for (const char* line : {"XMT VB0, 1", "RCV VB0, 1", "NETR VB0, 1", "NETW VB0, 1", "GPA VB0, 1", "SPA 5, 1"}) {
      Bench bench({"LD SM0.0", line}, {cpu, Edition::Edition2004});
      EXPECT_EQ(bench.scan().met(Hazard::OutOfRange), !two) << line;
    }
  }
}

Bench network(const std::string& op, int length, int mode = 2) {
  Bench bench({"LD I5.0", op + " VB200, 0"});
  bench.set("I5.0", 1);
  bench.set("SMB30", mode);
  bench.set("VB200", 0x8F);
  bench.set("VB206", length);
  return bench;
}

TEST(Network, RequestBecomesActive) {
  for (const char* op : {"NETR", "NETW"}) {
    for (const int length : {1, 16}) {
      Bench bench = network(op, length);
      bench.set("I5.0", 0);
      EXPECT_EQ(bench.scan().value("VB200"), 0x8FU) << "no power flow";
      bench.set("I5.0", 1);
      bench.scan();
      EXPECT_EQ(bench.value("VB200"), 0x40U) << "A = 1, D = E = 0";
      EXPECT_EQ(bench.reg(Reg::NetActive), 1U);
      EXPECT_EQ(bench.reg(Reg::NetTable, 0), pointer::encode(Area::V, 200));
      EXPECT_EQ(bench.reg(Reg::NetIsWrite, 0), op[3] == 'W' ? 1U : 0U);
      EXPECT_TRUE(bench.eno());
      EXPECT_TRUE(bench.quiet());
    }
  }
}

TEST(Network, RefusedRequests) {
  // 001:3052-3065: 5 no PPI master, 6 illegal parameter, 4 queue overflow.
  struct Row {
    int length, mode, active;
    unsigned status;
  };
  for (const char* op : {"NETR", "NETW"}) {
    for (const Row& row : std::vector<Row>{{4, 0, 0, 0x25},
                                           {4, 1, 0, 0x25},
                                           {4, 3, 0, 0x25},
                                           {0, 2, 0, 0x26},
                                           {17, 2, 0, 0x26},
                                           {255, 2, 0, 0x26},
                                           {4, 2, 8, 0x24}}) {
      Bench bench = network(op, row.length, row.mode);
      bench.store.set(Reg::NetActive, 0, static_cast<unsigned>(row.active), true);
      bench.scan();
      EXPECT_EQ(bench.value("VB200"), row.status) << op << row.length << row.mode;
      EXPECT_TRUE(bench.met(Hazard::PortParameter));
      EXPECT_FALSE(bench.eno());
      EXPECT_FALSE(bench.errorBit());
      EXPECT_EQ(bench.reg(Reg::NetActive), static_cast<unsigned>(row.active));
      EXPECT_EQ(bench.reg(Reg::NetTable, 0), 0U);
    }
  }
}

TEST(Network, EightAtATime) {
  std::vector<std::string> lines = {"LD SM0.0"};
  for (int i = 0; i < 9; ++i)
    lines.push_back((i % 2 == 0 ? "NETR VB" : "NETW VB") + std::to_string(100 + 30 * i) + ", 0");
  Bench bench(lines);
  bench.set("SMB30", 2);
  for (int i = 0; i < 9; ++i) bench.set("VB" + std::to_string(106 + 30 * i), 2);
  bench.store.set(Reg::NetTable, 3, 0, true);
  bench.scan();
  for (std::uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(bench.value("VB" + std::to_string(100 + 30 * i)), 0x40U) << i;
    EXPECT_EQ(bench.reg(Reg::NetTable, i), pointer::encode(Area::V, 100 + 30 * i));
    EXPECT_EQ(bench.reg(Reg::NetIsWrite, i), i % 2);
  }
  EXPECT_EQ(bench.value("VB340"), 0x24U) << "the ninth: queue overflow";
  EXPECT_EQ(bench.outside.hazards(), std::vector<Hazard>{Hazard::PortParameter});
  EXPECT_EQ(bench.reg(Reg::NetActive), 8U);
}

TEST(Network, ActiveTableFollowsTheChoice) {
  for (const bool queues : {false, true}) {
    Bench bench = network("NETR", 4);
    ASSERT_TRUE(bench.choices.set("network-again", queues ? "queued" : "ignored"));
    bench.scan().scan();
    EXPECT_EQ(bench.reg(Reg::NetActive), queues ? 2U : 1U);
    EXPECT_EQ(bench.reg(Reg::NetTable, 1), queues ? pointer::encode(Area::V, 200) : 0U);
    EXPECT_EQ(bench.value("VB200"), 0x40U);
    EXPECT_TRUE(bench.quiet());
  }
}

TEST(Network, TableMustFit) {
  for (const auto& [length, fits] : std::vector<std::pair<int, bool>>{{3, true}, {4, false}}) {
    Bench bench({"LD SM0.0", "NETR VB10230, 0"});  // ten bytes are left
    bench.set("SMB30", 2);
    bench.set("VB10236", length);
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::OutOfRange), !fits);
    EXPECT_EQ(bench.value("VB10230"), fits ? 0x40U : 0U);
  }
}

TEST(PortAddress, GetAndSet) {
  for (const Port& port : ports) {
    const std::string number = std::to_string(port.number);
    Bench bench({"LD I5.0", "SPA VB10, " + number, "LD SM0.0", "GPA VB0, " + number});
    bench.outside.values[{External::StationAddress, index(port)}] = 2;
    bench.set("VB10", 126);
    EXPECT_EQ(bench.scan().value("VB0"), 2U) << "that of the system block";
    bench.set("I5.0", 1);
    EXPECT_EQ(bench.scan().value("VB0"), 126U);
    EXPECT_TRUE(bench.eno());
    bench.set("VB10", 0);
    EXPECT_EQ(bench.scan().value("VB0"), 0U);
    EXPECT_EQ(bench.reg(Reg::StationAddress, 1 - index(port)), 0U);
  }
  Bench off({"LD I5.0", "GPA VB0, 0"});
  off.set("VB0", 99);
  EXPECT_EQ(off.scan().value("VB0"), 99U);
}

TEST(PortAddress, NotSetInInterruptRoutines) {
  Bench bench({"LD SM0.0"}, {}, {"SPA 5, 0", "GPA VB0, 0"});
  bench.outside.values[{External::StationAddress, 0}] = 2;
  bench.interrupt();
  EXPECT_EQ(bench.outside.hazards(), std::vector<Hazard>{Hazard::NotInInterrupt});
  EXPECT_EQ(bench.value("VB0"), 2U);
}

}  // namespace
}  // namespace rungproof::manual
