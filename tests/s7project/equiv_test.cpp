// A program and its machine code drive the same outputs; one changed constant is found with its run.
#include <gtest/gtest.h>

#include <filesystem>

#include "frontend/mc7/upload.hpp"
#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using test::TemporaryFolder;

TEST(S7Equiv, CorpusAndItsMachineCodeAreEqual) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus/s7300")) {
    const std::string text = test::contentOf(entry.path());
    test::ProjectPart part;
    const test::CompiledSource compiled = test::compileSource(text);
    ASSERT_EQ(compiled.fault, "") << entry.path();
    part.blocks = compiled.blocks;
    const TemporaryFolder folder;
    const std::string project = writeFiles(folder, test::writeProject({part}, 1252));
    const test::ProgramRun run = test::run({"equiv", "--isolated", entry.path().string(), project});
    EXPECT_EQ(run.exit, 0) << entry.path() << run.out << run.err;
    EXPECT_TRUE(run.says("EQUAL")) << run.out;
    ++count;
  }
  EXPECT_GE(count, 14);
}

TEST(S7Equiv, CallsAndTheirMachineCodeAreEqual) {
  const TemporaryFolder folder;
  const std::string source = folder.file("plant.awl", test::plantSource());
  const std::string project = writeFiles(folder, test::writeProject({test::plantPart()}, 1252));
  const test::ProgramRun run =
      test::run({"equiv", "--isolated", source, project, "--observe", "Q0.0,Q0.2,MW12,M92.0,MB91"});
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
}

// L 5 became L 6 in the machine code: the run that shows it is told.
TEST(S7Equiv, ChangedConstantIsDifferent) {
  const std::string source =
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L MW 10;\n L 5;\n ==I ;\n = Q 0.0;\nEND_ORGANIZATION_BLOCK\n";
  std::string changed = source;
  changed.replace(changed.find("L 5"), 3, "L 6");
  const TemporaryFolder folder;
  const std::string before = folder.file("before.awl", source);
  for (const mc7::StoredBlock& block : test::compileSource(changed).blocks)
    folder.file("upload/" + toString(block.key) + ".bin", mc7::writeUpload(block));
  const test::ProgramRun run = test::run({"equiv", "--isolated", "--external", "MW10", before, folder.path("upload")});
  EXPECT_EQ(run.exit, 1) << run.out << run.err;
  EXPECT_TRUE(run.says("DIFFERENT")) << run.out << run.err;
}

}  // namespace
}  // namespace rungproof
