// Damaged projects: each is said with its file and place, the rest is read, and nothing crashes.
#include <gtest/gtest.h>

#include <random>

#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using test::TemporaryFolder;

using Files = std::map<std::string, std::string>;

std::string* fileOf(Files& files, std::string_view part) {
  for (auto& [path, contents] : files) {
    if (path.find(part) != std::string::npos) return &contents;
  }
  return nullptr;
}

struct Damage {
  const char* file;
  void (*change)(std::string& bytes);
  const char* said;
};

// What is wrong, and what the message names: the file, and the record or byte.
const Damage damages[] = {
    {"BAUSTEIN.DBF", [](std::string& b) { b.clear(); }, "BAUSTEIN.DBF"},
    {"BAUSTEIN.DBF", [](std::string& b) { b[0] = 'x'; }, "BAUSTEIN.DBF, byte 0"},
    {"BAUSTEIN.DBF", [](std::string& b) { b.resize(40); }, "BAUSTEIN.DBF, byte"},
    {"BAUSTEIN.DBF", [](std::string& b) { b.resize(b.size() / 2); }, "lies behind the end of the file"},
    {"BAUSTEIN.DBF", [](std::string& b) { b[10] = b[11] = 0; }, "BAUSTEIN.DBF, byte 8"},
    {"BAUSTEIN.DBF", [](std::string& b) { b[7] = 1; }, "lies behind the end of the file"},
    {"BAUSTEIN.DBF", [](std::string& b) { b[8] = b[9] = '\xFF'; }, "BAUSTEIN.DBF, byte"},
    {"subblk.DBF", [](std::string& b) { b.resize(b.size() - 100); }, "lies behind the end of the file"},
    {"subblk.DBF", [](std::string& b) { b[0] = 0; }, "subblk.DBF, byte 0"},
    {"SUBBLK.DBT", [](std::string& b) { b.clear(); }, "behind the end of the memo file"},
    {"SUBBLK.DBT", [](std::string& b) { b.resize(b.size() / 2); }, "behind the end of the memo file"},
    {"SUBBLK.DBT", [](std::string& b) { std::fill(b.begin() + 512, b.end(), '\0'); }, "no memo begins there"},
    {"SUBBLK.DBT",
     [](std::string& b) {
       for (std::size_t i = 512; i + 8 < b.size(); i += 512) b[i + 7] = '\x7F';
     },
     "is not possible"},
    {"SUBBLK.DBT",
     [](std::string& b) {
       for (std::size_t i = 512; i + 8 < b.size(); i += 512) b[i + 4] = '\1', b[i + 5] = 0;
     },
     "is not possible"},
    {"hrs/S7RESOFF.DBF", [](std::string& b) { b[0] = 'x'; }, "S7RESOFF.DBF, byte 0"},
    {"linkhrs.lnk", [](std::string& b) { b.clear(); }, "linkhrs.lnk"},
    {"linkhrs.lnk", [](std::string& b) { b.resize(10); }, "linkhrs.lnk"},
    {"YLNKLIST.DBF", [](std::string& b) { b[0] = 'x'; }, "YLNKLIST.DBF, byte 0"},
    {"SYMLISTS.DBF", [](std::string& b) { b[11] = '\xFF'; }, "SYMLISTS.DBF, byte"},
    {"Symlist.dbf", [](std::string& b) { b.resize(70); }, "ymlist.dbf, byte"},
    {"HOBJECT1.DBF", [](std::string& b) { b[0] = 'x'; }, "HOBJECT1.DBF, byte 0"},
    {"HRELATI1.DBF", [](std::string& b) { b[0] = 'x'; }, "HRELATI1.DBF, byte 0"},
    {"s7hstatx/HOBJECT1.DBF", [](std::string& b) { b.resize(50); }, "HOBJECT1.DBF, byte"},
    {"HATTRME1.DBF", [](std::string& b) { b[10] = 1; }, "HATTRME1.DBF, byte 8"},
    {"YLNKLIST.DBF", [](std::string& b) { b.resize(b.size() - 5); }, "YLNKLIST.DBF, byte"},
    {"SYMLISTS.DBF", [](std::string& b) { b[4] = 100; }, "SYMLISTS.DBF, byte"},
    {"Symlist.dbf", [](std::string& b) { b[4] = 100; }, "ymlist.dbf, byte"},
    {"S7RESOFF.DBF", [](std::string& b) { b[4] = 100; }, "S7RESOFF.DBF, byte"},
    {"S7RESOFF.DBF", [](std::string& b) { b.resize(33); }, "S7RESOFF.DBF, byte"},
    {"subblk.DBF", [](std::string& b) { b[4] = b[5] = '\xFF'; }, "ubblk.DBF, byte"},
    {"subblk.DBF",
     [](std::string& b) {
       b[10] = 1;
       b[11] = 0;
     },
     "ubblk.DBF, byte 8"},
};

