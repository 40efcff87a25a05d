// Shorthand of these tests: what the program prints and its exit code for a text of IEC 61131-3.
#pragma once

#include <gtest/gtest.h>

#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {

struct IecOutput {
  int exit = 0;
  std::string text;
  bool has(std::string_view part) const { return text.find(part) != std::string::npos; }
};

/// `arguments` with the file behind the command's name.
inline IecOutput runIec(std::vector<std::string> arguments, const std::string& text,
                        const std::string& name = "main.st") {
  const test::TemporaryFolder folder;
  folder.file(name, text);
  arguments.insert(arguments.begin() + 1, folder.path(name));
  arguments.emplace_back("--isolated");
  std::istringstream in;
  std::ostringstream out, err;
  const int exit = runProgram(arguments, {in, out, err});
  return {exit, out.str() + err.str()};
}

inline IecOutput proofOfIec(const std::string& text, std::vector<std::string> options = {}) {
  options.insert(options.begin(), "prove");
  return runIec(options, text);
}

/// The verdict on one property of a text: "PROVED", "VIOLATED" ...; otherwise everything that was printed.
inline std::string verdictOf(const std::string& text, const std::string& property) {
  const IecOutput output = proofOfIec("//@ prove asked: " + property + "\n" + text);
  for (const std::string verdict : {"PROVED", "VIOLATED", "VACUOUS", "UNKNOWN", "NOT COVERED"}) {
    if (output.has(verdict + "  asked")) return verdict;
  }
  return output.text;
}

}  // namespace rungproof
