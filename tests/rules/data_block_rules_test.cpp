// Rules DBA: data blocks and address registers of the S7-300/400. Each case gives its reason.
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

const std::string data = db(1, "A : INT;\nB : INT;\nC : BOOL;\nD : BOOL;\nE : BYTE;\nF : REAL;") + db(2, "X : INT;");

TEST(DataBlockRules, ABlockIsOpenWhereItIsUsed) {
  const std::string takes = fc(2, "L #X;\nT MW 0;", "VAR_INPUT\nX : INT;\nEND_VAR\n");
  expectFindings(
      "DBA001",
      {{"no OPN", 1, data + ob1("L DBW 0;\nT MW 0;")},
       {"in an FC", 1, data + fc(1, "A DBX 4.0;\n= Q 0.0;") + ob1("OPN DB 1;\nCALL FC 1;")},
       {"OPN behind it", 1, data + ob1("L DBW 0;\nT MW 0;\nOPN DB 1;\nL DBW 0;\nT MW 2;")},
       {"OPN on one way", 1, data + ob1("A I 0.0;\nJC m;\nOPN DB 1;\nm: L DBW 0;\nT MW 0;")},
       {"behind a call with a full address", 1,
        data + takes + ob1("OPN DB 1;\nCALL FC 2 (X := DB2.DBW 0);\nL DBW 0;\nT MW 0;")},
       {"behind a call of an FB, whose instance stays open", 1,
        data + fb(1, "L #X;\nT MW 2;", "VAR\nX : INT;\nEND_VAR\n") + "DATA_BLOCK DB 3\nFB 1\nBEGIN\nEND_DATA_BLOCK\n" +
            ob1("OPN DB 1;\nCALL FB 1, DB 3;\nL DBW 0;\nT MW 0;")},
       {"UC of an FB gives the block back", 0,
        data + fb(1, "L 1;\nT MW 2;", "VAR\nX : INT;\nEND_VAR\n") + ob1("OPN DB 1;\nUC FB 1;\nL DBW 0;\nT MW 0;")},
       {"DIW in an OB", 1, data + ob1("L DIW 0;\nT MW 0;")},
       {"through a pointer", 1, data + ob1("L P#0.0;\nT MD 0;\nL DBW [MD 0];\nT MW 4;")},
       {"by AR1", 1, data + ob1("LAR1 P#0.0;\nL DBW [AR1,P#2.0];\nT MW 4;")},
       {"once for each block", 1, data + ob1("L DBW 0;\nT MW 0;\nL DBW 2;\nT MW 2;")},
       {"opened", 0, data + ob1("OPN DB 1;\nL DBW 0;\nT MW 0;")},
       {"a full address", 0, data + ob1("L DB1.DBW 0;\nT MW 0;")},
       {"a full address leaves its block open (002:603)", 0, data + ob1("L DB1.DBW 0;\nT MW 0;\nL DBW 2;\nT MW 2;")},
       {"OPN of a number in memory", 0, data + ob1("OPN DB [MW 2];\nL DBW 0;\nT MW 0;")},
       {"opened behind the call", 0, data + takes + ob1("CALL FC 2 (X := DB2.DBW 0);\nOPN DB 1;\nL DBW 0;\nT MW 0;")},
       {"a call without such a parameter gives the block back", 0,
        data + takes + ob1("OPN DB 1;\nCALL FC 2 (X := MW 8);\nL DBW 0;\nT MW 0;")},
       {"DIW in an FB", 0, fb(1, "L DIW 0;\nT MW 0;", "VAR\nX : INT;\nEND_VAR\n")}});
}

TEST(DataBlockRules, AccessesStayWithinTheBlock) {
  expectFindings(
      "DBA002",
      {{"a word behind the end", 1, data + ob1("L DB2.DBW 2;\nT MW 0;")},
       {"a word that begins in it", 1, data + ob1("L DB2.DBW 1;\nT MW 0;")},
       {"a bit", 1, data + ob1("A DB2.DBX 2.0;\n= Q 0.0;")},
       {"in the open block", 1, data + ob1("OPN DB 2;\nL DBD 0;\nT MD 0;")},
       {"written", 1, data + ob1("L 0;\nT DB2.DBB 2;")},
       {"in the block open in DI", 1, data + ob1("OPN DI 2;\nL DIW 2;\nT MW 0;")},
       {"the last word", 0, data + ob1("L DB2.DBW 0;\nT MW 0;")},
       {"the last bit", 0, data + ob1("A DB2.DBX 1.7;\n= Q 0.0;")},
       {"the open block is not known", 0, data + ob1("OPN DB [MW 0];\nL DBD 100;\nT MD 4;")},
       {"one of two blocks", 0, data + ob1("OPN DB 2;\nA I 0.0;\nJC m;\nOPN DB 1;\nm: L DBW 4;\nT MW 0;")},
       {"the longer block", 0, data + ob1("OPN DB 1;\nL DBD 6;\nT MD 0;")},
       {"the block of the full address before it", 0, data + ob1("OPN DB 2;\nL DB1.DBW 0;\nL DBW 2;\n+I;\nT MW 0;")}});
}

