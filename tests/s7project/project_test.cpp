// A written project of 20 blocks, with more deleted rows than live ones, is read, shown, linted, run and proved.
#include <gtest/gtest.h>

#include "frontend/s7project/s7_project.hpp"
#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using test::TemporaryFolder;

std::string plantIn(const TemporaryFolder& folder, unsigned page = 1252) {
  return writeFiles(folder, test::writeProject({test::plantPart()}, page));
}

TEST(S7Project, SourceOfThePlantCompiles) { EXPECT_EQ(test::compileSource(test::plantSource()).fault, ""); }

TEST(S7Project, LiveRowsOnlyCount) {
  const TemporaryFolder folder;
  const s7project::S7Project project = s7project::readS7Project(plantIn(folder), TextEncoding::Auto);
  ASSERT_FALSE(project.failure);
  for (const s7project::ProjectFault& fault : project.faults) ADD_FAILURE() << fault.text;
  ASSERT_EQ(project.programs.size(), 1U);
  const s7project::ProjectProgram& program = project.programs[0];
  EXPECT_EQ(program.blocks.size(), 20U);
  EXPECT_EQ(program.symbols.size(), 2U);
  EXPECT_EQ(program.path, "SIMATIC 300(1)/CPU 315-2 DP/S7 Program(1)");
  ASSERT_TRUE(program.cpu);
  EXPECT_EQ(program.cpu->orderNumber, "6ES7 315-2AG10-0AB0");
  EXPECT_EQ(program.cpu->type, "315-2");
}

TEST(S7Project, TreeNamesBlocksWithTheirCounts) {
  const TemporaryFolder folder;
  const test::ProgramRun run = test::run({"show", "--isolated", "--list", plantIn(folder)});
  EXPECT_EQ(run.exit, 0) << run.err;
  EXPECT_TRUE(run.says("20 blocks, 2 symbols")) << run.out;
  // Six statements and the closing BE; nine of FC 2 and BE; FC 3 in two networks.
  EXPECT_TRUE(run.says("FC1  STL  1 network, 7 instructions")) << run.out;
  EXPECT_TRUE(run.says("FC2  STL  1 network, 10 instructions")) << run.out;
  EXPECT_TRUE(run.says("FC3  STL  2 networks, 5 instructions, protected")) << run.out;
}

TEST(S7Project, ShowsCallsAndNamesAsTheyWereWritten) {
  const TemporaryFolder folder;
  const test::ProgramRun run = test::run({"show", "--isolated", "--as", "stl", "--no-findings", plantIn(folder)});
  EXPECT_EQ(run.exit, 0) << run.err;
  for (const char* text :
       {"FC1", "O      #Start", "JC     ok", "ok:", "CALL   FC 1 (Start := I0.0, Stop := I0.1, Motor := Q0.0)",
        "Limit := DB10.DBW0", "CALL   FB 21, DB 21 (In := I0.2, Out := Q0.2)", "Network 1  Self holding", "OB1  Main"})
    EXPECT_TRUE(run.says(text)) << text << "\n" << run.out << run.err;
}

TEST(S7Project, LintSaysNothingOfReading) {
  const TemporaryFolder folder;
  const test::ProgramRun run = test::run({"lint", "--isolated", "--format", "concise", plantIn(folder)});
  EXPECT_NE(run.exit, 2) << run.out << run.err;
  EXPECT_FALSE(run.says("SYN")) << run.out;
}

TEST(S7Project, ProvesAndRuns) {
  const TemporaryFolder folder;
  const std::string project = plantIn(folder);
  const std::string properties =
      folder.file("p.props", "prove stop: I0.1 implies not Q0.0\nreach on: Q0.0\nprove value: DB10.DBW0 == 12\n");
  const test::ProgramRun run = test::run({"prove", "--isolated", "--props", properties, project});
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
  EXPECT_TRUE(run.says("PROVED")) << run.out;
  EXPECT_TRUE(run.says("REACHABLE")) << run.out;
}

