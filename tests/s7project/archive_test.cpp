// Archives: packed and stored files, and what is damaged of them.
#include "frontend/s7project/archive.hpp"

#include <gtest/gtest.h>

#include "frontend/s7project/project_files.hpp"
#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using s7project::Archive;
using test::TemporaryFolder;

TEST(S7Archive, HoldsWhatWasPacked) {
  const std::map<std::string, std::string> files = {{"a.s7p", "first"}, {"hrs/b", std::string(5000, 'x')}, {"c", ""}};
  const Archive archive(test::zipOf(files, "Top"));
  EXPECT_EQ(archive.fault(), "");
  ASSERT_EQ(archive.entries().size(), 3U);
  for (const Archive::Entry& entry : archive.entries()) {
    ASSERT_TRUE(entry.name.starts_with("Top/")) << entry.name;
    EXPECT_EQ(archive.contents(entry), files.at(entry.name.substr(4))) << entry.name;
  }
}

TEST(S7Archive, DamageIsSaid) {
  const std::string whole = test::zipOf(test::writeProject({test::plantPart()}, 1252), "Plant");
  const TemporaryFolder folder;
  EXPECT_NE(Archive(whole.substr(0, whole.size() / 2)).fault(), "");
  std::string directory = whole;
  directory[directory.rfind("PK\1\2")] = 'x';
  EXPECT_NE(Archive(directory).fault().find("byte"), std::string::npos);
  // A packed file whose bytes are wrong: the part is missing, and nothing crashes.
  std::string packed = whole;
  for (std::size_t i = 200; i < 400; ++i) packed[i] = '\x55';
  const test::ProgramRun run = test::run({"lint", "--isolated", folder.file("p.zip", packed)});
  EXPECT_GE(run.exit, 0);
}

TEST(S7Archive, NamesAreFoundInAnyCase) {
  const TemporaryFolder folder;
  folder.file("P/HRS/S7resoff.dbf", "x");
  const s7project::ProjectFiles files = s7project::ProjectFiles::inFolder(folder.file("P/Plant.S7P", ""));
  EXPECT_EQ(files.bytes("hrs/S7RESOFF.DBF"), "x");
  EXPECT_EQ(files.spelling("hrs/S7RESOFF.DBF"), "HRS/S7resoff.dbf");
  EXPECT_EQ(files.namesIn("hrs"), std::vector<std::string>{"S7resoff.dbf"});
  EXPECT_FALSE(files.has("hrs/other"));
}

}  // namespace
}  // namespace rungproof
