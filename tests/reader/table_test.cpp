// Symbol tables, data blocks, declarations: everything that is not an instruction.
#include <gtest/gtest.h>

#include "frontend/stl/declaration.hpp"
#include "frontend/stl/local_layout.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

std::string symbols(const Program& program) {
  std::string result;
  for (const Symbol& symbol : program.symbols)
    result += fmt::format("{}={}({}) ", symbol.name, toString(symbol.address), symbol.comment);
  return result;
}

/// Flat picture of the data: "100:01 02 ".
std::string bytes(const Program& program) {
  std::string result;
  for (const DataInit& init : program.data) {
    result += fmt::format("{}:", init.offset);
    for (const std::uint8_t byte : init.bytes) result += fmt::format("{:02X}", byte);
    result += ' ';
  }
  return result;
}

TEST(SymbolTable, FormsOfTheManual) {  // 001:2401-2408
  const Program program =
      readText("symbols.txt",
               "\tSymbol\tAddress\tComment\r\n1\tAlwaysOn\tSM0.0\tAlways on contact\r\n2\tPump1\tQ2.3\tPump 1 "
               "on/off\r\n4\tPump1Pressure\tVD100\t\r\n6\t\t\t\r\n");
  EXPECT_EQ(symbols(program), "AlwaysOn=SM0.0(Always on contact) Pump1=Q2.3(Pump 1 on/off) Pump1Pressure=VD100() ");
  EXPECT_EQ(findings(program), "SYN006<>");  // a symbol table alone is no program
}

TEST(SymbolTable, OtherSeparators) {
  EXPECT_EQ(symbols(readText("s.csv", "Start,I0.0,\"first, second\"\nStop,I0.1,\nCount,C5\n")),
            "Start=I0.0(first, second) Stop=I0.1() Count=C5() ");
  EXPECT_EQ(symbols(readText("s.csv", "Name;Adresse;Kommentar\nStart;E0.0;ein\nMotor;A0.1;\n")),
            "Start=I0.0(ein) Motor=Q0.1() ");
  EXPECT_EQ(symbols(readText("s.txt", "\"Start\"\tI0.0\t// http://x\nMax\t+100\n")),
            "Start=I0.0(http://x) Max=+100() ");
}

TEST(SymbolTable, BadRowsAreReported) {
  const Program program = readText("s.tsv", "Start\tI0.0\nStop\tI0..1\nMotor\tQ0.0\n");
  EXPECT_EQ(symbols(program), "Start=I0.0() Motor=Q0.0() ");
  EXPECT_EQ(program.findings[0].rule, "SYN029");
  EXPECT_EQ(program.sources->position(program.findings[0].span).line, 2U);
}

TEST(DataBlock, WithoutHeading) {
  const Program program =
      readText("data.txt", "// initial values\nVB0 1, 2 3\n4\nVW10 16#1234, -1\nVD20 100000\nVD24 1.5\n");
  EXPECT_EQ(bytes(program), "0:01 1:02 2:03 3:04 10:1234 12:FFFF 20:000186A0 24:3FC00000 ");
}

TEST(DataBlock, SizesWithoutLetterComeFromTheValue) {
  EXPECT_EQ(bytes(readText("d.txt", "V0 5\n300\n70000\n1.0\n-129\nW#5\n")),
            "0:05 1:012C 3:00011170 7:3F800000 11:FF7F 13:0005 ");
}

TEST(DataBlock, Texts) {
  // A string in " carries its length byte, characters in ' do not.
  EXPECT_EQ(bytes(readText("d.txt", "VB100 \"AB\"\nVB110 'AB$0D', 7\n")), "100:024142 110:41420D 113:07 ");
}

