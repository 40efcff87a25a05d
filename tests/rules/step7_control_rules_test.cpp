// Rules CTL, SUB and OBL on the S7-300/400: loops, lists, reachability, calls, local data. Each case gives its reason.
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

TEST(Step7Control, LoopsAskForTheirCount) {
  const std::string body = "m: T MW 12;\nL MW 14;\n+ 1;\nT MW 14;\nL MW 12;\nLOOP m;";
  expectFindings("CTL008",
                 {{"from memory", 1, ob1("L MW 10;\n" + body)},
                  {"a parameter", 1, fc(1, "L #N;\n" + body, "VAR_INPUT\nN : INT;\nEND_VAR\n")},
                  {"0", 1, ob1("L 0;\n" + body)},
                  {"computed", 1, ob1("L MW 10;\nL 4;\n/I;\n" + body)},
                  {"the length of the pointer's block", 1, ob1("L MB 10;\nNOP 0;\n" + body)},
                  {"guarded by another value", 1, ob1("L MW 20;\nL 0;\n==I;\n= M 0.0;\nT MW 22;\nL MW 10;\n" + body)},
                  {"a constant", 0, ob1("L 10;\n" + body)},
                  {"compared before", 0, ob1("L MW 10;\nL 0;\n==I;\nJC e;\nL MW 10;\n" + body + "\ne: NOP 0;")},
                  {"jumped over where it is 0", 0, ob1("L MW 10;\nL 0;\n+I;\nJZ e;\n" + body + "\ne: NOP 0;")},
                  {"BEC before", 0, ob1("L 0;\nL MW 10;\n>=I;\nBEC;\nL MW 10;\n" + body)},
                  {"a hexadecimal constant", 0, ob1("L W#16#10;\n" + body)},
                  {"no loop", 0, ob1("L MW 10;\nT MW 12;")}});
}

// Inputs stay as they are for the whole scan: a loop that waits for one waits for ever.
TEST(Step7Control, LoopsThatNothingCounts) {
  expectFindings(
      "CTL004",
      {{"for ever", 1, ob1("m: JU m;")},
       {"waits for an input", 1, ob1("m: A I 0.0;\nJCN m;")},
       {"with a way out", 1, ob1("m: A I 0.0;\nJC e;\nJU m;\ne: NOP 0;")},
       {"in an FC", 1, fc(1, "m: L IW 0;\nL 5;\n>I;\nJC m;") + ob1("UC FC 1;")},
       {"counts", 0, ob1("L 0;\nT MW 0;\nm: L MW 0;\n+ 1;\nT MW 0;\nL 10;\n<I;\nJC m;")},
       {"a pointer walks", 0, ob1("LAR1 P#0.0;\nm: +AR1 P#2.0;\nTAR1 MD 0;\nL L#160;\nL MD 0;\n>D;\nJC m;")},
       {"LOOP", 0, ob1("L 5;\nm: T MW 0;\nA I 0.0;\nJC n;\nn: L MW 0;\nLOOP m;")},
       {"a called block counts", 0, fc(1, "L MW 0;\n+ 1;\nT MW 0;") + ob1("m: UC FC 1;\nL MW 0;\nL 9;\n<I;\nJC m;")},
       {"forwards", 0, ob1("A I 0.0;\nJC m;\nA I 0.1;\n= Q 0.0;\nm: NOP 0;")}});
}

TEST(Step7Control, ListsOfJumpsHaveNoHoles) {
  const std::string targets = "e: BEU;\na: SET;\n= Q 0.0;\nBEU;\nb: SET;\n= Q 0.1;";
  expectFindings("CTL009",
                 {{"NOP in it", 1, ob1("L MB 0;\nJL e;\nJU a;\nNOP 0;\nJU b;\n" + targets)},
                  {"a label in it", 1, ob1("L MB 0;\nJL e;\nJU a;\nc: JU b;\n" + targets)},
                  {"a conditional jump in it", 1, ob1("L MB 0;\nJL e;\nJU a;\nJC b;\nJU b;\n" + targets)},
                  {"empty", 1, ob1("L MB 0;\nJL e;\n" + targets + "\nA I 0.0;\nJC a;\nJC b;")},
                  {"its label stands elsewhere", 1, ob1("L MB 0;\nJL b;\nJU a;\nJU e;\n" + targets)},
                  {"a load in it", 1, ob1("L MB 0;\nJL e;\nJU a;\nL 1;\nJU b;\n" + targets)},
                  {"two entries", 0, ob1("L MB 0;\nJL e;\nJU a;\nJU b;\n" + targets)},
                  {"one entry", 0, ob1("L MB 0;\nJL e;\nJU a;\n" + targets + "\nA I 0.0;\nJC b;")},
                  {"the same target twice", 0, ob1("L MB 0;\nJL e;\nJU a;\nJU a;\nJU b;\n" + targets)},
                  {"an entry that goes to the end", 0, ob1("L MB 0;\nJL e;\nJU a;\nJU e;\nJU b;\n" + targets)},
                  {"no list", 0, ob1("A I 0.0;\nJC a;\nBEU;\na: NOP 0;")}});
}

