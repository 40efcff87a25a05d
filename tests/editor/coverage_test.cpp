// What tables beside a program cover, as hints of the editor.
#include "tests/editor/editor_session.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

/// "1:6 1 0" of a hint.
std::vector<std::string> hintsOf(EditorSession& session, const std::string& uri) {
  const Json range{{"start", Json{{"line", 0}, {"character", 0}}}, {"end", Json{{"line", 99}, {"character", 0}}}};
  const Json hints =
      at(session.request("textDocument/inlayHint", {{"textDocument", Json{{"uri", uri}}}, {"range", range}}), "result");
  std::vector<std::string> texts;
  for (const Json& hint : hints.items())
    texts.push_back(numberAt(hint, "position/line") + ":" + numberAt(hint, "position/character") + " " +
                    textAt(hint, "label"));
  return texts;
}

// I0.0 is pressed, I0.1 never: of the three conditions of Q0.0 two have decided both ways (tests/tables/coverage_test).
TEST(CoverageHints, StandAtContactsAndCoils) {
  const TemporaryFolder folder;
  const std::string text = "Network 1\nLD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n";
  const std::string uri = "file://" + folder.file("l.awl", text);
  EditorSession session;
  session.diagnosticsOf(text, uri);
  EXPECT_TRUE(hintsOf(session, uri).empty());  // no table
  folder.file("l.start.test.csv", "test,set I0.0,expect Q0.0\nt,0,0\nt,1,1\nt,0,1\n");
  EXPECT_EQ(hintsOf(session, uri),
            (std::vector<std::string>{"1:7 1 0", "2:6 1 0", "3:7 0, never 1", "4:6 2 of 3 pairs"}));
}

}  // namespace
}  // namespace rungproof::test
