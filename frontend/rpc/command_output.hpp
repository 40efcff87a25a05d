// A command of the program, run inside of a server: what it prints, and its exit code. The servers have no second way
// to an answer.
#pragma once

#include <string>
#include <vector>

namespace rungproof {

struct CommandOutput {
  int exit = 0;
  std::string out;
  std::string err;
};
CommandOutput outputOf(const std::vector<std::string>& arguments);

}  // namespace rungproof
