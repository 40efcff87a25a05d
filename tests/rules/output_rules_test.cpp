// Rules OUT and LOG on cases that their examples do not show. Lines are those of the text, from 1.
#include <gtest/gtest.h>

#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

TEST(OutputRules, DoubleCoilIsCertainOnlyWhereBothRun) {
  const Linted certain("Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.0\n");
  ASSERT_EQ(certain.of("OUT001").size(), 1U);
  EXPECT_EQ(certain.of("OUT001")[0].confirmation, Confirmation::NotNeeded);
  const Linted maybe(
      "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD I0.1\n= Q0.0\nNetwork 3\nLBL 1\nNetwork 4\nLD I0.2\n= Q0.0\n");
  ASSERT_EQ(maybe.of("OUT001").size(), 1U);
  EXPECT_EQ(maybe.of("OUT001")[0].confirmation, Confirmation::Unconfirmed);
}

TEST(OutputRules, FirstScanResetIsNoConflict) {
  EXPECT_EQ(lines("OUT002", "Network 1\nLD SM0.1\nR Q0.0, 1\nNetwork 2\nLD I0.0\n= Q0.0\n"), Lines());
  EXPECT_EQ(lines("OUT005", "Network 1\nLD SM0.1\nR Q0.0, 8\nNetwork 2\nLD I0.0\n= Q0.3\n"), Lines());
}

TEST(OutputRules, LatchesMayBeClearedByBytes) {
  EXPECT_EQ(lines("OUT004", "Network 1\nLD I0.0\nS M0.0, 1\nNetwork 2\nLD I0.1\nMOVB 0, MB0\n"), Lines());
  EXPECT_EQ(lines("OUT004", "Network 1\nLD I0.0\nS Q0.0, 2\nNetwork 2\nLD I0.1\nR Q0.0, 1\n"),
            Lines{3});  // Q0.1 stays on
}

TEST(OutputRules, HandshakeWithAnInterruptIsNoConflict) {
  const char* text = "LD SM0.1\nATCH 0, 0\nENI\nLD M0.0\nR M0.0, 1\nINCB QB0\nMEND\nINT 0\nS M0.0, 1\nRETI\n";
  EXPECT_EQ(lines("OUT006", text), Lines());
}

TEST(LogicRules, OverwrittenCoilHasNoEffectUnlessRead) {
  EXPECT_EQ(lines("LOG003", "Network 1\nLD I0.0\n= M0.0\nNetwork 2\nLD M0.0\n= Q0.0\nNetwork 3\nLD I0.1\n= M0.0\n"),
            Lines());
  EXPECT_EQ(lines("LOG003", "Network 1\nLD I0.0\n= M0.0\nNetwork 2\nLD I0.1\n= M0.0\nNetwork 3\nLD M0.0\n= Q0.0\n"),
            Lines{2});
}

TEST(LogicRules, EdgeStopsTheToggle) {
  EXPECT_EQ(lines("LOG005", "Network 1\nLD I0.0\nEU\nAN M0.0\n= M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n"), Lines());
  const Linted level("Network 1\nLD I0.0\nAN M0.0\n= M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n");
  ASSERT_EQ(level.of("LOG005").size(), 1U);
  EXPECT_EQ(level.of("LOG005")[0].confirmation, Confirmation::Unconfirmed);
}

}  // namespace
}  // namespace rungproof::testing
