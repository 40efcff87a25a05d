// Framing: what arrives in pieces, together, with wrong lengths or without a header.
#include "frontend/rpc/message_stream.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

std::string bodyOf(MessageStream& stream) {
  const std::optional<RawMessage> message = stream.next();
  return !message ? "<more>" : message->fault.empty() ? message->body : "<fault>";
}

TEST(MessageStream, TakesMessagesApartAndTogether) {
  MessageStream stream(Framing::Headers);
  stream.append("Content-Length: 2\r\n\r\n{}Content-Type: x\r\ncontent-length:3\r\n\r\n");
  EXPECT_EQ(bodyOf(stream), "{}");
  EXPECT_EQ(bodyOf(stream), "<more>");
  stream.append("ab");
  EXPECT_EQ(bodyOf(stream), "<more>");
  stream.append("c");
  EXPECT_EQ(bodyOf(stream), "abc");
  EXPECT_EQ(bodyOf(stream), "<more>");
}

TEST(MessageStream, GoesOnAfterALengthThatIsTooShort) {
  // The body is {"a":1}; two bytes are announced, so the rest stands in front of the next header.
  MessageStream stream(Framing::Headers);
  stream.append("Content-Length: 2\r\n\r\n{\"a\":1}Content-Length: 4\r\n\r\ntrue");
  EXPECT_EQ(bodyOf(stream), "{\"");
  EXPECT_EQ(bodyOf(stream), "true");
}

TEST(MessageStream, SaysWhatHeadersLack) {
  MessageStream stream(Framing::Headers);
  stream.append(
      "Length: 2\r\n\r\nContent-Length: x\r\n\r\nContent-Length: -1\r\n\r\nContent-Length: 99999999999\r\n\r\n");
  for (int i = 0; i < 4; ++i) EXPECT_EQ(bodyOf(stream), "<fault>") << i;
  stream.append("Content-Length: 99999999999999999999999\r\n\r\nContent-Length: 1\r\n\r\n7");
  EXPECT_EQ(bodyOf(stream), "<fault>");
  EXPECT_EQ(bodyOf(stream), "7");
}

TEST(MessageStream, GivesUpOnAHeaderWithoutEnd) {
  MessageStream stream(Framing::Headers);
  stream.append(std::string(10000, 'x'));
  EXPECT_EQ(bodyOf(stream), "<fault>");
  stream.append("Content-Length: 1\r\n\r\n8");
  EXPECT_EQ(bodyOf(stream), "8");
}

TEST(MessageStream, LinesAreMessagesAndBlankOnesAreNone) {
  MessageStream stream(Framing::Lines);
  stream.append("{}\r\n\n  \n[1]\nrest");
  EXPECT_EQ(bodyOf(stream), "{}");
  EXPECT_EQ(bodyOf(stream), "[1]");
  EXPECT_EQ(bodyOf(stream), "<more>");
}

}  // namespace
}  // namespace rungproof
