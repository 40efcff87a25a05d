// Nobody can wait for bytes of a pipe here: a thread reads each source and sets an event.
#include "engine/platform/waitable.hpp"

#include <io.h>
#include <windows.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace rungproof {

std::vector<bool> waitForAny(std::span<const Waitable* const> waited, int milliseconds) {
  std::vector<HANDLE> handles;
  for (const Waitable* one : waited) {
    if (one->handle() > 0) handles.push_back(reinterpret_cast<HANDLE>(one->handle()));
  }
  std::vector<bool> ready(waited.size(), false);
  const DWORD limit = milliseconds < 0 ? INFINITE : static_cast<DWORD>(milliseconds);
  const auto most = std::min<std::size_t>(handles.size(), MAXIMUM_WAIT_OBJECTS);
  ::WaitForMultipleObjects(static_cast<DWORD>(most), handles.data(), FALSE, limit);
  for (std::size_t i = 0; i < waited.size(); ++i) {
    const std::intptr_t handle = waited[i]->handle();
    ready[i] = handle > 0 && ::WaitForSingleObject(reinterpret_cast<HANDLE>(handle), 0) == WAIT_OBJECT_0;
  }
  return ready;
}

/// The thread's side. It outlives its source where the thread still waits for bytes: nothing can end that wait.
struct ByteSource::Reader {
  std::mutex mutex;
  std::condition_variable taken;
  std::deque<std::string> pieces;
  std::size_t size = 0;
  bool hasEnded = false, isLeft = false, isDone = false;
  HANDLE event = nullptr;
  int descriptor = -1;
  bool isClosed = false;  ///< with the source

  void read() {
    constexpr std::size_t most = std::size_t{1} << 22;  // so much is kept for who does not take it
    std::string piece(std::size_t{1} << 16, '\0');
    while (true) {
      const int count = ::_read(descriptor, piece.data(), static_cast<unsigned>(piece.size()));
      std::unique_lock lock(mutex);
      if (count <= 0) hasEnded = true;
      if (count > 0) {
        pieces.emplace_back(piece, 0, static_cast<std::size_t>(count));
        size += static_cast<std::size_t>(count);
      }
      ::SetEvent(event);
      taken.wait(lock, [&] { return isLeft || hasEnded || size < most; });
      if (isLeft || hasEnded) break;
    }
    std::unique_lock lock(mutex);
    isDone = true;
    const bool isLast = isLeft;
    lock.unlock();
    if (isLast) release();
  }
  void release() {
    if (isClosed) ::_close(descriptor);
    ::CloseHandle(event);
    delete this;
  }
};

ByteSource::ByteSource(int descriptor, Closing closing) : reader_(new Reader), closing_(closing) {
  reader_->event = ::CreateEventW(nullptr, TRUE, FALSE, nullptr);
  handle_ = reinterpret_cast<std::intptr_t>(reader_->event);
  reader_->descriptor = descriptor;
  reader_->isClosed = closing == Closing::Yes;
  std::thread([reader = reader_] { reader->read(); }).detach();
}

ByteSource::~ByteSource() {
  std::unique_lock lock(reader_->mutex);
  reader_->isLeft = true;
  const bool isDone = reader_->isDone;
  lock.unlock();
  reader_->taken.notify_all();
  if (isDone) reader_->release();
}

ByteSource::Taken ByteSource::take(std::string& bytes) {
  ::WaitForSingleObject(reader_->event, INFINITE);
  const std::unique_lock lock(reader_->mutex);
  if (reader_->pieces.empty()) return reader_->hasEnded ? Taken::End : Taken::Nothing;
  for (const std::string& piece : reader_->pieces) bytes += piece;
  reader_->pieces.clear();
  reader_->size = 0;
  if (!reader_->hasEnded) ::ResetEvent(reader_->event);
  reader_->taken.notify_all();
  return Taken::Bytes;
}

bool writeBytes(int descriptor, std::string_view bytes) {
  constexpr std::size_t most = std::size_t{1} << 20;
  while (!bytes.empty()) {
    const int count = ::_write(descriptor, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), most)));
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void outliveReaders() {}  // it is an error of writing anyway

OutlivedReaders::OutlivedReaders() = default;
OutlivedReaders::~OutlivedReaders() = default;

}  // namespace rungproof
