// The stack run on idioms of real programs, legal and not. Expected results follow from the manual's stack rules
// (001:2727-2870, 001:3994-4004, 001:6765) beside each program.
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

/// Ids of all STK findings that are warnings or errors, in program order.
std::string stackFindings(std::string text) {
  const Linted linted(std::move(text));
  std::string result;
  for (const char* id : {"STK001", "STK002", "STK003", "STK004", "STK005"}) {
    for (const std::uint32_t line : linted.lines(id))
      result += std::string(result.empty() ? "" : " ") + id + ":" + std::to_string(line);
  }
  return result;
}

struct Case {
  const char* name;
  const char* text;
  const char* expected;
};

class StackRules : public ::testing::TestWithParam<Case> {};

TEST_P(StackRules, Reports) { EXPECT_EQ(stackFindings(GetParam().text), GetParam().expected) << GetParam().text; }

const Case cases[] = {
    // LPS, LRD and LPP around branches, one of them joined by ALD.
    {"Branches", "Network 1\nLD I0.0\nLPS\nA I0.1\n= Q0.0\nLRD\nLD I0.2\nO I0.3\nALD\n= Q0.1\nLPP\nA I0.4\n= Q0.2\n",
     ""},
    // The text that the editor shows for RS: LPP is followed by ALD.
    {"Bistable", "Network 1\nLD I0.0\nLD I0.1\nNOT\nLPS\nA Q0.0\n= Q0.0\nLPP\nALD\nO Q0.0\n= Q0.0\n", ""},
    // Power flow of a call kept in L60.0 and L63.7 (001:6809).
    {"EditorCall",
     "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= L60.0\nLD I0.1\n= L63.7\nLD L60.0\nCALL SBR0, "
     "L63.7\nEND_ORGANIZATION_BLOCK\n"
     "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nOn:BOOL;\nEND_VAR\nBEGIN\nNetwork 1\nLD L0.0\n= "
     "Q0.0\nEND_SUBROUTINE_BLOCK\n",
     ""},
    // A called block begins with 1 on the stack (001:6765), here over two networks without a load.
    {"BlockEntry", "LD SM0.0\nCALL 1\nMEND\nSBR 1\nMOVB 1, VB0\nINCB VB0\nLD I0.0\n= Q0.0\nRET\n", ""},
    // LSCR puts the step bit on the stack; the network behind it may use it.
    {"Step", "Network 1\nLSCR S0.0\nNetwork 2\n= Q0.0\nNetwork 3\nLD I0.0\nSCRT S0.0\nNetwork 4\nSCRE\n", ""},
    // The body of a loop runs with 1 on the stack (001:5770).
    {"LoopBody", "Network 1\nLD I0.0\nFOR VW0, +1, +3\nNetwork 2\nINCW VW2\nNetwork 3\nNEXT\n", ""},
    // Contacts after a coil and an inversion go on with the same value (001:2768).
    {"AfterCoil", "Network 1\nLD I0.0\n= Q0.0\nNOT\n= Q0.1\nA I0.1\n= Q0.2\n", ""},
    // Many networks: nine levels are never exceeded by what is still needed, although nothing ever pops.
    {"ManyNetworks",
     "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.0\n= Q0.1\nNetwork 3\nLD I0.0\n= Q0.2\nNetwork 4\nLD I0.0\n= "
     "Q0.3\nNetwork 5\nLD I0.0\n= Q0.4\nNetwork 6\nLD I0.0\n= Q0.5\n"
     "Network 7\nLD I0.0\n= Q0.6\nNetwork 8\nLD I0.0\n= Q0.7\nNetwork 9\nLD I0.0\n= Q1.0\nNetwork 10\nLD I0.0\n= "
     "Q1.1\nNetwork 11\nLD I0.0\n= Q1.2\n",
     ""},
    {"CounterUpDown", "Network 1\nLD I0.0\nLD I0.1\nLD I0.2\nCTUD C1, +5\nNetwork 2\nLD C1\n= Q0.0\n", ""},
    {"CounterUpDownShort", "Network 1\nLD I0.0\nLD I0.1\nCTUD C1, +5\n", "STK004:4"},
    {"CounterTooMany", "Network 1\nLD I0.0\nLD I0.1\nLD I0.2\nCTU C1, +5\n", "STK004:5"},
    // The count input was loaded in the network before and used by nothing: cut in two on purpose, no error.
    {"CounterOverTwoNetworks", "Network 1\nLD I0.0\nNetwork 2\nLD I0.1\nCTU C1, +5\n", "STK002:5"},
    {"MissingLoad", "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nA I0.1\n= Q0.1\n", "STK002:5"},
    {"AldWithOneLoad", "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\nALD\n= Q0.1\n", "STK002:6"},
    {"LppAlone", "Network 1\nLD I0.0\nLPP\n= Q0.0\n", "STK002:3 STK003:3"},
    {"LoadBehindLps", "Network 1\nLD I0.0\nLPS\nLD I0.1\n= Q0.0\nLPP\n= Q0.1\n", "STK003:6"},
    {"UnusedLoad", "Network 1\nLD I0.0\nLD I0.1\n= Q0.0\n", "STK003:2"},
    {"LdsBeyond", "Network 1\nLD I0.0\nLDS 3\nALD\n= Q0.0\n", "STK005:3"},
    {"LdsInside", "Network 1\nLD I0.0\nLD I0.1\nLDS 1\nALD\nALD\n= Q0.0\n", ""},
};

INSTANTIATE_TEST_SUITE_P(Idioms, StackRules, ::testing::ValuesIn(cases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace rungproof::testing
