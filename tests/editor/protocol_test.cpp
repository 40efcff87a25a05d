// The life of a session: greeting, order, unknown and damaged messages, cancelled requests, the end.
#include "tests/editor/editor_session.hpp"

namespace rungproof::test {
namespace {

std::string errorOf(const Json& answer) { return numberAt(answer, "error/code"); }

TEST(Protocol, GreetsWithItsCapabilities) {
  EditorSession session;
  EXPECT_EQ(textAt(session.hello(), "result/capabilities/positionEncoding"), "utf-16");
  EXPECT_EQ(numberAt(session.hello(), "result/capabilities/textDocumentSync/change"), "2");
  EXPECT_EQ(textAt(session.hello(), "result/serverInfo/name"), "rungproof");
}

TEST(Protocol, EndsWith0AfterShutdownAndOtherwiseWith1) {
  {
    EditorSession session;
    EXPECT_EQ(at(session.request("shutdown", nullptr), "result").kind(), Json::Kind::Null);
    EXPECT_EQ(errorOf(session.request("textDocument/hover", session.place(0, 0))), "-32600");
    session.notify("exit", nullptr);
    EXPECT_EQ(session.end(), 0);
  }
  EditorSession hasty;
  hasty.notify("exit", nullptr);
  EXPECT_EQ(hasty.end(), 1);
  EditorSession gone;
  EXPECT_EQ(gone.end(), 1);  // the client is no more
}

TEST(Protocol, AnswersNothingBeforeTheGreeting) {
  RpcClient client(Framing::Headers, {"lsp", "--stdio"});
  EXPECT_EQ(errorOf(client.request("textDocument/hover", Json::object())), "-32002");
  client.notify("textDocument/didOpen", Json::object());
  EXPECT_EQ(errorOf(client.request("shutdown", nullptr)), "-32002");
  EXPECT_EQ(errorOf(client.request("initialize", Json::object())), "null");
  EXPECT_EQ(errorOf(client.request("initialize", Json::object())), "-32600");
}

TEST(Protocol, RefusesWhatItDoesNotKnow) {
  EditorSession session;
  EXPECT_EQ(errorOf(session.request("textDocument/declaration", Json::object())), "-32601");
  session.notify("$/somethingNew", Json::object());
  EXPECT_EQ(errorOf(session.request("textDocument/hover", session.place(0, 0, "file:///nowhere"))), "-32602");
  session.open("x");
  EXPECT_EQ(errorOf(session.request("textDocument/hover", {{"textDocument", Json{{"uri", untitled}}}})), "-32602");
  EXPECT_EQ(errorOf(session.request("workspace/executeCommand", {{"command", "rm"}})), "-32602");
  EXPECT_EQ(errorOf(session.request("workspace/executeCommand", {{"command", "rungproof.prove"}})), "-32602");
}

TEST(Protocol, SurvivesDamagedMessages) {
  EditorSession session;
  session.sendBytes("Content-Length: 8\r\n\r\n{\"a\": 1,");
  EXPECT_EQ(errorOf(session.receive()), "-32700");
  session.sendBytes("Header: only\r\n\r\n");
  EXPECT_EQ(errorOf(session.receive()), "-32700");
  session.sendBytes("Content-Length: 200000\r\n\r\n" + std::string(200000, '['));
  EXPECT_EQ(errorOf(session.receive()), "-32700");
  session.sendBytes("Content-Length: 2\r\n\r\n[]");
  EXPECT_EQ(errorOf(session.receive()), "-32600");
  // Parameters of every wrong kind.
  for (const Json& params : {Json(nullptr), Json::array({1, 2}), Json{{"textDocument", 7}},
                             Json{{"textDocument", Json{{"uri", untitled}}}, {"contentChanges", "x"}}}) {
    for (const char* method : {"textDocument/didOpen", "textDocument/didChange", "textDocument/didClose"})
      session.notify(method, params);
    EXPECT_EQ(errorOf(session.request("textDocument/completion", params)), "-32602");
  }
  EXPECT_EQ(session.diagnosticsOf("garbage\n").size() > 0, true);
}

TEST(Protocol, CancelsWhatWaits) {
  EditorSession session;
  session.open("Network 1\nLD I0.0\n= Q0.0\n");
  session.nextDiagnostics();
  // Both arrive at once, so the request still waits when its end is asked for.
  const Json request{
      {"jsonrpc", "2.0"}, {"id", "slow"}, {"method", "textDocument/hover"}, {"params", session.place(1, 1)}};
  const Json cancel{{"jsonrpc", "2.0"}, {"method", "$/cancelRequest"}, {"params", Json{{"id", "slow"}}}};
  session.sendBytes(framed(Framing::Headers, request.dump()) + framed(Framing::Headers, cancel.dump()));
  const Json answer = session.receive();
  EXPECT_EQ(textAt(answer, "id"), "slow");
  EXPECT_EQ(errorOf(answer), "-32800");
  session.notify("$/cancelRequest", {{"id", 999}});  // nothing to cancel
  EXPECT_NE(session.hover(1, 1), "");
}

TEST(Protocol, TakesMessagesByteByByte) {
  RpcClient client(Framing::Headers, {"lsp"});
  const std::string hello =
      framed(Framing::Headers, R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})");
  for (const char byte : hello) client.sendBytes(std::string(1, byte));
  EXPECT_EQ(textAt(client.answer(1), "result/serverInfo/name"), "rungproof");
}

}  // namespace
}  // namespace rungproof::test
