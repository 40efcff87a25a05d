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

}  // namespace
}  // namespace rungproof::test
