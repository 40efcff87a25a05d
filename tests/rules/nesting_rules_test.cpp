// Rules NST: parentheses, the RLO, labels, edges and BR of the S7-300/400. Each case gives its reason.
#include "analysis/flow/step7_blocks.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

TEST(NestingRules, ParenthesesAreClosedWhereTheyWereOpened) {
  const std::string eight = "A(;A(;A(;A(;A(;A(;A(;A(;A I 0.0;);););););););););= Q 0.0;";
  const std::string seven = "A(;A(;A(;A(;A(;A(;A(;A I 0.0;);););););););= Q 0.0;";
  expectFindings(
      "NST001",
      {{"A( without )", 1, ob1("A(;\nO I 0.0;\nO I 0.1;\n= Q 0.0;")},
       {") without A(", 1, ob1("A I 0.0;\n);\n= Q 0.0;")},
       {"the eighth level", 1, ob1(eight)},
       {"one of two is closed", 1, ob1("A(;\nO(;\nA I 0.0;\n);\n= Q 0.0;")},
       {"left by BEU", 1, ob1("A I 0.0;\nJC m;\nA(;\nA I 0.1;\nBEU;\nm: NOP 0;")},
       {"open on one way to the label only", 1, ob1("A I 0.0;\nJC m;\nA(;\nA I 0.1;\nm: A I 0.2;\n);\n= Q 0.0;")},
       {"X( is one too", 1, ob1("X(;\nA I 0.0;\n= Q 0.0;")},
       {"left by BEC, with the rest behind it", 1, ob1("A(;\nA I 0.1;\nBEC;\nA I 0.2;\n);\n= Q 0.0;")},
       {"seven levels", 0, ob1(seven)},
       {"a pair", 0, ob1("A(;\nO I 0.0;\nO I 0.1;\n);\n= Q 0.0;")},
       {"pairs side by side", 0, ob1("A(;\nO I 0.0;\nO I 0.1;\n);\nA(;\nO I 0.2;\nON I 0.3;\n);\n= Q 0.0;")},
       {"a comparison in it", 0, ob1("A I 0.0;\nA(;\nL MW 0;\nL 5;\n>I;\n);\n= Q 0.0;")},
       {"an assignment in it, as the compiler writes", 0, ob1("A(;\nA I 0.0;\n= M 0.0;\nA M 0.0;\n);\n= Q 0.0;")},
       {"a jump around a closed pair", 0, ob1("A I 0.0;\nJC m;\nA(;\nA I 0.1;\n);\n= Q 0.0;\nm: NOP 0;")},
       {"closed in the next network", 0, ob1("A(;\nA I 0.1;\nNETWORK\n);\n= Q 0.0;")}});
}

// Eight zones are general knowledge. They end with their block, so that BEC inside one leaves nothing open.
TEST(NestingRules, ZonesOfTheRelayAreClosedInTheirBlock) {
  const auto zones = [](int depth) {
    std::string text = "MCRA;\nA I 0.0;\n";
    for (int i = 0; i < depth; ++i) text += "MCR(;\nA I 0.1;\n= Q 0.0;\n";
    for (int i = 0; i < depth; ++i) text += ")MCR;\n";
    return ob1(text + "MCRD;");
  };
  expectFindings("NST001",
                 {{"the ninth zone", 1, zones(9)},
                  {"a zone that nothing closes", 1, ob1("MCRA;\nA I 0.0;\nMCR(;\nA I 0.1;\n= Q 0.0;\nMCRD;")},
                  {"left by BEU", 1, ob1("A I 0.0;\nMCR(;\nBEU;")},
                  {")MCR alone", 1, ob1("A I 0.0;\n= Q 0.0;\n)MCR;")},
                  {"open on one way to the label only", 1, ob1("A I 0.0;\nMCR(;\nA I 0.1;\nJC m;\n)MCR;\nm: NOP 0;")},
                  {"once more in every round", 1, ob1("L 3;\nm: T MW 0;\nA I 0.0;\nMCR(;\nL MW 0;\nLOOP m;\n)MCR;")},
                  {"a pair of each that is open", 2, ob1("A I 0.0;\nMCR(;\nA(;\nA I 0.1;\n= Q 0.0;")},
                  {"eight zones", 0, zones(8)},
                  {"side by side", 0, ob1("A I 0.0;\nMCR(;\n)MCR;\nA I 0.1;\nMCR(;\n)MCR;")},
                  {"BEC in a zone", 0, ob1("A I 0.0;\nMCR(;\nA I 0.1;\nBEC;\n)MCR;")},
                  {"closed in the next network", 0, ob1("A I 0.0;\nMCR(;\nNETWORK\n)MCR;")}});
}

