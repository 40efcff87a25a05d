// Streams are as the shell gives them; a small stack is made larger.
#include "engine/platform/console.hpp"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

namespace rungproof {

namespace {

constexpr std::size_t stackBytes = std::size_t{8} << 20;  ///< what systems give by default

struct Call {
  const std::function<int()>& work;
  int exit = 2;
};

void* runCall(void* call) {
  auto& [work, exit] = *static_cast<Call*>(call);
  exit = work();
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

std::vector<std::string> programArguments(int argc, char** argv) { return {argv + 1, argv + argc}; }

bool isTerminal(Stream stream) { return ::isatty(static_cast<int>(stream)) == 1; }

int runProgramIn(const std::function<int()>& work) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a failure with a reason, not the end of the program
  Call call{work};
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_t thread{};
  if (isStackSmall(attributes) && pthread_create(&thread, &attributes, runCall, &call) == 0)
    pthread_join(thread, nullptr);
  else
    runCall(&call);
  return call.exit;
}

}  // namespace rungproof
