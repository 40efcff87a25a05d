// Kept results: repeated word by word while nothing has changed, not believed once anything has - program, property
// file, configuration, a file that was looked for, the entry itself, or whose key signed it.
#include "frontend/result_cache.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "frontend/cli/cli.hpp"
#include "frontend/files/disk_file.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;

class ResultCacheTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* before = std::getenv("XDG_STATE_HOME");
    if (before != nullptr) before_ = before;
    useKeysIn("state");
    folder_.file("press.awl", "//@ prove off: Q0.0 implies I0.0\nNetwork 1\nLD I0.0\n= Q0.0\n");
    folder_.file("more.prop", "prove too: Q0.0 implies I0.0\n");
  }
  void TearDown() override {
    if (before_)
      ::setenv("XDG_STATE_HOME", before_->c_str(), 1);
    else
      ::unsetenv("XDG_STATE_HOME");
  }

  void useKeysIn(const std::string& name) { ::setenv("XDG_STATE_HOME", folder_.path(name).c_str(), 1); }

  struct Run {
    int exit;
    std::string out, err;
  };
  Run prove(std::vector<std::string> more = {}) {
    std::vector<std::string> arguments = {"prove",   folder_.path("press.awl"), "--props",  folder_.path("more.prop"),
                                          "--cache", cache().string(),          "--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::this_thread::sleep_for(std::chrono::milliseconds(50));  // a file of this moment may still be changing
    std::istringstream in;
    std::ostringstream out, err;
    const int exit = runProgram(arguments, {in, out, err});
    return {exit, out.str(), err.str()};
  }
  fs::path cache() const { return folder_.path("kept"); }
  std::vector<fs::path> entries() const {
    std::vector<fs::path> files;
    if (!fs::exists(cache())) return files;
    for (const auto& entry : fs::directory_iterator(cache())) files.push_back(entry.path());
    return files;
  }
  static std::string content(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  test::TemporaryFolder folder_;
  std::optional<std::string> before_;
};

// A checked-out project says where results are kept: not outside it, and not where a link in the folder leads.
TEST_F(ResultCacheTest, AConfigurationKeepsNothingOutsideItsProject) {
  const test::TemporaryFolder outside;
  folder_.file("project/press.awl", "//@ prove off: Q0.0 implies I0.0\nNetwork 1\nLD I0.0\n= Q0.0\n");
  fs::create_directory_symlink(outside.folder(), folder_.path("project/link"));
  for (const std::string& place : {std::string("../made"), outside.path("made"), std::string("link"),
                                   std::string("link/made"), std::string("/")}) {
    folder_.file("project/rungproof.toml", "cache = \"" + place + "\"\n");
    std::istringstream in;
    std::ostringstream out, err;
    EXPECT_EQ(runProgram({"prove", folder_.path("project/press.awl")}, {in, out, err}), 2) << place;
    EXPECT_NE(err.str().find("lies outside the folder of this configuration"), std::string::npos) << err.str();
  }
  EXPECT_FALSE(fs::exists(folder_.path("made")));
  EXPECT_TRUE(fs::is_empty(outside.folder()));
  folder_.file("project/rungproof.toml", "cache = \"kept\"\n");
  std::istringstream in;
  std::ostringstream out, err;
  EXPECT_EQ(runProgram({"prove", folder_.path("project/press.awl")}, {in, out, err}), 0) << err.str();
  EXPECT_TRUE(fs::is_directory(folder_.path("project/kept")));
}

TEST_F(ResultCacheTest, AnEntryIsNeverWrittenThroughALink) {
  prove();
  ASSERT_EQ(entries().size(), 1U);
  const fs::path entry = entries().front();
  const std::string victim = folder_.file("victim", "untouched");
  fs::remove(entry);
  fs::create_symlink(victim, entry);
  EXPECT_EQ(prove().exit, 0);
  EXPECT_EQ(content(victim), "untouched");
  EXPECT_FALSE(fs::is_symlink(entry)) << "the link is replaced";
}

TEST_F(ResultCacheTest, AFolderOpenToAllKeepsNothing) {
  fs::create_directories(cache());
  fs::permissions(cache(), fs::perms::all);
  const Run run = prove();
  EXPECT_EQ(run.exit, 0);
  EXPECT_NE(run.err.find("results are not kept: everybody may write"), std::string::npos) << run.err;
  EXPECT_TRUE(entries().empty());
}

// What came through a pipe cannot be compared with what comes next time.
TEST_F(ResultCacheTest, WhatCameThroughAPipeIsNotKept) {
  const std::string pipe = folder_.path("pipe.prop");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "prove piped: Q0.0 implies I0.0\n"; });
  const Run run = prove({"--props", pipe});
  writer.join();
  EXPECT_EQ(run.exit, 0) << run.err;
  EXPECT_TRUE(entries().empty());
}

// The times of the properties are in the text: two runs that both prove do not print the same.
TEST_F(ResultCacheTest, IsRepeatedWhileNothingChanges) {
  const Run first = prove();
  ASSERT_EQ(first.exit, 0) << first.err;
  ASSERT_EQ(entries().size(), 1U);
  const Run second = prove();
  EXPECT_EQ(second.exit, 0);
  EXPECT_EQ(second.out, first.out);
  EXPECT_EQ(second.err, first.err);
  EXPECT_NE(prove({"--builtin"}).out, first.out);
  EXPECT_EQ(entries().size(), 2U);
}

