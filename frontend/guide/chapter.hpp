// The chapters written by hand: the Markdown files of this folder, which the build puts into the program.
#pragma once

#include <span>
#include <string_view>

namespace rungproof {

struct Chapter {
  std::string_view name;  ///< "tutorial"; its page is tutorial.html
  std::string_view text;
};

/// In the order of the guide: by the number in front of the file's name.
std::span<const Chapter> chapters();

}  // namespace rungproof
