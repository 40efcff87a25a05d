// Messages of JSON-RPC 2.0: requests, notifications, answers, and what is none of them.
#include "frontend/rpc/rpc_message.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

int faultOf(const std::string& text) {
  const RpcMessage message = readMessage(text);
  return message.fault ? static_cast<int>(message.fault->code) : 0;
}

TEST(RpcMessage, TellsRequestsNotificationsAndAnswers) {
  const RpcMessage request = readMessage(R"({"jsonrpc":"2.0","id":"a","method":"m","params":{"x":1}})");
  EXPECT_TRUE(request.isRequest());
  EXPECT_EQ(request.id->dump(), "\"a\"");
  EXPECT_EQ(request.params.dump(), R"({"x":1})");
  EXPECT_FALSE(readMessage(R"({"jsonrpc":"2.0","method":"m"})").isRequest());
  const RpcMessage answer = readMessage(R"({"jsonrpc":"2.0","id":-3,"result":null})");
  EXPECT_FALSE(answer.isRequest());
  EXPECT_FALSE(answer.fault.has_value());
}

TEST(RpcMessage, FaultsHaveTheCodesOfTheProtocol) {
  EXPECT_EQ(faultOf("{"), -32700);
  EXPECT_EQ(faultOf("\"\\ud800\""), -32700);                                // half of a pair
  EXPECT_EQ(faultOf("{\"jsonrpc\":\"2.0\",\"method\":\"\xFF\"}"), -32700);  // not UTF-8
  EXPECT_EQ(faultOf(std::string(100000, '[')), -32700);
  EXPECT_EQ(faultOf("[]"), -32600);
  EXPECT_EQ(faultOf("7"), -32600);
  EXPECT_EQ(faultOf(R"({"id":1,"method":"m"})"), -32600);  // no version
  EXPECT_EQ(faultOf(R"({"jsonrpc":"1.0","id":1,"method":"m"})"), -32600);
  EXPECT_EQ(faultOf(R"({"jsonrpc":"2.0","id":1})"), -32600);
  EXPECT_EQ(faultOf(R"({"jsonrpc":"2.0","id":1,"method":5})"), -32600);
  EXPECT_EQ(faultOf(R"({"jsonrpc":"2.0","id":[],"method":"m"})"), -32600);
  EXPECT_EQ(faultOf(R"({"jsonrpc":"2.0","id":1,"method":"m","params":"x"})"), -32600);
  EXPECT_EQ(readMessage(R"({"id":1,"method":"m"})").id->dump(), "1");  // the answer names the request
}

TEST(RpcMessage, BracketsInsideOfTextsDoNotNest) {
  EXPECT_EQ(faultOf(R"({"jsonrpc":"2.0","method":")" + std::string(1000, '[') + R"("})"), 0);
}

}  // namespace
}  // namespace rungproof
