// Places that keep their names, symbols beside addresses, requirements above statements.
#include "frontend/acceptance/page_text.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "frontend/acceptance/record_of.hpp"

namespace rungproof {
namespace {

TEST(PlaceName, IsMadeOfTheNameAlone) {
  EXPECT_EQ(placeName("star and delta: exclude each other!"), "star-and-delta-exclude-each-other");
  EXPECT_EQ(placeName("network MAIN 3"), "network-MAIN-3");
  EXPECT_EQ(placeName("Schütz fällt ab"), "Schütz-fällt-ab");
  EXPECT_EQ(placeName("急停"), "急停");
  EXPECT_EQ(placeName("<>&\""), "unnamed") << "nothing that would need escapes in a link";
}

TEST(PlaceNames, NoPlaceIsGivenTwice) {
  PlaceNames names;
  EXPECT_EQ(names.of("stop"), "stop");
  EXPECT_EQ(names.of("stop"), "stop-2");
  EXPECT_EQ(names.of("stop 2"), "stop-2-2");
  EXPECT_EQ(names.of("stop!"), "stop-3");
}

const AddressNames& names() {
  static const AddressNames all({{"Q0.0", "Left", "contactor left"}, {"T37", "Pause", ""}, {"VW10", "Level", ""}});
  return all;
}

TEST(AddressNames, PutsSymbolsBehindAddressesAndAddressesBehindSymbols) {
  EXPECT_EQ(
      names().markedStatement("prove left: never Q0.0 and T37.value > 5"),
      "prove left: never Q0.0 <span class=\"also\">Left</span> and T37.value <span class=\"also\">Pause</span> &gt; 5");
  EXPECT_EQ(names().markedStatement("reach x: left and not I0.0"),
            "reach x: left <span class=\"also\">Q0.0</span> and not I0.0");
}

TEST(AddressNames, LeavesSentencesAlone) {
  EXPECT_EQ(names().marked("what is left stays; Q0.0 is written."),
            "what is left stays; Q0.0 <span class=\"also\">Left</span> is written.");
  EXPECT_EQ(names().marked("VW10 (Level) is read"), "VW10 (Level) is read") << "it is named already";
  EXPECT_EQ(names().marked("a < b & c"), "a &lt; b &amp; c");
}

TEST(Requirement, IsTheCommentOfTheNextStatementOnly) {
  const SourceFile file("press.prop",
                        "# SR-1: never both.\n"  // 1
                        "# See the risk assessment.\n"
                        "prove a: never Q0.0 and Q0.1\n"
                        "prove b: never Q0.1 and Q0.0   # the other way\n"
                        "\n"
                        "prove c: VB0 < 16#1F\n");
  EXPECT_EQ(requirementAbove(file, 3), "SR-1: never both. See the risk assessment.");
  EXPECT_EQ(requirementAbove(file, 4), "the other way") << "the comment is that of statement a";
  EXPECT_EQ(requirementAbove(file, 6), "") << "16#1F begins no comment, and a blank line ends what a comment is about";
}

TEST(Requirement, OfAProgramIsNoDescriptionOfTheBlock) {
  const SourceFile file("press.awl",
                        "TITLE=Press\n"
                        "// I0.0 start, Q0.0 ram.\n"
                        "//@ prove a: never Q0.0\n"
                        "// SR-2: the guard counts.\n"
                        "//@ prove b: Q0.0 implies I0.0\n");
  EXPECT_EQ(requirementAbove(file, 3), "");
  EXPECT_EQ(requirementAbove(file, 5), "SR-2: the guard counts.");
}

/// CONTRIBUTING: 001 is the System Manual of 2004; its chapter 4 begins with line 1171 of the text, chapter 6 holds 2640.
TEST(ManualTitles, StandForReferences) {
  const std::string text = withManualTitles("copied first (001:1719-1750), see 001:13997");
  EXPECT_EQ(text.find("001:"), std::string::npos) << text;
  EXPECT_TRUE(text.starts_with("copied first (System Manual 2004, chapter 4, ")) << text;
  EXPECT_NE(text.find("), see System Manual 2004, "), std::string::npos) << text;
  EXPECT_EQ(withManualTitles("001:1719, 001:1720"), withManualTitles("001:1719")) << "one place is named once";
  const std::string both = withManualTitles("001:1719, 001:13997");
  EXPECT_EQ(both, withManualTitles("001:1719") + "; " + withManualTitles("001:13997"));
  EXPECT_EQ(withManualTitles("16#1F, 12:30 and Q0.0"), "16#1F, 12:30 and Q0.0");
}

TEST(DataLink, IsBase64) {
  EXPECT_EQ(dataLink("text/csv", ""), "data:text/csv;base64,");
  EXPECT_EQ(dataLink("text/csv", "M"), "data:text/csv;base64,TQ==");  // RFC 4648, section 10, for f, fo, foo alike
  EXPECT_EQ(dataLink("text/csv", "foob"), "data:text/csv;base64,Zm9vYg==");
  EXPECT_EQ(dataLink("text/csv", "foobar"), "data:text/csv;base64,Zm9vYmFy");
}

TEST(PageDate, FollowsSourceDateEpoch) {
  ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);  // 2023-11-14 22:13:20 UTC
  EXPECT_EQ(pageDate(), "2023-11-14 22:13 UTC");
}

}  // namespace
}  // namespace rungproof
