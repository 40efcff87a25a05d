// Blocks that exclude each other may write the same place: what OUT006 says of dispatchers, modes, steps, and of what
// only looks like them.
#include "analysis/flow/exclusion.hpp"

#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

/// Networks of a block; ';' ends a line, '|' begins a network.
std::string networks(const std::string& lines) {
  std::string text;
  int number = 0;
  for (const char c : "|" + lines) {
    if (c == '|')
      text += "\nNetwork " + std::to_string(++number) + "\n";
    else
      text += c == ';' ? '\n' : c;
  }
  return text + "\n";
}

std::string program(const std::string& main, const std::vector<std::string>& subroutines) {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN" + networks(main) + "END_ORGANIZATION_BLOCK\n";
  for (std::size_t i = 0; i < subroutines.size(); ++i) {
    const std::string number = std::to_string(i);
    text += "SUBROUTINE_BLOCK SBR_" + number + ":SBR" + number + "\nBEGIN" + networks(subroutines[i]) +
            "END_SUBROUTINE_BLOCK\n";
  }
  return text;
}

/// What OUT006 finds where both subroutines write Q0.2 and VW10.
std::vector<std::string> exclusiveFindings(const std::string& main) {
  return Linted(program(main, {"LD I1.2;= Q0.2;MOVW 1, VW10", "LD I1.3;= Q0.2;MOVW 2, VW10"})).messages("OUT006");
}

TEST(Exclusion, DispatchersCallOneBlockAtATime) {
  for (const char* main :
       {"LDB= VB0, 1;CALL SBR0|LDB= VB0, 2;CALL SBR1", "LD SM0.0;AW= VW0, 10;CALL SBR0|LD SM0.0;AW= VW0, 20;CALL SBR1",
        "LDD= 5, VD0;CALL SBR0|LDD= VD0, 6;CALL SBR1", "LDB< VB0, 5;CALL SBR0|LDB>= VB0, 5;CALL SBR1",
        "LDW<= VW0, 16#FFFF;CALL SBR0|LDW= VW0, 0;CALL SBR1",  // words compare signed (001:3372)
        "LDB= VB0, 1;A I0.0;CALL SBR0|LD I0.1;AB= VB0, 2;CALL SBR1",
        "LD SM0.0;LPS;AB= VB0, 1;CALL SBR0;LPP;AB= VB0, 2;CALL SBR1",
        "LDB= VB0, 1;= M1.1|LDB= VB0, 2;= M1.2|LD M1.1;CALL SBR0|LD M1.2;CALL SBR1",
        "LDB= VB0, 1;LD I0.0;O I0.1;ALD;CALL SBR0|LDB= VB0, 2;CALL SBR1"})
    EXPECT_EQ(exclusiveFindings(main), std::vector<std::string>()) << main;
}

TEST(Exclusion, ModesExcludeEachOther) {
  for (const char* main :
       {"LD I0.0;CALL SBR0|LDN I0.0;CALL SBR1", "LD M0.0;A I0.1;CALL SBR0|LDN M0.0;CALL SBR1",
        "LD I0.0;= M0.0|LD M0.0;CALL SBR0|LDN I0.0;CALL SBR1", "LD I0.0;EU;CALL SBR0|LDN I0.0;CALL SBR1"})
    EXPECT_EQ(exclusiveFindings(main), std::vector<std::string>()) << main;
}

TEST(Exclusion, StepsOfAChainFollowEachOther) {
  const std::string chain =
      "LD SM0.1;S S0.0, 1|LSCR S0.0|LD SM0.0;CALL SBR0|LD I0.0;SCRT S0.1|SCRE|LSCR S0.1|LD SM0.0;CALL SBR1|LD "
      "I0.1;SCRT S0.0|SCRE";
  EXPECT_EQ(exclusiveFindings(chain), std::vector<std::string>());
  // Two steps that are entered together run together.
  const std::string fork =
      "LD SM0.1;S S0.0, 1|LSCR S0.0|LD I0.0;SCRT S0.1;SCRT S0.2|SCRE|LSCR S0.1|LD SM0.0;CALL SBR0|SCRE|LSCR S0.2|LD "
      "SM0.0;CALL SBR1|SCRE";
  EXPECT_EQ(exclusiveFindings(fork).size(), 2U);
  EXPECT_EQ(exclusiveFindings(chain + "|LD I0.7;S S0.1, 1").size(), 2U) << "a step that is set from elsewhere";
}

