// From arguments to a command: finds the command, parses, reads the configuration, runs. Separate from main() so that
// tests can call it in-process. Pinned by tests/golden and tests/cli.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/command.hpp"

namespace rungproof {

/// Where a run reads and writes.
struct Streams {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
  bool outIsTerminal = false;
  bool errIsTerminal = false;
};

/// Runs the program; `arguments` without the program's own name. Returns the exit code.
int runProgram(const std::vector<std::string>& arguments, const Streams& streams);

/// Help of the program and of one command with its own rows.
std::string programHelp();
std::string commandHelp(const Command& command, const ArgumentTable& table);
std::string_view programVersion();

}  // namespace rungproof
