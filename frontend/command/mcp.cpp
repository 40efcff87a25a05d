// `rungproof mcp`: tools for assistants.
#include <fmt/format.h>

#include <filesystem>

#include "engine/platform/console.hpp"
#include "frontend/assistant/assistant_server.hpp"
#include "frontend/command.hpp"

namespace rungproof {

namespace {

Action setUpMcp(ArgumentTable& table) {
  auto root = std::make_shared<std::string>(".");
  table.option("--root", *root, "DIR", "folder that tools may read, links followed [default: the current one]");
  return [root](Context& context) {
    std::error_code error;
    if (!std::filesystem::is_directory(*root, error))
      return context.fail({fmt::format("'{}' is no folder", *root), {}, "--root names the folder that tools may read"});
    confineInputs(*root);
    const Exit exit = AssistantServer(context, static_cast<int>(Stream::In), static_cast<int>(Stream::Out)).run();
    confineInputs({});
    return exit;
  };
}

}  // namespace

extern constexpr Command mcpCommand = {
    .name = "mcp",
    .usage = "[OPTIONS]",
    .summary = "serve an assistant over standard input and output (Model Context Protocol)",
    .details =
        "Reads and writes messages of the Model Context Protocol, one a line, on standard input and output. Tools:\n"
        "lint, check, prove, sim, test, show, explain and xref, as the commands of these names; the program is given\n"
        "as text or as a path below --root. An answer has the text of the command and its JSON report. Options given\n"
        "here count for every call; files that they name must lie below --root too.\n"
        "\n"
        "Example, in the settings of an assistant:\n"
        "    { \"mcpServers\": { \"rungproof\": { \"command\": \"rungproof\", \"args\": [\"mcp\", \"--timeout\", "
        "\"20s\"] } } }\n",
    .shows = option_group::Reading | option_group::Running | option_group::Rules | option_group::Configuration |
             option_group::Proving,
    .formats = "json",
    .setup = setUpMcp,
};

}  // namespace rungproof
