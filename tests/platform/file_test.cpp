// Files, folders of one user, changes of files.
#include "engine/platform/file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>

#include "engine/platform/folder_watch.hpp"
#include "engine/platform/private_folder.hpp"
#include "engine/platform/waitable.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& name) {
  std::ifstream stream(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}
void writeText(const fs::path& name, std::string_view text) { std::ofstream(name, std::ios::binary) << text; }

class PlatformFile : public testing::Test {
 protected:
  void SetUp() override { folder_ = temporaryFolder(); }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(PlatformFile, TwoNamesOfOneFileAreOne) {
  writeText(folder_ / "a", "x");
  writeText(folder_ / "b", "x");
  fs::create_hard_link(folder_ / "a", folder_ / "c");
  fs::create_symlink(folder_ / "a", folder_ / "d");
  EXPECT_EQ(fileStatus(folder_ / "a")->identity, fileStatus(folder_ / "c")->identity);
  EXPECT_EQ(fileStatus(folder_ / "a")->identity, fileStatus(folder_ / "d")->identity);
  EXPECT_NE(fileStatus(folder_ / "a")->identity, fileStatus(folder_ / "b")->identity);
  EXPECT_EQ(fileStatus(folder_ / "a")->names, 2u);
  EXPECT_EQ(entryStatus(folder_ / "d")->kind, FileKind::Other);  // the link itself
  EXPECT_TRUE(fileStatus(folder_)->isFolder());
  EXPECT_FALSE(fileStatus(folder_ / "nothing"));
  EXPECT_EQ(errno, ENOENT);
}

TEST_F(PlatformFile, ANewFileStandsInNobodysPlace) {
  writeText(folder_ / "a", "old");
  EXPECT_LT(openNew(folder_ / "a", Readers::Usual), 0);
  EXPECT_EQ(errno, EEXIST);
  EXPECT_EQ(textOf(folder_ / "a"), "old");
}

TEST_F(PlatformFile, APartIsHeldWhileItIsWritten) {
  const int file = openNew(folder_ / "part", Readers::OnlyUs);
  ASSERT_GE(file, 0);
  EXPECT_TRUE(writeBytes(file, "new"));
  EXPECT_FALSE(isLeft(folder_ / "part"));
  EXPECT_TRUE(closeFile(file));
  EXPECT_TRUE(isLeft(folder_ / "part"));
  EXPECT_EQ(fileStatus(folder_ / "part")->mode, 0600u);
}

TEST_F(PlatformFile, OneFileTakesThePlaceOfAnother) {
  writeText(folder_ / "part", "new");
  writeText(folder_ / "target", "old");
  EXPECT_FALSE(nameFile(folder_ / "part", folder_ / "target"));  // something stands there
  EXPECT_EQ(textOf(folder_ / "target"), "old");
  EXPECT_TRUE(replaceFile(folder_ / "part", folder_ / "target"));
  EXPECT_EQ(textOf(folder_ / "target"), "new");
  EXPECT_FALSE(fs::exists(folder_ / "part"));
}

TEST_F(PlatformFile, TheProcessOfThisTestIsThere) {
  EXPECT_FALSE(isProcessGone(processNumber()));
  EXPECT_FALSE(isProcessGone(::getppid()));
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(isProcessGone(child));
}

TEST_F(PlatformFile, AFolderBelongsToItsUser) {
  EXPECT_EQ(privateFolder(folder_ / "new"), FolderState::Private);
  EXPECT_EQ(fileStatus(folder_ / "new")->mode, 0700u);
  EXPECT_EQ(privateFolder(folder_ / "new"), FolderState::Private);
  ::chmod((folder_ / "new").c_str(), 0777);
  EXPECT_EQ(privateFolder(folder_ / "new"), FolderState::OpenToAll);
  writeText(folder_ / "file", "");
  EXPECT_EQ(privateFolder(folder_ / "file"), FolderState::NoFolder);
  EXPECT_EQ(privateFolder(folder_ / "nothing" / "below"), FolderState::CannotBeMade);
  const fs::path other = temporaryFolder();
  EXPECT_NE(other, folder_);
  fs::remove(other);
}

TEST_F(PlatformFile, NobodyGuessesTheBytes) {
  EXPECT_EQ(randomBytes(32).size(), 32u);
  EXPECT_NE(randomBytes(32), randomBytes(32));
}

TEST_F(PlatformFile, AChangeIsSeen) {
  FolderWatch watch;
  watch.add(folder_.string());
  watch.add((folder_ / "nothing").string());
  const std::array<const Waitable*, 1> waited = {&watch};
  EXPECT_FALSE(waitForAny(waited, 0).front());
  writeText(folder_ / "press.awl", "LD I0.0");
  EXPECT_TRUE(waitForAny(waited, -1).front());
  EXPECT_EQ(watch.take(), std::vector<std::string>{(folder_ / "press.awl").string()});
}

TEST_F(PlatformFile, BytesComeInPieces) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  ByteSource source(ends[0], ByteSource::Closing::Yes);
  const std::array<const Waitable*, 1> waited = {&source};
  EXPECT_FALSE(waitForAny(waited, 0).front());
  EXPECT_TRUE(writeBytes(ends[1], "one"));
  EXPECT_TRUE(waitForAny(waited, 0).front());
  std::string bytes;
  EXPECT_EQ(source.take(bytes), ByteSource::Taken::Bytes);
  EXPECT_TRUE(writeBytes(ends[1], " two"));
  ::close(ends[1]);
  EXPECT_EQ(source.take(bytes), ByteSource::Taken::Bytes);
  EXPECT_EQ(bytes, "one two");
  EXPECT_EQ(source.take(bytes), ByteSource::Taken::End);
}

}  // namespace
}  // namespace rungproof
