// Framing of messages.
#include "frontend/rpc/message_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace rungproof {

namespace {

constexpr std::string_view lengthHeader = "content-length:";
constexpr std::size_t longestHeader = 8192;

char smallLetter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

/// The number behind the last Content-Length of a header: rests of a message of wrong length may stand before it.
std::optional<std::size_t> lengthIn(std::string_view header) {
  std::string small(header);
  std::ranges::transform(small, small.begin(), smallLetter);
  const std::size_t at = small.rfind(lengthHeader);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t first = header.find_first_not_of(" \t", at + lengthHeader.size());
  if (first == std::string_view::npos) return std::nullopt;
  std::size_t length = 0;
  const char* const end = header.data() + header.size();
  const auto [rest, error] = std::from_chars(header.data() + first, end, length);
  const bool endsLine = rest == end || *rest == '\r' || *rest == '\n' || *rest == ' ';
  return error == std::errc() && endsLine ? std::optional(length) : std::nullopt;
}

}  // namespace

std::optional<RawMessage> MessageStream::next() { return framing_ == Framing::Lines ? nextLine() : nextFramed(); }

std::optional<RawMessage> MessageStream::nextLine() {
  while (true) {
    const std::size_t end = buffer_.find('\n');
    if (end == std::string::npos) {
      if (buffer_.size() <= longestMessage) return std::nullopt;
      buffer_.clear();
      return RawMessage{{}, "the line is too long"};
    }
    std::string line = buffer_.substr(0, end);
    drop(end + 1);
    if (line.ends_with('\r')) line.pop_back();
    if (line.find_first_not_of(" \t") != std::string::npos) return RawMessage{std::move(line), {}};
  }
}

std::optional<RawMessage> MessageStream::nextFramed() {
  if (!length_) {
    const std::size_t end = buffer_.find("\r\n\r\n");
    if (end == std::string::npos) {
      if (buffer_.size() <= longestHeader) return std::nullopt;
      drop(buffer_.size() - lengthHeader.size());  // the next header may have begun
      return RawMessage{{}, "no header 'Content-Length' was found"};
    }
    const std::optional<std::size_t> length = lengthIn(std::string_view(buffer_).substr(0, end));
    drop(end + 4);
    if (!length) return RawMessage{{}, "the header has no 'Content-Length' with a number"};
    if (*length > longestMessage) return RawMessage{{}, fmt::format("a message of {} bytes is too long", *length)};
    length_ = length;
  }
  if (buffer_.size() < *length_) return std::nullopt;
  RawMessage message{buffer_.substr(0, *length_), {}};
  drop(*length_);
  length_.reset();
  return message;
}

std::string framed(Framing framing, std::string_view body) {
  if (framing == Framing::Lines) return fmt::format("{}\n", body);
  return fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body);
}

}  // namespace rungproof