TEST(Step7Control, TheMasterControlRelayIsSaid) {
  expectFindings("CTL010", {{"a zone", 1, ob1("MCRA;\nA I 0.0;\nMCR(;\nA I 0.1;\n= Q 0.0;\n)MCR;\nMCRD;")},
                            {"once for each block", 2,
                             fc(1, "MCRA;\nA I 0.0;\nMCR(;\n)MCR;\nMCRD;") + ob1("MCRA;\nMCRD;\nCALL FC 1;")},
                            {"none", 0, ob1("A I 0.0;\n= Q 0.0;")}});
}

// Without a CPU the largest S7-300 is meant, which has one way to start (002:1355).
TEST(Step7Control, OrganizationBlocksThatNothingStarts) {
  const auto ob = [](int number) {
    return "ORGANIZATION_BLOCK OB " + std::to_string(number) +
           "\nBEGIN\nNETWORK\nSET;\n= M 9.0;\nEND_ORGANIZATION_BLOCK\n";
  };
  expectFindings("OBL003", {{"hot restart", 1, ob1("NOP 0;") + ob(101)},
                            {"cold restart", 1, ob1("NOP 0;") + ob(102)},
                            {"background", 1, ob1("NOP 0;") + ob(90)},
                            {"another cyclic interrupt", 1, ob1("NOP 0;") + ob(32)},
                            {"other interrupts", 4, ob1("NOP 0;") + ob(11) + ob(21) + ob(34) + ob(41)},
                            {"warm restart and interrupts", 0,
                             ob1("NOP 0;") + ob(100) + ob(10) + ob(20) + ob(35) + ob(40) + ob(82)}});
}

TEST(Step7Control, CodeThatNoPathReaches) {
  expectFindings(
      "CTL005",
      {{"behind BEU", 1, ob1("A I 0.0;\n= Q 0.0;\nBEU;\nA I 0.1;\n= Q 0.1;")},
       {"behind JU", 1, ob1("JU m;\nA I 0.1;\n= Q 0.1;\nm: A I 0.0;\n= Q 0.0;")},
       {"behind BE, to a label that no one jumps to", 1, ob1("A I 0.0;\n= Q 0.0;\nBE;\nm: A I 0.1;\n= Q 0.1;")},
       {"behind BE, reached by a jump (002:2320)", 0, ob1("A I 0.0;\nJC m;\n= Q 0.0;\nBE;\nm: A I 0.1;\n= Q 0.1;")},
       {"behind BEC", 0, ob1("A I 0.0;\nBEC;\nA I 0.1;\n= Q 0.1;")},
       {"entries of a list", 0, ob1("L MB 0;\nJL e;\nJU a;\nJU e;\ne: BEU;\na: SET;\n= Q 0.0;")},
       {"BEU at the end, as many write it", 0, ob1("A I 0.0;\nJC m;\nBEU;\nm: A I 0.1;\n= Q 0.1;\nBEU;")},
       {"one more BE behind BEU", 0, ob1("A I 0.0;\n= Q 0.0;\nBEU;\nBE;")}});
}

TEST(Step7Control, BlocksThatAreNotCalled) {
  const std::string block = fc(1, "A I 0.0;\n= Q 0.0;");
  expectFindings("CTL007", {{"an FC", 1, block + ob1("A I 1.0;\n= Q 1.0;")},
                            {"only by itself", 1, fc(1, "A I 0.0;\nCC FC 1;") + ob1("A I 1.0;\n= Q 1.0;")},
                            {"called", 0, block + ob1("CALL FC 1;")},
                            {"any may be called", 0, block + ob1("L 1;\nT MW 0;\nUC FC [MW 0];")},
                            {"an OB is called by the system", 0,
                             "ORGANIZATION_BLOCK OB 35\nBEGIN\nNETWORK\nA I 0.0;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n" +
                                 ob1("A I 1.0;\n= Q 1.0;")},
                            {"no OB1: a library", 0, block}});
}

