// The kinds of file that can be read: one object of this type per file of frontend/reader, named after the file.
// Nothing else has to be edited to add a reader. Tested by tests/reader/project_test.cpp.
#pragma once

#include <span>
#include <string_view>

#include "frontend/files/read_options.hpp"
#include "ir/program.hpp"

namespace rungproof {

struct DrawnProject;
namespace step7 {
struct Step7Project;
}
namespace iec {
struct ProjectSyntax;
}

/// How sure a reader is that a text is of its kind: the surest reader reads it, at 0 nobody does.
namespace sureness {
inline constexpr int None = 0;
inline constexpr int Ending = 10;    ///< only the file name says so
inline constexpr int Likely = 50;    ///< most lines look so
inline constexpr int Keyword = 90;   ///< a heading of that kind stands in the text
inline constexpr int Certain = 100;  ///< a heading that no other kind has, or the user said so
}  // namespace sureness

/// One text on its way into the program.
struct InputText {
  std::uint32_t file = 0;  ///< index in Program::sources
  TextEncoding encoding = TextEncoding::Utf8;
  bool isSymbolFile = false;             ///< named by --symbols
  DrawnProject* drawn = nullptr;         ///< readers of drawings append here; built when all files are read
  step7::Step7Project* step7 = nullptr;  ///< readers of S7-300/400 sources append here, likewise
  iec::ProjectSyntax* iec = nullptr;     ///< readers of IEC 61131-3 texts append here, likewise
  bool isStep7Project = false;           ///< the project has such sources
};

struct FileReader {
  std::string_view name;  ///< for messages: "statement list", "symbol table"
  int (*sureness)(const SourceFile& file, const InputText& input, const ReadOptions& options);
  /// Appends to the program; findings go to Program::findings.
  void (*read)(Program& program, const InputText& input, const ReadOptions& options);
  /// Whether the text is a table, whose reader is chosen when all other files are known; nullptr: never.
  bool (*waits)(const SourceFile& file) = nullptr;
};

/// Every reader, sorted by file name.
std::span<const FileReader* const> fileReaders();

/// Whether the file name ends in one of the endings (".awl"), in any case.
bool endsInAny(std::string_view name, std::initializer_list<std::string_view> endings);

}  // namespace rungproof