TEST(NestingRules, TheRloComesFromTheBlockItself) {
  expectFindings("NST002",
                 {{"= at the beginning", 1, ob1("= Q 0.0;")},
                  {"S at the beginning", 1, ob1("S Q 0.0;")},
                  {"a jump at the beginning of an FC", 1, fc(1, "JC m;\nL 1;\nT MW 0;\nm: NOP 0;")},
                  {"SAVE at the beginning", 1, ob1("SAVE;")},
                  {"FP at the beginning", 1, ob1("FP M 0.0;\n= Q 0.0;")},
                  {"a timer started behind a load only", 1, ob1("L S5T#1S;\nSD T 1;")},
                  {"= behind a call", 1, fc(1, "A I 0.0;\n= Q 0.0;") + ob1("CALL FC 1;\n= Q 1.0;")},
                  {"one way comes round the scan", 1, ob1("L MW 0;\nL 5;\n+I;\nJO m;\nA I 0.0;\nm: = Q 0.0;")},
                  {"a scan", 0, ob1("A I 0.0;\n= Q 0.0;")},
                  {"SET", 0, ob1("SET;\n= Q 0.0;")},
                  {"several assignments of one RLO", 0, ob1("A I 0.0;\n= Q 0.0;\nS Q 0.1;\nR Q 0.2;")},
                  {"a comparison", 0, ob1("L MW 0;\nL 5;\n==I;\n= Q 0.0;")},
                  {"a condition of the status word", 0, ob1("L MW 0;\nL 5;\n+I;\nA OV;\n= Q 0.0;")},
                  {"1 behind a jump that was not taken", 0, ob1("A I 0.0;\nJCN m;\nS Q 0.0;\nm: NOP 0;")},
                  {"A BR behind a call", 0, fc(1, "A I 0.0;\nSAVE;") + ob1("CALL FC 1;\nA BR;\n= Q 1.0;")},
                  {"a box of the compiler", 0,
                   ob1("A I 0.0;\nJNB _001;\nL MW 0;\nT MW 2;\nSET;\nSAVE;\nCLR;\n_001: A BR;\n= Q 0.0;")},
                  {"a jump by CC needs no RLO", 0, ob1("L MW 0;\nL 5;\n-I;\nJZ m;\nA I 0.0;\n= Q 0.0;\nm: NOP 0;")}});
}

TEST(NestingRules, StringsEndBeforeLabels) {
  expectFindings(
      "NST003",
      {{"a string over a label", 1, ob1("A I 0.0;\nJC m;\nA I 0.1;\nm: A I 0.2;\n= Q 0.0;")},
       {"an assignment behind the label ends the string of one way", 1, ob1("A I 0.0;\nJC m;\nA I 0.1;\nm: = Q 0.0;")},
       {"O behind it", 1, ob1("A I 0.0;\nJCN m;\nA I 0.1;\nm: O I 0.2;\n= Q 0.0;")},
       {"a comparison before it", 1, ob1("A I 0.0;\nJC m;\nL MW 0;\nL 1;\n==I;\nm: A I 0.2;\n= Q 0.0;")},
       {"a parenthesis behind it", 1, ob1("A I 0.0;\nJC m;\nA I 0.1;\nm: A(;\nO I 0.2;\nO I 0.3;\n);\n= Q 0.0;")},
       {"an edge before it", 1, ob1("A I 0.0;\nJC m;\nA I 0.1;\nFP M 0.0;\nm: A I 0.2;\n= Q 0.0;")},
       {"ended by =", 0, ob1("A I 0.0;\nJC m;\nA I 0.1;\n= Q 0.1;\nm: A I 0.2;\n= Q 0.0;")},
       {"the RLO of the jump is used on both ways", 0, ob1("A I 0.0;\nA I 0.1;\nJU m;\nm: A I 0.2;\n= Q 0.0;")},
       {"the same on all ways: each has just scanned", 0,
        ob1("L MW 0;\nL 1;\n-I;\nJZ a;\nA I 0.0;\nJU m;\na: A I 0.1;\nm: A I 0.2;\n= Q 0.0;")},
       {"a label that no one jumps to", 0, ob1("A I 0.0;\nm: A I 0.1;\n= Q 0.0;")},
       {"loads between label and scan do not matter", 0,
        ob1("A I 0.0;\nJC m;\nL 1;\nT MW 0;\nm: L 2;\nT MW 2;\nA I 0.2;\n= Q 0.0;")},
       {"CLR before the label, as the compiler writes", 0,
        ob1("A I 0.0;\nJNB _001;\nL 1;\nT MW 0;\nAN OV;\nSAVE;\nCLR;\n_001: A BR;\n= Q 0.0;")}});
}

