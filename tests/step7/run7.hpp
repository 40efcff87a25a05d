// Programs of an S7-300/400 as texts, run and proved through the command line. Part of the tests of this folder.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "frontend/cli/cli.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test7 {

/// An organization block of statements that end in ';'.
inline std::string block(int number, const std::string& statements, const std::string& declarations = "") {
  std::string text = "ORGANIZATION_BLOCK OB " + std::to_string(number) + "\n" + declarations + "BEGIN\nNETWORK\n";
  std::istringstream in(statements);
  for (std::string one; std::getline(in, one, ';');) text += one + ";\n";
  return text + "END_ORGANIZATION_BLOCK\n";
}

struct Output {
  int exit;
  std::string text;
  bool has(const std::string& part) const { return text.find(part) != std::string::npos; }
};

inline Output run(std::vector<std::string> arguments) {
  std::istringstream in;
  std::ostringstream out, err;
  arguments.emplace_back("--isolated");
  if (std::ranges::find(arguments, "--dialect") == arguments.end() &&
      std::ranges::find(arguments, "--cpu") == arguments.end())
    arguments.insert(arguments.end(), {"--dialect", "s7-300"});
  const int exit = runProgram(arguments, {in, out, err});
  return {exit, out.str() + err.str()};
}

inline Output proofOf(const std::string& properties, const std::string& blocks,
                      const std::vector<std::string>& more = {}) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", blocks);
  folder.file("main.prop", properties);
  std::vector<std::string> arguments = {"prove", folder.path("main.awl"), "--props", folder.path("main.prop")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

/// The rows of the trace of a run without their heading; what the command says where there is none.
inline std::vector<std::string> rowsOf(const std::string& blocks, const std::string& signals,
                                       const std::vector<std::string>& more, const std::string& stimulus = "") {
  const test::TemporaryFolder folder;
  folder.file("main.awl", blocks);
  std::vector<std::string> arguments = {"sim",  folder.path("main.awl"), "--trace", folder.path("run.csv"), "--signals",
                                        signals};
  arguments.insert(arguments.end(), more.begin(), more.end());
  if (!stimulus.empty()) {
    folder.file("in.csv", stimulus);
    arguments.insert(arguments.end(), {"--stimulus", folder.path("in.csv")});
  }
  const Output output = run(arguments);
  std::ifstream file(folder.path("run.csv"));
  std::vector<std::string> rows;
  for (std::string row; std::getline(file, row);) rows.push_back(row);
  if (rows.empty()) return {output.text};
  rows.erase(rows.begin());
  return rows;
}

/// The last row of the trace of a run.
inline std::string lastRow(const std::string& blocks, const std::string& signals, const std::vector<std::string>& more,
                           const std::string& stimulus = "") {
  return rowsOf(blocks, signals, more, stimulus).back();
}

}  // namespace rungproof::test7