TEST(Step7Control, CallsThatGoTooDeep) {
  std::string chain, nine;
  for (int i = 1; i < 9; ++i)
    chain = fc(i, i == 8 ? "A I 0.0;\n= Q 0.0;" : "UC FC " + std::to_string(i + 1) + ";") + chain;
  for (int i = 1; i < 10; ++i)
    nine = fc(i, i == 9 ? "A I 0.0;\n= Q 0.0;" : "UC FC " + std::to_string(i + 1) + ";") + nine;
  expectFindings("SUB001", {{"itself", 1, fc(1, "A I 0.0;\nCC FC 1;") + ob1("CALL FC 1;")},
                            {"by another", 1, fc(1, "UC FC 2;") + fc(2, "A I 0.0;\nCC FC 1;") + ob1("CALL FC 1;")},
                            {"twice in a row", 0, fc(1, "A I 0.0;\n= Q 0.0;") + ob1("UC FC 1;\nUC FC 1;")}});
  expectFindings("SUB002", {{"nine levels of an S7-300", 1, nine + ob1("UC FC 1;")},
                            {"eight levels", 0, chain + ob1("UC FC 1;")}});
}

TEST(Step7Locals, TemporaryDataIsWrittenFirst) {
  const std::string temp = "VAR_TEMP\nX : INT;\nB : BOOL;\nP : ANY;\nEND_VAR\n";
  expectFindings(
      "SUB005",
      {{"read first", 1, fc(1, "L #X;\nT MW 0;", temp)},
       {"a bit", 1, fc(1, "A #B;\n= Q 0.0;", temp)},
       {"written on one way (a note)", 1, fc(1, "A I 0.0;\nJC m;\nL 1;\nT #X;\nm: L #X;\nT MW 0;", temp)},
       {"counted up", 1, fc(1, "L #X;\n+ 1;\nT #X;", temp)},
       {"the half of it is written", 1, ob1("L 1;\nT LB 20;\nL LW 20;\nT MW 0;")},
       {"S alone (a note)", 1, fc(1, "A I 0.0;\nS #B;\nA #B;\n= Q 0.0;", temp)},
       {"an input of a call", 1,
        fc(2, "L #N;\nT MW 0;", "VAR_INPUT\nN : INT;\nEND_VAR\n") + fc(1, "CALL FC 2 (N := #X);", temp)},
       {"written first", 0, fc(1, "L 1;\nT #X;\nL #X;\nT MW 0;", temp)},
       {"on both ways", 0, fc(1, "A I 0.0;\nJC m;\nL 1;\nT #X;\nJU e;\nm: L 2;\nT #X;\ne: L #X;\nT MW 0;", temp)},
       {"start information", 0,
        "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\nOB1_DATA : ARRAY[0..19] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\nL LB 1;\nT MB "
        "0;\nEND_ORGANIZATION_BLOCK\n"},
       {"an output of a call", 0,
        fc(2, "L 1;\nT #N;", "VAR_OUTPUT\nN : INT;\nEND_VAR\n") + fc(1, "CALL FC 2 (N := #X);\nL #X;\nT MW 0;", temp)},
       {"written through a pointer", 0, fc(1, "LAR1 P##P;\nL 1;\nT LW [AR1,P#0.0];\nL #X;\nT MW 0;", temp)},
       {"the compiler's bit of a parameter", 0, ob1("A I 0.0;\n= L 20.0;\nBLD 103;\nA L 20.0;\n= Q 0.0;")}});
}

