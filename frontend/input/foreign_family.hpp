// What a file that no reader takes seems to be: programs of other controllers and makers, projects of editors,
// documents.
// Tested by tests/golden/errors/families.test and tests/reader/foreign_family_test.cpp.
#pragma once

#include <optional>
#include <string_view>

namespace rungproof {

struct ForeignFamily {
  std::string_view what;  ///< "STL of an S7-300 or S7-400"
  std::string_view help;  ///< what to do with such a file
};

/// By the first bytes: archives, editors' projects, documents.
std::optional<ForeignFamily> foreignContainer(std::string_view bytes);
/// By the root of an XML file, or by words and signs that a program of the S7-200 does not have. Nothing if unsure.
std::optional<ForeignFamily> foreignText(std::string_view text);

}  // namespace rungproof
