// Pairs of addresses, and the file that says them.
#include "analysis/equivalence/address_pairs.hpp"

#include <gtest/gtest.h>

#include "frontend/input/program_input.hpp"
#include "frontend/sides/map_file.hpp"

namespace rungproof::test {

namespace {

constexpr Address inputBit(std::uint32_t index) { return {Area::I, index}; }

struct ReadMap {
  std::vector<MapLine> lines;
  std::vector<Failure> failures;
};
ReadMap mapOf(const std::string& text) {
  const Program program =
      readText("a.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_ORGANIZATION_BLOCK\n");
  ReadMap result;
  result.lines = readMap("moved.map", text, program, program, result.failures);
  return result;
}

}  // namespace

TEST(AddressPairs, AnAddressWithoutLineStandsForItself) {
  const AddressPairs pairs;
  EXPECT_EQ(pairs.before(inputBit(3)), inputBit(3));
  EXPECT_EQ(pairs.after(inputBit(3)), inputBit(3));
}

TEST(AddressPairs, ARunPairsItsBitsInOrder) {
  AddressPairs pairs;
  ASSERT_TRUE(pairs.add(inputBit(0), inputBit(8), 8));
  EXPECT_EQ(pairs.before(inputBit(11)), inputBit(3));
  EXPECT_EQ(pairs.after(inputBit(3)), inputBit(11));
}

TEST(AddressPairs, WhatIsGivenToAnotherHasNoPartnerOfItsOwn) {
  AddressPairs pairs;
  ASSERT_TRUE(pairs.add(inputBit(0), inputBit(8), 1));
  EXPECT_EQ(pairs.before(inputBit(0)), std::nullopt) << "I0.0 of OLD stands for I1.0 of NEW";
  EXPECT_EQ(pairs.after(inputBit(8)), std::nullopt);
}

TEST(AddressPairs, AnAddressIsPairedOnce) {
  AddressPairs pairs;
  ASSERT_TRUE(pairs.add(inputBit(0), inputBit(8), 4));
  EXPECT_FALSE(pairs.add(inputBit(3), inputBit(20), 1));
  EXPECT_FALSE(pairs.add(inputBit(20), inputBit(11), 1));
  EXPECT_TRUE(pairs.add(inputBit(4), inputBit(12), 1));
}

TEST(AddressPairs, AWordIsPairedIfItsBytesStayTogether) {
  AddressPairs pairs;
  ASSERT_TRUE(pairs.add({Area::V, 100 * 8}, {Area::V, 10 * 8}, 16));
  const auto word = pairs.before(direct(Area::V, Width::Word, 10));
  ASSERT_TRUE(word);
  EXPECT_EQ(toString(*word), "VW100");
  EXPECT_FALSE(pairs.before(direct(Area::V, Width::Word, 11))) << "its second byte stands elsewhere";
}

TEST(AddressPairs, AnEventStandsForItselfOrItsPartner) {
  AddressPairs pairs;
  ASSERT_TRUE(pairs.addEvent(8, 25));
  EXPECT_EQ(pairs.eventBefore(25), 8);
  EXPECT_EQ(pairs.eventBefore(8), std::nullopt) << "event 8 of OLD stands for event 25 of NEW";
  EXPECT_EQ(pairs.eventBefore(9), 9);
  EXPECT_FALSE(pairs.addEvent(8, 26));
}

TEST(MapFile, PairsEvents) {
  const ReadMap read = mapOf("event 8 = event 25  # the other port\n");
  EXPECT_TRUE(read.failures.empty());
  ASSERT_EQ(read.lines.size(), 1U);
  EXPECT_EQ(read.lines[0].events, std::pair(8, 25));
}

TEST(MapFile, HasOnePairALine) {
  const ReadMap read =
      mapOf("# moved to the second module\nI0.0..I0.7 = I1.0..I1.7   # a byte\n\nT37 = T40\nVB10..VB19=VB30..VB39\n");
  EXPECT_TRUE(read.failures.empty());
  ASSERT_EQ(read.lines.size(), 3U);
  EXPECT_EQ(read.lines[0].count, 8U);
  EXPECT_EQ(read.lines[1].before, (Address{Area::T, 37}));
  EXPECT_EQ(read.lines[2].count, 80U);
}

TEST(MapFile, MistakesHaveTheirLine) {
  const auto failureOf = [](const std::string& text) {
    const ReadMap read = mapOf("I0.0 = I1.0\n" + text);
    EXPECT_EQ(read.failures.size(), 1U) << text;
    if (read.failures.empty()) return std::string();
    EXPECT_EQ(read.failures[0].place, "moved.map:2") << text;
    return read.failures[0].message;
  };
  EXPECT_EQ(failureOf("I0.1"), "'I0.1' is no pair");
  EXPECT_EQ(failureOf("I0.1 ="), "an address of NEW is missing");
  EXPECT_EQ(failureOf("Pump = I0.1"), "'Pump' is neither an address nor a symbol of OLD");
  EXPECT_EQ(failureOf("I0.1..I0.3 = I1.1..I1.2"), "the two sides of 'I0.1..I0.3 = I1.1..I1.2' are not of one size");
  EXPECT_EQ(failureOf("I0.3..I0.1 = I1.1..I1.3"), "'I0.3..I0.1' is no range");
  EXPECT_EQ(failureOf("event 8 = OB40"), "NEW is an S7-200 program, which has no OB40");
  EXPECT_EQ(failureOf("event 8 = event 34"), "'event 34' is no interrupt event of CPU 226, which is NEW's");
  EXPECT_EQ(failureOf("event 8 = I0.0"), "'I0.0' names no interrupt event of NEW");
  EXPECT_EQ(failureOf("event 0 = event 1"), "event 0 is 'rising edge of I0.0', event 1 is 'falling edge of I0.0'");
  EXPECT_EQ(failureOf("I0.0 = M9.9"), "M9.9 of NEW: M9.9 has bit number 9; a byte has bits 0 to 7");
  EXPECT_EQ(failureOf("I77.0 = I0.0"), "I77.0 of OLD: the CPU 226 has no I77.0: the last one is I15.7");
  EXPECT_EQ(failureOf("T37..T300 = T37..T99"), "T300 of OLD: the CPU 226 has no T300: the last one is T255");
  EXPECT_EQ(failureOf("T37 = M0.0"), "the two sides of 'T37 = M0.0' are not of one size");
}

TEST(AddressPairs, SeparateProgramsShareOnlyWhatIsPaired) {
  AddressPairs pairs;
  pairs.separate();
  EXPECT_TRUE(pairs.add({Area::V, 8}, {Area::Q, 0}, 1));
  EXPECT_EQ(pairs.after(Address{Area::V, 8}), (Address{Area::Q, 0}));
  EXPECT_EQ(pairs.before(Address{Area::Q, 0}), (Address{Area::V, 8}));
  EXPECT_FALSE(pairs.after(Address{Area::V, 9}).has_value());
  EXPECT_FALSE(pairs.before(Address{Area::V, 8}).has_value());
  EXPECT_FALSE(pairs.before(Address{Area::M, 0}).has_value());
}

}  // namespace rungproof::test
