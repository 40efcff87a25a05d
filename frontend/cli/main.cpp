// The program. Everything of it is in cli.cpp, so that tests can reach it.
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <iostream>

#include "frontend/cli/cli.hpp"

namespace {

constexpr std::size_t stackBytes = std::size_t{8} << 20;  ///< what systems give by default

struct Call {
  std::vector<std::string> arguments;
  int exit = 2;
};

void* work(void* call) {
  auto& [arguments, exit] = *static_cast<Call*>(call);
  exit = rungproof::runProgram(
      arguments, {std::cin, std::cout, std::cerr, isatty(STDOUT_FILENO) == 1, isatty(STDERR_FILENO) == 1});
  return nullptr;
}

/// Whether threads get less room than the program needs, as under `ulimit -s 64`. From now on they get enough.
bool isStackSmall(pthread_attr_t& attributes) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= stackBytes)
    return false;
  return pthread_attr_setstacksize(&attributes, stackBytes) == 0 && pthread_setattr_default_np(&attributes) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a failure with a reason, not the end of the program
  Call call{{argv + 1, argv + argc}};
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_t thread{};
  if (isStackSmall(attributes) && pthread_create(&thread, &attributes, work, &call) == 0)
    pthread_join(thread, nullptr);
  else
    work(&call);
  return call.exit;
}
