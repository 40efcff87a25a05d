// Fixes and suppressions: the edits, and that the finding is gone when they are applied.
#include <algorithm>

#include "frontend/editor/document.hpp"
#include "tests/editor/editor_session.hpp"

namespace rungproof::test {
namespace {

Json actionsOf(EditorSession& session, int line) {
  return at(
      session.request("textDocument/codeAction", {{"textDocument", Json{{"uri", untitled}}},
                                                  {"range", Json{{"start", Json{{"line", line}, {"character", 0}}},
                                                                 {"end", Json{{"line", line}, {"character", 100}}}}},
                                                  {"context", Json{{"diagnostics", Json::array()}}}}),
      "result");
}

/// The text with the action of that title applied; empty if there is none.
std::string applied(const Json& actions, const std::string& title, const std::string& text) {
  for (const Json& action : actions.items()) {
    if (textAt(action, "title") != title) continue;
    Document document{untitled, "", 1, text};
    const Json edit = at(action, "edit/changes/" + untitled + "/0");
    EXPECT_TRUE(applyChange(document, {{"range", at(edit, "range")}, {"text", at(edit, "newText")}}));
    return document.text;
  }
  return {};
}

/// Offers for the only finding of the text, which is ADR001 in that line.
std::string afterAction(const std::string& text, int line, const std::string& title) {
  EditorSession session;
  EXPECT_EQ(codesOf(session.diagnosticsOf(text)), (std::vector<std::string>{"ADR001 1"}));
  const std::string mended = applied(actionsOf(session, line), title, text);
  session.notify("textDocument/didChange", {{"textDocument", Json{{"uri", untitled}, {"version", 2}}},
                                            {"contentChanges", Json::array({Json{{"text", mended}}})}});
  EXPECT_TRUE(session.nextDiagnostics().empty()) << mended;
  return mended;
}

TEST(CodeAction, AllowsAFindingOnItsLine) {
  EXPECT_EQ(afterAction("Network 1\nLD SM0.0\nMOVW 1, VW20000\n", 2, "Allow ADR001 on this line"),
            "Network 1\nLD SM0.0\nMOVW 1, VW20000  // rungproof: allow ADR001 say why\n");
}

TEST(CodeAction, TheCommentThatStandsThereIsTheReason) {
  EXPECT_EQ(afterAction("Network 1\nLD SM0.0\nMOVW 1, VW20000 // Länge 😀\n", 2, "Allow ADR001 on this line"),
            "Network 1\nLD SM0.0\nMOVW 1, VW20000 // rungproof: allow ADR001 Länge 😀\n");
}

TEST(CodeAction, OneMoreCodeInASuppression) {
  // OUT001 at the second coil is silenced already; the address that the CPU lacks is not.
  const std::string text =
      "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\nMOVW 1, VW20000 // rungproof: allow STY002 known\n";
  EditorSession session;
  session.diagnosticsOf(text);
  EXPECT_EQ(applied(actionsOf(session, 5), "Allow ADR001 on this line", text),
            "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n"
            "MOVW 1, VW20000 // rungproof: allow ADR001, STY002 known\n");
}

TEST(CodeAction, AllowsAFindingInItsNetwork) {
  EXPECT_EQ(
      afterAction("Network 1 // title\n// about it\nLD SM0.0\nMOVW 1, VW20000\n", 3, "Allow ADR001 in this network"),
      "Network 1 // title\n// about it\n// rungproof: allow ADR001 say why\nLD SM0.0\nMOVW 1, VW20000\n");
}

TEST(CodeAction, WindowsLineEndsStay) {
  EXPECT_EQ(afterAction("Network 1\r\nLD SM0.0\r\nMOVW 1, VW20000\r\n", 2, "Allow ADR001 on this line"),
            "Network 1\r\nLD SM0.0\r\nMOVW 1, VW20000  // rungproof: allow ADR001 say why\r\n");
}

TEST(CodeAction, ErrorsOfTheReadersCannotBeAllowed) {
  EditorSession session;
  session.diagnosticsOf("Network 1\nLD I0.0\nNONSENSE Q0.0\n= Q0.0\n");
  const Json actions = actionsOf(session, 2);
  for (const Json& action : actions.items())
    EXPECT_EQ(textAt(action, "title").find("Allow SYN"), std::string::npos) << action.dump();
}

TEST(CodeAction, MendsWhatFixMends) {
  // A letter O in an address is a look-alike of 0: STY004 has a safe fix.
  const std::string text = "Network 1\nLD I0.O\n= Q0.0\n";
  EditorSession session;
  const Json diagnostics = session.diagnosticsOf(text);
  const Json actions = actionsOf(session, 1);
  EXPECT_EQ(applied(actions, "Mend all that can be mended safely (1)", text), "Network 1\nLD I0.0\n= Q0.0\n")
      << diagnostics.dump(1) << actions.dump(1);
  const auto isMend = [](const Json& action) { return textAt(action, "title").starts_with("Mend STY004"); };
  const auto single = std::ranges::find_if(actions.items(), isMend);
  ASSERT_NE(single, actions.items().end());
  EXPECT_TRUE(at(*single, "isPreferred").isTrue());
}

}  // namespace
}  // namespace rungproof::test
