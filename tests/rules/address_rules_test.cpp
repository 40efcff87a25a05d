// Rules ADR and SYM on cases that their examples do not show. Lines are those of the text, from 1.
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

TEST(AddressRules, ReadOnlyMemory) {
  EXPECT_EQ(lines("ADR003", "Network 1\nLD I0.0\nS SM29.7, 1\nS SM30.0, 1\nMOVW +1, SMW28\n"), (Lines{3, 5}));
  EXPECT_EQ(lines("ADR005", "Network 1\nLD M0.0\nMOVB 0, IB2\nMOVB IB2, MB1\n"), Lines{3});
}

TEST(AddressRules, HalvesAreNoOverlapButPartsAre) {
  EXPECT_EQ(lines("ADR007", "Network 1\nLD SM0.0\nMOVD +1, VD100\nMOVW VW102, VW0\nMOVB VB103, VB2\n"), Lines());
  EXPECT_EQ(lines("ADR007", "Network 1\nLD SM0.0\nMOVD +1, VD100\nMOVW +1, VW103\n"), Lines{4});
  EXPECT_EQ(lines("ADR007", "Network 1\nLD SM0.0\nMOVW VW101, VW0\nMOVW VW102, VW2\n"),
            Lines());  // nothing writes them
}

TEST(AddressRules, EditorBytesAreForTheEditor) {
  EXPECT_EQ(lines("ADR008", "Network 1\nLD I0.0\n= L60.0\nNetwork 2\nLD L60.0\n= Q0.0\n"),
            Lines{5});  // read in another network
}

TEST(AddressRules, WritersOfAnyKindCount) {
  EXPECT_EQ(lines("ADR010", "Network 1\nLD V10.0\n= Q0.0\nNetwork 2\nLD SM0.1\nFILL +0, VW0, 20\n"), Lines());
  EXPECT_EQ(lines("ADR010", "Network 1\nLD V10.0\n= Q0.0\nNetwork 2\nLD I0.0\n= V10.1\n"),
            Lines{2});  // another bit of the byte
  EXPECT_EQ(lines("ADR010", "Network 1\nLD I0.0\nTON T37, VW20\nNetwork 2\nLD T37\n= Q0.0\n"), Lines{3});
}

TEST(AddressRules, ReadersOfAnyKindCount) {
  EXPECT_EQ(lines("ADR011", "Network 1\nLD SM0.0\nMOVW AIW0, VW0\nBMB VB0, QB0, 2\n"), Lines());
  EXPECT_EQ(lines("ADR011", "Network 1\nLD I0.0\nINCW VW0\n"), Lines{3});  // reads itself only
  EXPECT_EQ(lines("ADR011", "Network 1\nLD SM0.1\nATCH 0, 21\nENI\nNetwork 2\nLD I0.0\nTON T32, +100\n"),
            Lines());  // T32 has its event
  const Linted call(
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= L60.0\nLD I0.1\n= L63.7\nLD L60.0\nCALL SBR0, L63.7, "
      "Q0.0\n"
      "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK "
      "SBR_0:SBR0\nVAR_INPUT\na:BOOL;\nEND_VAR\nVAR_OUTPUT\nc:BOOL;\nEND_VAR\nBEGIN\n"
      "Network 1\nLD #a\n= #c\nEND_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(call.lines("ADR011"), Lines());  // L63.7 is the first parameter
}

TEST(SymbolRules, TablesAreCompared) {
  const char* symbols = "Symbol\tAddress\tComment\nStart\tI0.0\ta\nGo\tI0.0\tb\nStop\tI0.1\tc\n";
  const Linted linted("Network 1\nLD Start\nA Halt\n= Q0.0\n", {}, symbols);
  EXPECT_EQ(linted.of("SYM001").size(), 1U);  // Halt
  EXPECT_EQ(linted.of("SYM002").size(), 1U);  // Start and Go
  EXPECT_EQ(linted.of("SYM003").size(), 1U);  // Stop
}

}  // namespace
}  // namespace rungproof::testing
