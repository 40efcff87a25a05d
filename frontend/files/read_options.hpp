// How files are to be read: the CPU that they are for, dialect, mnemonics, encoding. From the command line and the
// configuration; every reader is given it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frontend/files/encoding.hpp"
#include "ir/dialect.hpp"

namespace rungproof {

enum class Mnemonics : std::uint8_t { Auto, International, German };

struct ReadOptions {
  Target target{};
  std::string dialect = "auto";  ///< as --dialect takes it; auto: what the text looks like
  Mnemonics mnemonics = Mnemonics::Auto;
  TextEncoding encoding = TextEncoding::Auto;
  std::vector<std::string> symbolFiles{};  ///< read as symbol tables whatever they look like
  std::string stdinName = "<stdin>";       ///< name of the file `-` in messages
  std::filesystem::path root{};            ///< of the project: files are named from there (nameInProject)
  bool hidesProtected = false;             ///< STEP 7 project: know-how protected blocks count as interfaces only

  bool allows(const Dialect& wanted) const { return dialect == "auto" || dialect == wanted.name; }
};

}  // namespace rungproof
