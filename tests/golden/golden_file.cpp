// Reading and writing of golden tests.
#include "golden_file.hpp"

#include <fmt/core.h>

#include <regex>
#include <sstream>

namespace golden {

namespace {

constexpr std::string_view mark = "--- ";

void appendSection(std::string& text, const std::string& head, const std::string& body) {
  text += fmt::format("{}{}\n{}", mark, head, body);
  if (!body.empty() && body.back() != '\n') text += "\n--- end\n";
}

}  // namespace

GoldenFile readTest(const std::string& text) {
  GoldenFile test;
  std::string* body = &test.comment;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(mark)) {
      if (body == nullptr) test.fault = "text behind '--- end'";
      if (body != nullptr) *body += line + '\n';
      continue;
    }
    const std::string head = line.substr(mark.size());
    const std::string word = head.substr(0, head.find(' '));
    const std::string rest = word.size() < head.size() ? head.substr(word.size() + 1) : std::string();
    if (body != nullptr && word.find('.') != std::string::npos) {
      *body += line + '\n';  // the head of a unified diff: --- press.awl
    } else if (word == "end" && body != nullptr && !body->empty()) {
      body->pop_back();
      body = nullptr;
    } else if (word == "file") {
      body = &test.files.emplace_back(NamedText{rest, {}}).text;
    } else if (word == "run") {
      test.runs.push_back({});
      test.runs.back().arguments = rest;
      body = nullptr;
    } else if (test.runs.empty()) {
      test.fault = fmt::format("'{}' before the first command", line);
    } else if (word == "stdin") {
      body = &test.runs.back().input;
    } else if (word == "exit") {
      test.runs.back().exit = std::atoi(rest.c_str());
      body = nullptr;
    } else if (word == "stdout") {
      body = &test.runs.back().out;
    } else if (word == "stderr") {
      body = &test.runs.back().err;
    } else if (word == "wrote") {
      body = &test.runs.back().written.emplace_back(NamedText{rest, {}}).text;
    } else {
      test.fault = fmt::format("unknown section '{}'", line);
    }
    if (!test.fault.empty()) return test;
  }
  if (test.runs.empty()) test.fault = "no command";
  return test;
}

std::string toText(const GoldenFile& test) {
  std::string text = test.comment;
  for (const NamedText& file : test.files) appendSection(text, "file " + file.name, file.text);
  for (const CommandRun& run : test.runs) {
    text += fmt::format("{}run {}\n", mark, run.arguments);
    if (!run.input.empty()) appendSection(text, "stdin", run.input);
    if (run.exit != 0) text += fmt::format("{}exit {}\n", mark, run.exit);
    if (!run.out.empty()) appendSection(text, "stdout", run.out);
    if (!run.err.empty()) appendSection(text, "stderr", run.err);
    for (const NamedText& file : run.written) appendSection(text, "wrote " + file.name, file.text);
  }
  return text;
}

std::vector<std::string> splitArguments(const std::string& text) {
  std::vector<std::string> arguments;
  std::string current;
  bool open = false;
  bool any = false;
  for (const char c : text) {
    if (c == '\'') {
      open = !open;
      any = true;
    } else if (c == ' ' && !open) {
      if (any) arguments.push_back(current);
      current.clear();
      any = false;
    } else {
      current += c;
      any = true;
    }
  }
  if (any) arguments.push_back(current);
  return arguments;
}

std::string normalised(std::string text) {
  static const std::regex seconds("in [0-9]+\\.[0-9]+ s\\b");
  static const std::regex jsonSeconds("\"seconds\": [0-9.e-]+");
  static const std::regex version(
      "(rungproof\"?,?\\s+\"?(?:semanticV|v)ersion\": \"|^rungproof |by rungproof |content=\"rungproof "
      ")[0-9]+\\.[0-9]+\\.[0-9]+(?:\\+[0-9]+\\.g[0-9a-f]+)?");
  static const std::regex junitSeconds(" time=\"[0-9.]+\"");
  // How a page looks is pinned by nobody's eye here; the sheet begins with its colours.
  for (std::size_t at = text.find("<style>\n:root{"); at != std::string::npos;
       at = text.find("<style>\n:root{", at + 1))
    text.replace(at + 7, text.find("</style>", at) - at - 7, "*");
  text = std::regex_replace(text, junitSeconds, " time=\"0\"");
  text = std::regex_replace(text, seconds, "in * s");
  text = std::regex_replace(text, jsonSeconds, "\"seconds\": 0");
  return std::regex_replace(text, version, "$1*");
}

}  // namespace golden
