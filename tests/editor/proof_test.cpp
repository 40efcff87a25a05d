// "Prove this property": lens, run, verdict, cancelling, and that typing goes on meanwhile.

#include "tests/editor/editor_session.hpp"

namespace rungproof::test {
namespace {

/// Each coil locks the other, so both are never on; Q0.0 alone can be.
const std::string interlock =
    "Network 1\n"
    "//@ prove never both: never Q0.0 and Q0.1\n"
    "//@ prove a, b* [odd]: never Q0.0\n"
    "//@ reach runs: Q0.1\n"
    "//@ assume quiet: not I0.7\n"
    "LD I0.0\nAN Q0.1\n= Q0.0\n"
    "Network 2\nLD I0.1\nAN Q0.0\n= Q0.1\n";

Json lensesOf(EditorSession& session) {
  return at(session.request("textDocument/codeLens", {{"textDocument", Json{{"uri", untitled}}}}), "result");
}
Json proofOf(const std::string& name) {
  return {{"command", "rungproof.prove"}, {"arguments", Json::array({untitled, name})}};
}

TEST(Proof, ALensForEachProperty) {
  EditorSession session;
  session.open(interlock);
  const Json lenses = lensesOf(session);
  EXPECT_EQ(textsOf(lenses, "command/title"), std::vector<std::string>(3, "prove this property"));
  EXPECT_EQ(textsOf(lenses, "command/command"), std::vector<std::string>(3, "rungproof.prove"));
  EXPECT_EQ(textAt(lenses, "1/command/arguments/1"), "a, b* [odd]");
  EXPECT_EQ(numberAt(lenses, "2/range/start/line"), "3");
}

TEST(Proof, AProofIsShownInTheLens) {
  EditorSession session;
  session.open(interlock);
  const Json answer = session.request("workspace/executeCommand", proofOf("never both"));
  EXPECT_EQ(textAt(answer, "result/verdict"), "PROVED") << answer.dump();
  const Json message = session.notification("window/showMessage");
  EXPECT_EQ(numberAt(message, "params/type"), "3");
  EXPECT_EQ(textAt(message, "params/message").substr(0, 17), "PROVED never both");
  EXPECT_EQ(textAt(lensesOf(session), "0/command/title").substr(0, 9), "PROVED by");
  session.notify("textDocument/didChange", {{"textDocument", Json{{"uri", untitled}, {"version", 2}}},
                                            {"contentChanges", Json::array({Json{{"text", interlock + "\n"}}})}});
  EXPECT_EQ(textAt(lensesOf(session), "0/command/title"), "PROVED before the last change; prove again");
}

TEST(Proof, AViolationIsADiagnosticWithItsRun) {
  EditorSession session;
  session.open(interlock);
  session.nextDiagnostics();
  const Json answer = session.request("workspace/executeCommand", proofOf("a, b* [odd]"));
  EXPECT_EQ(textAt(answer, "result/verdict"), "VIOLATED") << answer.dump();
  EXPECT_EQ(numberAt(session.notification("window/showMessage"), "params/type"), "1");
  bool isShown = false;
  const Json diagnostics = session.nextDiagnostics();
  for (const Json& diagnostic : diagnostics.items()) {
    if (textAt(diagnostic, "code") != "VIOLATED") continue;
    isShown = numberAt(diagnostic, "range/start/line") == "2" &&
              textAt(diagnostic, "message").find("I0.0") != std::string::npos;
  }
  EXPECT_TRUE(isShown) << diagnostics.dump(1);
}

TEST(Proof, UnknownNamesAreRefused) {
  EditorSession session;
  session.open(interlock);
  EXPECT_EQ(numberAt(session.request("workspace/executeCommand", proofOf("nobody")), "error/code"), "-32602");
  EXPECT_EQ(numberAt(session.request("workspace/executeCommand", proofOf("quiet")), "error/code"), "-32602");
}

/// A property that takes long: a counter of 32 bits has to be counted up to a far value.
const std::string longSearch =
    "Network 1\n"
    "//@ prove far: VD0 <> 123456789\n"
    "LD I0.0\nEU\nINCD VD0\nLD I0.1\nEU\n+D VD0, VD4\nLD I0.2\nMOVD VD4, VD0\nLD I0.3\n*R VD8, VD12\n";

TEST(Proof, TypingGoesOnWhileAProofRuns) {
  EditorSession session({"--timeout", "40s"});
  session.open(longSearch);
  session.nextDiagnostics();
  Json params = proofOf("far");
  params["workDoneToken"] = "t";
  const int proof = session.begin("workspace/executeCommand", params);
  EXPECT_EQ(textAt(session.notification("$/progress"), "params/value/kind"), "begin");
  session.notify("textDocument/didChange", {{"textDocument", Json{{"uri", untitled}, {"version", 2}}},
                                            {"contentChanges", Json::array({Json{{"text", longSearch + "\n"}}})}});
  session.nextDiagnostics();
  session.notify("$/cancelRequest", {{"id", proof}});
  const Json answer = session.answer(proof);
  EXPECT_EQ(numberAt(answer, "error/code"), "-32800")
      << "diagnostics that wait for the proof find it ended: " << answer.dump();
}

}  // namespace
}  // namespace rungproof::test
