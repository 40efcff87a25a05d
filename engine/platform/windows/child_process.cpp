// This program, started again: the request comes and the result goes through pipes that the child inherits. A job
// object ends the child with its parent and holds its memory within the limit.
#include "engine/platform/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <io.h>
#include <windows.h>

#include <array>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "engine/platform/windows/names.hpp"

namespace rungproof {

namespace {

constexpr std::string_view workerSign = "--worker=";  ///< --worker=NAME:REQUEST:RESULT, two inherited handles
constexpr int brokenOff = 1;                          ///< exit code of a worker that threw or whose parent is deaf
constexpr DWORD mostExit = 255;                       ///< what is above that, the system has set

std::wstring ownProgram() {
  std::wstring name(32768, L'\0');
  name.resize(::GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
  return name;
}

/// A pipe of which the child inherits one end.
struct Pipe {
  HANDLE read = nullptr, write = nullptr;
  bool make(bool childReads) {
    if (::CreatePipe(&read, &write, nullptr, 1U << 16) == 0) return false;
    ::SetHandleInformation(childReads ? read : write, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
    return true;
  }
  static void close(HANDLE& end) {
    if (end != nullptr) ::CloseHandle(end);
    end = nullptr;
  }
};

HANDLE jobFor(std::uint64_t memory) {
  const HANDLE job = ::CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  if (memory > 0) {
    limits.BasicLimitInformation.LimitFlags |= JOB_OBJECT_LIMIT_PROCESS_MEMORY;
    limits.ProcessMemoryLimit = memory;
  }
  ::SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  return job;
}

/// Of a child that reads and prints nothing.
HANDLE nothing(DWORD access) {
  SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
  return ::CreateFileW(L"NUL", access, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited, OPEN_EXISTING, 0, nullptr);
}

}  // namespace

ChildProcess::ChildProcess(const Worker& worker, const std::string& request, ChildKind kind, std::uint64_t memory) {
  static std::mutex oneAtATime;  // a child must not inherit the ends that another one is given
  const std::lock_guard lock(oneAtATime);
  Pipe toChild, fromChild;
  if (!toChild.make(true) || !fromChild.make(false)) return;
  const std::wstring program = ownProgram();
  std::wstring line =
      L"\"" + program + L"\" " +
      wideName(fmt::format("{}{}:{}:{}", workerSign, worker.name, reinterpret_cast<std::uintptr_t>(toChild.read),
                           reinterpret_cast<std::uintptr_t>(fromChild.write)));
  STARTUPINFOW start{};
  start.cb = sizeof start;
  DWORD flags = CREATE_SUSPENDED;
  if (kind == ChildKind::Run) {
    flags |= CREATE_NEW_PROCESS_GROUP;  // Ctrl-C comes through the parent, once
  } else {
    flags |= CREATE_NO_WINDOW;
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdInput = nothing(GENERIC_READ);
    start.hStdOutput = nothing(GENERIC_WRITE);
    start.hStdError = ::GetStdHandle(STD_ERROR_HANDLE);
  }
  PROCESS_INFORMATION child{};
  const bool hasBegun = ::CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, flags, nullptr, nullptr,
                                         &start, &child) != 0;
  if (kind != ChildKind::Run) {
    ::CloseHandle(start.hStdInput);
    ::CloseHandle(start.hStdOutput);
  }
  Pipe::close(toChild.read);
  Pipe::close(fromChild.write);
  if (!hasBegun) {
    Pipe::close(toChild.write);
    Pipe::close(fromChild.read);
    return;
  }
  const HANDLE job = jobFor(memory);
  ::AssignProcessToJobObject(job, child.hProcess);
  ::ResumeThread(child.hThread);
  ::CloseHandle(child.hThread);
  process_ = reinterpret_cast<std::intptr_t>(child.hProcess);
  fate_ = reinterpret_cast<std::intptr_t>(job);
  // The child reads when it has started; who asks does not wait for that.
  const int to = ::_open_osfhandle(reinterpret_cast<std::intptr_t>(toChild.write), _O_BINARY | _O_NOINHERIT);
  std::thread([to, request] {
    writeBytes(to, request);
    ::_close(to);
  }).detach();
  const int from = ::_open_osfhandle(reinterpret_cast<std::intptr_t>(fromChild.read), _O_BINARY | _O_NOINHERIT);
  output_ = std::make_unique<ByteSource>(from, ByteSource::Closing::Yes);
}

ChildProcess::~ChildProcess() {
  if (process_ > 0) {
    const auto process = reinterpret_cast<HANDLE>(process_);
    ::TerminateProcess(process, mostExit + 1);
    ::WaitForSingleObject(process, INFINITE);
    ::CloseHandle(process);
  }
  if (fate_ > 0) ::CloseHandle(reinterpret_cast<HANDLE>(fate_));
  output_.reset();
}

std::optional<int> ChildProcess::wait() {
  if (process_ <= 0) return std::nullopt;
  const auto process = reinterpret_cast<HANDLE>(process_);
  ::WaitForSingleObject(process, INFINITE);
  DWORD exit = mostExit + 1;
  ::GetExitCodeProcess(process, &exit);
  ::CloseHandle(process);
  process_ = -1;
  return exit <= mostExit ? std::optional<int>(static_cast<int>(exit)) : std::nullopt;
}

void ChildProcess::interrupt(int /*which*/) {
  if (process_ <= 0) return;
  const auto process = reinterpret_cast<HANDLE>(process_);
  if (::GenerateConsoleCtrlEvent(CTRL_BREAK_EVENT, ::GetProcessId(process)) == 0)
    ::TerminateProcess(process, mostExit + 1);
}

std::optional<int> workerExit(const std::vector<std::string>& arguments, std::span<const Worker* const> workers) {
  if (arguments.size() != 1 || !arguments.front().starts_with(workerSign)) return std::nullopt;
  const std::string call = arguments.front().substr(workerSign.size());
  const std::size_t first = call.find(':'), second = call.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) return brokenOff;
  const auto descriptorOf = [](const std::string& number) {
    const auto handle = static_cast<std::intptr_t>(std::strtoull(number.c_str(), nullptr, 10));
    return ::_open_osfhandle(handle, _O_BINARY | _O_NOINHERIT);
  };
  const int in = descriptorOf(call.substr(first + 1, second - first - 1)), out = descriptorOf(call.substr(second + 1));
  if (in < 0 || out < 0) return brokenOff;
  std::string request, piece(std::size_t{1} << 16, '\0');
  while (true) {
    const int count = ::_read(in, piece.data(), static_cast<unsigned>(piece.size()));
    if (count <= 0) break;
    request.append(piece, 0, static_cast<std::size_t>(count));
  }
  for (const Worker* worker : workers) {
    if (worker->name != std::string_view(call).substr(0, first)) continue;
    try {
      return worker->work(request, [out](std::string_view bytes) { return writeBytes(out, bytes); });
    } catch (...) {
      return brokenOff;
    }
  }
  return brokenOff;
}

}  // namespace rungproof
