// One run of a command in which one call fails (injector.cpp), in a folder of its own, and what it leaves there.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rungproof::test {

using Contents = std::map<std::string, std::string>;  ///< of files, by their names in the folder

struct FaultRun {
  int exit = -1;       ///< -1: ended by a signal, or by the limit of time
  std::string output;  ///< standard output and standard error
  Contents files;
};

/// `fault`: "memory:7", "open:1+", or empty. The folder begins with `files`.
FaultRun runWithFault(const std::vector<std::string>& arguments, const Contents& files, const std::string& fault);

/// How many calls of each kind a run makes in which nothing fails.
std::map<std::string, std::uint64_t> countCalls(const std::vector<std::string>& arguments, const Contents& files);

}  // namespace rungproof::test