TEST_F(ResultCacheTest, AnotherProgramOrPropertyIsProvedAnew) {
  ASSERT_EQ(prove().exit, 0);
  folder_.file("more.prop", "prove too: Q0.0 implies I0.1\n");
  EXPECT_EQ(prove().exit, 1);
  folder_.file("more.prop", "prove too: Q0.0 implies I0.0\n");
  EXPECT_EQ(prove().exit, 0);
  folder_.file("press.awl", "//@ prove off: Q0.0 implies I0.0\nNetwork 1\nLDN I0.0\n= Q0.0\n");
  EXPECT_EQ(prove().exit, 1);
}

TEST_F(ResultCacheTest, AConfigurationThatAppearsCounts) {
  ASSERT_EQ(prove().exit, 0);
  folder_.file("rungproof.toml", "scan-time = \"5ms..6ms\"\n");
  EXPECT_NE(prove().out.find("5 to 6 ms"), std::string::npos);
}

TEST_F(ResultCacheTest, AChangedEntryIsNotBelieved) {
  ASSERT_EQ(prove().exit, 0);
  const fs::path entry = entries().at(0);
  const std::string whole = content(entry);
  std::string changed = whole;
  const std::size_t verdict = changed.find("\"PROVED\"");
  ASSERT_NE(verdict, std::string::npos);
  changed.replace(verdict, 8, "\"PROVEN\"");
  std::ofstream(entry, std::ios::binary) << changed;
  const Run after = prove();
  EXPECT_EQ(after.out.find("PROVEN"), std::string::npos);
  for (const std::size_t length : {std::size_t{0}, std::size_t{10}, whole.size() / 2, whole.size() - 1}) {
    std::ofstream(entry, std::ios::binary) << whole.substr(0, length);
    EXPECT_EQ(prove().exit, 0) << length;
    EXPECT_NE(content(entry), whole.substr(0, length)) << "the entry is made anew";
  }
}

TEST_F(ResultCacheTest, AnEntryThatSomebodyElseSignedIsNotBelieved) {
  ASSERT_EQ(prove().exit, 0);
  const std::string own = content(entries().at(0));
  useKeysIn("other");
  ASSERT_EQ(prove().exit, 0);
  const std::string foreign = content(entries().at(0));
  EXPECT_NE(foreign, own);
  useKeysIn("state");
  prove();
  EXPECT_NE(content(entries().at(0)), foreign) << "proved anew and signed with the own key";
}

TEST_F(ResultCacheTest, WhatMoreTimeCouldSettleIsNotKept) {
  folder_.file("press.awl", "//@ prove off: VW0 < 30000\nNetwork 1\nLD I0.0\nEU\nINCW VW0\n");
  const Run run = prove({"--bound", "2"});
  EXPECT_NE(run.out.find("HOLDS TO BOUND"), std::string::npos) << run.out;
  EXPECT_TRUE(entries().empty());
}

TEST_F(ResultCacheTest, AFileThatChangesDuringTheRunIsNotKept) {
  const ResultCache kept(cache().string(), "question", {});
  folder_.file("press.awl", "Network 1\nLDN I0.0\n= Q0.0\n");
  forgetInputs();
  noteInput(folder_.path("press.awl"));
  kept.keep({"result", "", Exit::Clean});
  EXPECT_FALSE(kept.find());
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const ResultCache later(cache().string(), "question", {});
  later.keep({"result", "", Exit::Clean});
  ASSERT_TRUE(later.find());
  EXPECT_EQ(later.find()->out, "result");
}

// The names of the folder stay the same, what it stands for does not.
TEST_F(ResultCacheTest, ANoteBecomesAProgram) {
  folder_.file("m/a.awl", "//@ prove off: never Q0.1\nNetwork 1\nLD I0.0\n= Q0.0\n");
  folder_.file("m/b.txt", "to be done\n");
  const auto prove = [&] {
    std::istringstream in;
    std::ostringstream out, err;
    runProgram({"prove", folder_.path("m"), "--isolated", "--cache", cache().string()}, {in, out, err});
    return out.str();
  };
  EXPECT_EQ(prove().find("VIOLATED"), std::string::npos);
  folder_.file("m/b.txt",
               "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n//@ prove on: never Q0.2\nNetwork 1\nLD I0.0\n= Q0.2\n"
               "END_ORGANIZATION_BLOCK\n");
  EXPECT_NE(prove().find("VIOLATED  on"), std::string::npos);
}

TEST_F(ResultCacheTest, NothingIsKeptUnasked) {
  std::istringstream in;
  std::ostringstream out, err;
  EXPECT_EQ(runProgram({"prove", folder_.path("press.awl"), "--isolated"}, {in, out, err}), 0);
  EXPECT_TRUE(entries().empty());
}

TEST(WithoutProgress, LeavesWhatIsNotOverwritten) {
  EXPECT_EQ(withoutProgress("a\n\rprove: 1 of 2\x1B[Kb\n\r\x1B[K"), "a\nb\n");
  EXPECT_EQ(withoutProgress("plain\n"), "plain\n");
}

}  // namespace
}  // namespace rungproof