// The folder, and the archive that STEP 7 makes, are the same project.
TEST(S7Project, FolderAndArchiveAreTheSame) {
  const TemporaryFolder folder;
  const std::string project = plantIn(folder);
  const std::string archive =
      folder.file("plant.zip", test::zipOf(test::writeProject({test::plantPart()}, 1252), "Plant"));
  const test::ProgramRun of = test::run({"show", "--isolated", "--as", "stl", "--no-findings", project});
  for (const std::string& name : {folder.path("Plant"), archive}) {
    const test::ProgramRun run = test::run({"show", "--isolated", "--as", "stl", "--no-findings", name});
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(run.out, of.out) << name;
  }
}

TEST(S7Project, TextsAreOfTheProjectsCodePage) {
  struct Case {
    unsigned page;
    const char* bytes;
    const char* text;
  };
  const Case cases[] = {
      {1250, "\xB3\xF3\xBF", "łóż"}, {1251, "\xEF\xF3\xF1\xEA", "пуск"}, {936, "\xC6\xF4\xB6\xAF", "启动"}};
  for (const Case& each : cases) {
    const TemporaryFolder folder;
    test::ProjectPart part = test::plantPart();
    part.symbols[0].name = each.bytes;
    for (mc7::StoredBlock& block : part.blocks) {
      if (block.key == step7::BlockKey{step7::BlockKind::Ob, 1}) block.networkTexts[0].title = each.bytes;
    }
    const std::string project = writeFiles(folder, test::writeProject({part}, each.page));
    const test::ProgramRun run = test::run({"show", "--isolated", "--pou", "OB1", "--no-findings", project});
    EXPECT_TRUE(run.says(each.text)) << each.page << run.out << run.err;
  }
}

TEST(S7Project, SeveralProgramsAreNamed) {
  const TemporaryFolder folder;
  test::ProjectPart second = test::plantPart();
  second.cpu = "CPU 314";
  second.orderNumber.clear();
  const std::string project = writeFiles(folder, test::writeProject({test::plantPart(), second}, 1252));
  EXPECT_NE(test::run({"lint", "--isolated", project}).exit, 2);
  for (const char* command : {"prove", "sim"}) {
    const test::ProgramRun run = test::run({command, "--isolated", project});
    EXPECT_EQ(run.exit, 2);
    EXPECT_TRUE(run.says("the project has 2 programs")) << run.err;
    EXPECT_TRUE(run.says("SIMATIC 300(2)/CPU 314/S7 Program(1)")) << run.err;
  }
  for (const char* command : {"equiv", "diff"}) {
    const test::ProgramRun run = test::run({command, "--isolated", project, project});
    EXPECT_EQ(run.exit, 2);
    EXPECT_TRUE(run.says("the project has 2 programs")) << run.err;
  }
  const test::ProgramRun named =
      test::run({"show", "--isolated", "--program", "CPU 314/S7 Program(1)", "--no-findings", project});
  EXPECT_EQ(named.exit, 0) << named.err;
  const test::ProgramRun both = test::run({"show", "--isolated", "--no-findings", project});
  const auto headed = [&](const std::string& cpu) { return project + "/" + cpu + "/S7 Program(1)\n\n" + named.out; };
  EXPECT_EQ(both.out, headed("SIMATIC 300(1)/CPU 315-2 DP") + "\n" + headed("SIMATIC 300(2)/CPU 314")) << both.err;
  // lint: each program below its name, with the findings that it has alone.
  const auto programNamed = [&](const std::string& cpu) { return project + "/" + cpu + "/S7 Program(1)"; };
  const std::string first = programNamed("SIMATIC 300(1)/CPU 315-2 DP"), next = programNamed("SIMATIC 300(2)/CPU 314");
  const std::string linted = test::run({"lint", "--isolated", project}).out;
  ASSERT_TRUE(linted.starts_with(first + "\n\n")) << linted;
  const std::size_t atNext = linted.find("\n" + next + "\n\n");
  ASSERT_NE(atNext, std::string::npos) << linted;
  EXPECT_EQ(linted.substr(0, atNext).find("--> " + next), std::string::npos) << linted;
  EXPECT_EQ(linted.substr(atNext).find("--> " + first), std::string::npos) << linted;
  const test::ProgramRun wrong = test::run({"lint", "--isolated", "--program", "nobody", project});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_TRUE(wrong.says("has no program 'nobody'")) << wrong.err;
}

