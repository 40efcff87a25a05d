// What the system gives a program at its start: arguments, streams, room. Tested through tests/cli.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rungproof {

/// The arguments behind the program's name, in UTF-8.
std::vector<std::string> programArguments(int argc, char** argv);

enum class Stream : int { In = 0, Out = 1, Err = 2 };  ///< as descriptors
/// Whether a person reads there, and letters have colours.
bool isTerminal(Stream stream);

/// Prepares streams and system, then runs `work` with as much stack as the program needs; its exit code.
int runProgramIn(const std::function<int()>& work);

}  // namespace rungproof
