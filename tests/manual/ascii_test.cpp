// ASCII arrays: ATH, HTA, ITA, DTA, RTA.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ir/s7200/cpu.hpp"
#include "plant.hpp"

namespace rungproof::manual {
namespace {

TEST(AsciiToHex, ExampleWithOddLength) {
  // 001:3699-3714: '3','E','A' from VB30 give 3E and A in the high nibble of VB41; its low nibble stays.
  Bench bench({"LD I3.2", "ATH VB30, VB40, 3"});
  bench.setText(30, "3EA");
  bench.set("VW40", 0x7777);
  EXPECT_EQ(bench.scan().value("VW40"), 0x7777U) << "no power flow";
  bench.set("I3.2", 1);
  bench.set("SM1.7", 1);
  EXPECT_EQ(bench.scan().value("VW40"), 0x3EA7U);
  EXPECT_EQ(bench.value("SM1.7"), 0U);
  EXPECT_TRUE(bench.eno());
}

TEST(AsciiToHex, AllDigitsAndVariableLength) {
  Bench bench({"LD SM0.0", "ATH VB100, VB200, VB0"});
  bench.setText(100, "0123456789ABCDEF");
  bench.set("VB0", 16);
  bench.scan();
  EXPECT_EQ(bench.value("VD200"), 0x01234567U);
  EXPECT_EQ(bench.value("VD204"), 0x89ABCDEFU);
  bench.set("VB0", 0);
  bench.set("VD200", 0);
  EXPECT_EQ(bench.scan().value("VD200"), 0U);
  EXPECT_TRUE(bench.eno());
}

TEST(AsciiToHex, IllegalCharacters) {
  // Legal are 30h-39h and 41h-46h only (001:3591); the neighbours and small letters are not.
  for (const int bad : {0x2F, 0x3A, 0x40, 0x47, 0x61, 0x66, 0x20, 0x00, 0xB1}) {
    for (const bool nothing : {false, true}) {
      Bench bench({"LD SM0.0", "ATH VB30, VB40, 4"});
      ASSERT_TRUE(bench.choices.set("ath-error", nothing ? "nothing" : "stops-there"));
      bench.setText(30, "12");
      bench.set("VB32", bad);
      bench.set("VB33", '4');
      bench.set("VW40", 0x7777);
      bench.scan();
      EXPECT_EQ(bench.value("VW40"), nothing ? 0x7777U : 0x1277U) << bad;
      EXPECT_EQ(bench.value("SM1.7"), 1U);
      EXPECT_TRUE(bench.met(Hazard::NotAscii));
      EXPECT_FALSE(bench.eno());
    }
  }
}

TEST(AsciiToHex, BuffersMustFit) {
  const Target cpu222{s7200Cpu("222"), Edition::Edition2004};
  for (const auto& [line, fits] : std::vector<std::pair<std::string, bool>>{{"ATH VB2044, VB0, 4", true},
                                                                            {"ATH VB2044, VB0, 5", false},
                                                                            {"ATH VB0, VB2046, 4", true},
                                                                            {"ATH VB0, VB2046, 5", false},
                                                                            {"HTA VB2046, VB0, 4", true},
                                                                            {"HTA VB2046, VB0, 5", false},
                                                                            {"HTA VB0, VB2044, 4", true},
                                                                            {"HTA VB0, VB2044, 5", false}}) {
    Bench bench({"LD SM0.0", line}, cpu222);
    for (std::uint32_t i = 0; i < 2048; ++i) bench.store.area(Area::V)[i] = '7';
    const auto before = bench.store.area(Area::V);
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::OutOfRange), !fits) << line;
    EXPECT_EQ(bench.eno(), fits) << line;
    EXPECT_EQ(bench.store.area(Area::V) == before, !fits) << line;
  }
}

TEST(HexToAscii, DigitsBecomeCapitals) {
  Bench bench({"LD I0.0", "HTA VB0, VB20, 16", "HTA VB0, VB60, 3"});
  bench.set("VD0", 0x01234567);
  bench.set("VD4", 0x89ABCDEF);
  bench.setText(60, "....");
  EXPECT_EQ(bench.scan().text(60, 4), "....");
  bench.set("I0.0", 1);
  bench.scan();
  EXPECT_EQ(bench.text(20, 16), "0123456789ABCDEF");
  EXPECT_EQ(bench.text(60, 4), "012.");
  EXPECT_TRUE(bench.eno());
  EXPECT_EQ(bench.value("SMB1"), 0U);
}

