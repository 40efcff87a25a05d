// Does the CPU run what was approved? A project beside blocks read out of a CPU: what is the same is said at once, what
// differs by network and with its verdict, values by their names.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "frontend/mc7/upload.hpp"
#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using step7::BlockKey;
using step7::BlockKind;
using test::TemporaryFolder;

/// The plant as a project, and as a CPU gives its blocks, changed by `change`.
class UploadedPlant {
 public:
  explicit UploadedPlant(const std::function<void(std::vector<mc7::StoredBlock>&)>& change = {}) {
    part_ = test::plantPart();
    project_ = writeFiles(folder_, test::writeProject({part_}, 1252));
    std::vector<mc7::StoredBlock> blocks = part_.blocks;
    std::erase_if(blocks, [](const mc7::StoredBlock& block) { return block.key.kind == BlockKind::Udt; });
    if (change) change(blocks);
    for (const mc7::StoredBlock& block : blocks)
      folder_.file("upload/" + toString(block.key) + ".mc7", mc7::writeUpload(block));
  }

  test::ProgramRun equiv(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"equiv", "--isolated", project_, folder_.path("upload")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments);
  }

 private:
  TemporaryFolder folder_;
  test::ProjectPart part_;
  std::string project_;
};

mc7::StoredBlock& blockIn(std::vector<mc7::StoredBlock>& blocks, BlockKey key) {
  return *std::ranges::find(blocks, key, &mc7::StoredBlock::key);
}

/// A source compiled in place of the block.
void replaceBlock(std::vector<mc7::StoredBlock>& blocks, BlockKey key, const std::string& before,
                  const std::string& after) {
  std::string source = test::plantSource();
  const std::size_t at = source.find(before);
  ASSERT_NE(at, std::string::npos);
  source.replace(at, before.size(), after);
  for (const mc7::StoredBlock& block : test::compileSource(source).blocks) {
    if (block.key == key) blockIn(blocks, key) = block;
  }
}

// Two OBs, six FCs, three FBs, seven DBs: eighteen blocks that a CPU has.
TEST(S7Uploads, TheSameBlocksAreSaidAtOnce) {
  const test::ProgramRun run = UploadedPlant().equiv();
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
  EXPECT_TRUE(run.says("blocks: 18 of OLD, 18 of NEW")) << run.out;
  EXPECT_TRUE(run.says("EQUAL  by the same machine code")) << run.out;
}

// A comparison of FC 2 that no value of an INT can tell apart: <=I or <I, where both ways end with the same number.
TEST(S7Uploads, HarmlessChangeIsProved) {
  const UploadedPlant plant([](std::vector<mc7::StoredBlock>& blocks) {
    replaceBlock(blocks, {BlockKind::Fc, 2}, "      <=I   ;\n      JC    ok;", "      <I    ;\n      JC    ok;");
  });
  const test::ProgramRun run = plant.equiv({"--observe", "Q0.0,Q0.2,MW12"});
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
  EXPECT_TRUE(run.says("changed          FC2  network 1\n")) << run.out;
  EXPECT_TRUE(run.says("what differs in the changed blocks changes no output")) << run.out;
}

TEST(S7Uploads, HarmfulChangeIsShown) {
  const UploadedPlant plant([](std::vector<mc7::StoredBlock>& blocks) {
    replaceBlock(blocks, {BlockKind::Fc, 1}, "      AN    #Stop;\n", "");
  });
  const test::ProgramRun run = plant.equiv();
  EXPECT_EQ(run.exit, 1) << run.out << run.err;
  EXPECT_TRUE(run.says("changed          FC1  network 1\n")) << run.out;
  EXPECT_TRUE(run.says("Q0.0: OLD 0, NEW 1")) << run.out;
}

// Values of a data block by their names in the project. Each program begins with its own, or both with OLD's.
TEST(S7Uploads, ValuesAreNamed) {
  const UploadedPlant plant([](std::vector<mc7::StoredBlock>& blocks) {
    blockIn(blocks, {BlockKind::Db, 10}).code[1] = 17;  // Count, which the project has as 12
  });
  const test::ProgramRun own = plant.equiv();
  EXPECT_TRUE(own.says("other values     DB10  Count 12 / 17")) << own.out;
  EXPECT_FALSE(own.says("the same machine code")) << own.out;
  const test::ProgramRun old = plant.equiv({"--values", "old"});
  EXPECT_EQ(old.exit, 0) << old.out << old.err;
  EXPECT_TRUE(old.says("EQUAL  by the same machine code")) << old.out;
}

TEST(S7Uploads, BlocksOnOneSideAreNamed) {
  const UploadedPlant plant([](std::vector<mc7::StoredBlock>& blocks) {
    std::erase_if(blocks, [](const mc7::StoredBlock& block) { return block.key == BlockKey{BlockKind::Db, 13}; });
    mc7::StoredBlock more = blockIn(blocks, {BlockKind::Db, 12});
    more.key.number = 99;
    blocks.push_back(more);
  });
  const test::ProgramRun run = plant.equiv();
  EXPECT_TRUE(run.says("only in OLD      DB13\n")) << run.out;
  EXPECT_TRUE(run.says("only in NEW      DB99\n")) << run.out;
  EXPECT_FALSE(run.says("the same machine code")) << run.out;
}

// A checksum is 16 bits: other code may have the same, and nobody takes it for equal.
TEST(S7Uploads, EqualChecksumOfOtherCodeIsSaid) {
  const UploadedPlant plant([](std::vector<mc7::StoredBlock>& blocks) {
    mc7::StoredBlock& block = blockIn(blocks, {BlockKind::Fc, 1});
    block.checksum = mc7::checksumOf(BlockKind::Fc, block.code);
    block.code[block.code.size() - 3] ^= 1;
  });
  const test::ProgramRun run = plant.equiv();
  EXPECT_NE(run.exit, 0) << run.out;
  EXPECT_TRUE(run.says("and their code differs")) << run.out << run.err;
}

TEST(S7Uploads, JsonHasARowForEachBlock) {
  const UploadedPlant plant([](std::vector<mc7::StoredBlock>& blocks) {
    replaceBlock(blocks, {BlockKind::Fc, 1}, "      AN    #Stop;\n", "");
  });
  const nlohmann::json report = nlohmann::json::parse(plant.equiv({"--format", "json"}).out);
  ASSERT_EQ(report["blocks"].size(), 18U);
  for (const nlohmann::json& row : report["blocks"]) {
    const bool isChanged = row["block"] == "FC1";
    EXPECT_EQ(row["likeness"], isChanged ? "changed" : "same") << row;
    EXPECT_EQ(row["networks"], isChanged ? nlohmann::json::array({"network 1"}) : nlohmann::json::array()) << row;
  }
  EXPECT_EQ(report["comparison"]["verdict"], "DIFFERENT");
}

// Of a source no bytes are there: statements are compared, whatever the names of local data are.
TEST(S7Uploads, SourceAndUploadHaveTheSameStatements) {
  const TemporaryFolder folder;
  const std::string source = folder.file("plant.awl", test::plantSource());
  for (const mc7::StoredBlock& block : test::plantPart().blocks) {
    if (block.key.kind != BlockKind::Udt)
      folder.file("upload/" + toString(block.key) + ".mc7", mc7::writeUpload(block));
  }
  const test::ProgramRun run = test::run({"equiv", "--isolated", source, folder.path("upload")});
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
  EXPECT_FALSE(run.says("changed")) << run.out;
  EXPECT_TRUE(run.says("same statements")) << run.out;
}

}  // namespace
}  // namespace rungproof
