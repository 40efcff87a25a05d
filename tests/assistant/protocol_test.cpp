// Greeting, versions, the list of tools, damaged messages, the end.
#include <algorithm>

#include "tests/assistant/assistant_session.hpp"

namespace rungproof::test {
namespace {

std::string versionFor(const std::string& wanted) {
  RpcClient client(Framing::Lines, {"mcp"});
  return textAt(client.request("initialize", {{"protocolVersion", wanted}, {"capabilities", Json::object()}}),
                "result/protocolVersion");
}

TEST(AssistantProtocol, AgreesOnAVersion) {
  EXPECT_EQ(versionFor("2025-06-18"), "2025-06-18");
  EXPECT_EQ(versionFor("2024-11-05"), "2024-11-05");
  EXPECT_EQ(versionFor("2031-01-01"), "2025-06-18");  // the newest that the server knows
  RpcClient client(Framing::Lines, {"mcp"});
  EXPECT_EQ(numberAt(client.request("initialize", Json::object()), "error/code"), "-32602");
}

TEST(AssistantProtocol, GreetsAndEnds) {
  AssistantSession session;
  EXPECT_EQ(textAt(session.hello(), "result/serverInfo/name"), "rungproof");
  EXPECT_EQ(at(session.hello(), "result/capabilities/tools").kind(), Json::Kind::Object);
  EXPECT_EQ(at(session.request("ping", Json::object()), "result").dump(), "{}");
  EXPECT_EQ(session.end(), 0);  // the client closes the input
}

TEST(AssistantProtocol, ToolsHaveSchemas) {
  AssistantSession session;
  const Json tools = at(session.request("tools/list", Json::object()), "result/tools");
  std::vector<std::string> names;
  for (const Json& tool : tools.items()) {
    names.push_back(textAt(tool, "name"));
    EXPECT_EQ(textAt(tool, "inputSchema/type"), "object");
    EXPECT_FALSE(textAt(tool, "description").empty());
    const Json properties = at(tool, "inputSchema/properties");
    for (const Json& property : properties.items()) {
      EXPECT_FALSE(textAt(property, "type").empty());
      EXPECT_FALSE(textAt(property, "description").empty());
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"lint", "check", "prove", "sim", "test", "show", "explain", "xref"}));
  EXPECT_EQ(textAt(tools, "6/inputSchema/required/0"), "topic");
}

TEST(AssistantProtocol, RefusesWhatItDoesNotKnow) {
  AssistantSession session;
  EXPECT_EQ(numberAt(session.request("resources/list", Json::object()), "error/code"), "-32601");
  EXPECT_EQ(numberAt(session.request("tools/call", {{"name", "format_disk"}}), "error/code"), "-32602");
  EXPECT_EQ(numberAt(session.request("tools/call", Json::object()), "error/code"), "-32602");
  session.sendBytes("{\"jsonrpc\":\n");
  EXPECT_EQ(numberAt(session.receive(), "error/code"), "-32700");
  session.sendBytes("[]\n");
  EXPECT_EQ(numberAt(session.receive(), "error/code"), "-32600");
  RpcClient hasty(Framing::Lines, {"mcp"});
  EXPECT_EQ(numberAt(hasty.request("tools/list", Json::object()), "error/code"), "-32002");
}

}  // namespace
}  // namespace rungproof::test
