// `rungproof lsp`: the server behind an editor.
#include "engine/platform/console.hpp"
#include "frontend/command.hpp"
#include "frontend/editor/editor_server.hpp"

namespace rungproof {

namespace {

Action setUpLsp(ArgumentTable& table) {
  // Editors add it without being asked; there is no other way to talk.
  auto isStdio = std::make_shared<bool>(false);
  table.flag("--stdio", *isStdio, "speak over standard input and output (always so)");
  return [isStdio](Context& context) {
    return EditorServer(context, static_cast<int>(Stream::In), static_cast<int>(Stream::Out)).run();
  };
}

}  // namespace

extern constexpr Command lspCommand = {
    .name = "lsp",
    .usage = "[--stdio]",
    .summary = "serve an editor over standard input and output (Language Server Protocol)",
    .details =
        "Reads and writes messages of the Language Server Protocol 3.17 on standard input and output. Findings are\n"
        "those of 'rungproof lint' with the configuration nearest to each document; options given here count for all.\n"
        "Offers: diagnostics on open, change and save; hover; definition; references; highlights; outline; workspace\n"
        "symbols; completion; rename; formatting; folding; colours by meaning; the symbol beside an address and the\n"
        "seconds beside a preset; fixes and suppressions as code actions; 'prove this property' as a code lens; the\n"
        "picture of a network (command rungproof.show, request rungproof/network); what the tables NAME.test.csv\n"
        "beside NAME.awl cover, as inlay hints at contacts and coils.\n"
        "\n"
        "Examples:\n"
        "    rungproof lsp\n"
        "    rungproof lsp --cpu ST40\n",
    .shows = option_group::Reading | option_group::Rules | option_group::Configuration | option_group::Proving,
    .formats = "json",
    .setup = setUpLsp,
};

}  // namespace rungproof