TEST(Step7Locals, OutputsOfAnFcAreWritten) {
  const std::string out = "VAR_OUTPUT\nY : INT;\nQ : BOOL;\nEND_VAR\n", both = "L 1;\nT #Y;\nA I 0.0;\n= #Q;\n";
  expectFindings(
      "SUB004",
      {{"never", 1, fc(1, "L 1;\nT #Y;", out)},
       {"neither", 2, fc(1, "L 1;\nT MW 0;", out)},
       {"on one way", 1, fc(1, "A I 0.0;\n= #Q;\nJC m;\nL 1;\nT #Y;\nm: NOP 0;", out)},
       {"BEC before", 2, fc(1, "A I 0.0;\nBEC;\n" + both, out)},
       {"a box with EN", 1, fc(1, "A I 0.0;\n= #Q;\nA I 0.1;\nJNB _001;\nL 1;\nT #Y;\n_001: NOP 0;", out)},
       {"the return value", 1, "FUNCTION FC 1 : INT\nBEGIN\nNETWORK\nL 1;\nT MW 0;\nEND_FUNCTION\n"},
       {"written", 0, fc(1, both, out)},
       {"before the jump", 0, fc(1, both + "A I 0.0;\nJC m;\nL 2;\nT #Y;\nm: NOP 0;", out)},
       {"on both ways", 0, fc(1, "A I 0.0;\n= #Q;\nJC m;\nL 1;\nT #Y;\nBEU;\nm: L 2;\nT #Y;", out)},
       {"by a call", 0, fc(2, both, out) + fc(1, "CALL FC 2 (Y := #Y, Q := #Q);", out)},
       {"of an FB they stay in the instance", 0, fb(1, "L 1;\nT MW 0;", out)},
       {"the return value is written", 0, "FUNCTION FC 1 : INT\nBEGIN\nNETWORK\nL 1;\nT #RET_VAL;\nEND_FUNCTION\n"}});
}

TEST(Step7Locals, OwnNamesLieBehindTheStartInformation) {
  const auto ob = [](const std::string& temps) {
    return "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n" + temps +
           "END_VAR\nBEGIN\nNETWORK\nL 1;\nT MW 0;\nEND_ORGANIZATION_BLOCK\n";
  };
  std::string uploaded;
  for (int i = 0; i < 6; ++i) uploaded += "TEMP" + std::to_string(i) + " : BYTE;\n";
  uploaded += "TEMP6 : INT;\nTEMP7 : INT;\nTEMP8 : INT;\nTEMP9 : DATE_AND_TIME;\n";
  const std::string foreign = "Ereignis : ARRAY[0..11] OF BYTE;\nZeitpunkt : DATE_AND_TIME;\n";
  expectFindings("OBL001",
                 {{"own name first", 1, ob("Step : INT;\n")},
                  {"behind two bytes", 1, ob("OB1_EV_CLASS : BYTE;\nOB1_SCAN_1 : BYTE;\nStep : INT;\n")},
                  {"a bit", 1, ob("OB1_EV_CLASS : BYTE;\nOn : BOOL;\n")},
                  {"a structure", 1, ob("S : STRUCT\nA : INT;\nEND_STRUCT;\n")},
                  {"the array is too short", 1, ob("OB1_INFO : ARRAY[0..17] OF BYTE;\nStep : INT;\n")},
                  {"a longer array", 1, ob("Buffer : ARRAY[0..29] OF BYTE;\n")},
                  {"20 bytes that stand for it", 0, ob("Info : ARRAY[0..19] OF BYTE;\nStep : INT;\n")},
                  {"behind 20 bytes", 0, ob("OB1_INFO : ARRAY[0..19] OF BYTE;\nStep : INT;\n")},
                  {"no names", 0, ob1("L 1;\nT MW 0;")},
                  {"only those of the start information", 0, ob("OB1_EV_CLASS : BYTE;\nOB1_SCAN_1 : BYTE;\n")},
                  {"as the editor writes them", 0,
                   ob("OB1_EV_CLASS : BYTE;\nOB1_SCAN_1 : BYTE;\nOB1_PRIORITY : BYTE;\nOB1_OB_NUMBR : BYTE;\n"
                      "OB1_RESERVED_1 : BYTE;\nOB1_RESERVED_2 : BYTE;\nOB1_PREV_CYCLE : INT;\n"
                      "OB1_MIN_CYCLE : INT;\nOB1_MAX_CYCLE : INT;\nOB1_DATE_TIME : DATE_AND_TIME;\nStep : INT;\n")},
                  {"an upload's names", 0, ob(uploaded + "TEMP10 : INT;\n")},
                  {"names of another language", 0, ob(foreign + "Schritt : INT;\n")},
                  {"an upload without the time", 0, ob("TEMP0 : BYTE;\nTEMP1 : WORD;\n")},
                  {"an upload that writes there", 1,
                   "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\nTEMP0 : INT;\nEND_VAR\nBEGIN\nNETWORK\nL 1;\nT #TEMP0;\n"
                   "END_ORGANIZATION_BLOCK\n"},
                  {"a time at another place", 1, ob("At : DATE_AND_TIME;\nStep : INT;\n")},
                  {"an FC has none", 0, fc(1, "L 1;\nT #X;", "VAR_TEMP\nX : INT;\nEND_VAR\n")}});
}

