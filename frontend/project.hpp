// From files to a program: reads, converts, recognises, parses, resolves. Several files make one program: main text,
// symbol tables, data blocks, libraries. Tested by tests/reader/project_test.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/read_errors.hpp"
#include "frontend/stl/encoding.hpp"
#include "ir/program.hpp"

namespace rungproof {

enum class Dialect : std::uint8_t { Auto, S7200, S7300, S7400 };
enum class Mnemonics : std::uint8_t { Auto, International, German };

struct ReadOptions {
  Target target{};
  Dialect dialect = Dialect::Auto;
  Mnemonics mnemonics = Mnemonics::Auto;
  TextEncoding encoding = TextEncoding::Auto;
  std::vector<std::string> symbolFiles{};  ///< read as symbol tables whatever they look like
  std::string stdinName = "<stdin>";       ///< name of the file `-` in messages
  std::filesystem::path root{};            ///< of the project: files are named from there (nameInProject)
};

/// Reads all files into one program. `-` is standard input. Whatever cannot be read becomes a finding.
Program readProgram(const std::vector<std::string>& files, const ReadOptions& options = {});
/// The same for a text in memory (bytes in any encoding); `name` decides where the content does not.
Program readText(std::string name, std::string text, const ReadOptions& options = {});

}  // namespace rungproof
