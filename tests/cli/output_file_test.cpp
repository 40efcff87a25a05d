// Where outputs go: regular files are replaced as a whole and keep mode and owner, links keep leading to their file,
// devices and pipes stay what they are, and neither an input nor a write-protected file is overwritten. Every command
// that writes goes through the same writer.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

const std::string lamp = "Network 1\nLD I0.0\n= Q0.0\n";
const std::string proved = "//@ prove lamp: Q0.0 implies I0.0\n" + mainBlock(lamp);
std::string modeOf(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return "missing";
  const char* kind = S_ISLNK(status.st_mode)    ? "link "
                     : S_ISFIFO(status.st_mode) ? "pipe "
                     : S_ISREG(status.st_mode)  ? ""
                                                : "other ";
  return kind + std::to_string(status.st_mode >> 6 & 7U) + std::to_string(status.st_mode >> 3 & 7U) +
         std::to_string(status.st_mode & 7U);
}

/// Every command that writes a file, writing that one.
std::vector<std::vector<std::string>> writers(const std::string& program, const std::string& output) {
  return {{"show", "--isolated", program, "-o", output},
          {"lint", "--isolated", program, "--format", "json=" + output},
          {"prove", "--isolated", program, "--format", "json=" + output},
          {"export", "--isolated", program, "--format", "smv", "-o", output},
          {"export", "--isolated", program, "--format", "smv=" + output},
          {"baseline", "--isolated", program, "-o", output},
          {"xref", "--isolated", program, "--format", "json=" + output},
          {"sim", "--isolated", program, "--scans", "2", "--trace", output},
          {"rules", "--isolated", "--format", "json=" + output}};
}

TEST(OutputFile, ModeAndLinkStayWhatTheyWere) {
  const TemporaryFolder folder;
  const std::string program = folder.file("p.awl", proved), real = folder.file("real/old.csv", "old");
  const std::string link = folder.path("link.csv"), chain = folder.path("chain.csv");
  fs::create_symlink("real/old.csv", link);
  fs::create_symlink("link.csv", chain);
  for (const std::vector<std::string>& arguments : writers(program, chain)) {
    folder.file("real/old.csv", "old");
    ASSERT_EQ(::chmod(real.c_str(), 0600), 0);
    EXPECT_LT(run(arguments).exit, 2) << arguments[0];
    EXPECT_EQ(modeOf(chain).substr(0, 4), "link") << arguments[0];
    EXPECT_EQ(modeOf(real), "600") << arguments[0];
    EXPECT_NE(contentOf(real), "old") << arguments[0];
    EXPECT_EQ(contentOf(real), contentOf(chain)) << arguments[0];
  }
  const auto entries = fs::directory_iterator(folder.folder() / "real");
  EXPECT_EQ(std::distance(fs::begin(entries), fs::end(entries)), 1) << "nothing is left beside the file";
}

TEST(OutputFile, ALinkToNothingLeadsToTheNewFile) {
  const TemporaryFolder folder;
  const std::string program = folder.file("p.awl", proved), link = folder.path("link.csv");
  fs::create_symlink("new.csv", link);
  EXPECT_EQ(run({"sim", "--isolated", program, "--scans", "2", "--trace", link}).exit, 0);
  EXPECT_EQ(modeOf(link).substr(0, 4), "link");
  EXPECT_TRUE(contentOf(folder.path("new.csv")).starts_with("scan")) << contentOf(folder.path("new.csv"));
  fs::create_symlink("circle", folder.path("circle"));
  const ProgramRun circle = run({"show", "--isolated", program, "-o", folder.path("circle")});
  EXPECT_EQ(circle.exit, 2);
  EXPECT_NE(circle.err.find("cannot be written"), std::string::npos) << circle.err;
}

TEST(OutputFile, TwoNamesStayOneFile) {
  const TemporaryFolder folder;
  const std::string program = folder.file("p.awl", proved), one = folder.file("one.txt", "old"),
                    two = folder.path("two.txt");
  fs::create_hard_link(one, two);
  EXPECT_EQ(run({"show", "--isolated", program, "-o", one}).exit, 0);
  EXPECT_NE(contentOf(two), "old");
  EXPECT_EQ(fs::hard_link_count(one), 2U);
}

TEST(OutputFile, DevicesAndPipesAreWrittenTo) {
  const TemporaryFolder folder;
  const std::string program = folder.file("p.awl", proved);
  for (const std::vector<std::string>& arguments : writers(program, "/dev/null")) {
    if (arguments[0] == "sim") continue;  // its form follows from the ending
    EXPECT_LT(run(arguments).exit, 2) << arguments[0];
    EXPECT_TRUE(fs::is_character_file("/dev/null")) << arguments[0];
  }
  EXPECT_EQ(run({"lint", "--isolated", program, "--format", "json=/dev/full"}).exit, 2) << "the device is full";
  const std::string pipe = folder.path("pipe.csv");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = contentOf(pipe); });
  EXPECT_EQ(run({"sim", "--isolated", program, "--scans", "2", "--trace", pipe}).exit, 0);
  reader.join();
  EXPECT_TRUE(received.starts_with("scan")) << received;
  EXPECT_EQ(modeOf(pipe), "pipe 600");
}

TEST(OutputFile, WhatIsWriteProtectedIsRefused) {
  const TemporaryFolder folder;
  const std::string program = folder.file("p.awl", proved), kept = folder.file("kept.csv", "kept");
  ASSERT_EQ(::chmod(kept.c_str(), 0444), 0);
  for (const std::vector<std::string>& arguments : writers(program, kept)) {
    const ProgramRun result = run(arguments);
    EXPECT_EQ(result.exit, 2) << arguments[0];
    EXPECT_NE(result.err.find("write-protected"), std::string::npos) << arguments[0] << ": " << result.err;
    EXPECT_EQ(contentOf(kept), "kept") << arguments[0];
  }
  EXPECT_EQ(run({"show", "--isolated", program, "-o", folder.folder().string()}).exit, 2) << "a folder";
}

