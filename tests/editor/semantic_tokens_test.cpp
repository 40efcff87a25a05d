// Each word with its kind, in all families. Rows read "line:character+length kind", in UTF-16 units from 0.
#include "tests/editor/editor_session.hpp"

namespace rungproof::test {
namespace {

using Rows = std::vector<std::string>;

Rows rowsOf(EditorSession& session, const std::string& uri = untitled) {
  std::vector<std::string> names;
  const Json legend = at(session.hello(), "result/capabilities/semanticTokensProvider/legend/tokenTypes");
  for (const Json& name : legend.items()) names.push_back(name.text());
  const Json answer =
      at(session.request("textDocument/semanticTokens/full", {{"textDocument", Json{{"uri", uri}}}}), "result/data");
  Rows rows;
  std::uint64_t line = 0, character = 0;
  const std::vector<Json>& data = answer.items();
  for (std::size_t i = 0; i + 4 < data.size(); i += 5) {
    const std::uint64_t down = *data[i].natural();
    line += down;
    character = *data[i + 1].natural() + (down == 0 ? character : 0);
    rows.push_back(
        fmt::format("{}:{}+{} {}", line, character, *data[i + 2].natural(), names.at(*data[i + 3].natural())));
  }
  return rows;
}

TEST(SemanticTokens, OfAStatementList) {
  EditorSession session;
  session.open(
      "SYMBOL_TABLE\nStart,I0.0,\nEND_SYMBOL_TABLE\nORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1 // größer\n"
      "LD Start // green\nTON T37, +100\nCALL SBR_0, I0.1\nJMP 3\nLBL 3\nEND_ORGANIZATION_BLOCK\n"
      "SUBROUTINE_BLOCK SBR_0:SBR0\nVAR_INPUT\nRun:BOOL;\nEND_VAR\nBEGIN\nNetwork 1\nLD #Run\n= Q0.0\n"
      "END_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(rowsOf(session),
            (Rows{"6:0+2 keyword", "6:3+5 property", "7:0+3 keyword", "7:4+3 variable", "7:9+4 number", "8:0+4 keyword",
                  "8:5+5 function", "8:12+4 variable", "9:0+3 keyword", "9:4+1 label", "10:0+3 keyword", "10:4+1 label",
                  "18:0+2 keyword", "18:3+4 parameter", "19:0+1 keyword", "19:2+4 variable"}));
}

TEST(SemanticTokens, OfAStep7Source) {
  EditorSession session({"--dialect", "s7-300"});
  session.open(
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  Run : BOOL;\nEND_VAR\nBEGIN\nNETWORK\n      A #Run;\n      JCN M001;\n"
      "      L W#16#FF;\nM001: NOP 0;\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
      "      CALL FC 1 ( Run := I 0.0 );\nEND_ORGANIZATION_BLOCK\n");
  const Rows rows = rowsOf(session);
  for (const char* row : {"6:6+1 keyword", "6:8+4 parameter", "7:6+3 keyword", "7:10+4 label", "8:6+1 keyword",
                          "8:8+7 number", "14:6+4 keyword", "14:11+4 function"})
    EXPECT_NE(std::ranges::find(rows, row), rows.end()) << row << "\n" << fmt::format("{}", fmt::join(rows, "\n"));
}

TEST(SemanticTokens, OfStructuredText) {
  EditorSession session;
  session.open("PROGRAM P\nVAR\n  T1 : TON; (* late *)\nEND_VAR\nT1(IN := TRUE, PT := T#2s);\nEND_PROGRAM\n",
               "untitled:p.st");
  EXPECT_EQ(rowsOf(session, "untitled:p.st"),
            (Rows{"0:0+7 keyword", "0:8+1 variable", "1:0+3 keyword", "2:2+2 variable", "2:7+3 variable",
                  "3:0+7 keyword", "4:0+2 function", "4:3+2 variable", "4:9+4 keyword", "4:15+2 variable",
                  "4:21+4 number", "5:0+11 keyword"}));
}

}  // namespace
}  // namespace rungproof::test
