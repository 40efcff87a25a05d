// ADR012: words of a panel that the program uses for itself.
#include <gtest/gtest.h>

#include "analysis/panel/panel_words.hpp"
#include "lint.hpp"

namespace rungproof::testing {
namespace {

PanelTag panelTag(const char* name, const char* address, TagAccess access = TagAccess::Unknown) {
  PanelTag result;
  result.name = name;
  result.address = *Linted::operandLookup(Program{})(address);
  result.access = access;
  return result;
}

/// Addresses of the findings, joined by blanks.
std::string panelWordsOf(const std::string& networks, std::vector<PanelTag> tags = {}, std::string_view symbols = {}) {
  const Linted linted(networks, {}, symbols, {.tags = std::move(tags)});
  std::string result;
  for (const Finding& finding : linted.of("ADR012")) result += (result.empty() ? "" : " ") + finding.address;
  return result;
}

TEST(Adr012, FindsScratchInDeclaredWords) {
  for (const auto& [text, address] :
       {std::pair{"//@ external VW100\nNetwork 1\nLD SM0.0\nMOVW AIW0, VW100\n+I 5, VW100\nMOVW VW100, VW4\n", "VW100"},
        // In a row of bytes the panel's word is the one that the program uses.
        std::pair{"//@ external VB100..VB199\nNetwork 1\nLD I0.0\nMOVD VD0, VD120\n*R 2.0, VD120\nMOVD VD120, VD4\n",
                  "VD120"},
        // The value is overwritten in every scan and compared elsewhere.
        std::pair{"//@ external VW100\nNetwork 1\nLD SM0.0\nMOVW VW2, VW100\nNetwork 2\nLDW>= AIW0, VW100\n"
                  "= Q0.0\n",
                  "VW100"},
        std::pair{"//@ external VW10..VW14\nNetwork 1\nLD SM0.0\nITD VW0, AC0\nBTI VB3, VW12\nMOVW VW12, AQW0\n",
                  "VW12"},
        // A coil gives the panel's button its own value in every scan.
        std::pair{"//@ external V10.0\nNetwork 1\nLD I0.0\n= V10.0\nNetwork 2\nLD V10.0\n= Q0.0\n", "V10.0"},
        std::pair{"//@ external MB5\nNetwork 1\nLD I0.3\nMOVB IB0, MB5\nANDB 15, MB5\nMOVB MB5, QB0\n", "MB5"}})
    EXPECT_EQ(panelWordsOf(text), address) << text;
}

TEST(Adr012, FindsWordsThatReachIntoThePanels) {
  const std::string external = "//@ external VW100, VD200\n";
  for (const auto& [network, address] :
       {std::pair{"Network 1\nLD SM0.0\nMOVW AIW0, VW101\n", "VW100"},  // one byte of each
        std::pair{"Network 1\nLD SM0.0\nMOVW AIW0, VW99\n", "VW100"},   // the other side
        std::pair{"Network 1\nLD SM0.0\nMOVD AC0, VD100\n", "VW100"},   // the panel's word is the upper half
        std::pair{"Network 1\nLDW>= VW200, 5\n= Q0.0\n", "VD200"},      // the upper word of a double word
        std::pair{"Network 1\nLD SM0.0\nMOVD AC0, VD202\n", "VD200"},
        std::pair{"Network 1\nLDB> VB100, 5\n= Q0.0\n", "VW100"},
        std::pair{"Network 1\nLDD> VD198, 5\n= Q0.0\n", "VD200"}})
    EXPECT_EQ(panelWordsOf(external + network), address) << network;
  EXPECT_EQ(panelWordsOf("//@ external VB100..VB109\nNetwork 1\nLD SM0.0\nMOVW AIW0, VW109\n"), "VB109");
}

// What is written in every scan before it is read is never the panel's value, by whatever move.
TEST(Adr012, FindsWordsThatMovesOverwriteFirst) {
  const std::string external = "//@ external VW100\nNetwork 1\n", read = "Network 2\nLDW>= AIW0, VW100\n= Q0.0\n";
  for (const char* move : {"LD SM0.0\nMOVW 5, VW100\n", "LD SM0.0\nMOVD VD2, VD98\n", "LD SM0.0\nMOVD VD2, VD100\n",
                           "LD SM0.0\nMOVB VB2, VB101\n", "LD SM0.0\nBMW VW2, VW98, 4\n", "LD SM0.0\nFILL 0, VW96, 4\n",
                           "LD SM0.0\nBMB VB0, VB101, 2\n"})
    EXPECT_EQ(panelWordsOf(external + move + read), "VW100") << move;
  for (const char* move : {"LD I0.0\nMOVW 5, VW100\n",                    // on a condition: a default or a recipe
                           "LD SM0.1\nMOVD VD2, VD98\n",                  // in the first scan
                           "LD I0.0\nEU\nFILL 0, VW96, 4\n",              // once
                           "LD SM0.0\nMOVW VW100, VW2\nMOVW 0, VW100\n",  // a command that is taken and acknowledged
                           "LDW<> VW100, 0\n= Q0.1\nLD SM0.0\nFILL 0, VW96, 4\n", "LD SM0.0\nMOVD VD2, VD96\n",
                           "LD SM0.0\nFILL 0, VW102, 4\n", "LDW> VW100, 9\nMOVW 9, VW100\n"})
    EXPECT_EQ(panelWordsOf(external + move + read), "") << move;
  EXPECT_EQ(panelWordsOf(external + "LDW>= AIW0, VW100\n= Q0.0\nNetwork 2\nLD SM0.0\nFILL 0, VW96, 4\n"), "")
      << "it is read first";
  const std::string shown = external + "LD SM0.0\nFILL 0, VW96, 4\n";
  EXPECT_EQ(panelWordsOf(shown), "") << "nothing reads it";
  EXPECT_EQ(panelWordsOf("Network 1\nLD SM0.0\nMOVW 5, VW100\n" + read, {panelTag("Dose", "VW100", TagAccess::Sets)}),
            "VW100");
  EXPECT_EQ(panelWordsOf("Network 1\nLD SM0.0\nMOVW 5, VW100\n" + read, {panelTag("Level", "VW100", TagAccess::Reads)}),
            "");
}

TEST(Adr012, HonestUsesAreSilent) {
  for (const char* text :
       {// The panel's value is used.
        "//@ external VW100\nNetwork 1\nLDW>= AIW0, VW100\n= Q0.0\n",
        // A default in the first scan.
        "//@ external VW100\nNetwork 1\nLD SM0.1\nMOVW VW0, VW100\nNetwork 2\nLDW>= AIW0, VW100\n= Q0.0\n",
        // A limit.
        "//@ external VW100\nNetwork 1\nLDW> VW100, VW102\nMOVW VW102, VW100\nNetwork 2\nLDW>= AIW0, VW100\n= Q0.0\n",
        // A bit that the program acknowledges.
        "//@ external V10.0\nNetwork 1\nLD V10.0\nS M0.0, 1\nR V10.0, 1\n",
        // A value that is only shown.
        "//@ external VW100\nNetwork 1\nLD SM0.0\nMOVW AIW0, VW100\n",
        // A recipe that is loaded once.
        "//@ external VW100\nNetwork 1\nLD I0.0\nEU\nMOVW VW0, VW100\nNetwork 2\nLDW>= AIW0, VW100\n= Q0.0\n",
        // A counter that the panel may set back.
        "//@ external VW100\nNetwork 1\nLD I0.0\nEU\nINCW VW100\nNetwork 2\nLDW>= VW100, 10\n= Q0.0\n",
        // The low word of a double word, and a word made of two bytes.
        "//@ external VD200\nNetwork 1\nLDW>= VW202, 5\n= Q0.0\n",
        "//@ external VW100\nNetwork 1\nLDB> VB100, 5\nAB> VB101, 5\n= Q0.0\n",
        // Bits of the panel's word.
        "//@ external VW100\nNetwork 1\nLD V100.3\nR V100.3, 1\n= Q0.0\n",
        // Two of the words that were declared together.
        "//@ external VW100..VW118\nNetwork 1\nLDD>= VD104, 5\n= Q0.0\n",
        // A block copy of a recipe.
        "//@ external VB100..VB119\nNetwork 1\nLD I0.0\nEU\nBMB VB300, VB90, 40\n",
        // A reset by a constant while a condition holds.
        "//@ external VW100\nNetwork 1\nLD I0.0\nMOVW 0, VW100\nNetwork 2\nLDW>= AIW0, VW100\n= Q0.0\n"})
    EXPECT_EQ(panelWordsOf(text), "") << text;
}

TEST(Adr012, TagsCountByWhoSetsThem) {
  const std::string scratch = "Network 1\nLD SM0.0\nMOVW AIW0, VW100\n+I 5, VW100\nMOVW VW100, VW4\n";
  EXPECT_EQ(panelWordsOf(scratch, {panelTag("Dose", "VW100", TagAccess::Sets)}), "VW100");
  EXPECT_EQ(panelWordsOf(scratch, {panelTag("Level", "VW100", TagAccess::Reads)}), "");
  // Nobody says who sets it: one chain may be what the panel shows, two are scratch.
  EXPECT_EQ(panelWordsOf(scratch, {panelTag("Level", "VW100")}), "");
  EXPECT_EQ(
      panelWordsOf(scratch + "Network 2\nLD SM0.0\nMOVW AIW2, VW100\nMOVW VW100, VW6\n", {panelTag("Level", "VW100")}),
      "VW100");
  // Two sources of what is shown.
  EXPECT_EQ(panelWordsOf("Network 1\nLD M0.0\nMOVW VW2, VW100\nNetwork 2\nLDN M0.0\nMOVW VW4, VW100\n",
                         {panelTag("Level", "VW100")}),
            "");
  EXPECT_EQ(panelWordsOf("Network 1\nLD I0.0\n= V10.0\nNetwork 2\nLD V10.0\n= Q0.0\n", {panelTag("Running", "V10.0")}),
            "");
}

TEST(Adr012, SymbolsMaySayThatThePanelSetsThem) {
  const std::string scratch = "Network 1\nLD SM0.0\nMOVW AIW0, VW100\n+I 5, VW100\nMOVW VW100, VW4\n";
  EXPECT_EQ(panelWordsOf(scratch, {}, "Dose\tVW100\tsetpoint, set by the HMI\n"), "VW100");
  EXPECT_EQ(panelWordsOf(scratch, {}, "Dose\tVW100\t触摸屏设定\n"), "VW100");
  EXPECT_EQ(panelWordsOf(scratch, {}, "Dose\tVW100\tshown on the HMI\n"), "");
  EXPECT_EQ(panelWordsOf(scratch, {}, "Dose\tVW100\tset by the operator\n"), "");
}

TEST(Adr012, SaysWhoseWordItIs) {
  const Linted linted("Network 1\nLD SM0.0\nMOVW AIW0, VW100\n+I 5, VW100\nMOVW VW100, VW4\n", {}, {},
                      {.tags = {panelTag("Dose", "VW100", TagAccess::Sets)}});
  const auto findings = linted.of("ADR012");
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].message, "MOVW AIW0, VW100 writes VW100 (Dose), which is set from outside the program");
}

TEST(SpeaksOfSetting, KnowsFourLanguages) {
  for (const char* text : {"Speed_Set", "SpeedSP", "set point", "Sollwert Menge", "Vorgabe", "Recipe 1",
                           "уставка давления", "设定速度", "Param_7"})
    EXPECT_TRUE(speaksOfSetting(text)) << text;
  for (const char* text : {"Speed", "Offset", "Speed_Actual", "Istwert", "Reset", "settled", "当前速度", "Spare"})
    EXPECT_FALSE(speaksOfSetting(text)) << text;
}

}  // namespace
}  // namespace rungproof::testing
