// Projects of files without block heads: names of files say what the blocks are.
#include "frontend/stl/file_block.hpp"

#include <gtest/gtest.h>

#include "frontend/input/program_input.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

std::string shown(std::string_view path) {
  const FileBlock block = fileBlock(path);
  const std::string kind = !block.kind                          ? "?"
                           : *block.kind == PouKind::Main       ? "main"
                           : *block.kind == PouKind::Subroutine ? "SBR"
                                                                : "INT";
  return block.name + " " + kind + (block.number ? std::to_string(*block.number) : "");
}

TEST(FileBlock, IsReadFromTheName) {
  EXPECT_EQ(shown("plant/MAIN.stl"), "MAIN main1");
  EXPECT_EQ(shown("OB1.awl"), "OB1 main1");
  EXPECT_EQ(shown("plant/FC0_SysInit.stl"), "FC0_SysInit SBR0");
  EXPECT_EQ(shown("SBR3_Valves.stl"), "SBR3_Valves SBR3");
  EXPECT_EQ(shown("sbr_12.stl"), "sbr_12 SBR12");
  EXPECT_EQ(shown("INT1.stl"), "INT1 INT1");
  EXPECT_EQ(shown("Pump.stl"), "Pump ?");
  EXPECT_EQ(shown("INTERLOCK.stl"), "INTERLOCK ?");
  EXPECT_EQ(shown("FC5a.stl"), "FC5a ?");
  EXPECT_EQ(shortName("SBR3_Valves"), "Valves");
  EXPECT_EQ(shortName("SBR3"), "");
  EXPECT_EQ(shortName("Pump_Control"), "");
}

class FileProject : public testing::Test {
 protected:
  const test::TemporaryFolder folder;
  Program read(const std::vector<std::string>& files) { return readProgram(files); }
  static std::string errors(const Program& program) {
    std::string text;
    for (const Finding& finding : program.findings)
      text += finding.severity == Severity::Error ? finding.message + "\n" : "";
    return text;
  }
};

TEST_F(FileProject, BlocksAreFoundByNumberByNameAndByShortName) {
  const std::string main =
      folder.file("MAIN.stl",
                  "NETWORK 1\nLD SM0.0\nCALL SBR3\nNETWORK 2\nLD SM0.0\nCALL SBR3_Valves\nNETWORK 3\n"
                  "LD SM0.0\nCALL Valves\nNETWORK 4\nLD SM0.0\nCALL Pump\nNETWORK 5\nLD SM0.1\n"
                  "ATCH INT1_Edge, 0\nNETWORK 6\nLD SM0.0\nCALL FC0\n");
  const Program program = read({main, folder.file("SBR3_Valves.stl", "NETWORK 1\nLD I0.0\n= Q0.0\n"),
                                folder.file("Pump.stl", "NETWORK 1\nLD I0.1\n= Q0.1\n"),
                                folder.file("FC0_Init.stl", "NETWORK 1\nLD I0.3\n= Q0.3\n"),
                                folder.file("INT1_Edge.stl", "NETWORK 1\nLD I0.2\n= Q0.2\n")});
  EXPECT_EQ(errors(program), "");
  ASSERT_NE(program.main(), nullptr);
  const auto callee = [&](std::size_t network) {
    return program.main()->networks[network].instructions[1].operands[0].value;
  };
  for (const std::size_t network : {0U, 1U, 2U}) EXPECT_EQ(callee(network), 3);
  EXPECT_EQ(callee(3), 1) << "the first number that is free";
  EXPECT_EQ(callee(4), 1);
  EXPECT_EQ(callee(5), 0);
  EXPECT_EQ(program.subroutine(3)->name, "SBR3_Valves");
  EXPECT_EQ(program.subroutine(1)->name, "Pump");
}

TEST_F(FileProject, AFileAloneIsAMainProgramUnlessItsNameSaysOtherwise) {
  EXPECT_NE(read({folder.file("Pump.stl", "NETWORK 1\nLD I0.1\n= Q0.1\n")}).main(), nullptr);
  EXPECT_EQ(read({folder.file("SBR3_Valves.stl", "NETWORK 1\nLD I0.1\n= Q0.1\n")}).main(), nullptr);
}

TEST_F(FileProject, AFolderBringsItsTables) {
  folder.file("MAIN.stl", "NETWORK 1\nLD Start\n= Motor\n");
  folder.file("symbols.csv", "Start,I0.0,button\nMotor,Q0.0,contactor\n");
  folder.file("run.csv", "scan,I0.0\n1,1\n");
  const Program program = read(expandFolders({folder.path("")}));
  EXPECT_EQ(errors(program), "");
  EXPECT_EQ(program.symbols.size(), 2U);
  const Operand& start = program.main()->networks[0].instructions[0].operands[0];
  EXPECT_EQ(start.area, Area::I);
  EXPECT_EQ(start.kind, OperandKind::Direct);
}

}  // namespace
}  // namespace rungproof
