// The Micro/WIN text export: frame, declarations, networks, titles, comments, instructions.
#include <gtest/gtest.h>

#include "frontend/project.hpp"
#include "ir/desc.hpp"

namespace rungproof {
namespace {

std::string listing(const Network& network) {
  std::string result;
  for (const Instruction& instruction : network.instructions) {
    if (!result.empty()) result += "; ";
    result += instruction.desc->stl;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) result += (i == 0 ? " " : ",") + toString(instruction.operands[i]);
  }
  return result;
}

std::string messages(const Program& program) {
  std::string result;
  for (const Finding& finding : program.findings) result += finding.rule + " " + finding.message + "\n";
  return result;
}

TEST(StlParser, ReadsTheFrameOfAnExport) {
  const Program program = readText("a.awl",
                                   "ORGANIZATION_BLOCK MAIN:OB1\r\n"
                                   "TITLE=Pump control\r\n"
                                   "// second line of the title\r\n"
                                   "BEGIN\r\n"
                                   "Network 1 // start\r\n"
                                   "// the start button\r\n"
                                   "LD     I0.0\r\n"
                                   "O      Q0.0\r\n"
                                   "AN     I0.1\r\n"
                                   "=      Q0.0\r\n"
                                   "Network 4 \r\n"
                                   "LD     SM0.1\r\n"
                                   "S      Q0.1, 2\r\n"
                                   "END_ORGANIZATION_BLOCK\r\n"
                                   "SUBROUTINE_BLOCK SBR_0:SBR0\r\n"
                                   "TITLE=SUBROUTINE COMMENTS\r\n"
                                   "BEGIN\r\n"
                                   "Network 1 // Network Title\r\n"
                                   "// Network Comment\r\n"
                                   "END_SUBROUTINE_BLOCK\r\n");
  EXPECT_EQ(messages(program), "");
  ASSERT_EQ(program.pous.size(), 2U);
  const Pou& main = program.pous[0];
  EXPECT_EQ(main.kind, PouKind::Main);
  EXPECT_EQ(main.name, "MAIN");
  EXPECT_EQ(main.number, 1);
  EXPECT_EQ(main.title, "Pump control");
  EXPECT_EQ(main.comments.size(), 1U);
  ASSERT_EQ(main.networks.size(), 2U);
  EXPECT_EQ(main.networks[0].title, "start");
  EXPECT_EQ(main.networks[0].number, 1);
  EXPECT_EQ(main.networks[1].number, 4);
  EXPECT_EQ(main.networks[1].title, "");
  ASSERT_EQ(main.networks[0].comments.size(), 1U);
  EXPECT_EQ(program.sources->text(main.networks[0].comments[0].span), "// the start button");
  EXPECT_EQ(listing(main.networks[0]), "LD I0.0; O Q0.0; AN I0.1; = Q0.0");
  EXPECT_EQ(listing(main.networks[1]), "LD SM0.1; S Q0.1,2");
  EXPECT_EQ(program.pous[1].kind, PouKind::Subroutine);
  EXPECT_EQ(program.pous[1].number, 0);
  EXPECT_TRUE(program.pous[1].networks[0].instructions.empty());
  EXPECT_FALSE(program.olderDialect);
}

}  // namespace
}  // namespace rungproof
