// Rules ARI, LOG and TIM about values on the S7-300/400. Each case gives its reason.
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

TEST(DataRules7, DivisorsAreNotZero) {
  expectFindings(
      "ARI001",
      {{"/I by 0", 1, ob1("L MW 0;\nL 0;\n/I;\nT MW 2;")},
       {"/D by 0", 1, ob1("L MD 0;\nL L#0;\n/D;\nT MD 4;")},
       {"MOD by 0", 1, ob1("L MD 0;\nL L#0;\nMOD;\nT MD 4;")},
       {"/R by 0.0", 1, ob1("L MD 0;\nL 0.0;\n/R;\nT MD 4;")},
       {"/I sees the lower half", 1, ob1("L MW 0;\nL L#65536;\n/I;\nT MW 2;")},
       {"by a word", 1, ob1("L MW 0;\nL MW 4;\n/I;\nT MW 2;")},
       {"logic between the loads and the division", 1, ob1("L MW 0;\nL MW 4;\nA I 0.0;\n= M 8.0;\n/I;\nT MW 2;")},
       {"by another constant", 0, ob1("L MW 0;\nL 10;\n/I;\nT MW 2;")},
       {"the dividend is 0", 0, ob1("L 0;\nL 10;\n/I;\nT MW 2;")},
       {"compared and jumped over", 0, ob1("L MW 4;\nL 0;\n==I;\nJC m;\nL MW 0;\nL MW 4;\n/I;\nT MW 2;\nm: NOP 0;")},
       {"JO behind it", 0, ob1("L MW 0;\nL MW 4;\n/I;\nJO m;\nT MW 2;\nm: NOP 0;")},
       {"the box of a drawing", 0, ob1("L MW 0;\nL MW 4;\n/I;\nT MW 2;\nAN OV;\nSAVE;\nCLR;")},
       {"made by a sum", 0, ob1("L MW 0;\nL MW 4;\nL 1;\n+I;\n/I;\nT MW 2;")},
       {"made before a label", 0, ob1("L MW 0;\nL MW 4;\nm: /I;\nT MW 2;\nA I 0.0;\nJC m;")}});
}

TEST(DataRules7, ProductsMayOverflow) {
  expectFindings("ARI002",
                 {{"two words", 1, ob1("L MW 0;\nL MW 2;\n*I;\nT MW 4;")},
                  {"two double words", 1, ob1("L MD 0;\nL MD 4;\n*D;\nT MD 8;")},
                  {"all of it is stored", 0, ob1("L MW 0;\nL MW 2;\n*I;\nT MD 4;")},
                  {"a constant", 0, ob1("L MW 0;\nL 3;\n*I;\nT MW 4;")},
                  {"a sum", 0, ob1("L MW 0;\nL MW 2;\n+I;\nT MW 4;")},
                  {"OV is asked", 0, ob1("L MW 0;\nL MW 2;\n*I;\nJO a;\nT MW 4;\na: NOP 0;")},
                  {"compared before", 0, ob1("L MW 0;\nL 100;\n>I;\nJC a;\nL MW 0;\nL MW 2;\n*I;\nT MW 4;\na: NOP 0;")},
                  {"REAL", 0, ob1("L MD 0;\nL MD 4;\n*R;\nT MD 8;")}});
}

TEST(DataRules7, ABitFromItsInverseToggles) {
  expectFindings("LOG005",
                 {{"alone", 1, ob1("AN M 0.0;\n= M 0.0;")},
                  {"behind another string", 1, ob1("A I 0.0;\n= Q 0.0;\nAN M 0.0;\n= M 0.0;")},
                  {"an output", 1, ob1("AN Q 4.0;\n= Q 4.0;")},
                  {"behind words", 1, ob1("L MW 10;\nT MW 12;\nAN M 0.0;\n= M 0.0;")},
                  {"behind a conditional jump", 1, ob1("A I 0.0;\nJC a;\nAN M 0.0;\n= M 0.0;\na: NOP 0;")},
                  {"in parentheses", 0, ob1("A I 0.0;\nA(;\nAN M 0.0;\n);\n= M 0.0;")},
                  {"another bit", 0, ob1("AN M 0.1;\n= M 0.0;")},
                  {"the bit itself", 0, ob1("A M 0.0;\n= M 0.0;")},
                  {"with a condition in front", 0, ob1("A I 0.0;\nAN M 0.0;\n= M 0.0;")},
                  {"behind an edge", 0, ob1("A I 0.0;\nFP M 1.0;\nAN M 0.0;\n= M 0.0;")},
                  {"written elsewhere too", 0, ob1("AN M 0.0;\n= M 0.0;\nA I 0.0;\nR M 0.0;")},
                  {"once, in the start-up", 0,
                   "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nAN M 0.0;\n= M 0.0;\nEND_ORGANIZATION_BLOCK\n" +
                       ob1("A M 0.0;\n= Q 0.0;")}});
}

