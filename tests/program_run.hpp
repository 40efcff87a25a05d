// Runs the program in-process: arguments in, exit code and both outputs out. And what tests read of its files.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/cli/cli.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {

struct ProgramRun {
  int exit = -1;
  std::string out, err;
  bool says(std::string_view text) const {
    return out.find(text) != std::string::npos || err.find(text) != std::string::npos;
  }
};

inline ProgramRun run(const std::vector<std::string>& arguments) {
  std::istringstream in;
  std::ostringstream out, err;
  ProgramRun result;
  result.exit = runProgram(arguments, {in, out, err});
  result.out = out.str();
  result.err = err.str();
  return result;
}

/// Empty where there is no file.
inline std::string contentOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// A MAIN block in the export form around the given network lines.
inline std::string mainBlock(const std::string& networks) {
  return "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" + networks + "END_ORGANIZATION_BLOCK\n";
}

}  // namespace rungproof::test
