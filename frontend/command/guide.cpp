// `rungproof guide -o FOLDER`: the guide as a static HTML site; with --man the manual pages for man(1).
#include <fmt/format.h>

#include <filesystem>

#include "engine/platform/names.hpp"
#include "frontend/command.hpp"
#include "frontend/guide/site.hpp"

namespace rungproof {

namespace {

struct GuideArguments {
  std::string folder;
  bool man = false;
};

Exit runGuide(const GuideArguments& arguments, Context& context) {
  if (arguments.folder.empty())
    return context.fail({"no folder is named that the pages are to be written into", {}, "give -o FOLDER"});
  std::error_code error;  // a folder that cannot be made shows when the first page is written
  std::filesystem::create_directories(arguments.folder, error);
  const std::vector<GuideFile> files = arguments.man ? manPages() : guidePages();
  for (const GuideFile& file : files) {
    const std::string name = pathName(std::filesystem::path(arguments.folder) / file.name);
    if (!context.write({"html", name}, file.text)) return Exit::Failed;
  }
  if (!context.settings.flag(Opt::Quiet))
    context.err << fmt::format("rungproof: {} pages in {}; the first is {}\n", files.size(), arguments.folder,
                               files.front().name);
  return Exit::Clean;
}

Action setUpGuide(ArgumentTable& table) {
  auto arguments = std::make_shared<GuideArguments>();
  table.option("-o,--output", arguments->folder, "FOLDER", "folder for the pages");
  table.flag("--man", arguments->man, "write pages for man(1) in place of the site");
  return [arguments](Context& context) { return runGuide(*arguments, context); };
}

}  // namespace

extern constexpr Command guideCommand = {
    .name = "guide",
    .usage = "-o FOLDER [--man]",
    .summary = "write the guide as a static HTML site, or as manual pages",
    .details =
        "The site needs no server and no network: a tutorial, the property language with a picture for each\n"
        "pattern, every rule, command, option, CPU and choice, recipes for build servers, what is modelled, and\n"
        "how to check a certificate by hand.\n"
        "\n"
        "Examples:\n"
        "    rungproof guide -o guide\n"
        "    rungproof guide --man -o man1\n",
    .shows = option_group::Output,
    .needsNoConfig = true,
    .formats = "text",
    .setup = setUpGuide,
};

}  // namespace rungproof
