// From sources to the IR: operands of every form, calls with their parameters, data blocks with their bytes.
#include <gtest/gtest.h>

#include "analysis/flow/facts.hpp"
#include "ir/s7300/block.hpp"
#include "tests/step7/read7.hpp"

namespace rungproof {
namespace {

std::string bound(const std::string& statements) {
  const Program program = readOb1(statements);
  return findings7(program) + (program.pous.empty() ? "" : show7(program.pous[0]));
}

TEST(Bind, PlacesThatNumbersName) {
  EXPECT_EQ(bound("A I 0.1; = Q 4.0; L MW 10; T PQB 4; L PIW 256; A T 5; A C 3; L LB 7;"),
            "A I0.1; = Q4.0; L MW10; T PQB4; L PIW256; A T5; A C3; L LB7");
  EXPECT_EQ(bound("L DBW 2; A DIX 0.5; T DID 4;"), "L DBW2@open; A DB0.5@open/DI; T DBD4@open/DI");
}

TEST(Bind, InstructionsThatTheirOperandsChoose) {
  EXPECT_EQ(bound("L T 5; LC T 5; L C 3; LC C 3; R T 5; R C 3; R M 0.0; S C 3; S M 0.0; FR T 5; FR C 3; O; O M 0.0; "
                  "NOP 0; NOP 1; L STW; T STW; L DBNO; L DILG; LAR1; LAR1 AR2; TAR1 AR2; TAR2 MD 4; LAR1 P#M 4.0;"),
            "L T T5; LC T T5; L C C3; LC C C3; R T T5; R C C3; R M0.0; S C C3; S M0.0; FR T T5; FR C C3; OR; O M0.0; "
            "NOP 0; NOP 1; L STW; T STW; L DBNO; L DILG; LAR1; LAR1 AR2; TAR1 AR2; TAR2 MD4; LAR1 P#M 4.0=2197815328");
}

TEST(Bind, ConditionsOfTheStatusWordHaveNumbers) {
  EXPECT_EQ(bound("A BR; AN OV; O OS; X UO; A ==0; A <>0; ON >0; A <0; A >=0; XN <=0;"),
            "A BR=0; AN OV=1; O OS=2; X UO=3; A ==0=4; A <>0=5; ON >0=6; A <0=7; A >=0=8; XN <=0=9");
}

TEST(Bind, ConstantsAreWhatLoadLeaves) {
  EXPECT_EQ(
      bound("L -1; L L#-1; L 1.5; L 'ab'; L S5T#2S; L W#16#FF; L 2#101; L T#1S; L C#25; + -3; AW W#16#F; SLW 4; SSD;"),
      "L -1=65535; L L#-1=4294967295; L 1.5=1069547520; L 'ab'=24930; L S5T#2S=512; L W#16#FF=255; L 2#101=5; "
      "L T#1S=1000; L C#25=37; + -3=65533; AW W#16#F=15; SLW 4=4; SSD");
}

TEST(Bind, IndirectForms) {
  EXPECT_EQ(
      bound("A I [MD 4]; L MW [LD 20]; L DBW [MD 8]; A DIX [MD 8]; A T [MW 2]; L W [AR1,P#2.0]; A [AR2,P#0.1]; "
            "L MB [AR1,P#3.0]; OPN DB [MW 2]; OPN DI [MW 2]; UC FC [MW 10];"),
      "A I0.0@pointer[MD4]; L MW0@pointer[LD20]; L DBW0@pointer[MD8]; A DB0.0@pointer[MD8]/DI; A T0@pointer[MW2]; "
      "L MW2@crossing; A M0.1@crossing/AR2; L MB3@register; OPN DBB0@pointer[MW2]; OPN DBB0@pointer[MW2]/DI; "
      "UC DBB0@pointer[MW10]");
}

TEST(Bind, LabelsAreNumbered) {
  EXPECT_EQ(bound("JU b; a: SET; b: JC a; c: "), "JU b=1; LABEL a=0; SET; LABEL b=1; JC a=0; LABEL c=2");
}

TEST(Bind, GermanMnemonicsMeanTheSame) {
  const Program program = read7(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nU E 0.0; UN A 4.0; U( ; O Z 1; ) ; SPB m; L S5T#1S; SE T 1; SI T 2; SV "
      "T 3; "
      "SA T 4; ZV Z 1; m: TAW ; TAR ; AUF DB [MW 2]; U BIE; L PEW 256; BEB ; UW W#16#F;\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(findings7(program), "");
  EXPECT_EQ(
      show7(program.pous.at(0)),
      "A I0.0; AN Q4.0; A(; O C1; ); JC m=0; L S5T#1S=256; SD T1; SP T2; SE T3; SF T4; CU C1; LABEL m=0; CAW; CAR; "
      "OPN DBB0@pointer[MW2]; A BR=0; L PIW256; BEC; AW W#16#F=15");
}

const char* const blocks = R"(FUNCTION_BLOCK FB 2
VAR_INPUT
  in : BOOL ;
  w : WORD ;
END_VAR
VAR_OUTPUT
  q : BOOL ;
END_VAR
VAR_IN_OUT
  list : ARRAY[1..3] OF INT ;
END_VAR
VAR
  t : FB 3 ;
  s : STRUCT
    a : INT ;
    b : ARRAY[0..1] OF BOOL ;
  END_STRUCT ;
END_VAR
VAR_TEMP
  x : INT ;
  y : DWORD ;
END_VAR
BEGIN
NETWORK
  A #in;
  L #w;
  T #s.a;
  = #s.b[1];
  L #list[2];
  T #x;
  LAR1 #y;
  LAR1 P##s;
  LAR1 P##x;
  A L 20.0;
  CALL #t (a := 5);
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB 3
VAR_INPUT
  a : INT := 7 ;
END_VAR
BEGIN
END_FUNCTION_BLOCK
FUNCTION FC 1 : WORD
VAR_OUTPUT
  q : BOOL ;
END_VAR
VAR_INPUT
  v : WORD ;
  t : TIMER ;
  p : ANY ;
  s : STRUCT
    a : INT ;
    b : INT ;
  END_STRUCT ;
END_VAR
BEGIN
NETWORK
  L #v;
  T #RET_VAL;
  A #t;
  L #t;
  L #s.b;
  L P##p;
  = #q;
END_FUNCTION
DATA_BLOCK DB 2
 FB 2
BEGIN
  w := W#16#1234;
END_DATA_BLOCK
DATA_BLOCK DB 5
STRUCT
  s : STRUCT
    a : INT := 1 ;
    b : INT := 2 ;
  END_STRUCT ;
  r : REAL ;
END_STRUCT ;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
  CALL FB 2 , DB 2 (in := I 0.0, list := P#M 0.0, q := Q 0.0);
END_ORGANIZATION_BLOCK
)";

TEST(Bind, OwnDataOfBlocks) {
  const Program program = read7(blocks);
  EXPECT_EQ(findings7(program), "");  // a pointer stands for an in-out array
  const Pou* fb = program.subroutine(blockNumber(BlockType::Fb, 2));
  ASSERT_NE(fb, nullptr);
  // in 0.0, w 2.0, q 4.0, list (pointer) 6.0, t 12.0, s 14.0: a 14.0, b 16.0.
  EXPECT_EQ(
      show7(*fb),
      "A DB0.0@instance; L DBW2@instance; T DBW14@instance; = DB16.1@instance; L DBW2@parameter3; T LW0; LAR1 LD2; "
      "LAR1 &DBB14@instance; LAR1 &LW0; A L20.0; CALL FB3=" +
          std::to_string(blockNumber(BlockType::Fb, 3)) + " DBB12@instance 5=5");
  EXPECT_EQ(fb->instanceBytes, 18u);
  EXPECT_EQ(fb->localBytes, 22u);
  ASSERT_EQ(fb->locals.size(), 8u);
  EXPECT_EQ(fb->locals[4].instanceOf, blockNumber(BlockType::Fb, 3));
  const Pou* fc = program.subroutine(blockNumber(BlockType::Fc, 1));
  ASSERT_NE(fc, nullptr);
  // v, t, p, s, RET_VAL, q: inputs first, then the value of the function.
  EXPECT_EQ(show7(*fc),
            "L DBW0@parameter0; T DBW0@parameter4; A T0@parameter1; L T T0@parameter1; L DBW2@parameter3; L "
            "&VB0@handed2; = DB0.0@parameter5");
  ASSERT_EQ(program.dataBlocks.size(), 2u);
  EXPECT_EQ(program.dataBlocks[0].instanceOf, blockNumber(BlockType::Fb, 2));
  EXPECT_EQ(program.dataBlocks[0].bytes,
            (std::vector<std::uint8_t>{0, 0, 0x12, 0x34, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0, 0}));
  EXPECT_EQ(program.dataBlocks[1].bytes, (std::vector<std::uint8_t>{0, 1, 0, 2, 0, 0, 0, 0}));
}

TEST(Bind, ActualParameters) {
  std::string text(blocks);
  const std::string call = "CALL FB 2 , DB 2 (in := I 0.0, list := P#M 0.0, q := Q 0.0);";
  text.replace(
      text.find(call), call.size(),
      "CALL FC 1 (v := W#16#7, t := T 4, p := P#DB5.DBX 0.0 BYTE 4, s := \"Set\".s, RET_VAL := MW 0, q := M 4.0);\n"
      "CALL FC 1 (v := MW 2, t := T 4, p := MW 6, s := \"Set\".s, RET_VAL := DB5.DBW 0, q := DB5.DBX 0.1);");
  // A copy without a number: no table gives "Set" one, so it gets the first that neither a block nor the text has.
  const std::size_t from = text.find("DATA_BLOCK DB 5"), end = text.find("END_DATA_BLOCK", from) + 15;
  std::string copy = text.substr(from, end - from);
  copy.replace(0, 15, "DATA_BLOCK \"Set\"");
  text.insert(end, copy);
  const Program program = read7(text);
  EXPECT_EQ(findings7(program), "");
  ASSERT_NE(program.main(), nullptr);
  const std::string fc1 = "CALL FC1=" + std::to_string(blockNumber(BlockType::Fc, 1));
  EXPECT_EQ(show7(*program.main()), fc1 + " W#16#7=7 T4 &'P#DB5.DBX 0.0 BYTE 4':2x4 DBB1:0 MW0 M4.0; " + fc1 +
                                        " MW2 T4 &MW6:4x1 DBB1:0 DBW5:0 DB5:0.1");
}

TEST(Bind, AttributesOfACallSayNothingAboutItsParameters) {
  const Program program = read7(
      "DATA_BLOCK DB 1\nSFB 4\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL SFB 4, DB 1\n"
      "{ time_type := 'Time' }\n( IN := I 0.0 ,\n PT := T#1s\n);\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(findings7(program), "");
  EXPECT_EQ(show7(*program.main()),
            "CALL SFB4=" + std::to_string(blockNumber(BlockType::Sfb, 4)) + " DBB1:0 I0.0 T#1S=1000 - -");
}

TEST(Bind, AListWithoutHeadIsOb1) {
  const Program program = read7("      L     MW    10\n      T     MW    12\n      CLR\n      =     Q 0.0\n");
  EXPECT_EQ(findings7(program), "");
  ASSERT_NE(program.main(), nullptr);
  EXPECT_EQ(program.main()->number, blockNumber(BlockType::Ob, 1));
  EXPECT_EQ(show7(*program.main()), "L MW10; T MW12; CLR; = Q0.0");
}

TEST(Bind, CallsAreToldByTheirBlockTheirInstanceAndWhatTheyGive) {
  const Program program = read7(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL SFB 4, DB 3 (IN := I 0.0, Q := Q 0.1);\nEND_ORGANIZATION_BLOCK\n"
      "DATA_BLOCK DB 3 SFB 4\nBEGIN\nEND_DATA_BLOCK\n");
  ASSERT_NE(program.main(), nullptr);
  EXPECT_EQ(Facts::text(program.main()->networks[0].instructions[0]), "CALL SFB4, DB3, I0.0, Q0.1");
}

TEST(Bind, AProtectedBlockIsAnInterface) {
  const Program program = read7(
      "FUNCTION FC 1 : VOID\nKNOW_HOW_PROTECT\nVERSION : 0.1\nVAR_OUTPUT\n q : BOOL ;\nEND_VAR\nBEGIN\nEND_FUNCTION\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FC 1 (q := M 0.0);\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(findings7(program), "SYN026 1:1 FC1 is there as an interface only");
  const Pou* fc = program.subroutine(blockNumber(BlockType::Fc, 1));
  ASSERT_NE(fc, nullptr);
  EXPECT_TRUE(fc->protectedBlock);
}

}  // namespace
}  // namespace rungproof