TEST(Exclusion, WhatOverlapsIsNoExclusion) {
  for (const char* main :
       {"LD I0.0;CALL SBR0|LD I0.1;CALL SBR1", "LDB= VB0, 1;CALL SBR0|LDB= VB0, 1;CALL SBR1",
        "LDB= VB0, 1;CALL SBR0|LDB= VB1, 2;CALL SBR1", "LDB<= VB0, 5;CALL SBR0|LDB>= VB0, 5;CALL SBR1",
        "LDB= VB0, 1;O I0.0;CALL SBR0|LDB= VB0, 2;CALL SBR1", "LDB= VB0, 1;CALL SBR0|LDB<> VB0, 2;CALL SBR1",
        "LDB= VB0, 1;LD I0.0;OLD;CALL SBR0|LDB= VB0, 2;CALL SBR1", "LD I0.0;ED;CALL SBR0|LDN I0.0;CALL SBR1",
        "LD I0.0;NOT;CALL SBR0|LDN I0.0;CALL SBR1", "LDB= VB0, 1;CALL SBR0|LDB= VB0, 2;CALL SBR1|LD I0.7;CALL SBR1"})
    EXPECT_EQ(exclusiveFindings(main).size(), 2U) << main;
}

/// A coil writes in every scan in which its block runs; a move only where its rung is closed.
TEST(Exclusion, RungsDecideOverMovesButNotOverCoils) {
  const std::string both = "LD SM0.0;CALL SBR0|LD SM0.0;CALL SBR1";
  EXPECT_EQ(Linted(program(both, {"LDB= VB0, 1;MOVW 1, VW10", "LDB= VB0, 2;MOVW 2, VW10"})).messages("OUT006"),
            std::vector<std::string>());
  EXPECT_EQ(Linted(program(both, {"LDB= VB0, 1;= Q0.2", "LDB= VB0, 2;= Q0.2"})).messages("OUT006").size(), 1U);
}

/// One memory for two calls is no harm where one of them runs at a time.
TEST(Exclusion, ASharedRoutineMayBeCalledInTurns) {
  const auto shared = [](const std::string& main) {
    return Linted(program(main, {"LD I1.2;EU;= Q0.2"})).messages("SUB006").size();
  };
  EXPECT_EQ(shared("LDB= VB0, 1;CALL SBR0|LDB= VB0, 2;CALL SBR0"), 0U);
  EXPECT_EQ(shared("LD I0.0;CALL SBR0|LDN I0.0;CALL SBR0"), 0U);
  EXPECT_EQ(shared("LD I0.0;CALL SBR0|LD I0.1;CALL SBR0"), 1U);
  EXPECT_EQ(shared("LDB= VB0, 1;CALL SBR0|LDB= VB0, 2;CALL SBR0|LDB= VB0, 2;CALL SBR0"), 1U);
}

TEST(Exclusion, CallsOfCallsHandTheirConditionsDown) {
  EXPECT_EQ(Linted(program("LDB= VB0, 1;CALL SBR0|LDB= VB0, 2;CALL SBR1",
                           {"LD I0.0;CALL SBR2", "LD I1.3;= Q0.2", "LD I1.2;= Q0.2"}))
                .messages("OUT006"),
            std::vector<std::string>());
}

/// Ten blocks that write one word are one line.
TEST(Exclusion, AllWritersOfAWordAreOneFinding) {
  std::string main;
  std::vector<std::string> blocks;
  for (int i = 0; i < 10; ++i) {
    main += (i == 0 ? "LD I0." : "|LD I0.") + std::to_string(i % 8) + ";CALL SBR" + std::to_string(i);
    blocks.push_back("LD SM0.0;MOVW " + std::to_string(i) + ", VW10");
  }
  EXPECT_EQ(Linted(program(main, blocks)).messages("OUT006").size(), 1U);
}

TEST(Exclusion, WhatTheTextLeavesOpenIsUnconfirmed) {
  const auto confirmationOf = [](const std::string& main) {
    return Linted(program(main, {"LD I1.2;= Q0.2", "LD I1.3;= Q0.2"})).of("OUT006").at(0).confirmation;
  };
  EXPECT_EQ(confirmationOf("LD SM0.0;CALL SBR0|LD SM0.0;CALL SBR1"), Confirmation::NotNeeded);
  EXPECT_EQ(confirmationOf("LD I0.0;CALL SBR0|LD I0.1;CALL SBR1"), Confirmation::Unconfirmed);
}

}  // namespace
}  // namespace rungproof::testing