// A LAD box leaves its ENO in BR (003:1205): what stands behind A BR and JNB runs only where the box ran.
TEST(Step7Locals, ConditionsAreFollowedAlongThePaths) {
  const std::string temp = "VAR_INPUT\nGo : BOOL;\nEND_VAR\nVAR_TEMP\nX : INT;\nB : BOOL;\nEND_VAR\n";
  const std::string box = "A #Go;\nJNB _001;\nL MW 10;\nL 5;\n+I;\nT #X;\nAN OV;\nSAVE;\nCLR;\n_001: ";
  const std::string use = "L #X;\nT MW 20;\n_002: NOP 0;";
  std::string many;
  for (int i = 0; i < 12; ++i) {
    const std::string bit = std::to_string(i / 8) + "." + std::to_string(i % 8), label = "n" + std::to_string(i);
    many += "A I " + bit + ";\nJNB " + label + ";\nL 1;\nT MW 30;\n" + label + ": A BR;\n= M 5" + bit + ";\n";
  }
  expectFindings(
      "SUB005",
      {{"the chain of the LAD compiler", 0, fc(1, box + "A BR;\nJNB _002;\n" + use, temp)},
       {"with a contact in between", 0, fc(1, box + "A BR;\nA M 0.0;\nJNB _002;\n" + use, temp)},
       {"BR in parentheses", 0, fc(1, "A(;\n" + box + "A BR;\n);\nA M 0.0;\nJNB _002;\n" + use, temp)},
       {"BR kept in a bit", 0, fc(1, box + "A BR;\n= #B;\nA #B;\nJNB _002;\n" + use, temp)},
       {"JNBI", 0, fc(1, box + "JNBI _002;\n" + use, temp)},
       {"the same input twice", 0, fc(1, "A #Go;\nJCN m;\nL 1;\nT #X;\nm: A #Go;\nJCN _002;\n" + use, temp)},
       {"a temporary bit twice", 0,
        fc(1, "A I 0.0;\n= #B;\nA #B;\nJCN m;\nL 1;\nT #X;\nm: A #B;\nJCN _002;\n" + use, temp)},
       {"either this or that", 0,
        fc(1, "A I 0.0;\nJCN m;\nL 1;\nT #X;\nm: AN I 0.0;\nJCN n;\nL 2;\nT #X;\nn: " + use, temp)},
       {"three boxes in a row", 0,
        fc(1, box + "A BR;\nJNB _003;\nL #X;\nL 2;\n*I;\nT #X;\nAN OV;\nSAVE;\nCLR;\n_003: A BR;\nJNB _002;\n" + use,
           temp)},
       {"behind many networks with bits of their own", 0, fc(1, many + box + "A BR;\nJNB _002;\n" + use, temp)},
       {"BR of the inverse", 1, fc(1, box + "AN BR;\nJNB _002;\n" + use, temp)},
       {"BR in parallel", 1, fc(1, box + "A BR;\nO M 0.0;\nJNB _002;\n" + use, temp)},
       {"a call in between", 1, fc(2, "A I 0.0;\n= Q 0.0;") + fc(1, box + "UC FC 2;\nA BR;\nJNB _002;\n" + use, temp)},
       {"BR set anew", 1, fc(1, box + "SET;\nSAVE;\nA BR;\nJNB _002;\n" + use, temp)},
       {"another input", 1, fc(1, "A #Go;\nJCN m;\nL 1;\nT #X;\nm: A I 0.1;\nJCN _002;\n" + use, temp)},
       {"the bit has changed", 1,
        fc(1, "A I 0.0;\n= #B;\nA #B;\nJCN m;\nL 1;\nT #X;\nm: A I 0.1;\n= #B;\nA #B;\nJCN _002;\n" + use, temp)},
       {"the word around the bit has changed", 1,
        fc(1, "A M 4.0;\nJCN m;\nL 1;\nT #X;\nm: L 7;\nT MW 4;\nA M 4.0;\nJCN _002;\n" + use, temp)},
       {"in a zone of the master control relay", 1,
        fc(1, "MCRA;\n" + box + "A I 0.0;\nMCR(;\nA BR;\nJNB _002;\nL #X;\nT MW 20;\n_002: )MCR;\nMCRD;", temp)}});
}