TEST(HexToAscii, SourceMayLieUnderTheResult) {
  Bench bench({"LD SM0.0", "HTA VB0, VB0, 4"});
  bench.set("VW0", 0x12AB);
  bench.scan();
  EXPECT_EQ(bench.text(0, 4), "12AB");
}

std::string ita(int value, int format) {
  Bench bench({"LD I2.3", "ITA VW2, VB10, " + std::to_string(format)});
  bench.set("I2.3", 1);
  bench.set("VW2", value);
  bench.setText(9, "##########");
  bench.scan();
  EXPECT_EQ(bench.text(9, 1) + bench.text(18, 1), "##") << "eight bytes exactly";
  EXPECT_EQ(bench.eno(), (format & 7) <= 5 && format < 16);
  return bench.text(10, 8);
}

TEST(IntToAscii, Vectors) {
  EXPECT_EQ(ita(12345, 0x0B), "  12,345") << "example 001:3716-3732";
  // 001:3639-3649: point, three places.
  EXPECT_EQ(ita(12, 3), "   0.012");
  EXPECT_EQ(ita(-123, 3), "  -0.123");
  EXPECT_EQ(ita(1234, 3), "   1.234");
  EXPECT_EQ(ita(-12345, 3), " -12.345");
  // By the same rules: no point for 0 places, the limits, the most places.
  EXPECT_EQ(ita(0, 0), "       0");
  EXPECT_EQ(ita(0, 8), "       0");
  EXPECT_EQ(ita(-32768, 0), "  -32768");
  EXPECT_EQ(ita(32767, 1), "  3276.7");
  EXPECT_EQ(ita(-7, 2), "   -0.07");
  EXPECT_EQ(ita(0, 4), "  0.0000");
  EXPECT_EQ(ita(-1, 5), "-0.00001");
  EXPECT_EQ(ita(-32768, 5), "-0.32768");
  EXPECT_EQ(ita(100, 0), "     100");
}

TEST(IntToAscii, BadFormats) {
  EXPECT_EQ(ita(12, 6), "        ") << "nnn > 5: blanks";
  EXPECT_EQ(ita(12, 15), "        ");
  EXPECT_EQ(ita(12, 0x13), "########") << "upper bits must be 0";
  Bench bench({"LD SM0.0", "ITA 12, VB10, 6"});
  EXPECT_TRUE(bench.scan().met(Hazard::BadFormat));
  EXPECT_FALSE(bench.errorBit());
}

std::string dta(std::int64_t value, int format) {
  Bench bench({"LD SM0.0", "DTA VD2, VB10, VB0"});
  bench.set("VD2", value);
  bench.set("VB0", format);
  bench.setText(9, "##############");
  bench.scan();
  EXPECT_EQ(bench.text(9, 1) + bench.text(22, 1), "##") << "twelve bytes exactly";
  EXPECT_EQ(bench.eno(), (format & 7) <= 5 && format < 16);
  return bench.text(10, 12);
}

TEST(DIntToAscii, Vectors) {
  // 000:2787-2812: four places.
  EXPECT_EQ(dta(-12, 4), "     -0.0012");
  EXPECT_EQ(dta(1234567, 4), "    123.4567");
  EXPECT_EQ(dta(1234567, 0x0C), "    123,4567");
  EXPECT_EQ(dta(-2147483648LL, 5), "-21474.83648");
  EXPECT_EQ(dta(2147483647, 0), "  2147483647");
  EXPECT_EQ(dta(0, 1), "         0.0");
  EXPECT_EQ(dta(5, 7), "            ");
  EXPECT_EQ(dta(5, 0x20), "############");
}

std::string rta(float value, int size, int format, bool works = true) {
  Bench bench({"LD SM0.0", "RTA VD2, VB10, " + std::to_string(size * 16 + format)});
  bench.setReal("VD2", value);
  bench.setText(9, "#################");
  bench.scan();
  EXPECT_EQ(bench.eno(), works) << value;
  EXPECT_EQ(bench.met(Hazard::BadFormat), !works) << value;
  EXPECT_EQ(bench.text(9, 1), "#");
  EXPECT_EQ(bench.text(10 + static_cast<std::uint32_t>(size), 1), "#");
  return bench.text(10, static_cast<std::size_t>(size));
}