TEST(DataRules7, RunningValuesAreNotComparedForEquality) {
  const std::string timer = "A I 0.0;\nL S5T#10S;\nSD T 1;\n", counter = "A I 0.0;\nCU C 1;\n";
  expectFindings("TIM010", {{"a timer", 1, ob1(timer + "L T 1;\nL 40;\n==I;\n= Q 0.0;")},
                            {"the constant first", 1, ob1(timer + "L 40;\nL T 1;\n<>I;\n= Q 0.0;")},
                            {"BCD", 1, ob1(timer + "LC T 1;\nL W#16#0040;\n==I;\n= Q 0.0;")},
                            {"a counter", 1, ob1(counter + "L C 1;\nL 5;\n==I;\n= Q 0.0;")},
                            {"elapsed", 0, ob1(timer + "L T 1;\nL 0;\n==I;\n= Q 0.0;")},
                            {"a range", 0, ob1(timer + "L T 1;\nL 40;\n<=I;\n= Q 0.0;")},
                            {"a word", 0, ob1("L MW 0;\nL 40;\n==I;\n= Q 0.0;")}});
}

TEST(DataRules7, NumbersOfTwoTypesAreNotMixed) {
  const std::string declared =
      "VAR_INPUT\nI : INT;\nD : DINT;\nR : REAL;\nS : S5TIME;\nT : TIME;\nW : DWORD;\nEND_VAR\n"
      "VAR_OUTPUT\nRo : REAL;\nIo : INT;\nTo : TIME;\nSo : S5TIME;\nEND_VAR\n";
  const auto in = [&](const std::string& statements) { return fc(1, statements, declared); };
  expectFindings("ARI008", {{"an INT in a sum of REAL", 1, in("L #I;\nL #R;\n+R;\nT MD 0;")},
                            {"the second operand", 1, in("L #R;\nL #D;\n*R;\nT MD 0;")},
                            {"a whole constant", 1, in("L #R;\nL 5;\n/R;\nT MD 0;")},
                            {"a REAL in a sum of INT", 1, in("L #R;\nL MW 0;\n+I;\nT MW 2;")},
                            {"compared", 1, in("L #I;\nL 1.5;\n>R;\n= M 0.0;")},
                            {"compared as INT", 1, in("L #R;\nL 5;\n==D;\n= M 0.0;")},
                            {"stored", 1, in("L #I;\nT #Ro;")},
                            {"stored the other way", 1, in("L #R;\nT #Io;")},
                            {"one more on a REAL", 1, in("L #R;\n+ 1;\nT MD 0;")},
                            {"S5TIME and TIME added", 1, in("L #S;\nL #T;\n+D;\nT MD 0;")},
                            {"S5TIME and TIME compared", 1, in("L #T;\nL S5T#2S;\n>I;\n= M 0.0;")},
                            {"S5TIME stored as TIME", 1, in("L #S;\nT #To;")},
                            {"TIME stored as S5TIME", 1, in("L T#2S;\nT #So;")},
                            {"a TIME for a timer", 1, in("A I 0.0;\nL #T;\nSD T 1;")},
                            {"converted", 0, in("L #I;\nITD;\nDTR;\nL #R;\n+R;\nT #Ro;")},
                            {"rounded", 0, in("L #R;\nRND;\nT #Io;")},
                            {"all of one type", 0, in("L #R;\nL 1.5;\n+R;\nT #Ro;\nL #I;\nL 5;\n+I;\nT #Io;")},
                            {"0", 0, in("L #R;\nL 0;\n==R;\n= M 0.0;")},
                            {"a pattern of bits", 0, in("L #W;\nL #R;\n+R;\nT #Ro;")},
                            {"a pattern as constant", 0, in("L DW#16#3F800000;\nL #R;\n+R;\nT #Ro;")},
                            {"INT and DINT", 0, in("L #I;\nL #D;\n+D;\nT MD 0;")},
                            {"an S5TIME for a timer", 0, in("A I 0.0;\nL #S;\nSD T 1;")},
                            {"memory without a type", 0, in("L MD 0;\nL MD 4;\n+R;\nT MD 8;")},
                            {"another value in between", 0, in("L #I;\nL MD 0;\nDTR;\n+R;\nT MD 0;")}});
}

