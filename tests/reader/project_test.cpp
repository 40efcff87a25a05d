// Files to one program: kinds, unreadable files, several files, standard input names.
#include "frontend/input/project.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "frontend/files/file_reader.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

class Project : public ::testing::Test {
 protected:
  void SetUp() override {
    directory_ = std::filesystem::path(RUNGPROOF_BINARY_DIR) / "reader_test";
    std::filesystem::create_directories(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }
  std::string file(const std::string& name, const std::string& text) {
    const std::filesystem::path path = directory_ / name;
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }
  std::filesystem::path directory_;
};

const std::string mainText =
    "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD Start\nCALL Pump\nEND_ORGANIZATION_BLOCK\n";

TEST_F(Project, SeveralFilesMakeOneProgram) {
  const Program program = readProgram(
      {file("sub.awl", "SUBROUTINE_BLOCK Pump:SBR2\nBEGIN\nNetwork 1\nLD Start\n= Q0.0\nEND_SUBROUTINE_BLOCK\n"),
       file("main.awl", mainText), file("symbols.txt", "Start\tI0.0\nStop\tI0.1\n"),
       file("data.txt", "VB0 1\nVB1 2\n")});
  EXPECT_EQ(findings(program), "");
  ASSERT_EQ(program.pous.size(), 2U);
  EXPECT_EQ(program.pous[0].name, "MAIN");
  EXPECT_EQ(show(program.pous[0]), "LD I0.0; CALL 2");
  EXPECT_EQ(show(program.pous[1]), "LD I0.0; = Q0.0");
  EXPECT_EQ(program.symbols.size(), 2U);
  EXPECT_EQ(program.data.size(), 2U);
  EXPECT_EQ(program.pous[0].networks[0].instructions[0].id, 0U);
  EXPECT_EQ(program.pous[1].networks[0].instructions[0].id, 2U);
}

TEST_F(Project, SymbolFilesByOption) {
  ReadOptions options;
  options.symbolFiles = {file("table.dat", "Start I0.5\n")};  // blanks alone would not be recognised
  EXPECT_EQ(show(readText("m.awl", mainText, options).pous[0]), "LD I0.5; CALL Pump");
}

TEST_F(Project, UnreadableFiles) {
  const Program missing = readProgram({(directory_ / "missing.awl").string()});
  ASSERT_EQ(missing.findings.size(), 1U);
  EXPECT_EQ(missing.findings[0].rule, "SYN001");
  EXPECT_EQ(missing.sources->file(missing.findings[0].span.file).name(), (directory_ / "missing.awl").string());
  EXPECT_TRUE(hasReadErrors(missing));
  EXPECT_TRUE(hasReadErrors(readProgram({directory_.string()})));
  EXPECT_EQ(readProgram({file("empty.awl", "")}).findings[0].rule, "SYN007");
  EXPECT_EQ(readProgram({file("blank.awl", " \r\n\t\n")}).findings[0].rule, "SYN007");
  EXPECT_EQ(readProgram({}).findings[0].rule, "SYN006");
}

TEST_F(Project, OneBadFileDoesNotHideTheOthers) {
  const Program program = readProgram({(directory_ / "missing.awl").string(), file("main.awl", mainText)});
  EXPECT_EQ(program.pous.size(), 1U);
  EXPECT_EQ(program.findings.size(), 1U);
}

TEST(ProjectKinds, ByContentFirst) {
  EXPECT_EQ(findings(readText("letter.txt", "Dear reader,\nthis is a letter.\nIt has no program.\n")), "SYN002<>");
  EXPECT_EQ(findings(readText("page.awl", "{ \"a\": 1 }")), "SYN002<>");
  EXPECT_EQ(readText("list.csv", "LD I0.0\n= Q0.0\n").instructionCount(), 2U);
  EXPECT_EQ(readText("noname", "Network 1\nLD I0.0\n= Q0.0\n").instructionCount(), 2U);
}

TEST(ProjectKinds, EndingDecidesWhenTheContentDoesNot) {
  const Program program = readText("bad.awl", "FOO I0.0\nBAR I0.1\n");
  EXPECT_EQ(findings(program), "SYN010<FOO> SYN010<BAR>");
}

TEST(ProjectKinds, BinaryDataIsNoText) {
  std::string bytes;
  for (int i = 0; i < 4000; ++i) bytes += static_cast<char>(i * 7919 >> 3);
  const Program program = readText("x.awl", bytes);
  EXPECT_TRUE(hasReadErrors(program));
  EXPECT_TRUE(program.pous.empty());
}

TEST(ProjectKinds, EveryReaderHasANameAndRefusesNothingness) {
  ASSERT_GE(fileReaders().size(), 3U);
  const SourceFile source("x", "neither fish nor flesh\n");
  for (const FileReader* reader : fileReaders()) {
    EXPECT_FALSE(reader->name.empty());
    EXPECT_EQ(reader->sureness(source, InputText{}, ReadOptions{}), 0) << reader->name;
  }
}

TEST(ProjectKinds, TargetComesFromTheOptions) {
  ReadOptions options;
  options.target.cpu = s7200Cpu("222");
  EXPECT_EQ(readText("a.awl", "NOT\n", options).target.cpu, s7200Cpu("222"));
}

}  // namespace
}  // namespace rungproof
