// Memory that the program uses as a REAL is compared as one, whatever stands beside it: 0.5 is not above 20 because its
// bits are.
#include <gtest/gtest.h>

#include "engine/real_places.hpp"
#include "tests/environment/asked.hpp"

namespace rungproof {
namespace {

using test::Asked;
using test::verdict;

/// VD20 holds 0.5 from the first scan on, VW0 holds 1; VD20 is compared as a REAL, VD40 is moved and nothing else.
Outcome ofHalf(const std::string& property) {
  return verdict(Asked{.program = "LD SM0.0;MOVR 0.5, VD20;MOVW 1, VW0;MOVD 7, VD40;Network 2;LDR> VD20, 0.0;= Q0.0",
                       .property = property});
}

TEST(RealPlace, WholeNumbersBesideItAreReals) {
  // 0.5 is above 0, below 1 and below 20; its double is 1; its bits, 16#3F000000, are far above 20.
  for (const std::string holds : {"VD20 < 1", "VD20 <= 1", "VD20 > 0", "VD20 * 2 = 1", "VD20 * VD20 < 1", "VD20 < VW0",
                                  "VD20 + VW0 > 1", "VD20 = 0.5", "-VD20 < 0"})
    EXPECT_EQ(ofHalf(holds), Outcome::Proved) << holds;
  for (const std::string fails : {"VD20 > 20", "VD20 * 2 > 5", "VD20 = 1056964608", "VD20 > VW0"})
    EXPECT_EQ(ofHalf(fails), Outcome::Violated) << fails;
  EXPECT_EQ(ofHalf("reach VD20 * 3 > 100"), Outcome::Unreachable);
}

TEST(RealPlace, APatternBesideItGivesItsBits) {
  EXPECT_EQ(ofHalf("VD20 = 16#3F000000"), Outcome::Proved);
  EXPECT_EQ(ofHalf("VD20 = 16#3F000001"), Outcome::Violated);
}

TEST(RealPlace, OtherDoubleWordsStayWholeNumbers) {
  EXPECT_EQ(ofHalf("VD40 = 7"), Outcome::Proved);
  EXPECT_EQ(ofHalf("VD40 > 6 and VD40 < 8"), Outcome::Proved);
}

/// 5 is above 4.5 and equals 5.0, although its bits, read as a REAL, are a tiny number.
TEST(RealPlace, WholeNumbersStayWholeBesideARealNumber) {
  struct Case {
    std::string program, holds;
  };
  const std::string reals = "LD SM0.0;MOVR 5.0, VD0;";
  for (const Case& each : {Case{reals + "MOVD 5, VD8", "VD8 > 4.5"},                  // a decimal constant
                           Case{reals + "MOVD 5, VD8", "VD0 = VD8"},                  // beside memory
                           Case{reals + "MOVD 5, VD8", "VD8 * 0.5 = 2.5"},            // computed
                           Case{reals + "MOVD 5, VD8", "VD8 + 0 > 4.5"},              // a sum of 33 bits
                           Case{reals + "MOVD 5, VD8;MOVD VD8, VD12", "VD12 > 4.5"},  // a copy
                           Case{reals + "MOVD 5, VD8", "VD8 - 1 < VD0"},
                           Case{"LD SM0.0;MOVW 3, VW0;ITD VW0, VD4", "VD4 > 2.5"},  // converted
                           Case{"LD SM0.0;MOVD 16#3, VD4;Network 2;LDD> VD4, 100;= Q0.0", "VD4 > 2.5"}})
    EXPECT_EQ(verdict(Asked{.program = each.program, .property = each.holds}), Outcome::Proved) << each.holds;
  EXPECT_EQ(verdict(Asked{.program = reals + "MOVD 5, VD8", .property = "reach VD8 = 5 and VD8 > 4.5"}),
            Outcome::Reachable);
}

/// A copy of a REAL holds a REAL.
TEST(RealPlace, CopiesAreWhatTheyAreCopiedFrom) {
  EXPECT_EQ(verdict(Asked{.program = "LD SM0.0;MOVR 2.5, VD0;MOVD VD0, VD4", .property = "VD4 < 3"}), Outcome::Proved);
}

/// A pattern is moved and nothing else: it is read like the number beside it. 16#40200000 are the bits of 2.5.
TEST(RealPlace, WhatIsOnlyMovedIsReadLikeTheNumberBesideIt) {
  EXPECT_EQ(verdict(Asked{.program = "LD SM0.0;MOVD 16#40200000, VD0", .property = "VD0 = 2.5"}), Outcome::Proved);
  EXPECT_EQ(verdict(Asked{.program = "LD SM0.0;MOVD 16#40200000, VD0", .property = "VD0 > 1000"}), Outcome::Proved);
}

TEST(RealPlace, AssumptionsLimitRealNumbers) {
  // 60.0 lies between 0 and 100 and is above 50.0.
  EXPECT_EQ(verdict(Asked{.program = "LDR> VD20, 50.0;= Q0.0",
                          .property = "reach Q0.0",
                          .declarations = "external VD20;assume lim: VD20 >= 0 and VD20 <= 100"}),
            Outcome::Reachable);
}

/// The double words of an S7-300 that accumulators bring to REAL arithmetic.
TEST(RealPlace, AccumulatorsTellWhatIsReal) {
  const Program program = readText("m.awl",
                                   "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
                                   "L MD 20;\nL MD 24;\n*R;\nT MD 28;\n"  // 20 and 24 are multiplied, 28 is the product
                                   "L 5.0e-1;\nT MD 32;\n"                // a constant that is a REAL
                                   "L MD 36;\nL MD 40;\n>R;\n= Q 0.0;\n"  // compared
                                   "L MD 44;\nSQRT;\nT MD 48;\n"          // a function and its result
                                   "L MD 52;\nL MD 56;\n+D;\nT MD 60;\n"  // whole numbers
                                   "L MD 64;\nT MD 68;\n"                 // moved: nobody knows
                                   "L MD 52;\nDTR;\nT MD 72;\n"           // converted
                                   "L MD 72;\nABS;\nT MD 76;\n"
                                   "L MD 28;\nT MD 80;\nL 5;\nT MD 84;\n"  // a copy; a whole number
                                   "END_ORGANIZATION_BLOCK\n");
  const RealPlaces reals(program);
  const auto useOf = [&](std::uint32_t byte) { return reals.useOf(direct(Area::M, Width::DWord, byte)); };
  for (const std::uint32_t byte : {20U, 24U, 28U, 32U, 36U, 40U, 44U, 48U, 72U, 76U, 80U})
    EXPECT_EQ(useOf(byte), NumberUse::Real) << byte;
  for (const std::uint32_t byte : {52U, 56U, 60U, 84U}) EXPECT_EQ(useOf(byte), NumberUse::Whole) << byte;
  for (const std::uint32_t byte : {64U, 68U, 21U}) EXPECT_EQ(useOf(byte), NumberUse::Unknown) << byte;
  EXPECT_FALSE(reals.contains(direct(Area::M, Width::Word, 20))) << "half of it";
}

}  // namespace
}  // namespace rungproof
