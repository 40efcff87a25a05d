// What help pages list, for the pages themselves and for everything else that is made from them: manual pages and the
// guide. Text is made by programHelp() and commandHelp() (cli.hpp).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "frontend/command.hpp"
#include "frontend/text/columns.hpp"

namespace rungproof {

/// "Arguments", "Options", then the groups of common options that the command shows.
struct HelpSection {
  std::string title;
  std::vector<TextRow> rows;
};
std::vector<HelpSection> helpSections(const Command& command, const ArgumentTable& table);

/// "0" and what it means.
std::vector<TextRow> exitCodeRows();

}  // namespace rungproof
