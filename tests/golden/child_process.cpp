// Child processes by fork and exec; outputs go through files, so that no pipe can fill up.
#include "child_process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace golden {

namespace {

std::string contentOf(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void redirect(const std::string& path, int flags, int descriptor) {
  const int file = ::open(path.c_str(), flags, 0600);
  if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(126);
  ::close(file);
}

}  // namespace

Outcome runChild(const std::string& program, const std::vector<std::string>& arguments, const std::string& folder,
                 const std::string& input) {
  const std::string base = folder + ".run";
  std::ofstream(base + ".in", std::ios::binary) << input;
  const pid_t child = ::fork();
  if (child == 0) {
    redirect(base + ".in", O_RDONLY, STDIN_FILENO);
    redirect(base + ".out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    redirect(base + ".err", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    ::unsetenv("NO_COLOR");
    ::setenv("TERM", "xterm", 1);
    ::setenv("LC_ALL", "C.UTF-8", 1);
    ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);  // pages name the day they were made
    std::vector<char*> argv = {const_cast<char*>("rungproof")};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::alarm(commandSeconds);
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  Outcome outcome;
  outcome.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = contentOf(base + ".out");
  outcome.err = contentOf(base + ".err");
  for (const char* ending : {".in", ".out", ".err"}) std::filesystem::remove(base + ending);
  return outcome;
}

}  // namespace golden
