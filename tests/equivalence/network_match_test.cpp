// Networks and instructions that stand for each other.
#include <algorithm>

#include "tests/equivalence/pair.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {

namespace {

Program readLine(const std::string& text) { return pairSide("p.awl", exportOf(text), "").program; }

}  // namespace

TEST(NetworkMatch, EqualNetworksAreFoundWhereverTheyStand) {
  const Program before = readLine("LD I0.0;= Q0.0|LD I0.1;= Q0.1"), after = readLine("LD I0.1;= Q0.1|LD I0.0;= Q0.0");
  const ProgramMatch match = matchPrograms(before, after);
  ASSERT_EQ(match.networks.size(), 2U);
  for (const NetworkPair& pair : match.networks) EXPECT_TRUE(pair.isSame);
  EXPECT_EQ(match.networks[0].before->network, 1U);
  EXPECT_EQ(match.beforeOf, (std::vector<std::uint32_t>{2, 3, 0, 1}));
}

TEST(NetworkMatch, AChangedNetworkKeepsTheInstructionsThatStayed) {
  const Program before = readLine("LD I0.0;A I0.1;= Q0.0"), after = readLine("LD I0.0;AN I0.2;A I0.1;= Q0.0");
  const ProgramMatch match = matchPrograms(before, after);
  ASSERT_EQ(match.networks.size(), 1U);
  EXPECT_FALSE(match.networks[0].isSame);
  EXPECT_TRUE(match.networks[0].before && match.networks[0].after);
  EXPECT_EQ(match.beforeOf, (std::vector<std::uint32_t>{0, noPartner, 1, 2}));
}

TEST(NetworkMatch, AddedAndRemovedNetworksHaveOneSide) {
  const Program before = readLine("LD I0.0;= Q0.0|LD I1.5;MOVW 7,VW0"),
                after = readLine("LD I0.0;= Q0.0|LDN M3.3;S Q1.0,1");
  const ProgramMatch match = matchPrograms(before, after);
  EXPECT_EQ(std::ranges::count_if(match.networks, [](const NetworkPair& p) { return p.isSame; }), 1);
  EXPECT_EQ(std::ranges::count_if(match.networks, [](const NetworkPair& p) { return !p.before; }), 1);
  EXPECT_EQ(std::ranges::count_if(match.networks, [](const NetworkPair& p) { return !p.after; }), 1);
}

TEST(NetworkMatch, ANetworkThatDrivesTheSameCoilIsItsSuccessor) {
  const ProgramMatch match = matchPrograms(readLine("LD I0.0;A I0.1;= Q0.0|LD I0.2;A I0.3;= Q0.1"),
                                           readLine("LD I0.5;AN I0.6;= Q0.1|LD I0.1;A I0.0;= Q0.0"));
  ASSERT_EQ(match.networks.size(), 2U);
  EXPECT_EQ(match.networks[0].before->network, 1U);
  EXPECT_EQ(match.networks[1].before->network, 0U);
}

/// The changed network shares more contacts with another one; what it drives decides.
TEST(NetworkMatch, WhatANetworkDrivesCountsMoreThanItsContacts) {
  const ProgramMatch match =
      matchPrograms(readLine("LD I0.0;A I0.1;A I0.2;= Q0.0|LD I0.3;A I0.4;= Q0.1"),
                    readLine("LD I0.0;A I0.1;A I0.3;A I0.4;= Q0.1|LD I0.0;A I0.1;A I0.5;= Q0.0"));
  ASSERT_EQ(match.networks.size(), 2U);
  EXPECT_EQ(match.networks[0].before->network, 1U);
  EXPECT_EQ(match.networks[1].before->network, 0U);
}

/// Rewritten from the first contact to another coil: the title alone says that it is the same network.
TEST(NetworkMatch, ATitleFindsARewrittenNetwork) {
  const auto titled = [](const std::string& title, const std::string& text) {
    return pairSide("p.awl", mainBlock("Network 1 // " + title + "\n" + text), "").program;
  };
  const Program before = titled("Lamp", "LD I0.0\n= Q0.0\n");
  EXPECT_EQ(matchPrograms(before, titled("Lamp", "LDN I0.5\n= Q0.1\n")).networks.size(), 1U);
  EXPECT_EQ(matchPrograms(before, titled("Horn", "LDN I0.5\n= Q0.1\n")).networks.size(), 2U);
}

TEST(NetworkMatch, AWordOperationIsAResultThoughItsNameBeginsLikeAContact) {
  // ANDW, ORB, ATT and ATH write what they name (001:5553, 001:6260, 001:3583); contacts and AENO only read.
  for (const std::string result : {"ANDW VW0,VW2", "ORB VB0,VB2", "ATT VW0,VW200", "ATH VB0,VB10,4"}) {
    const ProgramMatch match =
        matchPrograms(readLine("LD I0.0;A I0.1;A I0.2;AENO;" + result), readLine("LDN I0.5;AN I0.6;AN I0.7;" + result));
    ASSERT_EQ(match.networks.size(), 1U) << result;
    EXPECT_TRUE(match.networks[0].before && match.networks[0].after) << result;
  }
  const ProgramMatch reads =
      matchPrograms(readLine("LD I0.0;A I0.1;A I0.2;AENO;= Q0.0"), readLine("LDN I0.5;AN I0.6;AN I0.7;AENO;= Q0.1"));
  EXPECT_EQ(reads.networks.size(), 2U);
}

TEST(NetworkMatch, FormsOfAConstantAreOneNumber) {
  const ProgramMatch match = matchPrograms(readLine("LD I0.0;MOVW 16#10,VW0"), readLine("LD I0.0;MOVW +16,VW0"));
  EXPECT_TRUE(match.networks[0].isSame);
}

TEST(NetworkMatch, TheMapTranslatesAddresses) {
  AddressPairs pairs;
  ASSERT_TRUE(pairs.add({Area::I, 0}, {Area::I, 8}, 1));
  const ProgramMatch match = matchPrograms(readLine("LD I0.0;= Q0.0"), readLine("LD I1.0;= Q0.0"), pairs);
  ASSERT_EQ(match.networks.size(), 1U);
  EXPECT_TRUE(match.networks[0].isSame);
}

}  // namespace rungproof::test