TEST(S7Damage, IsSaidWithFileAndPlace) {
  for (const Damage& damage : damages) {
    Files files = test::writeProject({test::plantPart()}, 1252);
    std::string* bytes = fileOf(files, damage.file);
    ASSERT_NE(bytes, nullptr) << damage.file;
    damage.change(*bytes);
    const TemporaryFolder folder;
    const test::ProgramRun run = test::run({"lint", "--isolated", writeFiles(folder, files)});
    EXPECT_TRUE(run.says(damage.said)) << damage.file << "\n" << run.out << run.err;
    EXPECT_NE(run.exit, 0) << damage.file;
  }
}

struct BlockDamage {
  void (*change)(mc7::StoredBlock& block);
  const char* said;
};

// FC 2 alone is damaged: it is named with the byte, counts as an interface, and the others are read.
const BlockDamage blockDamages[] = {
    {[](mc7::StoredBlock& b) { b.code[0] = '\x6B', b.code[1] = '\xFF'; }, "byte"},
    {[](mc7::StoredBlock& b) { b.code.resize(3); }, "byte"},
    {[](mc7::StoredBlock& b) { b.code[0] = static_cast<char>(b.code[0] ^ 1); }, ""},
    {[](mc7::StoredBlock& b) { b.table[2] = '\x7F'; }, "a network ends at byte"},
    {[](mc7::StoredBlock& b) { b.table[2] = '\3'; }, "a network ends at byte"},
    {[](mc7::StoredBlock& b) { b.table[0] = '\x7F'; }, "the table of networks ends"},
    {[](mc7::StoredBlock& b) { b.table.resize(3); }, "the table of networks ends"},
    {[](mc7::StoredBlock& b) { b.checksum = 0x1234; }, "its checksum is 1234"},
    {[](mc7::StoredBlock& b) { b.code.clear(); }, ""},
};

TEST(S7Damage, OfOneBlockLeavesTheOthersReadable) {
  for (const BlockDamage& damage : blockDamages) {
    test::ProjectPart part = test::plantPart();
    for (mc7::StoredBlock& block : part.blocks) {
      if (block.key != step7::BlockKey{step7::BlockKind::Fc, 2}) continue;
      const auto sum = block.checksum;
      damage.change(block);
      if (block.checksum == sum && *damage.said != '\0') block.checksum.reset();
    }
    const TemporaryFolder folder;
    const std::string project = writeFiles(folder, test::writeProject({part}, 1252));
    const test::ProgramRun run = test::run({"lint", "--isolated", project});
    EXPECT_TRUE(run.says("FC2 is not read")) << run.out << run.err;
    EXPECT_TRUE(run.says(damage.said)) << damage.said << run.out;
    const test::ProgramRun shown =
        test::run({"show", "--isolated", "--as", "stl", "--pou", "FC1", "--no-findings", project});
    EXPECT_TRUE(shown.says("O      #Start")) << shown.out << shown.err;
    // What depends on it is not proved.
    const std::string properties = folder.file("p.props", "prove value: MW12 == 0\n");
    const test::ProgramRun proved = test::run({"prove", "--isolated", "--props", properties, project});
    EXPECT_TRUE(proved.says("NOT COVERED")) << proved.out << proved.err;
  }
}

// Random bytes in all files: no crash, and an exit code that says something.
TEST(S7Damage, RandomBytesDoNotCrash) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const Files whole = test::writeProject({test::plantPart()}, 1252);
  for (int i = 0; i < 40; ++i) {
    Files files = whole;
    auto file = files.begin();
    std::advance(file, random() % files.size());
    for (std::size_t count = 1 + random() % 20; count > 0 && !file->second.empty(); --count)
      file->second[random() % file->second.size()] = static_cast<char>(random());
    const TemporaryFolder folder;
    const std::string project = writeFiles(folder, files);
    const int exit = test::run({"lint", "--isolated", project}).exit;
    EXPECT_TRUE(exit >= 0 && exit <= 3) << file->first;
    EXPECT_GE(test::run({"show", "--isolated", "--list", project}).exit, 0) << file->first;
  }
}

}  // namespace
}  // namespace rungproof
