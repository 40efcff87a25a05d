// Things that come from outside and are waited for together: bytes, an interrupt, a change of a file. Tested by
// tests/platform.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof {

class Waitable {
 public:
  Waitable(const Waitable&) = delete;
  Waitable& operator=(const Waitable&) = delete;
  /// What the system waits for: a descriptor, or the handle of an event. Negative: nothing comes.
  std::intptr_t handle() const { return handle_; }

 protected:
  Waitable() = default;
  ~Waitable() = default;
  std::intptr_t handle_ = -1;
};

/// Waits until something has come, or so long; negative: without end. By index: what is there; it may be nothing.
std::vector<bool> waitForAny(std::span<const Waitable* const> waited, int milliseconds);

/// Bytes that somebody writes: what stands behind a descriptor of this process, or what a child process gives.
class ByteSource final : public Waitable {
 public:
  enum class Taken : std::uint8_t { Bytes, Nothing, End };
  enum class Closing : bool { No, Yes };  ///< Yes: the descriptor is closed with the source

  explicit ByteSource(int descriptor, Closing closing = Closing::No);
  ~ByteSource();
  /// Appends what has come; waits if that is nothing yet.
  Taken take(std::string& bytes);

 private:
  struct Reader;  ///< where the system cannot wait for bytes
  Reader* reader_ = nullptr;
  Closing closing_;
};

/// All bytes, also where the system takes them in pieces; errno tells why not.
bool writeBytes(int descriptor, std::string_view bytes);
/// From now on a pipe without a reader is an error of writing, not the end of the program.
void outliveReaders();
/// The same while it lives.
class OutlivedReaders {
 public:
  OutlivedReaders();
  ~OutlivedReaders();
  OutlivedReaders(const OutlivedReaders&) = delete;
  OutlivedReaders& operator=(const OutlivedReaders&) = delete;

 private:
  void (*before_)(int) = nullptr;
};

}  // namespace rungproof
