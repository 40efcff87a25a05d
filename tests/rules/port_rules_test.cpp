// PRT001: what a program for the S7-200 means on the S7-200 SMART and the other way round, and which of that speaks
// without --port-to.
#include <gtest/gtest.h>

#include "analysis/flow/analogue_flow.hpp"
#include "ir/s7200/cpu.hpp"
#include "lint.hpp"

namespace rungproof::testing {
namespace {

constexpr Target cpu226{s7200Cpu("226"), Edition::Edition2004}, smartCpu{s7200Cpu("ST40"), Edition::Smart28};

std::vector<Finding> ported(const std::string& networks, Target cpu, std::optional<Target> to) {
  return Linted(networks, cpu, {}, {.portTo = to}).of("PRT001");
}
std::string portedAddresses(const std::string& networks, Target cpu, std::optional<Target> to = std::nullopt) {
  std::string result;
  for (const Finding& finding : ported(networks, cpu, to)) result += (result.empty() ? "" : " ") + finding.address;
  return result;
}

TEST(Prt001, HabitsOfTheS7200SpeakOnASmart) {
  for (const auto& [text, address] :
       {std::pair{"Network 1\nLD SM0.7\n= SM30.0\n", "SM0.7"},
        std::pair{"Network 1\nLD SM0.1\nA SM0.7\nMOVB 9, SMB30\n", "SM0.7"},
        std::pair{"Network 1\nLDN SM0.7\nA I0.0\n= Q0.5\n", "SM0.7"},
        std::pair{"Network 1\nLD SM0.7\nEU\nXMT VB100, 0\n", "SM0.7"},
        std::pair{"Network 1\nLD SM0.0\nMOVB SMB28, VB10\n", "SMB28"},
        std::pair{"Network 1\nLD SM0.0\nBTI SMB29, VW10\n", "SMB29"},
        std::pair{"Network 1\nLD I0.0\nEU\nMOVB 16#83, SMB31\n", "SMB31"},
        std::pair{"Network 1\nLD I0.0\nEU\nMOVW 100, SMW32\n", "SMW32"},
        std::pair{"Network 1\nLD SM0.0\nITD AIW16, AC0\nDTR AC0, AC0\n/R 32000.0, AC0\nMOVR AC0, VD0\n", "32000.0"},
        std::pair{"Network 1\nLD SM0.0\nMOVW AIW16, VW0\n-I 6400, VW0\n", "6400"},
        std::pair{"Network 1\nLD SM0.0\nMOVW AIW16, VW0\nNetwork 2\nLD SM0.0\nITD VW0, VD4\nDTR VD4, VD4\n/R 25600.0, "
                  "VD4\n",
                  "25600.0"},
        std::pair{
            "Network 1\nLD SM0.0\nMOVR VD0, AC1\n*R 32000.0, AC1\nROUND AC1, AC1\nDTI AC1, VW4\nMOVW VW4, AQW16\n",
            "32000.0"}})
    EXPECT_EQ(portedAddresses(text, smartCpu), address) << text;
}

TEST(Prt001, HonestProgramsOfASmartAreSilent) {
  for (const char* text :
       {"Network 1\nLD SM0.7\nS M0.0, 1\n",                // the clock was lost: remembered
        "Network 1\nLD SM0.7\nTODW VB0\n",                 // and set
        "Network 1\nLD SM0.7\nO M0.0\nAN I0.0\n= M0.0\n",  // an alarm that holds itself
        "Network 1\nLD RTC_Lost\n= Q0.5\n",                // by its name on the S7-200 SMART
        "Network 1\nLDB<> SMB28, 0\n= M0.0\n",             // which signal board is there
        "Network 1\nLD SM29.0\n= M0.0\n", "Network 1\nLD SM0.0\nITD AIW16, AC0\nDTR AC0, AC0\n/R 27648.0, AC0\n",
        "Network 1\nLD I0.0\nEU\n+I 32000, VW0\n",  // no analogue value
        "Network 1\nLDW> AIW16, 32000\n= M0.0\n",   // a limit of the range
        "Network 1\nLD I0.0\nTON T37, 32000\nNetwork 2\nLD SM0.0\nMOVW AIW16, VW0\n",
        "Network 1\nLD SM0.1\nMOVB 16#C5, SMB67\nMOVW 500, SMW68\nMOVD 1000, SMD72\nPLS 0\n",
        "Network 1\nLD SM0.1\nMOVB 16#85, SMB67\nMOVW 500, SMW68\nMOVW 100, SMW70\nPLS 0\n",
        "Network 1\nLD I8.0\n= Q8.0\n"})
    EXPECT_EQ(portedAddresses(text, smartCpu), "") << text;
}

TEST(Prt001, NothingIsSaidOfAProgramThatStays) {
  EXPECT_EQ(portedAddresses("Network 1\nLD SM0.7\n= SM30.0\nNetwork 2\nLD SM0.0\nMOVB SMB28, VB0\nMOVB 16#83, SMB31\n"
                            "MOVW AIW0, VW2\n-I 6400, VW2\nNETR VB100, 0\nMOVB 16#85, SMB67\nPLS 0\n",
                            cpu226),
            "");
}

TEST(Prt001, WithPortToEveryDifferenceSpeaks) {
  for (const auto& [text, address] :
       {std::pair{"Network 1\nLD SM0.1\nMOVB 16#85, SMB67\nPLS 0\n", "SMB67"},
        std::pair{"Network 1\nLD SM0.1\nMOVB 16#DB, SMB77\nPLS 1\n", "SMB77"},
        std::pair{"Network 1\nLD SM0.1\nMOVB 16#8D, SMB67\nMOVW 500, SMW68\nPLS 0\n", "SMB67 SMW68"},
        std::pair{"Network 1\nLD SM0.1\nMOVB 16#A0, SMB67\nMOVW 500, SMW168\nPLS 0\n", "SMB67 SMW168"},
        std::pair{"Network 1\nLD I0.0\nEU\nNETR VB200, 0\n", ""},
        std::pair{"Network 1\nLD SM0.1\nMOVB 2, SMB30\n", "SMB30"},
        std::pair{"Network 1\nLD SM0.1\nHDEF 1, 0\n", "HC1"},       // I0.6 becomes I0.1
        std::pair{"Network 1\nLD SM0.1\nHDEF 3, 0\n", "HC3"},       // I0.1 becomes I0.3
        std::pair{"Network 1\nLD I3.0\nA I4.5\n= Q0.0\n", "I3.0"},  // one finding for the area
        std::pair{"Network 1\nLD I0.0\n= Q2.0\n", "Q2.0"}, std::pair{"Network 1\nLD SM0.0\nMOVW AIW4, VW0\n", "AIW4"},
        std::pair{"Network 1\nLD SM0.0\nMOVB SMB6, VB0\n", "SMB6"},
        std::pair{"Network 1\nLD SM0.7\nS M0.0, 1\n", "SM0.7"},
        std::pair{"Network 1\nLDB> SMB28, 100\n= Q0.0\n", "SMB28"}})
    EXPECT_EQ(portedAddresses(text, cpu226, smartCpu), address) << text;
}

TEST(Prt001, WhatTheCpuLacksIsToldByTheRulesOfLimits) {
  const auto message = [](const std::string& text, Target from, Target to) {
    const auto findings = ported(text, from, to);
    return findings.size() == 1 ? std::string(findings[0].message) : std::to_string(findings.size()) + " findings";
  };
  EXPECT_TRUE(message("Network 1\nLD I0.0\nEU\nNETW VB200, 0\n", cpu226, smartCpu).starts_with("on a CPU ST40: "));
  // HDEF mode 12 exists on the S7-200 only; HDEF 0, 2 is a mode with a start input.
  EXPECT_TRUE(message("Network 1\nLD SM0.1\nHDEF 0, 12\n", cpu226, smartCpu).starts_with("on a CPU ST40: "));
  // VB20000 is there on an ST40 (V2.8: VB20479) and not on a 226 (VB10239).
  EXPECT_TRUE(message("Network 1\nLD I0.0\nMOVB 1, VB20000\n", smartCpu, cpu226).starts_with("on a CPU 226: "));
  // Ten levels of the stack, and an instruction that only the S7-200 SMART has.
  std::string deep = "Network 1\n";
  for (const char* input : {"I0.0", "I0.1", "I0.2", "I0.3", "I0.4", "I0.5", "I0.6", "I0.7", "I1.0", "I1.1"})
    deep += std::string("LD ") + input + "\n";
  for (int i = 0; i < 9; ++i) deep += "OLD\n";
  EXPECT_TRUE(message(deep + "= Q0.0\n", smartCpu, cpu226).starts_with("on a CPU 226: "));
  EXPECT_TRUE(message("Network 1\nLD I0.0\nEU\nGET VB200\n", smartCpu, cpu226).starts_with("on a CPU 226: "));
  // From one S7-200 to a smaller one.
  EXPECT_TRUE(message("Network 1\nLD I0.0\nMOVB 1, VB5000\n", cpu226, {s7200Cpu("222"), Edition::Edition2004})
                  .starts_with("on a CPU 222: "));
}

TEST(Prt001, TheWayBackToTheS7200) {
  for (const auto& [text, address] :
       {std::pair{"Network 1\nLD SM0.1\nMOVB 16#C5, SMB67\nPLS 0\n", "SMB67"},
        std::pair{"Network 1\nLD SM0.7\nS M0.0, 1\n", "SM0.7"}, std::pair{"Network 1\nLD I8.0\n= Q0.0\n", "I8.0"},
        std::pair{"Network 1\nLD SM0.0\nITD AIW16, AC0\nDTR AC0, AC0\n/R 27648.0, AC0\n", "27648.0 AIW16"},
        std::pair{"Network 1\nLD SM0.1\nMOVB 16#C0, SMB67\nMOVW 2000, SMW68\nPLS 0\n", "SMB67 SMW68"},
        std::pair{"Network 1\nLD SM0.1\nHDEF 2, 0\n", "HC2"}})  // I0.2 becomes I1.2
    EXPECT_EQ(portedAddresses(text, smartCpu, cpu226), address) << text;
}

TEST(Prt001, WhatIsTheSameOnBothIsSilent) {
  for (const char* text : {"Network 1\nLD I0.0\nAN I0.1\nTON T37, 50\nNetwork 2\nLD T37\n= Q0.0\n",
                           "Network 1\nLD SM0.1\nHDEF 0, 0\n",                     // I0.0 on both
                           "Network 1\nLD SM0.1\nMOVB 9, SMB30\n",                 // freeport
                           "Network 1\nLD SM0.0\nMOVW VW0, VW2\n+I 32000, VW2\n",  // no analogue value
                           "Network 1\nLD I2.7\n= Q1.7\n",                         // points of a 226 and of an ST40
                           "Network 1\nLD SM0.1\nMOVB 0, SMB67\nPLS 0\n",          // the output is switched off
                           "Network 1\nLD I0.0\nMOVB 16#85, VB67\n"})
    EXPECT_EQ(portedAddresses(text, cpu226, smartCpu), "") << text;
}

TEST(Prt001, SaysWhichControlByteIsRight) {
  const auto findings = ported("Network 1\nLD SM0.1\nMOVB 16#85, SMB67\nPLS 0\n", cpu226, smartCpu);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, Severity::Error);
  EXPECT_EQ(findings[0].help, "write 16#C5");
  EXPECT_NE(findings[0].message.find("selects a pulse train on the S7-200"), std::string::npos) << findings[0].message;
}

TEST(AnalogueFlow, GoesThroughMovesAndArithmetic) {
  const Linted linted(
      "Network 1\nLD SM0.0\nMOVW AIW0, VW0\n+I 5, VW0\nMOVW VW10, VW12\nNetwork 2\nLD SM0.0\nMOVW VW0, VW4\n"
      "Network 3\nLD SM0.0\nMOVW VW20, VW22\nMOVW VW22, AQW0\n");
  const AnalogueFlow flow(*linted.facts);
  std::string concerned;
  for (const InstructionPlace& place : linted.facts->instructions())
    concerned += flow.concerns(place.instruction->id) ? '1' : '0';
  // LD, MOVW, +I, MOVW (other words), LD, MOVW, LD, MOVW (towards AQW0), MOVW
  EXPECT_EQ(concerned, "011001011");
}

}  // namespace
}  // namespace rungproof::testing
