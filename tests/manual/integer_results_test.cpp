// Integer arithmetic (001:4786-4936).
#include <gtest/gtest.h>

#include "plant.hpp"

namespace rungproof::manual {
namespace {

struct Case {
  const char* op;
  std::int64_t in1, out;
  std::optional<std::int64_t> result;  ///< nothing: overflow
};

void expectCase(const Case& c, bool wide) {
  const std::string in = wide ? "VD0" : "VW0", out = wide ? "VD10" : "VW10";
  Bench bench({"LD SM0.0", std::string(c.op) + " " + in + ", " + out});
  const std::uint64_t mask = wide ? 0xFFFFFFFF : 0xFFFF;
  bench.set(in, c.in1);
  bench.set(out, c.out);
  bench.outside.values[{External::UnknownStatus, 0}] = 1;
  bench.set("SM1.1", c.result.has_value());
  bench.scan();
  const auto expected = static_cast<std::uint64_t>(c.result.value_or(c.out)) & mask;
  EXPECT_EQ(bench.value(out), expected) << c.op << " " << c.in1 << ", " << c.out;
  EXPECT_EQ(bench.value("SM1.1"), c.result ? 0U : 1U) << c.op << " " << c.in1 << ", " << c.out;
  EXPECT_EQ(bench.eno(), c.result.has_value());
  EXPECT_EQ(bench.met(Hazard::Overflow), !c.result);
  EXPECT_FALSE(bench.errorBit());
  EXPECT_EQ(bench.value("SM1.0"), c.result ? (*c.result == 0 ? 1U : 0U) : 1U)
      << "zero, or the unknown value after an overflow";
  EXPECT_EQ(bench.value("SM1.2"), c.result && *c.result < 0 ? 1U : 0U);
  bench.set("SMB0", 0);  // without power flow nothing happens
  bench.set(out, c.out);
  EXPECT_EQ(bench.scan().value(out), static_cast<std::uint64_t>(c.out) & mask);
}

TEST(Integer, WordsStayInTheirRange) {
  for (const Case& c : std::vector<Case>{{"+I", 40, 60, 100},
                                         {"+I", -40, 40, 0},
                                         {"+I", 1, 32767, std::nullopt},
                                         {"+I", -1, -32768, std::nullopt},
                                         {"+I", -10, -20, -30},
                                         {"-I", 40, 60, 20},
                                         {"-I", 60, 40, -20},
                                         {"-I", 5, 5, 0},
                                         {"-I", 1, -32768, std::nullopt},
                                         {"-I", -1, 32767, std::nullopt},
                                         {"*I", 40, 60, 2400},
                                         {"*I", -3, 7, -21},
                                         {"*I", 0, 7, 0},
                                         {"*I", 256, 128, std::nullopt},
                                         {"*I", -128, 256, -32768},
                                         {"*I", -1, -32768, std::nullopt},
                                         {"/I", 40, 4000, 100},
                                         {"/I", 7, -22, -3},
                                         {"/I", 7, 6, 0},
                                         {"/I", -1, -32768, std::nullopt},
                                         {"/I", -2, -32768, 16384}}) {
    expectCase(c, false);
  }
}

TEST(Integer, DoubleWordsStayInTheirRange) {
  for (const Case& c : std::vector<Case>{{"+D", 400000, 600000, 1000000},
                                         {"+D", 1, 2147483647, std::nullopt},
                                         {"+D", -5, 5, 0},
                                         {"+D", -1, -2147483648LL, std::nullopt},
                                         {"+D", -70000, -1, -70001},
                                         {"-D", 400000, 600000, 200000},
                                         {"-D", 1, -2147483648LL, std::nullopt},
                                         {"-D", 9, 9, 0},
                                         {"-D", 70001, 70000, -1},
                                         {"*D", 1000, 3000, 3000000},
                                         {"*D", 65536, 32768, std::nullopt},
                                         {"*D", -65536, 32768, -2147483648LL},
                                         {"*D", 5, 0, 0},
                                         {"/D", 41, 400000, 9756},
                                         {"/D", -1, -2147483648LL, std::nullopt},
                                         {"/D", 3, -7, -2},
                                         {"/D", 3, 2, 0}}) {
    expectCase(c, true);
  }
}

TEST(Integer, DivisionByZeroLeavesEverythingElse) {
  for (const auto& [line, out] : std::vector<std::pair<std::string, std::string>>{
           {"/I VW0, VW10", "VW10"}, {"/D VD0, VD10", "VD10"}, {"DIV VW0, VD10", "VD10"}}) {
    Bench bench({"LD SM0.0", line});
    bench.set(out, 1234);
    bench.set("SMB1", 0b0111);
    bench.scan();
    EXPECT_EQ(bench.value(out), 1234U) << line;
    EXPECT_EQ(bench.value("SMB1"), 0b1111U) << "SM1.3 comes on, the others keep their values (001:4814)";
    EXPECT_FALSE(bench.eno());
    EXPECT_EQ(bench.outside.hazards(), std::vector<Hazard>{Hazard::DivideByZero});
    bench.set("VD0", 0x00010001);
    bench.scan();
    EXPECT_EQ(bench.value("SM1.3"), 0U) << "a division that works clears it";
    EXPECT_EQ(bench.value("SM1.1"), 0U);
    EXPECT_TRUE(bench.eno());
  }
}

TEST(Integer, WideExamplesOfTheManual) {
  // 001:4920-4936: 400 * 200 = 80000 in VD100 with the factor in VW102; 4000 / 41 = 97 remainder 23.
  Bench bench({"LD I0.0", "MUL AC1, VD100", "DIV VW10, VD200"});
  bench.set("AC1", 400);
  bench.set("VW100", 0x7777);
  bench.set("VW102", 200);
  bench.set("VW10", 41);
  bench.set("VW200", 0x7777);
  bench.set("VW202", 4000);
  bench.scan();
  EXPECT_EQ(bench.value("VW102"), 200U) << "no power flow";
  bench.set("I0.0", 1);
  bench.scan();
  EXPECT_EQ(bench.value("VD100"), 80000U);
  EXPECT_EQ(bench.value("VW200"), 23U);
  EXPECT_EQ(bench.value("VW202"), 97U);
  EXPECT_TRUE(bench.eno());
}

TEST(Integer, WideMultiplyFlags) {
  for (const auto& [a, b, product] : std::vector<std::tuple<int, int, std::int64_t>>{
           {-400, 200, -80000}, {0, 5, 0}, {-32768, -32768, 1073741824}, {3, 4, 12}}) {
    Bench bench({"LD SM0.0", "MUL VW0, VD10"});
    bench.set("VW0", a);
    bench.set("VW12", b);
    bench.set("SMB1", 0b1111);
    bench.scan();
    EXPECT_EQ(static_cast<std::int32_t>(bench.value("VD10")), product);
    EXPECT_EQ(bench.value("SM1.0"), product == 0 ? 1U : 0U);
    EXPECT_EQ(bench.value("SM1.1"), 0U);
    EXPECT_EQ(bench.value("SM1.2"), product < 0 ? 1U : 0U);
    EXPECT_EQ(bench.value("SM1.3"), 0U);
  }
}

TEST(Integer, WideDivideFlagsFollowTheChoice) {
  // 3 / 41: quotient 0, remainder 3; -4000 / 41: quotient -97, remainder -23; 4000 / -41: -97, remainder 23.
  for (const auto& [dividend, divisor, quotient, remainder] : std::vector<std::tuple<int, int, int, int>>{
           {3, 41, 0, 3}, {-4000, 41, -97, -23}, {4000, -41, -97, 23}, {0, 5, 0, 0}}) {
    for (const bool ofQuotient : {false, true}) {
      Bench bench({"LD SM0.0", "DIV VW0, VD10"});
      ASSERT_TRUE(bench.choices.set("div-flags", ofQuotient ? "quotient" : "double-word"));
      bench.set("VW0", divisor);
      bench.set("VW12", dividend);
      bench.set("SM1.1", 1);
      bench.scan();
      EXPECT_EQ(static_cast<std::int16_t>(bench.value("VW10")), remainder) << dividend;
      EXPECT_EQ(static_cast<std::int16_t>(bench.value("VW12")), quotient) << dividend;
      EXPECT_EQ(bench.value("SM1.0"), (ofQuotient ? quotient == 0 : quotient == 0 && remainder == 0) ? 1U : 0U)
          << dividend;
      EXPECT_EQ(bench.value("SM1.2"), (ofQuotient ? quotient < 0 : remainder < 0) ? 1U : 0U) << dividend;
      EXPECT_EQ(bench.value("SM1.1"), 0U);
      EXPECT_TRUE(bench.eno());
    }
  }
  Bench overflow({"LD SM0.0", "DIV VW0, VD10"});
  overflow.set("VW0", -1);
  overflow.set("VD10", 0x12348000);
  overflow.scan();
  EXPECT_EQ(overflow.value("SM1.1"), 1U);
  EXPECT_EQ(overflow.value("VD10"), 0x12348000U);
  EXPECT_FALSE(overflow.eno());
}

}  // namespace
}  // namespace rungproof::manual
