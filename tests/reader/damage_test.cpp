// Damaged input: cut, mixed and random texts never crash or hang, and time grows with the length only.
#include <gtest/gtest.h>

#include <random>

#include "frontend/stl/stl_parser.hpp"
#include "frontend/stl/stl_writer.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

const std::string sample =
    "ORGANIZATION_BLOCK MAIN:OB1\r\nTITLE=x\r\nVAR\r\na:BOOL;\r\nEND_VAR\r\nBEGIN\r\nNetwork 1 // t\r\n// c\r\nLD "
    "I0.0\r\nAN \"sym\"\r\nLPS\r\nA *VD10\r\nLPP\r\n= Q0.0\r\n"
    "MOVW +10, VW0 // c\r\nCALL SBR_0, 'AB', 16#FF, &VB0\r\nEND_ORGANIZATION_BLOCK\r\nSUBROUTINE_BLOCK "
    "SBR_0:SBR0\r\nVAR_INPUT\r\nx:DWORD;\r\nEND_VAR\r\nBEGIN\r\nNetwork 1\r\nLD #x\r\nEND_SUBROUTINE_BLOCK\r\n"
    "DATA_BLOCK_TAB U\r\nBEGIN\r\nVB0 1, "
    "\"ab\"\r\nEND_DATA_BLOCK_TAB\r\nSYMBOL_TABLE\r\nsym\tI0.5\tc\r\nEND_SYMBOL_TABLE\r\n";

/// Reads, walks over everything that was read, and writes it back.
void survive(const std::string& text) {
  const Program program = readText("damaged.awl", text);
  for (const Finding& finding : program.findings) {
    ASSERT_LT(finding.span.file, program.sources->size());
    ASSERT_LE(finding.span.offset + finding.span.length, program.sources->file(finding.span.file).text().size())
        << finding.rule;
    ASSERT_FALSE(finding.message.empty());
  }
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) ASSERT_NE(instruction.desc, nullptr);
    }
  }
  ASSERT_FALSE(text.size() > 100 && writeStl(program).empty() && program.instructionCount() > 0);
}

TEST(Damage, CutAtEveryByte) {
  for (std::size_t i = 0; i <= sample.size(); ++i) survive(sample.substr(0, i));
}

TEST(Damage, BeginsAnywhere) {
  for (std::size_t i = 0; i < sample.size(); i += 3) survive(sample.substr(i));
}

TEST(Damage, ChangedBytes) {
  const unsigned seed = 20240611;
  std::mt19937 random(seed);
  for (int round = 0; round < 2000; ++round) {
    std::string text = sample;
    for (int k = 0; k < 6; ++k) text[random() % text.size()] = static_cast<char>(random());
    survive(text);
    ASSERT_FALSE(HasFatalFailure()) << "seed " << seed << " round " << round;
  }
}

TEST(Damage, ShuffledLinesAndTokens) {
  const unsigned seed = 7;
  std::mt19937 random(seed);
  const std::vector<std::string> tokens = {"LD",
                                           "A",
                                           "=",
                                           "I0.0",
                                           "VW10",
                                           ",",
                                           " ",
                                           "\n",
                                           "\t",
                                           "'",
                                           "\"",
                                           "$",
                                           "//",
                                           ";",
                                           "*",
                                           "&",
                                           "#",
                                           "Network",
                                           "BEGIN",
                                           "END_VAR",
                                           "VAR",
                                           "1",
                                           "16#",
                                           "ORGANIZATION_BLOCK",
                                           "SBR",
                                           "INT",
                                           "END_SUBROUTINE_BLOCK",
                                           "SUBROUTINE_BLOCK",
                                           "DATA_BLOCK",
                                           "TITLE=",
                                           "VB0",
                                           "\xE5\x90\xAF",
                                           "\xFF",
                                           "\xD0\x90",
                                           ">=",
                                           "LDW",
                                           "CALL",
                                           "SYMBOL_TABLE",
                                           "x:BOOL;",
                                           "//@ prove"};
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    for (int k = 0; k < 60; ++k)
      text += tokens[random() % tokens.size()] + (random() % 2 == 0 ? " " : random() % 3 == 0 ? "\n" : "");
    survive(text);
    ASSERT_FALSE(HasFatalFailure()) << "seed " << seed << " round " << round;
  }
}

TEST(Damage, RandomBytes) {
  const unsigned seed = 99;
  std::mt19937 random(seed);
  for (int round = 0; round < 500; ++round) {
    std::string text;
    const std::size_t length = random() % 400;
    for (std::size_t k = 0; k < length; ++k)
      text += static_cast<char>(round % 2 == 0 ? random() % 256 : 32 + random() % 95);
    survive(text);
    ASSERT_FALSE(HasFatalFailure()) << "seed " << seed << " round " << round;
  }
}

std::string repeated(std::string_view piece, std::size_t count) {
  std::string result;
  result.reserve(piece.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += piece;
  return result;
}

TEST(Damage, ManyProblemsAreCounted) {
  const Program program = readText("a.awl", "NOT\n" + repeated("FOO\n", 25000) + "LD nobody\n");
  EXPECT_EQ(program.findings.size(), 10001U);
  EXPECT_EQ(program.findings.back().rule, "SYN008");
  EXPECT_NE(program.findings.back().message.find("15000 further"), std::string::npos);
  EXPECT_EQ(program.instructionCount(), 2U);
}

TEST(Damage, HundredThousandNetworks) {
  const Program program = readText("many.awl", repeated("Network 1\nLD I0.0\n= Q0.0\n", 100000));
  EXPECT_EQ(program.instructionCount(), 200000U);
  EXPECT_EQ(program.pous[0].networks.size(), 100000U);
}

TEST(Damage, OneLineOfTenMegabytes) {
  const Program program = readText("line.awl", "NOT\nLD " + std::string(10'000'000, 'x') + "\n= Q0.0\n");
  EXPECT_EQ(program.instructionCount(), 3U);
}

}  // namespace
}  // namespace rungproof