// Names in any case (002:180), members of data blocks, of structures and of arrays, data of instances.
TEST(DataRules7, NumbersWithADeclarationAnywhereAreNotMixed) {
  const std::string fields =
      "r : REAL;\ni : INT;\ns : S5TIME;\nt : TIME;\nar : ARRAY [1 .. 3] OF REAL;\n"
      "st : STRUCT\nx : REAL;\nn : INT;\nEND_STRUCT;\nd : DINT;";
  const std::string data = db(1, fields);
  const std::string type = "TYPE UDT 1\nSTRUCT\n" + fields + "\nEND_STRUCT;\nEND_TYPE\n";
  const std::string function =
      fc(7, "L #x;\nL 1.0;\n>R;\n= #y;", "VAR_INPUT\nx : REAL;\nEND_VAR\nVAR_OUTPUT\ny : BOOL;\nEND_VAR\n");
  const std::string timer = "VAR\nTn : SFB 4;\nw : WORD;\nEND_VAR\n";
  const auto withType = [&](const std::string& statements) {
    return type + fc(1, statements, "VAR_INPUT\nu : UDT 1;\nEND_VAR\nVAR_TEMP\nv : UDT 1;\nEND_VAR\n");
  };
  expectFindings("ARI008",
                 {{"another case", 1, fc(1, "L #ratio;\nL 5;\n+I;\nT MW 0;", "VAR_INPUT\nRatio : REAL;\nEND_VAR\n")},
                  {"of a data block", 1, data + ob1("L DB1.r;\nL 1;\n+I;\nT MW 0;")},
                  {"by its address", 1, data + ob1("L DB1.DBD 0;\nL 1;\n+I;\nT MW 0;")},
                  {"from one member to another", 1, data + ob1("L DB1.i;\nT DB1.r;")},
                  {"S5TIME to TIME", 1, data + ob1("L DB1.s;\nT DB1.t;")},
                  {"an element", 1, data + ob1("L DB1.ar[2];\nL 1;\n+I;\nT MW 0;")},
                  {"in a structure", 1, data + ob1("L DB1.st.n;\nL 1.5;\n>R;\n= M 0.0;")},
                  {"of a parameter", 1, withType("L #u.r;\nL 1;\n+I;\nT MW 0;")},
                  {"of an element of a parameter", 1, withType("L #u.ar[3];\nL 1;\n+I;\nT MW 0;")},
                  {"of temporary data", 1, withType("L #v.st.x;\nT #v.st.n;")},
                  {"of an instance", 1, fb(1, "L S5T#5S;\nT #Tn.PT;", timer)},
                  {"of an instance, compared", 1, fb(1, "L #Tn.ET;\nL 5.0;\n>R;\n= M 0.0;", timer)},
                  {"a parameter of a function", 1, data + function + ob1("CALL FC 7 (x := DB1.d, y := M 0.0);")},
                  {"a parameter of an instance", 1,
                   data + fb(3, "L #x;\nL 1.0;\n>R;\n= M 0.0;", "VAR_INPUT\nx : REAL;\nEND_VAR\n") +
                       instanceDb(4, "FB 3") + ob1("CALL FB 3, DB 4 (x := DB1.d);")},
                  {"a parameter of its type", 0, data + function + ob1("CALL FC 7 (x := DB1.r, y := M 0.0);")},
                  {"an address as parameter", 0, data + function + ob1("CALL FC 7 (x := MD 4, y := M 0.0);")},
                  {"converted", 0, data + ob1("L DB1.i;\nITD;\nDTR;\nT DB1.r;")},
                  {"of one type", 0, data + ob1("L DB1.ar[2];\nT DB1.r;\nL DB1.i;\nT DB1.st.n;")},
                  {"half of a REAL", 0, data + ob1("L DB1.DBW 0;\nL 1;\n+I;\nT MW 0;")},
                  {"half of a TIME into an S5TIME", 0, data + ob1("L DB1.DBW 8;\nT DB1.s;")},
                  {"a TIME for an IEC timer", 0, fb(1, "L T#5S;\nT #Tn.PT;", timer)},
                  {"of a parameter, of one type", 0, withType("L #u.r;\nT #v.r;\nL #u.t;\nT #v.t;")}});
}

// Each network is judged by itself where a statement of another one could not be read.
TEST(DataRules7, ANetworkThatCannotBeReadHidesNoOther) {
  const std::string data = db(1, "i : INT;\nr : REAL;");
  const auto beside = [&](const std::string& before, const std::string& behind) {
    return data + ob1(before + "\nNETWORK\nA \"nope\";\n= M 1.0;\nNETWORK\n" + behind);
  };
  const Target target{*cpuNamed("319-3"), usualEdition(*cpuNamed("319-3"))};
  const auto count = [&](const char* rule, const std::string& text) { return Linted(text, target).of(rule).size(); };
  EXPECT_EQ(count("DBA002", beside("L DB1.DBW 100;\nT MW 50;", "L DB1.DBW 6;\nT MW 52;")), 2U);
  EXPECT_EQ(count("NST001", beside("A(;\nA I 0.0;\n= M 20.4;", "NOP 0;")), 1U);
  EXPECT_EQ(count("ARI008", beside("NOP 0;", "L DB1.i;\nT DB1.r;")), 1U);
  // The block that is open behind the unread network is not known, and a jump over it joins what is before and behind.
  EXPECT_EQ(count("DBA002", beside("OPN DB 1;\nL DBW 0;\nT MW 50;", "L DBW 6;\nT MW 52;")), 0U);
  EXPECT_EQ(count("DBA002", beside("L DB1.DBW 100;\nT MW 50;\nJU m;", "m: L DB1.DBW 6;\nT MW 52;")), 0U);
}

}  // namespace
}  // namespace rungproof::testing
