// A document in SCL: its words are what the text has, not the instructions that it becomes, and nothing changes them.
#include "tests/editor/editor_session.hpp"

namespace rungproof::test {
namespace {

const std::string sclUri = "untitled:Motor.scl";
const std::string sclText =
    "FUNCTION FC 1 : INT\nVAR_INPUT\n  x : INT;\nEND_VAR\nBEGIN\n"
    "    IF #x > 3 THEN\nFC1 := #x / 2;\n    END_IF;\nEND_FUNCTION\n"
    "ORGANIZATION_BLOCK OB 1\nBEGIN\n  MW10 := FC1(x := WORD_TO_INT(IW0));\nEND_ORGANIZATION_BLOCK\n";

TEST(SclDocument, IsFormattedAndRenamedByNobody) {
  EditorSession session;
  session.open(sclText, sclUri);
  const Json edits =
      at(session.request("textDocument/formatting", {{"textDocument", Json{{"uri", sclUri}}},
                                                     {"options", Json{{"tabSize", 2}, {"insertSpaces", true}}}}),
         "result");
  EXPECT_EQ(edits.items().size(), 0U) << edits.dump(1);
  EXPECT_EQ(session.ask("textDocument/prepareRename", 5, 8, sclUri).dump(), "null");
  Json place = session.place(5, 8, sclUri);
  place["newName"] = "level";
  EXPECT_EQ(textAt(session.request("textDocument/rename", place), "error/message"),
            "names in SCL are not changed here");
}

TEST(SclDocument, NoInstructionIsShownThatNobodyWrote) {
  EditorSession session;
  session.open(sclText, sclUri);
  const Json outline =
      at(session.request("textDocument/documentSymbol", {{"textDocument", Json{{"uri", sclUri}}}}), "result");
  EXPECT_EQ(outline.dump().find("LABEL"), std::string::npos) << outline.dump(1);
  // On #x, on the division and on IW0.
  for (const auto& [line, character] : {std::pair{5, 8}, {6, 10}, {11, 35}}) {
    const Json hover = session.ask("textDocument/hover", line, character, sclUri);
    for (const char* mnemonic : {"ACCU", "accumulator", "JCN", "load"})
      EXPECT_EQ(hover.dump().find(mnemonic), std::string::npos) << line << ":" << character << " " << hover.dump(1);
  }
}

// Names mean what their block declares; behind a call its parameters.
TEST(SclDocument, NamesHavePagesDefinitionsAndUses) {
  const std::string text =
      "FUNCTION_BLOCK FB1\nVAR_INPUT\n  go : BOOL;\nEND_VAR\nVAR\n  n : INT;\nEND_VAR\nBEGIN\n"
      "  IF go THEN #n := n + 1; END_IF;\nEND_FUNCTION_BLOCK\n"
      "ORGANIZATION_BLOCK OB1\nBEGIN\n  FB1.DB1(go := I4.0);\nEND_ORGANIZATION_BLOCK\n"
      "DATA_BLOCK DB1 FB1\nBEGIN\nEND_DATA_BLOCK\n";
  EditorSession session;
  session.open(text, sclUri);
  const auto hover = [&](int line, int character) {
    return textAt(session.ask("textDocument/hover", line, character, sclUri), "contents/value");
  };
  EXPECT_EQ(hover(8, 20), "**n** of FB1\n\nVAR : INT\n");
  EXPECT_EQ(hover(8, 6), "**go** of FB1\n\nVAR_INPUT : BOOL\n");
  const std::string input = hover(12, 17);
  EXPECT_NE(input.find("**I4.0**"), std::string::npos) << input;
  EXPECT_NE(input.find("FB1.DB1(go := I4.0)"), std::string::npos) << input;
  EXPECT_EQ(rangesOf(session.ask("textDocument/definition", 8, 20, sclUri)), (std::vector<std::string>{"5:2-5:3"}));
  EXPECT_EQ(rangesOf(session.ask("textDocument/definition", 12, 3, sclUri)), (std::vector<std::string>{"0:15-0:18"}));
  Json place = session.place(5, 2, sclUri);
  place["context"] = Json{{"includeDeclaration", false}};
  EXPECT_EQ(rangesOf(at(session.request("textDocument/references", place), "result")),
            (std::vector<std::string>{"8:14-8:15", "8:19-8:20"}));
}

TEST(SclDocument, BlocksWrittenWithABlank) {
  // FC 1 and FC1 are one block: its page, its heading and its uses are the same from everywhere.
  EditorSession session;
  session.open(
      "FUNCTION FC 1 : INT\nVAR_INPUT a : BOOL; END_VAR\nBEGIN\nFC1 := 5;\nEND_FUNCTION\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nMW20 := FC1(a := I0.0);\nMW22 := FC 1(a := I0.1);\nEND_ORGANIZATION_BLOCK\n",
      sclUri);
  const std::vector<std::pair<int, int>> places = {{0, 10}, {0, 12}, {3, 1}, {7, 9}, {8, 9}, {8, 11}};
  for (const auto& [line, character] : places) {
    EXPECT_EQ(textAt(session.ask("textDocument/hover", line, character, sclUri), "contents/value"),
              "**FC 1**\n\nFUNCTION\n")
        << line << ':' << character;
    EXPECT_EQ(rangesOf(session.ask("textDocument/definition", line, character, sclUri)),
              (std::vector<std::string>{"0:9-0:13"}))
        << line << ':' << character;
    Json place = session.place(line, character, sclUri);
    place["context"] = Json{{"includeDeclaration", false}};
    EXPECT_EQ(rangesOf(at(session.request("textDocument/references", place), "result")),
              (std::vector<std::string>{"3:0-3:3", "7:8-7:11", "8:8-8:12"}))
        << line << ':' << character;
  }
}

}  // namespace
}  // namespace rungproof::test
