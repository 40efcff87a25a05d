// Definitions, references, highlights, outline, hover and completion in a text of IEC 61131-3. Lines count from 0.
#include <algorithm>

#include "tests/editor/editor_session.hpp"

namespace rungproof::test {
namespace {

using Rows = std::vector<std::string>;
const std::string uri = "untitled:a.st";
const std::string text =
    /* 0 */
    "FUNCTION_BLOCK Mix\n"
    /* 1 */
    "VAR_INPUT k : INT; END_VAR\n"
    /* 2 */
    "VAR_OUTPUT q : BOOL; END_VAR\n"
    /* 3 */
    "q := k > 5; // k is the level\n"
    /* 4 */
    "END_FUNCTION_BLOCK\n"
    /* 5 */
    "PROGRAM P\n"
    /* 6 */
    "VAR_INPUT k : BOOL; насос : BOOL; END_VAR\n"
    /* 7 */
    "VAR_OUTPUT lamp : BOOL; END_VAR\n"
    /* 8 */
    "VAR m : Mix; t : TON; END_VAR\n"
    /* 9 */
    "m(k := 3);\n"
    /* 10 */
    "t(IN := K, PT := T#3s);\n"
    /* 11 */
    "lamp := m.q AND насос;\n"
    /* 12 */
    "END_PROGRAM\n"
    /* 13 */
    "//@ prove p: lamp implies P.k or not k\n";

class StructuredNavigation : public testing::Test {
 protected:
  StructuredNavigation() { session_.open(text, uri); }
  Rows definition(int line, int character) {
    return rangesOf(session_.ask("textDocument/definition", line, character, uri));
  }
  Rows references(int line, int character) {
    Json params = session_.place(line, character, uri);
    params["context"] = Json{{"includeDeclaration", false}};
    return rangesOf(at(session_.request("textDocument/references", params), "result"));
  }
  std::string hover(int line, int character) {
    return textAt(session_.ask("textDocument/hover", line, character, uri), "contents/value");
  }
  Rows labels(int line, int character) {
    return textsOf(at(session_.ask("textDocument/completion", line, character, uri), "items"), "label");
  }
  EditorSession session_;
};

TEST_F(StructuredNavigation, AUseLeadsToItsDeclaration) {
  EXPECT_EQ(definition(10, 8), (Rows{"6:10-6:11"}));   // K, in any case of letters
  EXPECT_EQ(definition(3, 5), (Rows{"1:10-1:11"}));    // k of the block
  EXPECT_EQ(definition(9, 2), (Rows{"1:10-1:11"}));    // its parameter in the call
  EXPECT_EQ(definition(11, 10), (Rows{"2:11-2:12"}));  // q of m.q
  EXPECT_EQ(definition(8, 9), (Rows{"0:15-0:18"}));    // the type Mix
  EXPECT_EQ(definition(13, 14), (Rows{"7:11-7:15"}));  // in a property
  EXPECT_EQ(definition(10, 0), (Rows{"8:13-8:14"}));
  EXPECT_EQ(definition(3, 15), Rows());  // in a comment
}

TEST_F(StructuredNavigation, UsesInTextsAndProperties) {
  EXPECT_EQ(references(6, 10), (Rows{"10:8-10:9", "13:28-13:29", "13:37-13:38"}));
  EXPECT_EQ(references(1, 10), (Rows{"3:5-3:6", "9:2-9:3"}));
  EXPECT_EQ(references(2, 11), (Rows{"3:0-3:1", "11:10-11:11"}));
  EXPECT_EQ(references(0, 16), (Rows{"8:8-8:11"}));
  const Json list = session_.ask("textDocument/documentHighlight", 11, 1, uri);
  Rows rows;
  for (const Json& item : list.items()) rows.push_back(rangeText(at(item, "range")) + " " + numberAt(item, "kind"));
  EXPECT_EQ(rows, (Rows{"7:11-7:15 1", "11:0-11:4 3", "13:13-13:17 2"}));
}

TEST_F(StructuredNavigation, TheOutlineIsThatOfTheText) {
  const Json outline =
      at(session_.request("textDocument/documentSymbol", {{"textDocument", Json{{"uri", uri}}}}), "result");
  EXPECT_EQ(textsOf(outline, "name"), (Rows{"Mix", "P"}));
  EXPECT_EQ(textsOf(at(outline, "1/children"), "name"), (Rows{"k", "насос", "lamp", "m", "t"}));
  EXPECT_EQ(rangeText(at(outline, "0/range")), "0:0-4:18");
  const Json found = at(session_.request("workspace/symbol", {{"query", "K"}}), "result");
  EXPECT_EQ(textsOf(found, "containerName"), (Rows{"Mix", "P"}));
  EXPECT_EQ(rangeText(at(found, "1/location/range")), "6:10-6:11");
}

TEST_F(StructuredNavigation, HoverTellsTheVariableOfItsBlock) {
  EXPECT_NE(hover(11, 18).find("насос"), std::string::npos);
  EXPECT_NE(hover(3, 5).find("**k** of Mix\n\nVAR_INPUT : INT"), std::string::npos) << hover(3, 5);
  EXPECT_EQ(hover(10, 8).find("Mix"), std::string::npos);
}

TEST_F(StructuredNavigation, WordsAreOfferedWhereTheyMayStand) {
  const auto has = [](const Rows& list, const char* word) {
    return std::find(list.begin(), list.end(), word) != list.end();
  };
  const Rows inProgram = labels(11, 8);
  for (const char* word : {"lamp", "насос", "t.Q", "t.ET", "m.q", "Mix", "IF"})
    EXPECT_TRUE(has(inProgram, word)) << word;
  for (const char* word : {"t.STATE", "t.M", "q"}) EXPECT_FALSE(has(inProgram, word)) << word;
  EXPECT_TRUE(has(labels(3, 5), "q"));
  EXPECT_FALSE(has(labels(3, 5), "lamp"));
  EXPECT_EQ(labels(3, 18), Rows());
  EditorSession other;
  other.open("PROGRAM P\nVAR s : STRING; END_VAR\n(* a b *) s := 'a b';\nEND_PROGRAM\n", uri);
  EXPECT_TRUE(at(other.ask("textDocument/completion", 2, 5, uri), "items").items().empty());
  EXPECT_TRUE(at(other.ask("textDocument/completion", 2, 18, uri), "items").items().empty());
  EXPECT_FALSE(at(other.ask("textDocument/completion", 2, 10, uri), "items").items().empty());
}

}  // namespace
}  // namespace rungproof::test
