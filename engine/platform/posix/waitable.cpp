// Descriptors and poll().
#include "engine/platform/waitable.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace rungproof {

std::vector<bool> waitForAny(std::span<const Waitable* const> waited, int milliseconds) {
  std::vector<pollfd> watched;
  for (const Waitable* one : waited) watched.push_back({static_cast<int>(one->handle()), POLLIN, 0});
  std::vector<bool> ready(waited.size(), false);
  if (::poll(watched.data(), watched.size(), milliseconds) <= 0) return ready;
  for (std::size_t i = 0; i < watched.size(); ++i) ready[i] = watched[i].revents != 0;
  return ready;
}

ByteSource::ByteSource(int descriptor, Closing closing) : closing_(closing) { handle_ = descriptor; }

ByteSource::~ByteSource() {
  if (closing_ == Closing::Yes) ::close(static_cast<int>(handle_));
}

ByteSource::Taken ByteSource::take(std::string& bytes) {
  std::array<char, 65536> piece{};
  const ssize_t count = ::read(static_cast<int>(handle_), piece.data(), piece.size());
  if (count < 0 && errno == EINTR) return Taken::Nothing;
  if (count <= 0) return Taken::End;
  bytes.append(piece.data(), static_cast<std::size_t>(count));
  return Taken::Bytes;
}

bool writeBytes(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void outliveReaders() { std::signal(SIGPIPE, SIG_IGN); }

OutlivedReaders::OutlivedReaders() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
OutlivedReaders::~OutlivedReaders() { std::signal(SIGPIPE, before_); }

}  // namespace rungproof
