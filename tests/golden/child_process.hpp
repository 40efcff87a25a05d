// Runs the program under test as a child: fixed environment, given folder and standard input, both outputs captured.
#pragma once

#include <string>
#include <vector>

namespace golden {

struct Outcome {
  int exit = -1;  ///< exit code, or 128 + signal
  std::string out;
  std::string err;
};

/// Longest time a command may take, in seconds; then it is killed by SIGALRM.
inline constexpr unsigned commandSeconds = 60;

Outcome runChild(const std::string& program, const std::vector<std::string>& arguments, const std::string& folder,
                 const std::string& input);

}  // namespace golden