TEST(RealToAscii, Vectors) {
  // 000:2879-2892: six bytes, one place.
  EXPECT_EQ(rta(1234.5F, 6, 1), "1234.5");
  EXPECT_EQ(rta(-0.0004F, 6, 1), "   0.0") << "no minus sign for 0";
  EXPECT_EQ(rta(-3.67526F, 6, 1), "  -3.7");
  EXPECT_EQ(rta(1.95F, 6, 1), "   2.0");
  EXPECT_EQ(rta(123.45F, 10, 3), "   123.450") << "example 001:3743-3758";
  EXPECT_EQ(rta(123.45F, 10, 0x0B), "   123,450");
  // By the same rules; 0.5 and 2.5 are exact halves and round up.
  EXPECT_EQ(rta(0.0F, 3, 0), "  0");
  EXPECT_EQ(rta(0.5F, 3, 0), "  1");
  EXPECT_EQ(rta(-2.5F, 3, 0), " -3");
  EXPECT_EQ(rta(-0.25F, 3, 0), "  0");
  EXPECT_EQ(rta(999.0F, 3, 0), "999");
  EXPECT_EQ(rta(-12345678.0F, 15, 5), "-12345678.00000");
  EXPECT_EQ(rta(0.00001F, 8, 5), " 0.00001");
  EXPECT_EQ(rta(1e-40F, 8, 5), " 0.00000") << "a denormal number";
  EXPECT_EQ(rta(16777216.0F, 15, 2), "    16777216.00");
  EXPECT_EQ(rta(1e14F, 15, 0), "100000000376832") << "the REAL next to 10^14, all places shown";
}

TEST(RealToAscii, RoundsTheNumberItself) {
  // The REAL 1.15 is 1.14999997..., the REAL 1.25 is exact.
  EXPECT_EQ(rta(1.15F, 6, 1), "   1.1");
  EXPECT_EQ(rta(1.25F, 6, 1), "   1.3");
}

TEST(RealToAscii, BuffersTooSmallAndBadFormats) {
  EXPECT_EQ(rta(12345.5F, 6, 1, false), "      ") << "seven characters needed";
  EXPECT_EQ(rta(-1234.5F, 6, 1, false), "      ") << "no place for the sign";
  EXPECT_EQ(rta(1000.0F, 3, 0, false), "   ");
  EXPECT_EQ(rta(1.0F, 3, 1, false), "   ") << "at least three bytes more than places (001:3689)";
  EXPECT_EQ(rta(1.0F, 4, 1), " 1.0");
  EXPECT_EQ(rta(1.0F, 15, 6, false), std::string(15, ' ')) << "nnn > 5";
  EXPECT_EQ(rta(2e15F, 15, 0, false), std::string(15, ' ')) << "sixteen digits";
  EXPECT_EQ(rta(-2e14F, 15, 0, false), std::string(15, ' ')) << "no place for the sign";
  EXPECT_EQ(rta(1e30F, 15, 0, false), std::string(15, ' '));
  EXPECT_EQ(rta(std::nanf(""), 8, 1, false), std::string(8, ' '));
  EXPECT_EQ(rta(std::numeric_limits<float>::infinity(), 8, 1, false), std::string(8, ' '));
  for (const int size : {0, 1, 2})
    EXPECT_EQ(rta(1.0F, size, 0, false), std::string(static_cast<std::size_t>(size), '#'));
}

TEST(NumberToAscii, BuffersMustFit) {
  const Target cpu222{s7200Cpu("222"), Edition::Edition2004};
  for (const auto& [line, fits] : std::vector<std::pair<std::string, bool>>{{"ITA 1, *AC1, 0", false},
                                                                            {"DTA 1, *AC1, 0", false},
                                                                            {"RTA 1.0, *AC1, 16#70", true},
                                                                            {"RTA 1.0, *AC1, 16#80", false}}) {
    Bench bench({"LD SM0.0", line}, cpu222);
    bench.set("AC1", pointer::encode(Area::V, 2041));  // seven bytes are left
    bench.scan();
    EXPECT_EQ(bench.met(Hazard::OutOfRange), !fits) << line;
    EXPECT_EQ(bench.eno(), fits) << line;
    EXPECT_EQ(bench.value("VB2047"), fits ? '1' : 0U) << line;
  }
}

}  // namespace
}  // namespace rungproof::manual
