// The program. Everything of it is in cli.cpp, so that tests can reach it.
#include <unistd.h>

#include <iostream>

#include "frontend/cli/cli.hpp"

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const rungproof::Streams streams{std::cin, std::cout, std::cerr, isatty(STDOUT_FILENO) == 1,
                                   isatty(STDERR_FILENO) == 1};
  return rungproof::runProgram(arguments, streams);
}
