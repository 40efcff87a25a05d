// The programs of the corpus for tests that go through all of them: files, expected verdicts, and the program read
// with its properties. The form of the expectations is described in corpus_test.cpp.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/proof/prover.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/settings/retentive_range.hpp"

namespace rungproof::test {

/// The file with the expectations: of a project of many files its main program.
inline std::filesystem::path headOf(const std::filesystem::path& program) {
  return std::filesystem::is_directory(program) ? program / "MAIN.stl" : program;
}

/// Programs in corpus/, or in one folder of it, sorted by name: files, and folders that hold one program in many files.
inline std::vector<std::filesystem::path> corpusFiles(const std::string& folder = "") {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus" / folder)) {
    const std::string ending = entry.path().extension().string();
    if (entry.is_directory() && std::filesystem::exists(headOf(entry.path()))) files.push_back(entry.path());
    const bool isProgram = ending == ".awl" || ending == ".stl" || ending == ".st" || ending == ".il" ||
                           ending == ".scl" || ending == ".xml";
    if (isProgram && !std::filesystem::exists(headOf(entry.path().parent_path()))) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// A name for a parameterised test: folder and name of the file.
inline std::string testNameOf(const std::filesystem::path& file) {
  std::string name = file.parent_path().filename().string() + "_" + file.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

/// What the head of a program says about each property, what is still owed included.
inline std::map<std::string, std::string> trueVerdicts(const std::filesystem::path& file) {
  std::map<std::string, std::string> verdicts;
  std::ifstream stream(headOf(file), std::ios::binary);
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    for (const std::string head : {"//! verdict ", "//! open "}) {
      const std::size_t colon = line.rfind(": ");
      if (line.rfind(head, 0) == 0) verdicts[line.substr(head.size(), colon - head.size())] = line.substr(colon + 2);
    }
  }
  return verdicts;
}

/// The options that the head of a program gives, such as --cpu 222; values of one that stands there again in a list.
inline std::map<std::string, std::string> optionsOf(const std::filesystem::path& file) {
  std::map<std::string, std::string> options;
  std::ifstream stream(headOf(file), std::ios::binary);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string head, kind, name, value;
    words >> head >> kind;
    while (head == "//!" && kind == "options" && words >> name >> value)
      options[name] += (options[name].empty() ? "" : ",") + value;
  }
  return options;
}

/// How the prover sees the program: the default environment and the scan time of its head.
inline ProverOptions proverOptions(const std::filesystem::path& file) {
  ProverOptions options;
  options.time.high = static_cast<std::uint32_t>(options.choices.watchdogMs());
  const auto given = optionsOf(file);
  if (const auto range = given.find("--scan-time"); range != given.end()) {
    const auto time = scanTimeNamed(range->second);
    options.time.low = static_cast<std::uint32_t>(time->low.count() / 1000);
    options.time.high = static_cast<std::uint32_t>(time->high.count() / 1000);
  }
  if (const auto choice = given.find("--choice"); choice != given.end()) {
    std::istringstream all(choice->second);
    for (std::string one; std::getline(all, one, ',');) {
      const std::size_t equal = one.find('=');
      options.choices.set(one.substr(0, equal), one.substr(equal + 1));
    }
  }
  return options;
}

inline ProgramInput corpusInput(const std::filesystem::path& file) {
  ProgramInput input;
  ReadOptions reading;
  const auto given = optionsOf(file);
  if (const auto cpu = given.find("--cpu"); cpu != given.end()) reading.target.cpu = *cpuNamed(cpu->second);
  input.program = readProgram(expandFolders({file.string()}), reading);
  if (const auto memory = given.find("--library-memory"); memory != given.end())
    input.program.libraryMemory.push_back(*libraryMemoryNamed(memory->second));
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  return input;
}

inline std::vector<Property> goalsOf(const PropertySet& set) {
  std::vector<Property> goals;
  for (const Property& property : set.properties) {
    if (property.isGoal()) goals.push_back(property);
  }
  return goals;
}

}  // namespace rungproof::test