TEST(DataBlock, Faults) {
  const Program range = readText("d.txt", "VB0 256\nVB1 -129\nVW2 70000\nVW4 1.5\nVB5 1\nVB6 2\nVB7 3\n");
  EXPECT_EQ(findings(range), "SYN031<256> SYN031<-129> SYN031<70000> SYN031<1.5>");
  EXPECT_EQ(bytes(range), "5:01 6:02 7:03 ");
  const Program rows = readText("d.awl",
                                "DATA_BLOCK\nBEGIN\n5\nVB0\nQB0 1\nVB1 x\nVB2 1\nEND_DATA_BLOCK\nORGANIZATION_BLOCK "
                                "M:OB1\nBEGIN\nNetwork 1\nNOT\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(findings(rows), "SYN032<5> SYN030<VB0> SYN030<QB0 1> SYN030<x>");
  EXPECT_EQ(bytes(rows), "2:01 ");
}

LocalVariable local(std::string name, VarSection section, DataType type) {
  LocalVariable variable;
  variable.name = std::move(name);
  variable.section = section;
  variable.type = type;
  return variable;
}

TEST(LocalLayout, ExampleOfTheManual) {  // 001:2424-2431, two addresses of the print mended
  std::vector<LocalVariable> locals = {
      local("FinalPass", VarSection::Input, DataType::Bool), local("Addr", VarSection::Input, DataType::Byte),
      local("Data", VarSection::Input, DataType::Int),       local("Status", VarSection::InOut, DataType::Byte),
      local("Done", VarSection::Output, DataType::Bool),     local("Error", VarSection::Output, DataType::Word)};
  EXPECT_EQ(layOutLocals(locals), 8U);
  const char* expected[] = {"L0.0", "LB1", "LW2", "LB4", "L5.0", "LW6"};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(toString(locals[i].address), expected[i]);
}

TEST(LocalLayout, NineBitsTakeTwoBytes) {
  std::vector<LocalVariable> locals(9, local("b", VarSection::Input, DataType::Bool));
  locals.push_back(local("s", VarSection::Input, DataType::String));
  EXPECT_EQ(layOutLocals(locals), 6U);
  EXPECT_EQ(toString(locals[7].address), "L0.7");
  EXPECT_EQ(toString(locals[8].address), "L1.0");
  EXPECT_EQ(toString(locals[9].address), "LD2");
}

TEST(LocalLayout, SectionsAreSortedIntoTheOrderOfCall) {
  std::vector<LocalVariable> locals = {
      local("t", VarSection::Temp, DataType::Byte), local("o", VarSection::Output, DataType::Byte),
      local("i", VarSection::Input, DataType::Byte), local("io", VarSection::InOut, DataType::Byte)};
  layOutLocals(locals);
  EXPECT_EQ(locals[0].name + locals[1].name + locals[2].name + locals[3].name, "iioot");
}

TEST(Declarations, FaultsAreReported) {
  const Program program = readText("a.awl",
                                   "SUBROUTINE_BLOCK A:SBR0\nVAR_INPUT\nEN:BOOL;\nx:BOOL\ny:LWORD;\n5:INT;\nz;\nq:INT "
                                   ":= 5;\nEND_VAR\nBEGIN\nNetwork 1\nNOT\nEND_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(findings(program), "SYN027<y:LWORD> SYN027<5:INT> SYN027<z> SYN027<q:INT := 5>");
  ASSERT_EQ(program.pous[0].locals.size(), 2U);
  EXPECT_EQ(toString(program.pous[0].locals[0].address), "L0.0");  // EN takes no local memory
  EXPECT_EQ(toString(program.pous[0].locals[1].address), "LW1");
}

TEST(Declarations, TooManyLocals) {
  std::string text = "SUBROUTINE_BLOCK A:SBR0\nVAR\n";
  for (int i = 0; i < 17; ++i) text += fmt::format("v{}:REAL;\n", i);
  const Program program = readText("a.awl", text + "END_VAR\nBEGIN\nNetwork 1\nNOT\nEND_SUBROUTINE_BLOCK\n");
  EXPECT_EQ(findings(program), "SYN028<SUBROUTINE_BLOCK A:SBR0>");
}

}  // namespace
}  // namespace rungproof
