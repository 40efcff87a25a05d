// ADR013: the limits stand in the rows of ir/s7300/cpu.hpp. A 314 has 256 bytes of M, 256 timers and counters, images
// of 1024 bytes, 2048 bytes of L, data blocks of 32768 bytes and two accumulators; a 414 has 6000 data blocks.
#include "ir/dialect.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

std::string toldOn(const char* name, const std::string& text) {
  const Cpu cpu = *cpuNamed(name);
  const Linted linted(text, {cpu, usualEdition(cpu)});
  std::string told;
  for (const Finding& finding : linted.of("ADR013")) told += finding.message + "\n";
  return told;
}

TEST(Step7Addresses, BeyondTheAreasOfTheCpu) {
  const std::vector<std::pair<const char*, const char*>> beyond = {
      {"A M 256.0;\n= Q 0.0;", "M256.0 is beyond the last address of the CPU 314, M255.7\n"},
      {"L MW 255;\nT QW 0;", "MW255 is beyond the last address of the CPU 314, MW254\n"},
      {"L MD 253;\nT QD 0;", "MD253 is beyond the last address of the CPU 314, MD252\n"},
      {"A I 1024.0;\n= Q 0.0;", "I1024.0 is beyond the last address of the CPU 314, I1023.7\n"},
      {"A I 0.0;\n= Q 1024.0;", "Q1024.0 is beyond the last address of the CPU 314, Q1023.7\n"},
      {"A T 256;\n= Q 0.0;", "T256 is beyond the last address of the CPU 314, T255\n"},
      {"L C 256;\nT QW 0;", "C256 is beyond the last address of the CPU 314, C255\n"},
      {"L LW 2047;\nT QW 0;", "LW2047 is beyond the last address of the CPU 314, LW2046\n"},
      {"L PIW 8191;\nT QW 0;", "PIW8191 is beyond the last address of the CPU 314, PIW8190\n"},
      {"A M [MD 254];\n= Q 0.0;", "MD254 is beyond the last address of the CPU 314, MD252\n"},
      {"ENT;\nL 1;\nT MW 0;", "ENT moves ACCU3 and ACCU4, and the CPU 314 has two accumulators\n"},
  };
  for (const auto& [statements, message] : beyond) EXPECT_EQ(toldOn("314", ob1(statements)), message) << statements;
  for (const char* within : {"A M 255.7;\n= Q 1023.7;", "L MW 254;\nT QW 1022;", "A T 255;\n= Q 0.0;",
                             "L PIW 8190;\nT QW 0;", "L LD 2044;\nT QD 0;", "A M [MD 252];\n= Q 0.0;"})
    EXPECT_EQ(toldOn("314", ob1(within)), "") << within;
}

TEST(Step7Addresses, TheLargestOfTheFamilyRefusesNothingLegal) {
  EXPECT_EQ(toldOn("319-3", ob1("L MW 8190;\nT QW 4094;\nA T 2047;\n= M 0.0;")), "");
  EXPECT_EQ(toldOn("417", ob1("L MW 16382;\nENT;\nLEAVE;\nT QW 16382;")), "");
}

TEST(Step7Addresses, ParametersAndDataBlocks) {
  const std::string block = fc(1, "L #V;\nT MW 0;", "VAR_INPUT\nV : INT;\nEND_VAR\n");
  EXPECT_EQ(toldOn("314", block + ob1("CALL FC 1 (V := MW 300);")),
            "MW300 is beyond the last address of the CPU 314, MW254\n");
  EXPECT_EQ(toldOn("414", db(6001, "A : INT;") + ob1("L DB6001.DBW 0;\nT MW 0;")),
            "DB6001 is beyond the last data block of the CPU 414, DB6000\n");
  EXPECT_EQ(toldOn("314", db(1, "A : ARRAY[1..16385] OF INT;") + ob1("L DB1.DBW 0;\nT MW 0;")),
            "DB1 has 32770 bytes, and a data block of the CPU 314 at most 32768\n");
  EXPECT_EQ(toldOn("314", db(1, "A : ARRAY[1..16384] OF INT;") + ob1("L DB1.DBW 0;\nT MW 0;")), "");
}

}  // namespace
}  // namespace rungproof::testing
