// Strings: ITS, DTS, RTS, STI, STD, STR.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "plant.hpp"

namespace rungproof::manual {
namespace {

TEST(NumberToString, WritesLengthAndCharacters) {
  Bench bench({"LD I0.0", "ITS VW0, 16#0B, VB100", "DTS VD4, 4, VB120", "RTS VD8, 16#61, VB140"});
  bench.set("VW0", 12345);
  bench.set("VD4", -12);
  bench.setReal("VD8", -3.67526F);
  bench.set("VB109", 0xEE);
  bench.set("VB133", 0xEE);
  bench.set("VB147", 0xEE);
  EXPECT_EQ(bench.scan().value("VB100"), 0U) << "no power flow";
  bench.set("I0.0", 1);
  bench.scan();
  EXPECT_EQ(bench.value("VB100"), 8U);
  EXPECT_EQ(bench.text(101, 8), "  12,345");
  EXPECT_EQ(bench.value("VB120"), 12U);
  EXPECT_EQ(bench.text(121, 12), "     -0.0012");
  EXPECT_EQ(bench.value("VB140"), 6U);
  EXPECT_EQ(bench.text(141, 6), "  -3.7");
  for (const char* behind : {"VB109", "VB133", "VB147"}) EXPECT_EQ(bench.value(behind), 0xEEU) << behind;
  EXPECT_TRUE(bench.eno());
}

TEST(NumberToString, BadFormats) {
  Bench bench({"LD SM0.0", "ITS 1, 6, VB100", "DTS 1, 7, VB120", "RTS 1.0, 16#87, VB140", "RTS 1000.0, 16#30, VB160",
               "RTS 1.0, 16#20, VB180"});
  bench.scan();
  EXPECT_EQ(bench.outside.hazards(), std::vector<Hazard>(5, Hazard::BadFormat));
  EXPECT_EQ(bench.value("VB100"), 8U);
  EXPECT_EQ(bench.text(101, 8), std::string(8, ' '));
  EXPECT_EQ(bench.value("VB120"), 12U);
  EXPECT_EQ(bench.text(121, 12), std::string(12, ' '));
  EXPECT_EQ(bench.value("VB140"), 8U);
  EXPECT_EQ(bench.text(141, 8), std::string(8, ' '));
  EXPECT_EQ(bench.value("VB160"), 3U);
  EXPECT_EQ(bench.text(161, 3), "   ");
  EXPECT_EQ(bench.value("VB180"), 0U) << "ssss < 3 writes nothing";
  EXPECT_FALSE(bench.eno());
}

TEST(NumberToString, MustFit) {
  const Target cpu222{s7200Cpu("222"), Edition::Edition2004};
  for (const auto& [line, room, fits] :
       std::vector<std::tuple<std::string, int, bool>>{{"ITS 1, 0, *AC1", 9, true},
                                                       {"ITS 1, 0, *AC1", 8, false},
                                                       {"DTS 1, 0, *AC1", 13, true},
                                                       {"DTS 1, 0, *AC1", 12, false},
                                                       {"RTS 1.0, 16#50, *AC1", 6, true},
                                                       {"RTS 1.0, 16#50, *AC1", 5, false}}) {
    Bench bench({"LD SM0.0", line}, cpu222);
    bench.set("AC1", pointer::encode(Area::V, static_cast<std::uint32_t>(2048 - room)));
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::OutOfRange), !fits) << line << room;
    EXPECT_EQ(bench.value("VB2047"), fits ? '1' : 0U);
    EXPECT_EQ(bench.eno(), fits);
  }
}

struct Read {
  const char* text;
  bool works;
  double number;
};

template <class Get>
void expectReads(const std::string& op, const std::string& out, const std::vector<Read>& reads, Get get) {
  for (const Read& r : reads) {
    Bench bench({"LD SM0.0", op + " VB0, 1, " + out});
    bench.setString(0, r.text);
    bench.set("VD200", 0x4D4D4D4D);
    bench.set("SM1.1", r.works);
    bench.scan();
    EXPECT_EQ(bench.eno(), r.works) << op << " '" << r.text << "'";
    EXPECT_EQ(bench.value("SM1.1"), r.works ? 0U : 1U) << op << " '" << r.text << "'";
    EXPECT_EQ(bench.met(Hazard::Overflow), !r.works);
    if (r.works) {
      EXPECT_EQ(get(bench), r.number) << op << " '" << r.text << "'";
    } else {
      EXPECT_EQ(bench.value("VD200"), 0x4D4D4D4DU) << "unchanged after '" << r.text << "'";
    }
  }
}

TEST(SubstringToInt, ListsOfTheManual) {
  // 001:3888-3913, the limits of 001:3877, and words that follow from the format.
  expectReads("STI", "VW200",
              {{"123", true, 123},
               {"-00456", true, -456},
               {"123.45", true, 123},
               {"+2345", true, 2345},
               {"000000123ABCD", true, 123},
               {"  7", true, 7},
               {"0", true, 0},
               {"32767", true, 32767},
               {"-32768", true, -32768},
               {"32768", false, 0},
               {"-32769", false, 0},
               {"99999999999999999999", false, 0},
               {"65536", false, 0},
               {"A123", false, 0},
               {" ", false, 0},
               {"++123", false, 0},
               {"+-123", false, 0},
               {"+ 123", false, 0},
               {"", false, 0},
               {"-", false, 0},
               {".5", false, 0}},
              [](Bench& b) { return static_cast<double>(static_cast<std::int16_t>(b.value("VW200"))); });
}