TEST(Step7Locals, OutputsOfAnFcThatAreOnlySetAndReset) {
  const std::string out = "VAR_INPUT\nA : BOOL;\nEND_VAR\nVAR_OUTPUT\nQ : BOOL;\nEND_VAR\n";
  expectFindings("SUB004",
                 {{"S and R", 1, fc(1, "A #A;\nS #Q;\nA I 0.0;\nR #Q;", out)},
                  {"S alone", 1, fc(1, "A #A;\nS #Q;", out)},
                  {"R alone", 1, fc(1, "AN #A;\nR #Q;", out)},
                  {"S on every way", 1, fc(1, "A #A;\nJC m;\nA I 0.0;\nS #Q;\nBEU;\nm: A I 0.1;\nR #Q;", out)},
                  {"S behind an edge", 1, fc(1, "A #A;\nFP M 0.0;\nS #Q;\nA I 0.0;\nR #Q;", out)},
                  {"= on one way", 1, fc(1, "A #A;\nS #Q;\nA I 0.0;\nJC m;\nA I 0.1;\n= #Q;\nm: NOP 0;", out)},
                  {"=", 0, fc(1, "A #A;\n= #Q;", out)},
                  {"cleared first", 0, fc(1, "CLR;\n= #Q;\nA #A;\nS #Q;", out)},
                  {"R behind SET first", 0, fc(1, "SET;\nR #Q;\nA #A;\nS #Q;", out)},
                  {"S behind SET", 0, fc(1, "SET;\nS #Q;", out)},
                  {"in and out", 0, fc(1, "A I 0.0;\nS #Q;\nA I 0.1;\nR #Q;", "VAR_IN_OUT\nQ : BOOL;\nEND_VAR\n")},
                  {"of an FB", 0, fb(1, "A I 0.0;\nS #Q;\nA I 0.1;\nR #Q;", "VAR_OUTPUT\nQ : BOOL;\nEND_VAR\n")}});
}

TEST(Step7Control, AnFcHandsNoArrayOn) {
  const std::string array = "ARRAY [0..3] OF INT;\n", record = "STRUCT\nX : INT;\nY : INT;\nEND_STRUCT;\n";
  const auto with = [](const std::string& type, const std::string& section = "VAR_INPUT") {
    return section + "\nA : " + type + "END_VAR\n";
  };
  const std::string use = "L MW 0;\nT MW 10;", call = "CALL FC 2 (A := #A);";
  expectFindings("SUB003",
                 {{"an ARRAY", 1, fc(2, use, with(array)) + fc(1, call, with(array))},
                  {"a STRUCT", 1, fc(2, use, with(record)) + fc(1, call, with(record))},
                  {"an output", 1, fc(2, use, with(array, "VAR_OUTPUT")) + fc(1, call, with(array, "VAR_OUTPUT"))},
                  {"in and out", 1, fc(2, use, with(array, "VAR_IN_OUT")) + fc(1, call, with(array, "VAR_IN_OUT"))},
                  {"to an FB", 1,
                   fb(2, use, with(array)) + instanceDb(2, "FB 2") + fc(1, "CALL FB 2, DB 2 (A := #A);", with(array))},
                  {"twice", 2, fc(2, use, with(array)) + fc(1, call + "\n" + call, with(array))},
                  {"an FB may", 0, fc(2, use, with(array)) + fb(1, call, with(array)) + instanceDb(1, "FB 1")},
                  {"one element", 0, fc(2, use, with("INT;\n")) + fc(1, "CALL FC 2 (A := #A[1]);", with(array))},
                  {"a number", 0, fc(2, use, with("INT;\n")) + fc(1, call, with("INT;\n"))},
                  {"temporary data", 0, fc(2, use, with(array)) + fc(1, call, with(array, "VAR_TEMP"))},
                  {"a block's data", 0,
                   fc(2, use, with(array)) + db(5, "A : ARRAY [0..3] OF INT;") + ob1("CALL FC 2 (A := DB5.A);")},
                  {"it is used", 0, fc(1, "L #A[0];\nT MW 10;", with(array))}});
}

}  // namespace
}  // namespace rungproof::testing
