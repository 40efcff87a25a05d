// A thread for each folder reads its changes; a handler of the console notes interrupts.
#include "engine/platform/folder_watch.hpp"

#include <windows.h>

#include <array>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "engine/platform/windows/names.hpp"

namespace rungproof {

struct FolderWatch::State {
  std::mutex mutex;
  std::vector<std::string> changed;
  std::set<std::string> folders;
  HANDLE event = ::CreateEventW(nullptr, TRUE, FALSE, nullptr);

  ~State() { ::CloseHandle(event); }
  void note(std::vector<std::string> names) {
    const std::lock_guard lock(mutex);
    changed.insert(changed.end(), names.begin(), names.end());
    ::SetEvent(event);
  }
};

FolderWatch::FolderWatch() : state_(std::make_shared<State>()) {
  handle_ = reinterpret_cast<std::intptr_t>(state_->event);
}

FolderWatch::~FolderWatch() = default;  // the threads wait until the process ends

void FolderWatch::add(const std::string& folder) {
  {
    const std::lock_guard lock(state_->mutex);
    if (!state_->folders.insert(folder).second) return;
  }
  const HANDLE handle = ::CreateFileW(std::filesystem::path(folder).c_str(), FILE_LIST_DIRECTORY,
                                      FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, OPEN_EXISTING,
                                      FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return;
  std::thread([state = state_, folder, handle] {
    constexpr DWORD kinds = FILE_NOTIFY_CHANGE_FILE_NAME | FILE_NOTIFY_CHANGE_LAST_WRITE | FILE_NOTIFY_CHANGE_SIZE;
    alignas(FILE_NOTIFY_INFORMATION) std::array<char, 16384> events{};
    DWORD count = 0;
    while (::ReadDirectoryChangesW(handle, events.data(), events.size(), FALSE, kinds, &count, nullptr, nullptr) != 0) {
      std::vector<std::string> names;
      for (DWORD at = 0; count > 0;) {
        const auto& event = *reinterpret_cast<const FILE_NOTIFY_INFORMATION*>(events.data() + at);
        const std::wstring name(event.FileName, event.FileNameLength / sizeof(wchar_t));
        names.push_back((std::filesystem::path(folder) / name).generic_string());
        if (event.NextEntryOffset == 0) break;
        at += event.NextEntryOffset;
      }
      state->note(std::move(names));
    }
    ::CloseHandle(handle);
  }).detach();
}

std::vector<std::string> FolderWatch::take() {
  const std::lock_guard lock(state_->mutex);
  ::ResetEvent(state_->event);
  return std::exchange(state_->changed, {});
}

namespace {

std::mutex watchMutex;
HANDLE interruptEvent = nullptr;  ///< of the one watch that lives

BOOL WINAPI noteInterrupt(DWORD which) {
  const std::lock_guard lock(watchMutex);
  if (interruptEvent == nullptr || (which != CTRL_C_EVENT && which != CTRL_BREAK_EVENT)) return FALSE;
  ::SetEvent(interruptEvent);
  return TRUE;
}

}  // namespace

InterruptWatch::InterruptWatch() {
  const std::lock_guard lock(watchMutex);
  interruptEvent = ::CreateEventW(nullptr, TRUE, FALSE, nullptr);  // stays until take()
  handle_ = reinterpret_cast<std::intptr_t>(interruptEvent);
  ::SetConsoleCtrlHandler(noteInterrupt, TRUE);
}

InterruptWatch::~InterruptWatch() {
  ::SetConsoleCtrlHandler(noteInterrupt, FALSE);
  const std::lock_guard lock(watchMutex);
  ::CloseHandle(interruptEvent);
  interruptEvent = nullptr;
}

int InterruptWatch::take() {
  ::ResetEvent(interruptEvent);
  return CTRL_BREAK_EVENT;
}

}  // namespace rungproof