TEST(DataBlockRules, AbsoluteAccessesFitTheFields) {
  expectFindings(
      "DBA003",
      {{"two halves", 1, data + ob1("L DB1.DBW 1;\nT MW 0;")},
       {"a half of a REAL", 1, data + ob1("L DB1.DBW 6;\nT MW 0;")},
       {"bits and a byte in one word", 1, data + ob1("L DB1.DBW 4;\nT MW 0;")},
       {"a bit of an INT", 1, data + ob1("A DB1.DBX 0.0;\n= Q 0.0;")},
       {"a byte of an INT", 1, data + ob1("L DB1.DBB 0;\nT MB 0;")},
       {"in the open block", 1, data + ob1("OPN DB 1;\nL DBW 1;\nT MW 0;")},
       {"the field", 0, data + ob1("L DB1.DBW 2;\nT MW 0;")},
       {"two fields of one type", 0, data + ob1("L DB1.DBD 0;\nT MD 0;")},
       {"the byte of the bits", 0, data + ob1("L DB1.DBB 4;\nT MB 0;")},
       {"a bit of a BYTE", 0, data + ob1("A DB1.DBX 5.3;\n= Q 0.0;")},
       {"a byte of an array of bytes", 0, db(3, "A : ARRAY[0..9] OF BYTE;") + ob1("L DB3.DBW 3;\nT MW 0;")},
       {"the second element", 0, db(3, "A : ARRAY[1..9] OF INT;") + ob1("L DB3.DBW 2;\nT MW 0;")},
       {"a part of a STRUCT", 0, db(3, "S : STRUCT\nA : INT;\nB : DINT;\nEND_STRUCT;") + ob1("L DB3.DBD 2;\nT MD 0;")},
       {"the field of the open block", 0, data + ob1("OPN DB 1;\nL DBD 6;\nT MD 0;")}});
}

TEST(DataBlockRules, AnFbKeepsItsInstance) {
  const std::string own = "VAR\nX : INT;\nEND_VAR\nVAR_TEMP\nK : DWORD;\nN : WORD;\nEND_VAR\n";
  expectFindings(
      "DBA004",
      {{"LAR2", 1, fb(1, "L P#4.0;\nLAR2;\nL 5;\nT #X;", own)},
       {"+AR2", 1, fb(1, "+AR2 P#2.0;\nL #X;\nT MW 0;", own)},
       {"TAR1 AR2", 1, fb(1, "LAR1 P#4.0;\nTAR1 AR2;\nL #X;\nT MW 0;", own)},
       {"CAR", 1, fb(1, "CAR;\nL #X;\nT MW 0;", own)},
       {"OPN DI", 1, data + fb(1, "OPN DI 1;\nL #X;\nT MW 0;", own)},
       {"on one way", 1, fb(1, "A I 0.0;\nJC m;\nLAR2 P#4.0;\nm: L #X;\nT MW 0;", own)},
       {"CDB", 1, data + fb(1, "OPN DB 1;\nCDB;\nL #X;\nT MW 0;", own)},
       {"saved and loaded again", 0, fb(1, "TAR2 #K;\nLAR2 P#4.0;\nLAR2 #K;\nL #X;\nT MW 0;", own)},
       {"saved by way of ACCU1", 0, fb(1, "TAR2;\nT #K;\nLAR2 P#4.0;\nL #K;\nLAR2;\nL #X;\nT MW 0;", own)},
       {"kept in AR1", 0, fb(1, "LAR1 AR2;\nLAR2 P#4.0;\nL W [AR2,P#0.0];\nT MW 0;\nTAR1 AR2;\nL #X;\nT MW 0;", own)},
       {"CAR twice", 0, fb(1, "CAR;\nCAR;\nL #X;\nT MW 0;", own)},
       {"AR2 saved, and something else written there", 1,
        fb(1, "TAR2 #K;\nLAR2 P#4.0;\nL 5;\nT #K;\nLAR2 #K;\nL #X;\nT MW 0;", own)},
       {"AR2 saved when it was moved", 1, fb(1, "LAR2 P#4.0;\nTAR2 #K;\nLAR2 #K;\nL #X;\nT MW 0;", own)},
       {"DI saved and opened again", 0, data + fb(1, "L DINO;\nT #N;\nOPN DI 1;\nOPN DI [#N];\nL #X;\nT MW 0;", own)},
       {"on one way only", 1,
        data + fb(1, "A I 0.0;\nJC m;\nL DINO;\nT #N;\nm: OPN DI 1;\nOPN DI [#N];\nL #X;\nT MW 0;", own)},
       {"DI saved, and something else written there", 1,
        data + fb(1, "L DINO;\nT #N;\nOPN DI 1;\nL 1;\nT #N;\nOPN DI [#N];\nL #X;\nT MW 0;", own)},
       {"DI saved when it was moved", 1, data + fb(1, "OPN DI 1;\nL DINO;\nT #N;\nOPN DI [#N];\nL #X;\nT MW 0;", own)},
       {"CDB twice", 0, fb(1, "CDB;\nCDB;\nL #X;\nT MW 0;", own)},
       {"another block opened between", 1, data + fb(1, "CDB;\nOPN DB 1;\nCDB;\nL #X;\nT MW 0;", own)},
       {"CDB behind another block in DI", 1, data + fb(1, "OPN DI 1;\nCDB;\nL #X;\nT MW 0;", own)},
       {"in an FC", 0, fc(1, "LAR2 P#4.0;\nL #X;\nT MW 0;", "VAR_INPUT\nX : INT;\nEND_VAR\n")},
       {"AR1", 0, fb(1, "LAR1 P#4.0;\nL #X;\nT MW 0;", own)},
       {"nothing of its own behind it", 0, fb(1, "L #X;\nT MW 0;\nLAR2 P#4.0;\nL MW [AR2,P#0.0];\nT MW 2;", own)}});
}

