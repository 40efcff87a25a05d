// A golden test in one file: input files, command lines, and what each must print. Layout, in this order:
//
//   # what the test pins
//   --- file NAME            a file in the test's folder; any number
//   --- run ARGUMENTS        a command line, '...' around arguments with blanks; any number, in this order
//   --- stdin                its standard input; optional, as are the following
//   --- exit N               0 if left out
//   --- stdout / --- stderr  empty if left out
//   --- wrote NAME           content of a file that the command wrote
//
// Behind the mark a word with a point in it, such as the file name of a unified diff, is text of its section.
// A section ends with a line end that belongs to the file, not to the section's text, if `--- end` follows; otherwise
// each line of it ends with one.
#pragma once

#include <string>
#include <vector>

namespace golden {

struct NamedText {
  std::string name;
  std::string text;
};

struct CommandRun {
  std::string arguments;  ///< as written
  std::string input;
  int exit = 0;
  std::string out;
  std::string err;
  std::vector<NamedText> written;
};

struct GoldenFile {
  std::string comment;  ///< lines before the first section
  std::vector<NamedText> files;
  std::vector<CommandRun> runs;
  std::string fault;  ///< why the file is no test; empty if it is one
};

GoldenFile readTest(const std::string& text);
std::string toText(const GoldenFile& test);
/// Splits at blanks outside single quotes.
std::vector<std::string> splitArguments(const std::string& text);
/// Replaces what differs from run to run: seconds, and the version of the program.
std::string normalised(std::string text);

}  // namespace golden
