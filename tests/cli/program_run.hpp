// Runs the program in-process: arguments in, exit code and both outputs out.
#pragma once

#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"

namespace rungproof::test {

struct ProgramRun {
  int exit = -1;
  std::string out;
  std::string err;
};
ProgramRun run(const std::vector<std::string>& arguments);

std::string contentOf(const std::string& path);
/// A MAIN block in the export form around the given network lines.
std::string mainBlock(const std::string& networks);

}  // namespace rungproof::test
