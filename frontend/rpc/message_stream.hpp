// Bytes of a stream cut into the messages of JSON-RPC: with headers, as the Language Server Protocol frames them, or
// one a line, as the Model Context Protocol does. Whatever is damaged becomes a fault, and reading goes on at the next
// message that can be recognised. Tested by tests/editor/message_stream_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rungproof {

enum class Framing : std::uint8_t { Headers, Lines };

/// The body of one message, or why there is none.
struct RawMessage {
  std::string body;
  std::string fault;  ///< one sentence; empty: `body` counts
};

/// Longest message, in bytes; a longer one is a fault.
inline constexpr std::size_t longestMessage = std::size_t{64} << 20;

class MessageStream {
 public:
  explicit MessageStream(Framing framing) : framing_(framing) {}

  void append(std::string_view bytes) { buffer_.append(bytes); }
  /// The next message that has arrived as a whole; nothing: more bytes are needed.
  std::optional<RawMessage> next();

 private:
  std::optional<RawMessage> nextLine();
  std::optional<RawMessage> nextFramed();
  void drop(std::size_t bytes) { buffer_.erase(0, bytes); }

  Framing framing_;
  std::string buffer_;
  std::optional<std::size_t> length_;  ///< of the body whose header has been read
};

/// A message as it goes out.
std::string framed(Framing framing, std::string_view body);

}  // namespace rungproof