TEST(NestingRules, EveryEdgeHasABitOfItsOwn) {
  const std::string own = "VAR\nX : BOOL;\nE : BOOL;\nF : BOOL;\nEND_VAR\n";
  expectFindings(
      "NST004",
      {{"two FP", 1, ob1("A I 0.0;\nFP M 1.0;\nS Q 0.0;\nA I 0.1;\nFP M 1.0;\nR Q 0.0;")},
       {"FP and FN", 1, ob1("A I 0.0;\nFP M 1.0;\nS Q 0.0;\nA I 0.0;\nFN M 1.0;\nR Q 0.0;")},
       {"in two blocks", 1, fc(1, "A I 0.1;\nFP M 1.0;\n= M 2.0;") + ob1("A I 0.0;\nFP M 1.0;\n= M 2.1;\nCALL FC 1;")},
       {"local data", 1, ob1("A I 0.0;\nFP L 20.0;\n= Q 0.0;")},
       {"a declared temporary bit", 1, fc(1, "A I 0.0;\nFP #E;\n= Q 0.0;", "VAR_TEMP\nE : BOOL;\nEND_VAR\n")},
       {"assigned too", 1, ob1("A I 0.0;\nFP M 1.0;\n= Q 0.0;\nA I 0.1;\n= M 1.0;")},
       {"part of a word that is transferred", 1, ob1("A I 0.0;\nFP M 1.0;\n= Q 0.0;\nL 5;\nT MW 0;")},
       {"an input", 1, ob1("A I 0.0;\nFP I 0.1;\n= Q 0.0;")},
       {"static data twice", 1, fb(1, "A I 0.0;\nFP #E;\n= #X;\nA I 0.1;\nFP #E;\n= #X;", own)},
       {"static data set too", 1, fb(1, "A I 0.0;\nFP #E;\n= #X;\nA I 0.1;\nS #E;", own)},
       {"a data block twice", 1,
        db(1, "E : BOOL;") + ob1("A I 0.0;\nFP DB1.DBX 0.0;\n= Q 0.0;\nA I 0.1;\nFP DB1.DBX 0.0;\n= Q 0.1;")},
       {"different bits", 0, ob1("A I 0.0;\nFP M 1.0;\nS Q 0.0;\nA I 0.1;\nFP M 1.1;\nR Q 0.0;")},
       {"static data of two blocks", 0, fb(1, "A I 0.0;\nFP #E;\n= #X;", own) + fb(2, "A I 0.0;\nFP #E;\n= #X;", own)},
       {"set in the start-up", 0,
        "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nSET;\n= M 1.0;\nEND_ORGANIZATION_BLOCK\n" +
            ob1("A I 0.0;\nFP M 1.0;\n= Q 0.0;")},
       {"reset, which asks for a new edge", 0, ob1("A I 0.0;\nFP M 1.0;\n= Q 0.0;\nA I 0.1;\nR M 1.0;")},
       {"a neighbouring bit is assigned", 0, ob1("A I 0.0;\nFP M 1.0;\n= Q 0.0;\nA I 0.1;\n= M 1.1;")},
       {"read elsewhere", 0, ob1("A I 0.0;\nFP M 1.0;\n= Q 0.0;\nA M 1.0;\n= Q 0.1;")},
       {"a parameter", 0,
        fc(1, "A I 0.0;\nFP #E;\n= Q 0.0;", "VAR_IN_OUT\nE : BOOL;\nEND_VAR\n") + ob1("CALL FC 1 (E := M 1.0);")}});
}

