// Commands on streams in memory.
#include "frontend/rpc/command_output.hpp"

#include <sstream>

#include "frontend/cli/cli.hpp"
#include "frontend/text/text_stream.hpp"

namespace rungproof {

CommandOutput outputOf(const std::vector<std::string>& arguments) {
  std::istringstream in;
  TextStream out, err;
  const int exit = runProgram(arguments, {in, out, err});
  return {exit, std::move(out).str(), std::move(err).str()};
}

}  // namespace rungproof