TEST(OutputFile, InputsAreRefused) {
  const TemporaryFolder folder;
  const std::string program = folder.file("p.awl", proved);
  fs::create_symlink("p.awl", folder.path("same.csv"));
  for (const std::string& output : {program, folder.path("same.csv")}) {
    for (const std::vector<std::string>& arguments : writers(program, output)) {
      // --trace wants an ending, and the list of rules reads no program.
      if (arguments[0] == "rules" || (arguments[0] == "sim" && output == program)) continue;
      const ProgramRun result = run(arguments);
      EXPECT_EQ(result.exit, 2) << arguments[0];
      EXPECT_NE(result.err.find("read as input"), std::string::npos) << arguments[0] << ": " << result.err;
      EXPECT_EQ(contentOf(program), proved) << arguments[0];
    }
  }
  const std::string stimulus = folder.file("s.csv", "scan,I0.0\n1,1\n"), props = folder.file("a.prop", "");
  EXPECT_EQ(run({"sim", "--isolated", program, "--stimulus", stimulus, "--trace", stimulus}).exit, 2);
  EXPECT_EQ(run({"sim", "--isolated", program, "--expect", stimulus, "--trace", stimulus}).exit, 2);
  EXPECT_EQ(run({"prove", "--isolated", program, "--props", props, "--format", "json=" + props}).exit, 2);
  const std::string known = folder.file("known.json", "{\"rungproof_baseline\": 1, \"findings\": []}");
  EXPECT_EQ(run({"lint", "--isolated", program, "--baseline", known, "--format", "json=" + known}).exit, 2);
  EXPECT_EQ(contentOf(stimulus), "scan,I0.0\n1,1\n");
  // What an earlier run has read is no input of this one.
  EXPECT_EQ(run({"rules", "--isolated", "--format", "json=" + program}).exit, 0);
}

TEST(OutputFile, FixesReachTheFileBehindALink) {
  const TemporaryFolder folder;
  const std::string text = mainBlock("Network 1\nLD IO.0\n= Q0.0\n");  // the letter O, which has a safe fix
  const std::string real = folder.file("real/p.awl", text), link = folder.path("p.awl");
  fs::create_symlink("real/p.awl", link);
  ASSERT_EQ(::chmod(real.c_str(), 0640), 0);
  run({"lint", "--isolated", "--fix", link});
  EXPECT_NE(contentOf(real), text);
  EXPECT_EQ(modeOf(real), "640");
  EXPECT_EQ(modeOf(link).substr(0, 4), "link");
  folder.file("real/p.awl", text);
  ASSERT_EQ(::chmod(real.c_str(), 0444), 0);
  EXPECT_EQ(run({"lint", "--isolated", "--fix", link}).exit, 2);
  EXPECT_EQ(contentOf(real), text);
}

TEST(OutputFile, EvidenceThatIsLostShowsInTheExitCode) {
  const TemporaryFolder folder;
  const std::string program = folder.file("p.awl", proved), kept = folder.file("out/lamp.smt2", "kept");
  const std::string broken = folder.file("q.awl", "//@ prove lamp: never Q0.0\n" + mainBlock(lamp));
  EXPECT_EQ(run({"prove", "--isolated", program, "--certificate", folder.path("new")}).exit, 0);
  ASSERT_EQ(::chmod(kept.c_str(), 0444), 0);
  EXPECT_EQ(run({"prove", "--isolated", program, "--certificate", folder.path("out")}).exit, 2);
  EXPECT_EQ(contentOf(kept), "kept");
  folder.file("out/lamp.csv", "kept");
  ASSERT_EQ(::chmod(folder.path("out/lamp.csv").c_str(), 0444), 0);
  EXPECT_EQ(run({"prove", "--isolated", broken, "--traces", folder.path("out")}).exit, 2);
}

TEST(OutputFile, AConfigurationNamesFilesInItsFolderOnly) {
  const TemporaryFolder folder;
  const std::string program = folder.file("project/p.awl", proved);
  const auto lintWith = [&](const std::string& format) {
    folder.file("project/rungproof.toml", "format = \"" + format + "\"\n");
    return run({"lint", program});
  };
  EXPECT_EQ(lintWith("json=report.json").exit, 0);
  EXPECT_TRUE(contentOf(folder.path("project/report.json")).starts_with("{"));
  EXPECT_EQ(lintWith("json=" + folder.path("project/absolute.json")).exit, 0);
  EXPECT_TRUE(fs::exists(folder.path("project/absolute.json")));
  fs::create_symlink("../outside.json", folder.path("project/link.json"));
  fs::create_directories(folder.path("project2"));
  for (const std::string& file :
       {std::string("../outside.json"), folder.path("outside.json"), std::string("sub/../../outside.json"),
        std::string("link.json"), folder.path("project2/outside.json"), std::string("/dev/null")}) {
    const ProgramRun result = lintWith("json=" + file);
    EXPECT_EQ(result.exit, 2) << file;
    EXPECT_NE(result.err.find("lies outside the folder"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("rungproof.toml:1:"), std::string::npos) << result.err;
  }
  EXPECT_FALSE(fs::exists(folder.path("outside.json")));
  // On the command line the user says where.
  EXPECT_EQ(run({"lint", "--isolated", program, "--format", "json=" + folder.path("outside.json")}).exit, 0);
}

}  // namespace
}  // namespace rungproof::test