TEST(DataBlockRules, InstancesAreUsed) {
  const std::string box = fb(1, "L 1;\nT #X;", "VAR\nX : INT;\nEND_VAR\n");
  expectFindings(
      "DBA005", {{"no call", 1, box + instanceDb(1, "FB 1") + ob1("A I 0.0;\n= Q 0.0;")},
                 {"one of two", 1, box + instanceDb(1, "FB 1") + instanceDb(2, "FB 1") + ob1("CALL FB 1, DB 1;")},
                 {"read by others only", 1, box + instanceDb(1, "FB 1") + ob1("L DB1.DBW 0;\nT MW 0;")},
                 {"of a timer", 1, instanceDb(1, "SFB 4") + ob1("A I 0.0;\n= Q 0.0;")},
                 {"called", 0, box + instanceDb(1, "FB 1") + ob1("CALL FB 1, DB 1;")},
                 {"both called", 0,
                  box + instanceDb(1, "FB 1") + instanceDb(2, "FB 1") + ob1("CALL FB 1, DB 1;\nCALL FB 1, DB 2;")},
                 {"opened", 0, box + instanceDb(1, "FB 1") + ob1("OPN DI 1;\nL DIW 0;\nT MW 0;")},
                 {"any block may be opened", 0, box + instanceDb(1, "FB 1") + ob1("OPN DB [MW 0];\nL DBW 0;\nT MW 2;")},
                 {"a global block", 0, db(3, "X : INT;") + ob1("A I 0.0;\n= Q 0.0;")}});
}

TEST(DataBlockRules, GuardedBlocks) {
  const std::string fixed = db(1, "X : INT;", "READ_ONLY\n"), stored = db(2, "X : INT;", "UNLINKED\n");
  expectFindings(
      "DBA006",
      {{"T", 1, fixed + ob1("L 1;\nT DB1.DBW 0;")},
       {"S", 1, fixed + ob1("A I 0.0;\nS DB1.DBX 0.0;")},
       {"in the open block", 1, fixed + ob1("OPN DB 1;\nL 1;\nT DBW 0;")},
       {"an output of a call", 1,
        fixed + fc(1, "L 1;\nT #Y;", "VAR_OUTPUT\nY : INT;\nEND_VAR\n") + ob1("CALL FC 1 (Y := DB1.DBW 0);")},
       {"reading one that is not loaded", 1, stored + ob1("L DB2.DBW 0;\nT MW 0;")},
       {"writing one that is not loaded", 1, stored + ob1("L 1;\nT DB2.DBW 0;")},
       {"reading", 0, fixed + ob1("L DB1.DBW 0;\nT MW 0;")},
       {"an input of a call", 0,
        fixed + fc(1, "L #Y;\nT MW 0;", "VAR_INPUT\nY : INT;\nEND_VAR\n") + ob1("CALL FC 1 (Y := DB1.DBW 0);")},
       {"another block", 0, fixed + db(3, "X : INT;") + ob1("L 1;\nT DB3.DBW 0;")},
       {"another block is open by then", 0, fixed + db(3, "X : INT;") + ob1("OPN DB 1;\nOPN DB 3;\nL 1;\nT DBW 0;")},
       {"scanned", 0, fixed + ob1("A DB1.DBX 0.0;\n= Q 0.0;")},
       {"read in the open block", 0, fixed + ob1("OPN DB 1;\nL DBW 0;\nT MW 0;")}});
}

}  // namespace
}  // namespace rungproof::testing
