// Compare contacts: signedness, relations, joints, fatal errors.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "ir/s7200/cpu.hpp"
#include "plant.hpp"

namespace rungproof::manual {
namespace {

struct Relation {
  const char* symbol;
  std::function<bool(double, double)> holds;
};
const std::vector<Relation>& relations() {
  static const std::vector<Relation> list = {
      {"<", [](double a, double b) { return a < b; }},  {"<=", [](double a, double b) { return a <= b; }},
      {"=", [](double a, double b) { return a == b; }}, {">=", [](double a, double b) { return a >= b; }},
      {">", [](double a, double b) { return a > b; }},  {"<>", [](double a, double b) { return a != b; }},
  };
  return list;
}

/// Stack of three known levels after `mnemonic IN1, IN2` where the relation holds or not.
void expectJoint(const std::string& letter, const std::string& symbol, const std::string& operands, bool holds,
                 const std::function<void(Bench&)>& fill) {
  for (const bool top : {false, true}) {
    const std::array<bool, 9> start{top, true, false};
    const auto stackAfter = [&](const std::string& prefix) {
      Bench bench({prefix + letter + symbol + " " + operands});
      fill(bench);
      bench.scanWithStack(start);
      EXPECT_TRUE(bench.quiet()) << prefix << letter << symbol;
      return bench.stack;
    };
    EXPECT_EQ(stackAfter("LD"), (std::array<bool, 9>{holds, top, true, false})) << letter << symbol;
    EXPECT_EQ(stackAfter("A"), (std::array<bool, 9>{top && holds, true, false})) << letter << symbol;
    EXPECT_EQ(stackAfter("O"), (std::array<bool, 9>{top || holds, true, false})) << letter << symbol;
  }
}

TEST(Compare, BytesAreUnsigned) {
  for (const auto& [a, b] : std::vector<std::pair<int, int>>{{0x80, 0x7F}, {0x7F, 0x80}, {5, 5}, {0, 255}, {255, 0}}) {
    for (const Relation& r : relations()) {
      expectJoint("B", r.symbol, "VB0, VB1", r.holds(a, b), [&](Bench& bench) {
        bench.set("VB0", a);
        bench.set("VB1", b);
      });
    }
  }
}

TEST(Compare, WordsAreSigned) {
  for (const auto& [a, b] :
       std::vector<std::pair<int, int>>{{-1, 1}, {1, -1}, {-32768, 32767}, {32767, -32768}, {-5, -5}, {256, 255}}) {
    for (const Relation& r : relations()) {
      expectJoint("W", r.symbol, "VW0, VW2", r.holds(a, b), [&](Bench& bench) {
        bench.set("VW0", a);
        bench.set("VW2", b);
      });
    }
  }
}

TEST(Compare, DoubleWordsAreSigned) {
  for (const auto& [a, b] : std::vector<std::pair<double, double>>{
           {-1, 1}, {2147483647.0, -2147483648.0}, {65536, 65535}, {-7, -7}, {-70000, -69999}}) {
    for (const Relation& r : relations()) {
      expectJoint("D", r.symbol, "VD0, VD4", r.holds(a, b), [&](Bench& bench) {
        bench.set("VD0", static_cast<std::int64_t>(a));
        bench.set("VD4", static_cast<std::int64_t>(b));
      });
    }
  }
}

TEST(Compare, RealsAreSigned) {
  for (const auto& [a, b] : std::vector<std::pair<float, float>>{
           {-1.5F, 1.5F}, {1.5F, -1.5F}, {0.0F, -0.0F}, {-2.5F, -2.25F}, {1e30F, 1e-30F}}) {
    for (const Relation& r : relations()) {
      expectJoint("R", r.symbol, "VD0, VD4", r.holds(a, b), [&](Bench& bench) {
        bench.setReal("VD0", a);
        bench.setReal("VD4", b);
      });
    }
  }
}

TEST(Compare, StringsByLengthAndBytes) {
  for (const auto& [a, b] :
       std::vector<std::pair<std::string, std::string>>{{"ABC", "ABC"},
                                                        {"ABC", "ABD"},
                                                        {"ABC", "AB"},
                                                        {"AB", "ABC"},
                                                        {"", ""},
                                                        {"abc", "ABC"},
                                                        {std::string(254, 'x'), std::string(254, 'x')}}) {
    for (const char* symbol : {"=", "<>"}) {
      const bool holds = (a == b) == (symbol[0] == '=');
      expectJoint("S", symbol, "VB0, VB300", holds, [&](Bench& bench) {
        bench.setString(0, a);
        bench.setString(300, b);
      });
    }
  }
  Bench constant({"LDS= \"OK\", VB0", "= Q0.0"});
  constant.setString(0, "OK");
  EXPECT_EQ(constant.scan().value("Q0.0"), 1U);
  constant.setString(0, "OX");
  EXPECT_EQ(constant.scan().value("Q0.0"), 0U);
}

TEST(Compare, ExamplesOfTheManual) {
  // 000:2183-2223: potentiometer, and network 4 with the small and the large values.
  Bench pot({"LD I0.0", "LPS", "AB<= SMB28, 50", "= Q0.0", "LPP", "AB>= SMB28, 150", "= Q0.1"});
  pot.set("I0.0", 1);
  for (const auto& [value, outputs] :
       std::vector<std::pair<int, unsigned>>{{0, 1}, {50, 1}, {51, 0}, {149, 0}, {150, 2}, {255, 2}}) {
    pot.set("SMB28", value);
    EXPECT_EQ(pot.scan().value("QB0"), outputs) << value;
  }
  Bench numbers({"LD I0.3", "LPS", "AW> VW0, +10000", "= Q0.2", "LRD", "AD< -150000000, VD2", "= Q0.3", "LPP",
                 "AR> VD6, 5.001E-006", "= Q0.4"});
  numbers.set("I0.3", 1);
  numbers.set("VW0", -30000);
  numbers.set("VD2", -200000000);
  numbers.setReal("VD6", 1.012E-006F);
  EXPECT_EQ(numbers.scan().value("QB0"), 0U);
  numbers.set("VW0", 30000);
  numbers.set("VD2", -100000000);
  numbers.setReal("VD6", 3.141593F);
  EXPECT_EQ(numbers.scan().value("QB0"), 0b11100U);
}

TEST(Compare, OtherOperands) {
  Bench bench({"LDW= T5, C6", "= Q0.0", "LDD= HC0, 16#FFFFFFFF", "= Q0.1", "LDB= AC0, 16#34", "= Q0.2", "LDW= AIW4, 77",
               "= Q0.3"});
  bench.store.set(Reg::TimerCurrent, 5, 9, true);
  bench.store.set(Reg::CounterCurrent, 6, 9, true);
  bench.store.set(Reg::HscCurrent, 0, 0xFFFFFFFF, true);
  bench.set("AC0", 0x1234);
  bench.outside.values[{External::AnalogInput, 4}] = 77;
  EXPECT_EQ(bench.scan().value("QB0"), 0b1111U);
}

TEST(Compare, BadPointerStopsTheCpuEvenWithoutPowerFlow) {
  for (const char* line :
       {"AB= *VD0, 1", "AW> *VD0, 1", "OD< 1, *VD0", "AR= *VD0, 1.0", "LDB= *VD0, 1", "AS= *VD0, VB100"}) {
    Bench bench({"LD I0.0", line, "LD SM0.0", "= Q0.0"});
    bench.set("VD0", 0xFF000000);
    bench.scan();
    EXPECT_TRUE(bench.met(Hazard::FatalIndirectAddress)) << line;
    EXPECT_TRUE(bench.halted);
    EXPECT_EQ(bench.value("Q0.0"), 0U) << "nothing runs after it";
    bench.set("VD0", pointer::encode(Area::V, 40));
    bench.scan();
    EXPECT_TRUE(bench.quiet()) << line;
    EXPECT_EQ(bench.value("Q0.0"), 1U);
  }
}

TEST(Compare, IllegalRealStopsTheCpuEvenWithoutPowerFlow) {
  for (const float illegal :
       {std::nanf(""), std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
    for (const char* line : {"AR> VD0, VD4", "AR> VD4, VD0", "OR<> VD0, 1.0", "LDR= VD0, VD0"}) {
      Bench bench({"LD I0.0", line, "LD SM0.0", "= Q0.0"});
      bench.setReal("VD0", illegal);
      bench.scan();
      EXPECT_TRUE(bench.met(Hazard::FatalReal)) << line;
      EXPECT_TRUE(bench.halted);
      EXPECT_EQ(bench.value("Q0.0"), 0U);
    }
  }
}

TEST(Compare, OneIllegalRealIsEnough) {
  for (const char* letter : {"LD", "A", "O"}) {
    for (const Relation& relation : relations()) {
      for (const char* operands : {" VD0, VD4", " VD4, VD0"}) {
        const std::string line = std::string(letter) + "R" + relation.symbol + operands;
        Bench bench({"LD I0.0", line, "LD SM0.0", "= Q0.0"});
        bench.setReal("VD0", std::nanf(""));
        bench.setReal("VD4", 1.0F);
        bench.scan();
        EXPECT_EQ(bench.outside.hazards(), std::vector<Hazard>{Hazard::FatalReal}) << line;
        EXPECT_EQ(bench.value("Q0.0"), 0U) << "the program has ended";
      }
    }
  }
}

TEST(Compare, StringsDifferInAnyPlace) {
  struct Pair {
    const char *left, *right;
    bool equal;
  };
  for (const Pair& pair : std::vector<Pair>{{"", "", true},
                                            {"A", "A", true},
                                            {"A", "", false},
                                            {"", "A", false},
                                            {"AB", "A", false},
                                            {"A", "AB", false},
                                            {"B", "A", false},
                                            {"A", "B", false},
                                            {"ABCDEFGH", "ABCDEFGH", true},
                                            {"XBCDEFGH", "ABCDEFGH", false},
                                            {"ABXDEFGH", "ABCDEFGH", false},
                                            {"ABCDXFGH", "ABCDEFGH", false},
                                            {"ABCDEFXH", "ABCDEFGH", false},
                                            {"ABCDEFGX", "ABCDEFGH", false}}) {
    for (const auto& [symbol, holds] :
         std::vector<std::pair<std::string, bool>>{{"=", pair.equal}, {"<>", !pair.equal}}) {
      expectJoint("S", symbol, "VB0, VB300", holds, [&](Bench& bench) {
        bench.setString(0, pair.left);
        bench.setString(300, pair.right);
      });
    }
  }
}

TEST(Compare, StringsEndWithTheirLength) {
  // What lies in memory behind the shorter string continues the longer one: the lengths alone tell them apart.
  for (const char* operands : {"VB0, VB300", "VB300, VB0"}) {
    for (const auto& [symbol, holds] : std::vector<std::pair<std::string, bool>>{{"=", false}, {"<>", true}}) {
      expectJoint("S", symbol, operands, holds, [&](Bench& bench) {
        bench.setString(0, "AB");
        bench.setString(300, "A");
        bench.setText(302, "B");
      });
    }
  }
}

TEST(Compare, EitherStringOutsideItsAreaStopsTheCpu) {
  for (const char* mnemonic : {"LDS=", "LDS<>", "AS=", "AS<>", "OS=", "OS<>"}) {
    for (const char* operands : {" VB10238, VB0", " VB0, VB10238"}) {
      for (const int length : {1, 2}) {
        Bench bench({"LD I0.0", std::string(mnemonic) + operands, "LD SM0.0", "= Q0.0"});
        bench.set("VB10238", length);
        EXPECT_EQ(bench.scan().met(Hazard::FatalRange), length == 2) << mnemonic << operands;
        EXPECT_EQ(bench.value("Q0.0"), length == 2 ? 0U : 1U) << "ends the program";
      }
    }
    for (const char* operands : {" VB300, VB0", " VB0, VB300"}) {
      for (const int length : {254, 255}) {
        Bench bench({"LD I0.0", std::string(mnemonic) + operands});
        bench.set("VB300", length);
        EXPECT_EQ(bench.scan().met(Hazard::FatalRange), length == 255) << mnemonic << operands;
      }
    }
  }
}

TEST(Compare, StringOutsideItsAreaStopsTheCpu) {
  // V of a CPU 222 ends at VB2047. A length byte of 255 is illegal as well.
  const Target cpu222{s7200Cpu("222"), Edition::Edition2004};
  for (const auto& [length, fatal] : std::vector<std::pair<int, bool>>{{3, false}, {4, true}, {255, true}}) {
    for (const char* line : {"LDS= VB2044, VB0", "LDS<> VB0, VB2044"}) {
      Bench bench({line}, cpu222);
      bench.set("VB2044", length);
      EXPECT_EQ(bench.scan().met(Hazard::FatalRange), fatal) << length << line;
      EXPECT_EQ(bench.halted, fatal);
    }
  }
  Bench limit({"LDS= VB0, VB300", "= Q0.0"});
  limit.set("VB0", 255);
  limit.set("VB300", 255);
  EXPECT_TRUE(limit.scan().met(Hazard::FatalRange));
  EXPECT_EQ(limit.value("Q0.0"), 0U);
}

}  // namespace
}  // namespace rungproof::manual