TEST(SubstringToDInt, ListsOfTheManual) {
  expectReads("STD", "VD200",
              {{"123", true, 123},
               {"-00456", true, -456},
               {"123.45", true, 123},
               {"+2345", true, 2345},
               {"000000123ABCD", true, 123},
               {"2147483647", true, 2147483647.0},
               {"-2147483648", true, -2147483648.0},
               {"2147483648", false, 0},
               {"-2147483649", false, 0},
               {"4294967296", false, 0},
               {"123456789012345678901234567890", false, 0},
               {"A123", false, 0},
               {" ", false, 0},
               {"++123", false, 0},
               {"+-123", false, 0},
               {"+ 123", false, 0}},
              [](Bench& b) { return static_cast<double>(static_cast<std::int32_t>(b.value("VD200"))); });
}

TEST(SubstringToReal, ListsOfTheManual) {
  expectReads("STR", "VD200",
              {{"123", true, 123.0F},
               {"-00456", true, -456.0F},
               {"123.45", true, 123.45F},
               {"+2345", true, 2345.0F},
               {"00.000000123", true, 0.000000123F},
               {"1.234E6", true, 1.234F},
               {"98,6F", true, 98.6F},
               {"1.2.3", true, 1.2F},
               {"-0.5", true, -0.5F},
               {"  5.", true, 5.0F},
               {"100000000000000000000", true, 1e20F},
               {"4000000000000000000000000000000000000000", false, 0},
               {"A123", false, 0},
               {" ", false, 0},
               {"++123", false, 0},
               {"+-123", false, 0},
               {"+ 123", false, 0},
               {".5", false, 0},
               {"-.5", false, 0}},
              [](Bench& b) { return static_cast<double>(b.real("VD200")); });
}

TEST(SubstringToReal, LongNumbersKeepSevenDigits) {
  // 001:3679: REAL holds seven significant digits; a number with more may differ in the last of its 24 bits.
  const std::vector<std::pair<std::string, double>> cases = {{"0.0000000000000000000000000001", 1e-28},
                                                             {"340000000000000000000000000000000000000", 3.4e38},
                                                             {"123456789.987654321", 123456789.98},
                                                             {"-0.00000000000000000000000000000000000123", -1.23e-36}};
  for (const auto& [text, number] : cases) {
    Bench bench({"LD SM0.0", "STR VB0, 1, VD200"});
    bench.setString(0, text);
    bench.scan();
    EXPECT_NEAR(bench.real("VD200") / number, 1.0, 2e-7) << text;
    EXPECT_TRUE(bench.eno());
  }
}

TEST(SubstringToNumber, ExampleOfTheManual) {
  // 001:3920-3939: "Temp  98.6F" from character 7.
  Bench bench({"LD I0.0", "STI VB0,7,VW100", "STD VB0,7,VD200", "STR VB0,7,VD300"});
  bench.setString(0, "Temp  98.6F");
  EXPECT_EQ(bench.scan().value("VW100"), 0U);
  bench.set("I0.0", 1);
  bench.scan();
  EXPECT_EQ(bench.value("VW100"), 98U);
  EXPECT_EQ(bench.value("VD200"), 98U);
  EXPECT_EQ(bench.real("VD300"), 98.6F);
}

TEST(SubstringToNumber, IndexAndRange) {
  Bench zero({"LD SM0.0", "STI VB0, 0, VW100", "STD VB0, VB50, VD200", "STR VB0, 0, VD300"});
  zero.setString(0, "12");
  zero.scan();
  EXPECT_EQ(zero.outside.hazards(), std::vector<Hazard>(3, Hazard::StringIndexZero));
  EXPECT_FALSE(zero.eno());
  EXPECT_TRUE(zero.errorBit());
  EXPECT_EQ(zero.value("VW100") + zero.value("VD200") + zero.value("VD300"), 0U);

  for (const auto& [index, number, works] :
       std::vector<std::tuple<int, int, bool>>{{1, 12, true}, {2, 2, true}, {3, 0, false}, {255, 0, false}}) {
    Bench bench({"LD SM0.0", "STI \"12\", VB50, VW100"});
    bench.set("VB50", index);
    bench.scan();
    EXPECT_EQ(bench.value("VW100"), static_cast<unsigned>(number)) << index;
    EXPECT_EQ(bench.eno(), works) << index;
  }

  const Target cpu222{s7200Cpu("222"), Edition::Edition2004};
  for (const auto& [length, fits] : std::vector<std::pair<int, bool>>{{2, true}, {3, false}, {255, false}}) {
    Bench bench({"LD SM0.0", "STI VB2045, 1, VW100"}, cpu222);
    bench.setText(2046, "77");
    bench.set("VB2045", length);
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::OutOfRange), !fits) << length;
    EXPECT_EQ(bench.value("VW100"), fits ? 77U : 0U);
  }
}

TEST(SubstringToNumber, OverflowMayLeaveAnything) {
  Bench bench({"LD SM0.0", "STI VB0, 1, VW100"});
  ASSERT_TRUE(bench.choices.set("substring-overflow", "unknown"));
  bench.outside.values[{External::UnknownResult, 0}] = 0x1234;
  bench.setString(0, "40000");
  EXPECT_EQ(bench.scan().value("VW100"), 0x1234U);
  EXPECT_EQ(bench.value("SM1.1"), 1U);
  EXPECT_TRUE(bench.met(Hazard::Overflow));
  bench.set("VW100", 5);
  bench.setString(0, "x");
  EXPECT_EQ(bench.scan().value("VW100"), 5U) << "no number at all: unchanged (001:3879)";
  EXPECT_TRUE(bench.met(Hazard::Overflow));
}

}  // namespace
}  // namespace rungproof::manual
