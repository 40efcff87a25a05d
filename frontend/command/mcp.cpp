// `rungproof mcp`: tools for assistants.
#include <unistd.h>

#include "frontend/assistant/assistant_server.hpp"
#include "frontend/command.hpp"

namespace rungproof {

namespace {

Action setup(ArgumentTable&) {
  return [](Context& context) { return AssistantServer(context, STDIN_FILENO, STDOUT_FILENO).run(); };
}

}  // namespace

extern constexpr Command mcpCommand = {
    .name = "mcp",
    .usage = "[OPTIONS]",
    .summary = "serve an assistant over standard input and output (Model Context Protocol)",
    .details =
        "Reads and writes messages of the Model Context Protocol, one a line, on standard input and output. Tools:\n"
        "lint, check, prove, sim, show, explain and xref, as the commands of these names; the program is given as "
        "text\n"
        "or as a path. An answer has the text of the command and its JSON report. Options given here count for every\n"
        "call.\n"
        "\n"
        "Example, in the settings of an assistant:\n"
        "    { \"mcpServers\": { \"rungproof\": { \"command\": \"rungproof\", \"args\": [\"mcp\", \"--timeout\", "
        "\"20s\"] } } }\n",
    .shows = option_group::Reading | option_group::Running | option_group::Rules | option_group::Configuration |
             option_group::Proving,
    .formats = "json",
    .setup = setup,
};

}  // namespace rungproof
