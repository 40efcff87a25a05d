// What hover says: instructions, addresses with their users, timers, special memory, blocks, pictures.
#include "tests/editor/editor_session.hpp"
#include "tests/editor/press.hpp"

namespace rungproof::test {
namespace {

class HoverTest : public testing::Test {
 protected:
  HoverTest() { session_.open(press); }
  void expect(int line, int character, std::initializer_list<std::string> parts) {
    const std::string text = session_.hover(line, character);
    for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  EditorSession session_;
};

TEST_F(HoverTest, InstructionWithTheLimitsOfTheCpu) {
  // T32 to T63 and T96 to T255 are TON/TOF timers (001:6598); table 6-2 ends the 226 at T255 and VW10238 (001:2697).
  expect(13, 1, {"TON: on-delay timer", "32 to 63; 96 to 255", "CPU 226", "T255", "VW10238"});
}

TEST_F(HoverTest, TimerWithResolutionPresetWritersAndReaders) {
  // T37 counts 100 ms (001:6598): 100 of them are 10 s.
  expect(13, 5,
         {"resolution 100 ms", "Preset +100 in network 3: 10 s", "Written by", "line 14: `TON T37, +100`", "Read by",
          "line 15: `LD T37`"});
}

TEST_F(HoverTest, OutputWithWriterAndReader) {
  expect(9, 4, {"**Q0.0**", "MAIN network 1, line 7: `= Q0.0`", "MAIN network 2, line 10: `AN Q0.0`"});
  expect(4, 4, {"**I0.0**", "No instruction writes it."});
}

TEST_F(HoverTest, SpecialMemoryHasItsMeaning) { expect(18, 4, {"SM0.1: first scan", "read-only"}); }

TEST_F(HoverTest, AddressInAProperty) {
  // "//@ prove never both: never Q0.0 and Q0.1": Q0.0 begins at 28.
  expect(3, 30, {"**Q0.0**", "Written by"});
}

TEST_F(HoverTest, HeadingShowsThePicture) { expect(7, 2, {"MAIN (OB1)", "Network 2", "Q0.1", "──"}); }

TEST_F(HoverTest, CallNamesTheBlock) { expect(16, 6, {"SBR_0"}); }

TEST_F(HoverTest, NothingToSay) {
  EXPECT_EQ(session_.hover(1, 2), "");
  EXPECT_EQ(session_.hover(4, 14), "");  // in a comment
  EXPECT_EQ(session_.hover(4000, 14), "");
}

TEST(Hover, SymbolsWithTheirAddressAndComment) {
  EditorSession session;
  session.open(
      "SYMBOL_TABLE\nStart,I0.0,green button\nEND_SYMBOL_TABLE\nORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n"
      "Network 1\nLD Start\n= Q0.0\nEND_ORGANIZATION_BLOCK\n");
  const std::string text = session.hover(6, 4);
  EXPECT_NE(text.find("**I0.0** Start: green button"), std::string::npos) << text;
}

TEST(Hover, AnotherCpuHasOtherLimits) {
  EditorSession session({"--cpu", "221"});
  session.open("Network 1\nLD SM0.0\nMOVW 1, VW10\n");
  // Table 6-2: V memory of the 221 ends with VB2047, so its last word is VW2046 (001:2697).
  EXPECT_NE(session.hover(2, 1).find("VW2046"), std::string::npos) << session.hover(2, 1);
}

// Names of a source are shown as the source has them, not as places and numbers that they became.
TEST(Hover, LocalsBlocksAndLabelsOfAStep7Source) {
  EditorSession session({"--dialect", "s7-300"});
  session.open(
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  n : INT;\nEND_VAR\nBEGIN\nNETWORK\n      L #n;\n      T MW 0;\n"
      "      JU M001;\nM001: NOP 0;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      CALL FB 1 , DB 1 ( n := 3 );\nEND_ORGANIZATION_BLOCK\n");
  const std::string local = session.hover(6, 9);
  EXPECT_NE(local.find("**#n** of FB1, input"), std::string::npos) << local;
  EXPECT_NE(local.find("This block does not write it."), std::string::npos) << local;
  EXPECT_NE(local.find("Read by\n\n- FB1 network 1, line 7: `L #n`"), std::string::npos) << local;
  EXPECT_EQ(local.find("DBW"), std::string::npos) << local;
  EXPECT_NE(session.hover(8, 10).find("Label M001"), std::string::npos) << session.hover(8, 10);
  const std::string called = session.hover(18, 12);
  EXPECT_NE(called.find("FB1"), std::string::npos) << called;
  EXPECT_EQ(called.find("196609"), std::string::npos) << called;
}

TEST(Hover, APictureOnRequest) {
  EditorSession session;
  session.open(press);
  const Json picture = at(session.request("rungproof/network", session.place(9, 0)), "result");
  EXPECT_EQ(textAt(picture, "heading"), "MAIN, Network 2");
  EXPECT_NE(textAt(picture, "text").find("Q0.1"), std::string::npos);
  EXPECT_EQ(textAt(picture, "svg").substr(0, 4), "<svg");
  const Json shown =
      at(session.request("workspace/executeCommand",
                         {{"command", "rungproof.show"},
                          {"arguments", Json::array({untitled, Json{{"line", 9}, {"character", 0}}, "stl"})}}),
         "result");
  EXPECT_NE(textAt(shown, "text").find("AN     Q0.0"), std::string::npos) << textAt(shown, "text");
  EXPECT_EQ(numberAt(session.request("rungproof/network", session.place(24, 0)), "error/code"), "-32803");
}

}  // namespace
}  // namespace rungproof::test
