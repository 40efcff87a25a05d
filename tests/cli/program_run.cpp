#include "program_run.hpp"

#include <unistd.h>

#include <fstream>
#include <sstream>

#include "frontend/cli.hpp"

namespace rungproof::test {

ProgramRun run(const std::vector<std::string>& arguments) {
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  ProgramRun result;
  result.exit = runProgram(arguments, {in, out, err});
  result.out = out.str();
  result.err = err.str();
  return result;
}

TemporaryFolder::TemporaryFolder() {
  static int count = 0;
  path_ = std::filesystem::temp_directory_path() / ("rungproof-cli-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
  std::filesystem::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() { std::filesystem::remove_all(path_); }

std::string TemporaryFolder::file(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path(name);
}

std::string contentOf(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string mainBlock(const std::string& networks) {
  return "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" + networks + "END_ORGANIZATION_BLOCK\n";
}

}  // namespace rungproof::test
