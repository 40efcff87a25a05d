#include "program_run.hpp"

#include <fstream>
#include <sstream>

#include "frontend/cli/cli.hpp"

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
