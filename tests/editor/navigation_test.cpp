// Definitions, references and the outline.
#include "tests/editor/editor_session.hpp"
#include "tests/editor/press.hpp"

namespace rungproof::test {
namespace {

using Ranges = std::vector<std::string>;

class NavigationTest : public testing::Test {
 protected:
  NavigationTest() { session_.open(press); }
  Ranges definitions(int line, int character) {
    return rangesOf(session_.ask("textDocument/definition", line, character));
  }
  Ranges references(int line, int character, bool withDeclaration) {
    Json params = session_.place(line, character);
    params["context"] = Json{{"includeDeclaration", withDeclaration}};
    return rangesOf(at(session_.request("textDocument/references", params), "result"));
  }
  EditorSession session_;
};

TEST_F(NavigationTest, AnAddressIsDefinedWhereItIsWritten) {
  EXPECT_EQ(definitions(9, 4), (Ranges{"6:2-6:6"}));     // AN Q0.0: the coil in network 1
  EXPECT_EQ(definitions(26, 4), (Ranges{"15:2-15:6"}));  // LD M0.0 in the subroutine: S in the main program
  EXPECT_EQ(definitions(14, 4), (Ranges{"13:4-13:7"}));  // LD T37: its box
  EXPECT_EQ(definitions(3, 30), (Ranges{"6:2-6:6"}));    // in a property
  EXPECT_EQ(definitions(4, 4), Ranges{});                // nobody writes an input
}

TEST_F(NavigationTest, CallsAndJumpsLeadToBlocksAndLabels) {
  EXPECT_EQ(definitions(16, 7), (Ranges{"23:0-23:27"}));
  EXPECT_EQ(definitions(19, 4), (Ranges{"21:0-21:5"}));
  EXPECT_EQ(references(21, 4, false), (Ranges{"19:4-19:5"}));
  EXPECT_EQ(references(16, 7, false), (Ranges{"16:5-16:10"}));
}

TEST_F(NavigationTest, ReferencesAreReadersAndWriters) {
  EXPECT_EQ(references(6, 3, false), (Ranges{"6:2-6:6", "9:3-9:7", "3:28-3:32"}));  // the property names it too
  EXPECT_EQ(references(26, 4, false), (Ranges{"15:2-15:6", "26:3-26:7"}));
  EXPECT_EQ(references(1, 0, true), Ranges{});
}

TEST_F(NavigationTest, HighlightsTellReadersFromWriters) {
  const auto highlights = [&](int line, int character) {
    const Json list = session_.ask("textDocument/documentHighlight", line, character);
    Ranges rows;
    for (const Json& item : list.items()) rows.push_back(rangeText(at(item, "range")) + " " + numberAt(item, "kind"));
    return rows;
  };
  EXPECT_EQ(highlights(6, 3), (Ranges{"6:2-6:6 3", "9:3-9:7 2", "3:28-3:32 2"}));  // = Q0.0, AN Q0.0, property
  EXPECT_EQ(highlights(19, 4), (Ranges{"21:0-21:5 1", "19:4-19:5 1"}));
  EXPECT_EQ(highlights(1, 0), Ranges{});
}

TEST_F(NavigationTest, BlocksAndNetworksFold) {
  const Json folds =
      at(session_.request("textDocument/foldingRange", {{"textDocument", Json{{"uri", untitled}}}}), "result");
  Ranges rows;
  for (const Json& fold : folds.items()) rows.push_back(numberAt(fold, "startLine") + "-" + numberAt(fold, "endLine"));
  EXPECT_EQ(rows, (Ranges{"0-22", "2-6", "7-10", "11-16", "17-19", "20-21", "23-28", "25-27"}));
}

TEST_F(NavigationTest, OutlineHasBlocksNetworksAndLabels) {
  const Json outline =
      at(session_.request("textDocument/documentSymbol", {{"textDocument", Json{{"uri", untitled}}}}), "result");
  EXPECT_EQ(textsOf(outline, "name"), (Ranges{"MAIN", "SBR_0"}));
  EXPECT_EQ(textsOf(at(outline, "0/children"), "name"),
            (Ranges{"Network 1: Насос", "Network 2", "Network 3: delay", "Network 4", "Network 5"}));
  EXPECT_EQ(textsOf(at(outline, "0/children/4/children"), "name"), (Ranges{"LBL 3"}));
  EXPECT_EQ(rangeText(at(outline, "0/children/0/selectionRange")), "2:0-2:18");
  EXPECT_EQ(rangeText(at(outline, "1/selectionRange")), "23:0-23:27");
}

TEST_F(NavigationTest, SymbolsOfTheWorkspace) {
  const Json found = at(session_.request("workspace/symbol", {{"query", "LAMP"}}), "result");
  EXPECT_EQ(textsOf(found, "name"), (Ranges{"Network 1: lamp"}));
  EXPECT_EQ(textsOf(found, "containerName"), (Ranges{"SBR_0"}));
}

TEST(Navigation, ANameLeadsToItsRow) {
  EditorSession session;
  session.open(
      "SYMBOL_TABLE\nStart,I0.0,green button\nMotor,Q0.0,\nEND_SYMBOL_TABLE\nORGANIZATION_BLOCK MAIN:OB1\n"
      "BEGIN\nNetwork 1\nLD Start\n= Motor\nEND_ORGANIZATION_BLOCK\n");
  const Json rows = session.ask("textDocument/definition", 7, 4);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(numberAt(rows, "0/range/start/line"), "1");
  EXPECT_EQ(numberAt(session.ask("textDocument/definition", 8, 4), "0/range/start/line"), "2");
}

TEST(Navigation, ALocalNameLeadsToItsDeclaration) {
  EditorSession session;
  session.open(
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nCALL SBR_0, I0.0\nEND_ORGANIZATION_BLOCK\n"
      "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nRun:BOOL;\nEND_VAR\nBEGIN\nNetwork 1\nLD #Run\n= Q0.0\n"
      "END_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(numberAt(session.ask("textDocument/definition", 12, 5), "0/range/start/line"), "8");
}

}  // namespace
}  // namespace rungproof::test
