// Inputs that have no end, come through pipes or lie where they must not be read; what an interrupted run left; and
// what the program needs of the system: no page that is writable and executable, no large stack, no room on the disk.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "frontend/files/disk_file.hpp"
#include "frontend/text/safe_text.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

const std::string motor = "Network 1\nLD I0.0\n= Q0.0\n";

/// Runs the executable as the shell runs it; exit code, or the negative signal.
int shell(const std::string& command) {
  const int status = std::system(("PATH=" RUNGPROOF_BINARY_DIR ":$PATH; " + command).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(InputLimit, WhatHasNoEndIsRefused) {
  const ProgramRun result = run({"lint", "--isolated", "/dev/zero"});
  EXPECT_EQ(result.exit, 2);
  EXPECT_NE(result.out.find("cannot read /dev/zero: it has more than 128 MiB"), std::string::npos) << result.out;
  const TemporaryFolder folder;
  EXPECT_EQ(shell("yes | rungproof lint --isolated - > " + folder.path("out")), 2);
  EXPECT_NE(contentOf(folder.path("out")).find("it has more than 128 MiB"), std::string::npos);
  for (const char* option : {"--props", "--stimulus"}) {
    const bool isTrace = option == std::string("--stimulus");
    const ProgramRun other =
        run({isTrace ? "sim" : "prove", "--isolated", option, "/dev/zero", folder.file("p.awl", motor)});
    EXPECT_EQ(other.exit, 2) << other.out;
    EXPECT_NE((other.out + other.err).find("it has more than"), std::string::npos) << other.err << other.out;
  }
}

TEST(InputLimit, APipeIsReadOnceAndKept) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("p.awl"), table = folder.file("s.csv", "Motor,Q0.0,\n");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const char* command : {"lint", "xref", "prove"}) {
    std::thread writer([&] { std::ofstream(pipe) << "//@ prove a: Q0.0 implies I0.0\n" << motor; });
    const ProgramRun result = run({command, "--isolated", pipe, table});
    writer.join();
    EXPECT_EQ(result.exit, 0) << command << result.out << result.err;
  }
}

TEST(InputLimit, AFolderIsNoFile) {
  const TemporaryFolder folder;
  const ProgramRun result =
      run({"prove", "--isolated", "--props", folder.folder().string(), folder.file("p.awl", motor)});
  EXPECT_NE(result.out.find("it is a folder"), std::string::npos) << result.out;
}

TEST(InputLimit, ConfinedInputsLieBelowTheirFolderBehindAllLinks) {
  const TemporaryFolder folder;
  const std::string inside = folder.file("in/p.awl", motor), outside = folder.file("out.awl", motor);
  fs::create_symlink(outside, folder.path("in/link.awl"));
  confineInputs(folder.path("in"));
  EXPECT_FALSE(confinedAgainst(inside));
  EXPECT_FALSE(confinedAgainst(folder.path("in")));
  for (const std::string& name : {outside, folder.path("in/link.awl"), folder.path("in/../out.awl")}) {
    const ProgramRun result = run({"lint", "--isolated", name});
    EXPECT_EQ(result.exit, 2);
    EXPECT_NE(result.out.find("the folder that tools may read"), std::string::npos) << result.out;
  }
  confineInputs({});
  EXPECT_EQ(run({"lint", "--isolated", outside}).exit, 0);
}

TEST(StaleParts, GoWithTheNextRunThatWritesThere) {
  const TemporaryFolder folder;
  const pid_t ended = ::fork();
  if (ended == 0) ::_exit(0);
  ::waitpid(ended, nullptr, 0);
  const std::string target = folder.path("report.html");
  const std::string stale = folder.file("report.html." + std::to_string(ended) + ".part", "half");
  const std::string ofOther = folder.file("other.html." + std::to_string(ended) + ".part", "half");
  const std::string ofLiving = folder.file("report.html." + std::to_string(::getppid()) + ".part", "half");
  const std::string noPart = folder.file("report.html.old.part", "mine");
  EXPECT_EQ(run({"lint", "--isolated", "--format", "html=" + target, folder.file("p.awl", motor)}).exit, 0);
  EXPECT_TRUE(fs::exists(target));
  EXPECT_FALSE(fs::exists(stale));
  for (const std::string& kept : {ofOther, ofLiving, noPart}) EXPECT_TRUE(fs::exists(kept)) << kept;
}

TEST(CodePages, AreNeverWritableAndExecutable) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", motor);
  EXPECT_EQ(run({"sim", "--isolated", "--engine", "compiled", "--scans", "3", file}).exit, 0);
  EXPECT_EQ(
      run({"prove", "--isolated", "--self-check", folder.file("q.awl", "//@ prove a: Q0.0 implies I0.0\n" + motor)})
          .exit,
      0);
  std::istringstream maps(contentOf("/proc/self/maps"));
  std::size_t executable = 0;
  for (std::string line; std::getline(maps, line);) {
    EXPECT_EQ(line.find(" rwx"), std::string::npos) << line;
    if (line.find(" r-x") != std::string::npos) ++executable;
  }
  EXPECT_GT(executable, 1U) << "the list is read wrongly";
}

