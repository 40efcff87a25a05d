// Applying the fixes of findings to their files, or showing what that would change. Safe fixes cannot change what a
// correct program does; unsafe ones are guesses at what was meant, and are taken only if asked for. A file keeps its
// encoding, its byte order mark and its line ends; a file with bytes that its encoding does not know is left alone.
// Tested by tests/golden/lint/fix.test, tests/golden/lint/diff.test and tests/cli/fix_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "frontend/command.hpp"
#include "frontend/files/encoding.hpp"

namespace rungproof {

enum class FixLevel : bool { Safe, Unsafe };  ///< Unsafe: these too

/// A file with its fixes applied; of fixes that overlap the first is taken.
struct FixedFile {
  std::uint32_t file = 0;  ///< in the report's sources
  std::string name;
  std::string text;                 ///< UTF-8, as a whole
  std::vector<const Fix*> applied;  ///< in the order of their places
};
std::vector<FixedFile> fixedFiles(const Report& report, FixLevel level = FixLevel::Safe);

/// The bytes of the file after its fixes: outside of them every byte stays. Nothing if the bytes do not stand for the
/// text in that encoding, or the encoding lacks a character of a fix.
std::optional<std::string> fixedBytes(std::string_view bytes, std::string_view text,
                                      const std::vector<const Fix*>& fixes, TextEncoding encoding);

/// What the fixes change, as a unified diff with three lines around each change.
std::string unifiedDiff(const std::string& name, std::string_view text, const std::vector<const Fix*>& fixes);

/// Writes the files, standard input to Context::out; says on Context::err what was changed and what could not be. False
/// if something could not be written.
bool applyFixes(const Context& context, const Report& report, FixLevel level, bool readsStandardInput);
/// Prints the differences to Context::out and how many there are to Context::err; gives their number.
std::size_t showFixes(const Context& context, const Report& report, FixLevel level);

}  // namespace rungproof
