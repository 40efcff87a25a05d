// The child runs the commands in the order of the list and writes one line for each; the parent reads them and how the
// child ended.
#include "tests/damage/every_command.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include "analysis/unread/unread_code.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/input/project.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {

namespace {

const std::vector<std::vector<std::string>> commands = {
    {"lint"},
    {"lint", "--prove"},
    {"prove"},
    {"prove", "--builtin"},
    {"sim", "--scans", "20"},
    {"export", "--builtin", "--format", "btor2"},
    {"show"},
    {"show", "--as", "fbd"},
    {"xref"},
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// Everything that was found wrong, one line each.
std::string judged(const std::vector<std::string>& command, int exit, const std::string& out, const std::string& err,
                   const UnreadCode& unread, bool isBroken) {
  const std::string name = joined(command);
  std::string faults;
  if (exit < 0 || exit > 3) faults += name + ": exit code " + std::to_string(exit) + "\n";
  if (err.find("internal disagreement") != std::string::npos) faults += name + ": internal disagreement\n";
  if (command[0] == "lint") {
    if (unread.isRefused() && exit == 0) faults += name + ": exit code 0 over unread code\n";
    if (isBroken && exit != 2) faults += name + ": exit code " + std::to_string(exit) + " over unreadable text\n";
    return faults;
  }
  if (unread.isRefused() && exit != 2)
    faults += name + ": exit code " + std::to_string(exit) + " over code that is refused\n";
  // What a library block fills at an unknown place leaves the rest of the program as it is.
  if (unread.hinderRuns() && exit == 0 && command[0] != "show" && command[0] != "xref")
    faults += name + ": exit code 0 over unread code\n";
  const bool isUnlimited = unread.isUnlimited() && command[0] == "prove";
  for (const char* verdict : {"PROVED  ", "VIOLATED  ", "UNREACHABLE  ", "\nREACHABLE  "}) {
    if (isUnlimited && out.find(verdict) != std::string::npos)
      faults += name + ": a verdict although anything may be written\n";
  }
  return faults;
}

void runAll(const SeedProgram& program, const EveryCommandLimits& limits, const std::string& report) {
  rlimit limit{limits.seconds, limits.seconds + 5};
  ::setrlimit(RLIMIT_CPU, &limit);
  limit = {limits.memory, limits.memory};
  ::setrlimit(RLIMIT_AS, &limit);
  limit = {0, 0};
  ::setrlimit(RLIMIT_CORE, &limit);
  std::ofstream result(report, std::ios::app);
  const TemporaryFolder folder;
  const std::string file = folder.file(program.name, program.text);
  std::vector<std::string> options = {"--isolated", "--cpu", program.cpu};
  ReadOptions reading;
  reading.target.cpu = *cpuNamed(program.cpu);
  if (!program.symbols.empty()) {
    reading.symbolFiles.push_back(folder.file("symbols.txt", program.symbols));
    options.insert(options.end(), {"--symbols", reading.symbolFiles.back()});
  }
  result << "reading\n" << std::flush;
  const Program text = readProgram({file}, reading);
  const UnreadCode unread(text);
  for (const std::vector<std::string>& command : commands) {
    std::vector<std::string> arguments = command;
    arguments.push_back(file);
    arguments.insert(arguments.end(), options.begin(), options.end());
    const bool proves = command[0] == "prove" || command.back() == "--prove";
    if (proves) arguments.insert(arguments.end(), {"--timeout", limits.timeout});
    result << joined(command) << "\n" << std::flush;
    std::istringstream in;
    std::ostringstream out, err;
    const int exit = static_cast<int>(runProgram(arguments, {in, out, err}));
    const std::string faults = judged(command, exit, out.str(), err.str(), unread, hasReadErrors(text));
    if (!faults.empty()) result << "FAULT " << faults << std::flush;
  }
  result << "done\n" << std::flush;
}

std::string readWhole(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::string faultOf(const SeedProgram& program, const EveryCommandLimits& limits, bool& isSlow) {
  const TemporaryFolder folder;
  const std::string report = folder.path("report.txt"), printed = folder.path("stderr.txt");
  const pid_t child = ::fork();
  if (child == 0) {
    // What a failing CHECK prints belongs to the report, not between those of the test.
    if (std::freopen(printed.c_str(), "w", stderr) == nullptr) ::_exit(9);
    std::setvbuf(stderr, nullptr, _IONBF, 0);
    runAll(program, limits, report);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  std::ifstream stream(report);
  std::string last, faults;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("FAULT "))
      faults += line.substr(6) + "\n";
    else
      last = line;
  }
  isSlow = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
  if (WIFSIGNALED(status) && !isSlow)
    faults += last + ": ended by signal " + std::to_string(WTERMSIG(status)) + "\n" + readWhole(printed);
  if (WIFEXITED(status) && WEXITSTATUS(status) != 0)
    faults += last + ": ended with " + std::to_string(WEXITSTATUS(status)) + "\n";
  return faults;
}

}  // namespace rungproof::test