TEST(S7Project, OldLayoutIsRefusedByName) {
  const TemporaryFolder folder;
  std::map<std::string, std::string> files = test::writeProject({test::plantPart()}, 0);
  std::erase_if(files, [](const auto& file) {
    return file.first.find("ubblk") != std::string::npos || file.first.find("SUBBLK") != std::string::npos;
  });
  const test::ProgramRun run = test::run({"lint", "--isolated", writeFiles(folder, files)});
  EXPECT_EQ(run.exit, 2);
  EXPECT_TRUE(run.says("old layout of STEP 7 V1 and V2")) << run.err;
}

// A caller that was compiled with an older interface than the project has.
TEST(S7Project, TimeStampConflictIsFound) {
  const TemporaryFolder folder;
  test::ProjectPart part = test::plantPart();
  for (mc7::StoredBlock& block : part.blocks) {
    if (block.key == step7::BlockKey{step7::BlockKind::Fb, 21}) block.interfaceTime = 5000;
    if (block.key == step7::BlockKey{step7::BlockKind::Ob, 1})
      block.used = {{{step7::BlockKind::Fb, 21}, 4000}, {{step7::BlockKind::Fc, 1}, 0}};
  }
  const test::ProgramRun run = test::run({"lint", "--isolated", writeFiles(folder, test::writeProject({part}, 1252))});
  EXPECT_TRUE(run.says("OB1 was compiled with another interface of FB21")) << run.out;
}

// One finding for a block, however many callers it has.
TEST(S7Project, CallersOfOneInterfaceAreOneFinding) {
  const TemporaryFolder folder;
  test::ProjectPart part = test::plantPart();
  std::size_t callers = 0;
  for (mc7::StoredBlock& block : part.blocks) {
    if (block.key == step7::BlockKey{step7::BlockKind::Fb, 21}) block.interfaceTime = 5000;
    if (block.key.kind != step7::BlockKind::Fc) continue;
    block.used = {{{step7::BlockKind::Fb, 21}, 4000}};
    ++callers;
  }
  ASSERT_EQ(callers, 6U);  // FC 1 to FC 6, of which four are named
  const test::ProgramRun run = test::run({"lint", "--isolated", "--format", "concise", "--select", "SYN072",
                                          writeFiles(folder, test::writeProject({part}, 1252))});
  EXPECT_TRUE(run.says("FC1, FC2, FC3, FC4 and 2 more were compiled with another interface of FB21")) << run.out;
  EXPECT_EQ(run.out.find("SYN072"), run.out.rfind("SYN072")) << run.out;
}

// The values of a data block count as they are stored, also those that no constant spells: a DATE_AND_TIME of zeros.
TEST(S7Project, StoredBytesOfADataBlockCount) {
  const TemporaryFolder folder;
  test::ProjectPart part;
  part.blocks = test::compileSource(
                    "DATA_BLOCK DB 5\nSTRUCT\n at : DATE_AND_TIME ;\n n : INT := 3 ;\nEND_STRUCT ;\n"
                    "BEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
                    " L DB5.DBD 0;\n T MD 20;\n L DB5.DBW 8;\n T MW 24;\nEND_ORGANIZATION_BLOCK\n")
                    .blocks;
  part.blocks.front().code = std::string(9, '\0') + '\x07';
  const std::string project = writeFiles(folder, test::writeProject({part}, 1252));
  const std::string properties = folder.file("p.props", "prove date: MD20 == 0\nprove number: MW24 == 7\n");
  const test::ProgramRun run = test::run({"prove", "--isolated", "--props", properties, project});
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
}

// A memo file that is missing is one finding, and not one for each block and part.
TEST(S7Project, MissingMemoFileIsOneFinding) {
  const TemporaryFolder folder;
  std::map<std::string, std::string> files = test::writeProject({test::plantPart()}, 1252);
  std::erase_if(files, [](const auto& file) { return file.first.ends_with("SUBBLK.DBT"); });
  const test::ProgramRun run = test::run({"lint", "--isolated", "--format", "concise", writeFiles(folder, files)});
  EXPECT_TRUE(run.says("SUBBLK.DBT: it is missing, so 20 blocks have no code, names and comments")) << run.out;
  EXPECT_EQ(run.out.find("SYN071"), run.out.rfind("SYN071")) << run.out;
}

}  // namespace
}  // namespace rungproof
