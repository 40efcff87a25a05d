// A program run as a process of its own, with a limit, and what the system says that it took.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace rungproof::test {

struct ProcessRun {
  double seconds = 0;           ///< processor time, its children's included
  std::uint64_t peakBytes = 0;  ///< largest resident memory
  bool isCut = false;           ///< ended by a signal, or by the limit of time
  int exit = -1;                ///< exit code; -1: there is none
  std::string output;           ///< standard output and standard error
};

/// In the child: never returns.
[[noreturn]] inline void executeLimited(const std::vector<std::string>& command, int output, double limit,
                                        std::uint64_t addressSpace) {
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  const auto most = static_cast<rlim_t>(std::ceil(limit));
  const rlimit processor{most, most + 1};
  ::setrlimit(RLIMIT_CPU, &processor);
  if (addressSpace != 0) {
    const rlimit space{addressSpace, addressSpace};
    ::setrlimit(RLIMIT_AS, &space);
  }
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execvp(words[0], words.data());
  ::_exit(127);
}

/// Runs a program, found along PATH, with at most `limit` seconds of processor time (1 s or more) and so many bytes of
/// address space; 0: any.
inline ProcessRun runProcess(const std::vector<std::string>& command, double limit, std::uint64_t addressSpace = 0) {
  FILE* const output = std::tmpfile();
  if (output == nullptr) throw std::runtime_error("no temporary file can be made");
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) executeLimited(command, ::fileno(output), limit, addressSpace);
  int status = 0;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  ProcessRun run;
  for (const timeval& time : {used.ru_utime, used.ru_stime})
    run.seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  run.peakBytes = static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
  if (WIFEXITED(status)) run.exit = WEXITSTATUS(status);
  run.isCut = WIFSIGNALED(status) || run.seconds > limit;
  std::rewind(output);
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), output)) > 0;)
    run.output.append(buffer.data(), n);
  std::fclose(output);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) throw std::runtime_error(command[0] + " cannot be run");
  return run;
}

}  // namespace rungproof::test
