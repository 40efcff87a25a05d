// Manual pages for man(1), from the same tables as --help. Tested by tests/guide/man_test.cpp, which has groff read
// them.
#pragma once

#include <string>
#include <vector>

#include "frontend/command.hpp"

namespace rungproof {

/// A file of the guide or of the manual.
struct GuideFile {
  std::string name;  ///< "rungproof-prove.1", "tutorial.html"
  std::string text;
};

/// rungproof(1) and one page for each command.
std::vector<GuideFile> manPages();

/// Text for roff: nothing in it is a request or an escape.
std::string roffText(std::string_view text);

}  // namespace rungproof