TEST(SystemLimits, AFullDeviceOrAFileThatMayNotGrowIsAFailureWithAReason) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", motor), err = folder.path("err");
  for (const std::string& arguments : {std::string("--version"), std::string("--help"), std::string("rules"),
                                       "lint --isolated " + file, std::string("config"), std::string("lint --help")}) {
    EXPECT_EQ(shell("rungproof " + arguments + " > /dev/full 2> " + err), 2) << arguments;
    EXPECT_NE(contentOf(err).find("standard output cannot be written"), std::string::npos) << arguments;
  }
  EXPECT_EQ(shell("ulimit -f 1; rungproof rules --format json > " + folder.path("out") + " 2> " + err), 2)
      << contentOf(err);
  EXPECT_EQ(shell("ulimit -f 8; rungproof lint --isolated --format html=" + folder.path("page.html") + ' ' + file +
                  " > /dev/null 2> " + err),
            2);
  EXPECT_NE(contentOf(err).find("page.html' cannot be written: File too large"), std::string::npos) << contentOf(err);
  EXPECT_FALSE(fs::exists(folder.path("page.html")));
}

TEST(SystemLimits, ASmallStackIsEnough) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", "//@ prove a: Q0.0 implies I0.0\n" + motor);
  for (const char* command : {"lint", "prove", "sim", "show", "lint --prove"})
    EXPECT_EQ(shell(std::string("ulimit -s 64; rungproof ") + command + " --isolated " + file + " > /dev/null"), 0)
        << command;
}

TEST(Messages, AreCutWhereANameHasMegabytes) {
  const TemporaryFolder folder;
  const std::string name(3'000'000, 'x');
  const std::vector<std::vector<std::string>> runs = {
      {"lint", "--isolated", folder.file("a.awl", "Network 1\nLD " + name + "\n= Q0.0\n")},
      {"lint", "--isolated", folder.file("b.awl", "Network 1\n" + name + " I0.0\n= Q0.0\n")},
      {"prove", "--isolated", folder.file("c.awl", "//@ prove " + name + ": Q0.0 implies I0.0\n" + motor)},
      {"lint", "--isolated", folder.file("d.awl", "SUBROUTINE_BLOCK " + name + ":SBR0\nBEGIN\n" + motor)},
      {"lint", "--isolated", "--select", name, folder.file("e.awl", motor)},
      {name, folder.path("e.awl")}};
  for (std::vector<std::string> arguments : runs) {
    for (const char* form : {"human", "concise", "github"}) {
      std::vector<std::string> all = arguments;
      if (all.front() != name) all.insert(all.begin() + 1, {"--format", form});
      const ProgramRun result = run(all);
      EXPECT_LT(result.out.size() + result.err.size(), 50000U) << form << result.out.substr(0, 500);
    }
  }
}

TEST(JsonTechniques, ComeOnlyWhereTheyAreAskedFor) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", "//@ prove a: Q0.0 implies I0.0\n" + motor);
  EXPECT_FALSE(nlohmann::json::parse(run({"prove", "--isolated", "--format", "json", file}).out).contains("techniques"))
      << "their counts differ from run to run";
}

// A day of 10 ms is 8.6 million scans; what is compared are ten moments.
TEST(LongRun, KeepsTheScansThatAreLookedAt) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", "Network 1\nLD SM0.0\nINCW VW0\n");
  std::string expected = "time_ms,VW0\n";
  for (int i = 1; i <= 10; ++i) expected += std::to_string(i * 10000 + 5) + "," + std::to_string(i * 1000 + 1) + "\n";
  const std::string wanted = folder.file("e.csv", expected);
  const ProgramRun agreed =
      run({"sim", "--isolated", "--scan-time", "10ms", "--memory", "1MB", "--expect", wanted, file});
  EXPECT_EQ(agreed.exit, 0) << agreed.out << agreed.err;
  expected += "100025,5\n";
  const ProgramRun differs = run({"sim", "--isolated", "--scan-time", "10ms", "--memory", "1MB", "--slack", "2",
                                  "--expect", folder.file("f.csv", expected), file});
  EXPECT_EQ(differs.exit, 1) << differs.out << differs.err;
  EXPECT_NE(differs.out.find("expected 5, actual 10003"), std::string::npos) << differs.out;
  EXPECT_NE(differs.out.find(" 10000 "), std::string::npos) << "three scans before it are shown\n" << differs.out;
}

}  // namespace
}  // namespace rungproof::test
