// Runs the program in-process.
#include "page_run.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "frontend/cli/cli.hpp"

namespace rungproof::test {

std::string pageOf(std::vector<std::string> arguments, int* exit) {
  ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  arguments.insert(arguments.end(), {"--format", "html"});
  std::istringstream in;
  std::ostringstream out, err;
  const int code = runProgram(arguments, {in, out, err});
  if (exit != nullptr) *exit = code;
  return out.str();
}

std::string corpusFile(const std::string& name) { return std::string(RUNGPROOF_SOURCE_DIR) + "/corpus/" + name; }

std::string contentOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::size_t countIn(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

}  // namespace rungproof::test
