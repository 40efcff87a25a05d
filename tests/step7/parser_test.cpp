// The syntax tree of sources and listings: every form of blocks, declarations, statements and calls.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "frontend/step7/source_parser.hpp"

namespace rungproof::step7 {
namespace {

struct Read {
  Program program;
  SourceSyntax source;
};

Read readText7(const std::string& text, MnemonicSet set = MnemonicSet::International) {
  Read read;
  const std::uint32_t file = read.program.sources->add("x.awl", text);
  SyntaxSink sink(read.program, file);
  read.source = readSource(read.program.sources->file(file).text(), {set, TextEncoding::Utf8}, sink);
  return read;
}

std::string pathText(const std::vector<PathStep>& path) {
  std::string text;
  for (const PathStep& step : path) {
    text += (text.empty() ? "" : ".") + step.name;
    for (std::size_t i = 0; i < step.indices.size(); ++i)
      text += fmt::format("{}{}", i == 0 ? "[" : ",", step.indices[i]);
    if (!step.indices.empty()) text += "]";
  }
  return text;
}

std::string show(const Operand& operand) {
  static const char* const places[] = {"I", "Q", "M", "PI", "PQ", "L", "DB", "DI", "T", "C"};
  static const char* const sizes[] = {"x", "b", "w", "d"};
  const std::string place =
      fmt::format("{}{}", places[static_cast<int>(operand.place)], sizes[static_cast<int>(operand.size)]);
  const std::string block = operand.block ? toString(*operand.block) + ":" : "";
  switch (operand.form) {
    case OperandForm::None: return "-";
    case OperandForm::Address: return fmt::format("{}{}{}.{}", block, place, operand.number, operand.bit);
    case OperandForm::Local: return "#" + pathText(operand.path);
    case OperandForm::Symbol:
      return fmt::format("\"{}\"{}{}", operand.name, operand.path.empty() ? "" : ".", pathText(operand.path));
    case OperandForm::Constant: return fmt::format("={}", operand.constant.value);
    case OperandForm::Block: return toString(*operand.block);
    case OperandForm::Word: return operand.name;
    case OperandForm::Parameter: return "P##" + pathText(operand.path);
    case OperandForm::Indirect:
      if (operand.addressRegister != 0)
        return fmt::format("{}[AR{},{}]", operand.crossesAreas ? sizes[static_cast<int>(operand.size)] : place,
                           operand.addressRegister, operand.offset);
      return (operand.block ? std::string(blockKindName(*operand.block->kind)) : place) + "[" + show(*operand.pointer) +
             "]";
  }
  return "?";
}

std::string show(const Statement& statement) {
  std::string text = statement.label.text.empty() ? "" : statement.label.text + ": ";
  text += statement.mnemonic.text;
  if (statement.operand.form != OperandForm::None) text += " " + show(statement.operand);
  if (statement.instance.form != OperandForm::None) text += "," + show(statement.instance);
  if (statement.hasArguments) {
    text += " (";
    for (const Argument& argument : statement.arguments)
      text += argument.formal.text + ":=" + show(argument.actual) + " ";
    text += ")";
  }
  return statement.fault.empty() ? text : text + " !" + statement.fault;
}

std::string show(const NetworkSyntax& network) {
  std::string text;
  for (const Statement& statement : network.statements) text += (text.empty() ? "" : "; ") + show(statement);
  return text;
}

/// Statements of a list without a head, in one network.
std::string statements(const std::string& text, MnemonicSet set = MnemonicSet::International) {
  const Read read = readText7(text, set);
  EXPECT_EQ(read.source.blocks.size(), 1u) << text;
  std::string result;
  for (const BlockSyntax& block : read.source.blocks)
    for (const NetworkSyntax& network : block.networks) result += (result.empty() ? "" : " | ") + show(network);
  for (const Finding& finding : read.program.findings) result += " " + finding.rule;
  return result;
}

TEST(Statements7, AddressesInBothSets) {
  EXPECT_EQ(statements("A I0.0;\nAN I 0.1;\n= Q4.0;\nL MW10\nT PQB 4\n"),
            "A Ix0.0; AN Ix0.1; = Qx4.0; L Mw10.0; T PQb4.0");
  EXPECT_EQ(statements("U E 0.0;\nUN A0.1;\n= A 4.0;\nL PEW 256;\nT AW 4;\nU Z 3;", MnemonicSet::German),
            "U Ix0.0; UN Qx0.1; = Qx4.0; L PIw256.0; T Qw4.0; U Cx3.0");
  EXPECT_EQ(statements("A %I0.0; L %IW 64; A T 5; A T5; A C 1;"), "A Ix0.0; L Iw64.0; A Tx5.0; A Tx5.0; A Cx1.0");
  EXPECT_EQ(statements("L DBW 2; A DBX0.1; L DIW 4; A DIX 0.7; L LD 20; L DB10.DBW 2; A DB 10.DBX 0.3; A DB10.DBX0.3;"),
            "L DBw2.0; A DBx0.1; L DIw4.0; A DIx0.7; L Ld20.0; L DB 10:DBw2.0; A DB 10:DBx0.3; A DB 10:DBx0.3");
  EXPECT_EQ(statements("L \"Motor\".DBW 2; A \"Motor\".%DBX0.1;"), "L \"Motor\":DBw2.0; A \"Motor\":DBx0.1");
}

TEST(Statements7, NamesAndTheirParts) {
  EXPECT_EQ(statements("A \"T 1\"; L \"Db\".list[2].x; T #arr[1,2].y; A #\"my var\"; L #s.a; A motor.on;"),
            "A \"T 1\"; L \"Db\".list[2].x; T #arr[1,2].y; A #my var; L #s.a; A #motor.on");
}

TEST(Statements7, IndirectForms) {
  EXPECT_EQ(
      statements("A I[MD4]; L MW [LD 20]; OPN DB[#n]; UC FC[MW10]; L W [AR1,P#2.0]; A [AR2,P#0.1]; "
                 "L DBW [AR1, P#4.0]; A T [MW 2];"),
      "A Ix[Md4.0]; L Mw[Ld20.0]; OPN DB[#n]; UC FC[Mw10.0]; L w[AR1,16]; A x[AR2,1]; L DBw[AR1,32]; A Tx[Mw2.0]");
}

TEST(Statements7, MnemonicsThatAreSigns) {
  EXPECT_EQ(
      statements("A(;\nO I0.0;\n);\n==I;\n<>R;\n>=D;\n+I;\n-D;\n*R;\n/I;\n+ -33;\n+ L#1;\n+AR1 P#2.0;\n)MCR;\n"
                 "MCR(;\nRND+;\nRND-;\n= M0.0;\nO;\nX(;\nA (;\n);"),
      "A(; O Ix0.0; ); ==I; <>R; >=D; +I; -D; *R; /I; + =-33; + =1; +AR1 =16; )MCR; MCR(; RND+; RND-; = Mx0.0; O; "
      "X(; A(; )");
  EXPECT_EQ(statements("A ==0;\nO UO;\nAN OV;\nA BR;\nL STW;\nL DBLG;\nTAR1 AR2;\nNOP 0;\nBLD 103;"),
            "A ==0; O UO; AN OV; A BR; L STW; L DBLG; TAR1 AR2; NOP =0; BLD =103");
}

TEST(Statements7, LabelsAreLabelsWhateverTheyLookLike) {
  EXPECT_EQ(statements("JC M1;\nJU T5;\nM1: NOP 0;\nT5:\n  L 1;\nLOOP M1;\nend: "),
            "JC M1; JU T5; M1: NOP =0; T5: L =1; LOOP M1; end: ");
  EXPECT_EQ(statements("SPB m001;\nm001: SET;\n", MnemonicSet::German), "SPB m001; m001: SET");
  EXPECT_EQ(statements("SP T 5;\nSE T 6;"), "SP Tx5.0; SE Tx6.0");
}

TEST(Statements7, SeveralStatementsALineAndCommentsAnywhere) {
  EXPECT_EQ(statements("A I0.0; A I0.1; // both\n= Q0.0 // listing\n(* not\n this *) S M0.0;"),
            "A Ix0.0; A Ix0.1; = Qx0.0; S Mx0.0");
}

TEST(Calls7, InParenthesesAndAsListing) {
  EXPECT_EQ(statements("CALL FC 5 (\n  NUM1 := 1,\n  NUM2 := MW 2, // two\n  NUM3 := \"x\".y);\nA I0.0;"),
            "CALL FC 5 (NUM1:==1 NUM2:=Mw2.0 NUM3:=\"x\".y ); A Ix0.0");
  EXPECT_EQ(statements("CALL \"TIME_TCK\"\n RET_VAL:=#tick\n L #tick\n"),
            "CALL \"TIME_TCK\" (RET_VAL:=#tick ); L #tick");
  EXPECT_EQ(statements("CALL FB 2 , DB 3\n IN :=I0.0\n Q:=\n PT:=T#5s\nNOP 0\n"),
            "CALL FB 2,DB 3 (IN:=Ix0.0 Q:=- PT:==5000 ); NOP =0");
  EXPECT_EQ(
      statements("CALL \"Fb\" , \"InstDb\" ( IN := #a , Q := #b );\nCALL #inst ( );\nCALL FB 2 , DB 3;\nCALL FC 1;"),
      "CALL \"Fb\",\"InstDb\" (IN:=#a Q:=#b ); CALL #inst (); CALL FB 2,DB 3; CALL FC 1");
  EXPECT_EQ(statements("CALL SFC 20 (SRCBLK := P#DB1.DBX0.0 BYTE 4, RET_VAL := MW 0, DSTBLK := P#M 10.0 BYTE 4);"),
            "CALL SFC 20 (SRCBLK:==2214592512 RET_VAL:=Mw0.0 DSTBLK:==2197815376 )");
}

TEST(Statements7, WhatCannotBeReadIsNamedAndTheRestGoesOn) {
  EXPECT_EQ(statements("A M 10;\nA M10.9;\nA I0.0 I0.1;\nL W#16#12345;\nA \"open;\nA I0.0;"),
            "A Mx10.0 !the bit number is missing, as in M 10.0; A Mx10.9 !a byte has the bits 0 to 7; "
            "A Ix0.0 !text behind the end of the statement; L !the value is larger than 16#FFFF; "
            "A !the name has no second quotation mark; A Ix0.0");
  EXPECT_EQ(statements("CALL FC 1 (A := 1 B := 2);\nA I0.0;"),
            "CALL FC 1 (A:==1 ) !a comma is missing between two parameters; A Ix0.0");
  EXPECT_EQ(statements("CALL FC 1 (A := 1,\nNETWORK\nA I0.0;"),
            "CALL FC 1 (A:==1 ) !the parameter list is not closed | A Ix0.0");
}

const char* const wholeSource = R"(TYPE "Recipe"
VERSION : 0.1
  STRUCT
    Butter : INT := 5 ;   //comment
    Eggs { a := 'b' } : INT ;
  END_STRUCT ;
END_TYPE

DATA_BLOCK DB 10
TITLE = Values
{ S7_m_c := 'true' ;
  b := 'x' }
AUTHOR : me
FAMILY : 'fam'
NAME : nam
VERSION : 0.1
NON_RETAIN
  STRUCT
   list : ARRAY [1 .. 10 ] OF //comment
    "Recipe" ;
   v : ARRAY[0..3] OF INT := 1, 2, 2 (8);
   name : STRING [10 ] := 'abc';
   inner : STRUCT
     a : BOOL ;
   END_STRUCT ;
  END_STRUCT ;
BEGIN
   list[2].Eggs := 7 ;
   inner.a := TRUE;
END_DATA_BLOCK

DATA_BLOCK DB 3
FB 2
BEGIN
  IN1 := 4;
END_DATA_BLOCK

FUNCTION FC 5 : INT
TITLE =SUM
KNOW_HOW_PROTECT
VERSION : 0.1
VAR_INPUT
  NUM1, NUM2 : INT ;
END_VAR
VAR_TEMP
  x : INT
  ;
END_VAR
BEGIN
NETWORK
TITLE = first one
// remark
//@ never: M0.0
      L     #NUM1;
NETWORK
TITLE =
      T     #RET_VAL;
END_FUNCTION

FUNCTION_BLOCK "Valve"
VAR
  t : FB 4;
  u : "Timer";
END_VAR
END_FUNCTION_BLOCK

ORGANIZATION_BLOCK OB 1
BEGIN
  CALL FC 5 (NUM1 := 1, NUM2 := 2, RET_VAL := MW 2);
END_ORGANIZATION_BLOCK
)";

TEST(Blocks7, EveryKind) {
  const Read read = readText7(wholeSource);
  EXPECT_TRUE(read.program.findings.empty());
  for (const Finding& finding : read.program.findings) ADD_FAILURE() << finding.message;
  ASSERT_EQ(read.source.blocks.size(), 6u);
  const BlockSyntax& type = read.source.blocks[0];
  EXPECT_EQ(type.kind, BlockKind::Udt);
  EXPECT_EQ(type.name.symbol, "Recipe");
  ASSERT_NE(type.type, nullptr);
  ASSERT_EQ(type.type->fields.size(), 2u);
  EXPECT_EQ(type.type->fields[0].initial.at(0).value, 5);
  const BlockSyntax& data = read.source.blocks[1];
  EXPECT_EQ(data.title, "Values");
  EXPECT_EQ(data.author, "me");
  EXPECT_TRUE(data.nonRetain);
  ASSERT_EQ(data.type->fields.size(), 4u);
  EXPECT_EQ(data.type->fields[0].type->element->named->symbol, "Recipe");
  EXPECT_EQ(data.type->fields[1].initial.size(), 4u);
  EXPECT_EQ(data.type->fields[2].type->elementary.length, 10);
  ASSERT_EQ(data.assignments.size(), 2u);
  EXPECT_EQ(pathText(data.assignments[0].path), "list[2].Eggs");
  EXPECT_EQ(read.source.blocks[2].type->named->kind, BlockKind::Fb);
  const BlockSyntax& sum = read.source.blocks[3];
  EXPECT_TRUE(sum.knowHowProtected);
  EXPECT_EQ(sum.type->elementary.kind, s7300::TypeKind::Int);
  ASSERT_EQ(sum.declarations.size(), 3u);
  EXPECT_EQ(sum.declarations[1].name.text, "NUM2");
  ASSERT_EQ(sum.networks.size(), 2u);
  EXPECT_EQ(sum.networks[0].title, "first one");
  EXPECT_EQ(show(sum.networks[0]), "L #NUM1");
  ASSERT_EQ(sum.directives.size(), 1u);
  EXPECT_EQ(sum.directives[0].text, "never: M0.0");
  EXPECT_EQ(sum.directives[0].network, 1);
  EXPECT_EQ(read.program.sources->text(sum.directives[0].span), "never: M0.0");
  EXPECT_EQ(read.source.blocks[4].declarations.size(), 2u);
  EXPECT_FALSE(read.source.blocks[4].hasBody);
  EXPECT_EQ(show(read.source.blocks[5].networks.at(0)), "CALL FC 5 (NUM1:==1 NUM2:==2 RET_VAL:=Mw2.0 )");
}

TEST(Blocks7, ASourceOfTia) {
  const Read read = readText7(
      "FUNCTION_BLOCK \"Motor\"\n{ S7_Optimized_Access := 'FALSE' }\nVERSION : 0.1\n   VAR_INPUT \n      "
      "\"start it\" { ExternalWritable := 'False'} : Bool;   // go\n   END_VAR\n   VAR RETAIN\n      n : Int := 3;\n   "
      "END_VAR\n\nBEGIN\nNETWORK\nTITLE = Lauf\n      A #\"start it\";\n      JNB L_0001;\nL_0001:      NOP 1;\n"
      "END_FUNCTION_BLOCK\n");
  EXPECT_TRUE(read.program.findings.empty());
  ASSERT_EQ(read.source.blocks.size(), 1u);
  const BlockSyntax& block = read.source.blocks[0];
  ASSERT_EQ(block.declarations.size(), 2u);
  EXPECT_EQ(block.declarations[0].name.text, "start it");
  EXPECT_EQ(block.declarations[1].initial.at(0).value, 3);
  EXPECT_EQ(show(block.networks.at(0)), "A #start it; JNB L_0001; L_0001: NOP =1");
}

TEST(Blocks7, AListingWithItsHeadings) {
  const Read read =
      readText7("Network 1: Start\n\n      A     I      0.0\n      =     Q      4.0\nNetwork 2\n      SET\n");
  ASSERT_EQ(read.source.blocks.size(), 1u);
  ASSERT_EQ(read.source.blocks[0].networks.size(), 2u);
  EXPECT_EQ(read.source.blocks[0].networks[0].title, "Start");
  EXPECT_EQ(show(read.source.blocks[0].networks[0]), "A Ix0.0; = Qx4.0");
  EXPECT_EQ(show(read.source.blocks[0].networks[1]), "SET");
}

}  // namespace
}  // namespace rungproof::step7