TEST(NestingRules, EdgesOfBlocksThatRunTwice) {
  const std::string edge = fc(1, "A I 0.0;\nFP M 1.0;\nS Q 0.0;");
  const std::string own = "VAR\nE : BOOL;\nEND_VAR\n";
  const std::string box = fb(1, "A I 0.0;\nFP #E;\nS Q 0.0;", own);
  expectFindings(
      "NST005",
      {{"called twice", 1, edge + ob1("CALL FC 1;\nCALL FC 1;")},
       {"called from two blocks", 1, edge + fc(2, "CALL FC 1;") + ob1("CALL FC 1;\nCALL FC 2;")},
       {"its caller is called twice", 1, edge + fc(2, "CALL FC 1;") + ob1("CALL FC 2;\nCALL FC 2;")},
       {"in a loop", 1, edge + ob1("L 3;\nm: T MW 10;\nCALL FC 1;\nL MW 10;\nLOOP m;")},
       {"by UC", 1, edge + ob1("UC FC 1;\nUC FC 1;")},
       {"one instance twice", 1, box + instanceDb(1, "FB 1") + ob1("CALL FB 1, DB 1;\nCALL FB 1, DB 1;")},
       {"a data block's bit", 1,
        db(9, "E : BOOL;") + fc(1, "A I 0.0;\nFP DB9.DBX 0.0;\nS Q 0.0;") + ob1("CALL FC 1;\nCALL FC 1;")},
       {"called once", 0, edge + ob1("CALL FC 1;")},
       {"either here or there", 0, edge + ob1("A I 1.0;\nJC m;\nCALL FC 1;\nJU e;\nm: CALL FC 1;\ne: NOP 0;")},
       {"two instances", 0,
        box + instanceDb(1, "FB 1") + instanceDb(2, "FB 1") + ob1("CALL FB 1, DB 1;\nCALL FB 1, DB 2;")},
       {"once in the start-up and once in a scan", 0,
        edge + "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nCALL FC 1;\nEND_ORGANIZATION_BLOCK\n" + ob1("CALL FC 1;")},
       {"no edge in it", 0, fc(1, "A I 0.0;\nS Q 0.0;") + ob1("CALL FC 1;\nCALL FC 1;")},
       {"the bit is handed over", 0,
        fc(1, "A I 0.0;\nFP #E;\nS Q 0.0;", "VAR_IN_OUT\nE : BOOL;\nEND_VAR\n") +
            ob1("CALL FC 1 (E := M 1.0);\nCALL FC 1 (E := M 1.1);")},
       {"multi-instances", 0,
        box + fb(2, "CALL #A;\nCALL #B;", "VAR\nA : FB 1;\nB : FB 1;\nEND_VAR\n") + instanceDb(2, "FB 2") +
            ob1("CALL FB 2, DB 2;")}});
}

TEST(NestingRules, BrIsTheAnswerOfTheCalledBlock) {
  const std::string asks = "A I 1.0;\nJNB _001;\nCALL FC 1;\n_001: A BR;\n= Q 1.0;";
  expectFindings(
      "NST006",
      {{"no SAVE", 1, fc(1, "A I 0.0;\n= Q 0.0;") + ob1(asks)},
       {"SAVE on one way", 1, fc(1, "A I 0.0;\nJC m;\nSET;\nSAVE;\nm: NOP 0;") + ob1(asks)},
       {"BEU before it", 1, fc(1, "A I 0.0;\nJCN m;\nBEU;\nm: SET;\nSAVE;") + ob1(asks)},
       {"BEC before it", 1, fc(1, "A I 0.0;\nBEC;\nSET;\nSAVE;") + ob1(asks)},
       {"JNBI behind the call", 1, fc(1, "A I 0.0;\n= Q 0.0;") + ob1("CALL FC 1;\nJNBI m;\nL 1;\nT MW 0;\nm: NOP 0;")},
       {"AN BR behind the call", 1, fc(1, "L 1;\nT MW 2;") + ob1("CALL FC 1;\nAN BR;\n= Q 1.0;")},
       {"SAVE at the end", 0, fc(1, "A I 0.0;\n= Q 0.0;\nSET;\nSAVE;") + ob1(asks)},
       {"SAVE on both ways", 0, fc(1, "A I 0.0;\nJC m;\nSET;\nSAVE;\nBEU;\nm: CLR;\nSAVE;") + ob1(asks)},
       {"JNB keeps the RLO in BR", 0, fc(1, "A I 0.0;\nJNB m;\nL 1;\nT MW 0;\nm: NOP 0;") + ob1(asks)},
       {"no one asks", 0, fc(1, "A I 0.0;\n= Q 0.0;") + ob1("CALL FC 1;")},
       {"SAVE of the caller in between", 0, fc(1, "L 1;\nT MW 2;") + ob1("CALL FC 1;\nSET;\nSAVE;\nA BR;\n= Q 1.0;")},
       {"the answer of a called block is handed on", 0, fc(2, "SET;\nSAVE;") + fc(1, "CALL FC 2;") + ob1(asks)}});
}

TEST(Step7Blocks, LibraryTextIsNotTheProgramsOwn) {
  const Cpu cpu = *cpuNamed("319-3");
  const Linted linted(instanceDb(1, "SFB 4") + ob1("CALL SFB 4, DB 1 (IN := I 0.0, PT := T#1S);"),
                      {cpu, usualEdition(cpu)});
  std::size_t own = 0, library = 0;
  for (const Pou& pou : linted.program.pous) ++(isLibraryText(linted.program, pou) ? library : own);
  EXPECT_EQ(own, 1U);
  EXPECT_EQ(library, 1U);
}

}  // namespace
}  // namespace rungproof::testing
