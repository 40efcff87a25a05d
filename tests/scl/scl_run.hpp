// Programs in SCL as texts, run, proved, compared and linted through the command line. Part of the tests of this
// folder.
#pragma once

#include "tests/step7/run7.hpp"

namespace rungproof::testscl {

using test7::Output;

/// OB1 of a body, with its declarations.
inline std::string mainOf(const std::string& body, const std::string& declarations = "") {
  return "ORGANIZATION_BLOCK OB 1\n" + declarations + "BEGIN\n" + body + "\nEND_ORGANIZATION_BLOCK\n";
}

inline Output commandOn(const std::string& command, const std::string& text,
                        const std::vector<std::string>& more = {}) {
  const test::TemporaryFolder folder;
  folder.file("main.scl", text);
  std::vector<std::string> arguments = {command, folder.path("main.scl")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test7::run(arguments);
}

inline Output proofOf(const std::string& properties, const std::string& text,
                      const std::vector<std::string>& more = {}) {
  const test::TemporaryFolder folder;
  folder.file("main.scl", text);
  folder.file("main.prop", properties);
  std::vector<std::string> arguments = {"prove", folder.path("main.scl"), "--props", folder.path("main.prop")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test7::run(arguments);
}

/// Scan and values of the last row of a run; what the command says where there is none.
inline std::string lastRow(const std::string& text, const std::string& signals, const std::string& scans = "1",
                           const std::string& stimulus = "") {
  const test::TemporaryFolder folder;
  folder.file("main.scl", text);
  std::vector<std::string> arguments = {
      "sim", folder.path("main.scl"), "--trace", folder.path("run.csv"), "--signals", signals, "--scans", scans};
  if (!stimulus.empty()) {
    folder.file("in.csv", stimulus);
    arguments.insert(arguments.end(), {"--stimulus", folder.path("in.csv")});
  }
  const Output output = test7::run(arguments);
  std::ifstream file(folder.path("run.csv"));
  std::string last;
  for (std::string row; std::getline(file, row);) last = row;
  if (last.empty()) return output.text;
  std::size_t behind = 0;  // scan, time_ms, scan_ms
  for (int i = 0; i < 3; ++i) behind = last.find(',', behind) + 1;
  return last.substr(0, last.find(',') + 1) + last.substr(behind);
}

}  // namespace rungproof::testscl
