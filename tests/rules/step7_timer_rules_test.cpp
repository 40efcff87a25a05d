// Rules S5T, and TIM on the S7-300/400: S5 timers and counters, IEC timers. Each case gives its reason.
#include "ir/s7200/cpu.hpp"
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

TEST(S5Rules, OneStatementWorksAnElement) {
  expectFindings(
      "S5T001",
      {{"two starts", 1, ob1("A I 0.0;\nL S5T#1S;\nSD T 1;\nA I 0.1;\nL S5T#2S;\nSD T 1;")},
       {"starts of two kinds", 1, ob1("A I 0.0;\nL S5T#1S;\nSD T 1;\nA I 0.1;\nL S5T#2S;\nSF T 1;")},
       {"in two blocks", 1, fc(1, "A I 0.0;\nL S5T#1S;\nSD T 1;") + ob1("CALL FC 1;\nA I 0.1;\nL S5T#2S;\nSD T 1;")},
       {"CU twice", 1, ob1("A I 0.0;\nCU C 1;\nA I 0.1;\nCU C 1;")},
       {"S of a counter twice", 1, ob1("A I 0.0;\nL C#5;\nS C 1;\nA I 0.1;\nL C#6;\nS C 1;")},
       {"in a block that is called twice", 1, fc(1, "A I 0.0;\nCU C 1;") + ob1("CALL FC 1;\nCALL FC 1;")},
       {"once", 0, ob1("A I 0.0;\nL S5T#1S;\nSD T 1;")},
       {"CU and CD remember apart", 0, ob1("A I 0.0;\nCU C 1;\nA I 0.1;\nCD C 1;")},
       {"either here or there", 0,
        ob1("A I 1.0;\nJC m;\nA I 0.0;\nL S5T#1S;\nSD T 1;\nJU e;\nm: A I 0.1;\nL S5T#2S;\nSD T 1;\ne: NOP 0;")},
       {"two timers", 0, ob1("A I 0.0;\nL S5T#1S;\nSD T 1;\nA I 0.1;\nL S5T#2S;\nSD T 2;")},
       {"R is no start", 0, ob1("A I 0.0;\nL S5T#1S;\nSS T 1;\nA I 0.1;\nR T 1;\nA I 0.2;\nR T 1;")},
       {"preset in the start-up", 0,
        "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nSET;\nL C#5;\nS C 1;\nEND_ORGANIZATION_BLOCK\n" +
            ob1("A I 0.0;\nL C#5;\nS C 1;")}});
}

TEST(S5Rules, AStartSeesBothValuesOfItsRlo) {
  expectFindings("S5T002",
                 {{"behind JCN", 1, ob1("A I 0.0;\nJCN m;\nL S5T#1S;\nSE T 1;\nm: NOP 0;")},
                  {"behind JC of the inverse", 1, ob1("AN I 0.0;\nJC m;\nL S5T#1S;\nSP T 1;\nm: NOP 0;")},
                  {"SET", 1, ob1("SET;\nL S5T#1S;\nSD T 1;")},
                  {"CLR", 1, ob1("CLR;\nL S5T#1S;\nSD T 1;")},
                  {"SET, NOT", 1, ob1("SET;\nNOT;\nL S5T#1S;\nSD T 1;")},
                  {"a counter behind JNB", 1, ob1("A I 0.0;\nJNB m;\nCU C 1;\nm: NOP 0;")},
                  {"S C behind BEC", 1, ob1("A I 0.0;\nBEC;\nL C#5;\nS C 1;")},
                  {"a condition", 0, ob1("A I 0.0;\nL S5T#1S;\nSE T 1;")},
                  {"a condition behind the jump", 0, ob1("A I 0.0;\nJCN m;\nA I 0.1;\nL S5T#1S;\nSE T 1;\nm: NOP 0;")},
                  {"CLR elsewhere gives it the 0", 0,
                   ob1("A I 0.0;\nJCN m;\nSET;\nL S5T#1S;\nSD T 1;\nBEU;\nm: CLR;\nL S5T#1S;\nSD T 1;")},
                  {"freed", 0, ob1("SET;\nL S5T#1S;\nSD T 1;\nA I 0.0;\nFR T 1;")},
                  {"in the start-up", 0,
                   "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nSET;\nL C#5;\nS C 1;\nEND_ORGANIZATION_BLOCK\n" +
                       ob1("A C 1;\n= Q 0.0;")},
                  {"O of a 0", 0, ob1("CLR;\nO I 0.0;\nL S5T#1S;\nSD T 1;")}});
}

TEST(S5Rules, TimesAndCountsAreBcd) {
  expectFindings(
      "S5T003",
      {{"digit A", 1, ob1("A I 0.0;\nL W#16#00FA;\nSD T 1;")},
       {"digit above 9 for a counter", 1, ob1("A I 0.0;\nL W#16#001B;\nS C 1;")},
       {"a decimal number for a counter: 100 is 16#0064", 1, ob1("A I 0.0;\nL 100;\nS C 1;")},
       {"a decimal number for a timer", 1, ob1("A I 0.0;\nL 2000;\nSP T 1;")},
       {"a computed number", 1, ob1("L MW 0;\nL 5;\n+I;\nA I 0.0;\nS C 1;")},
       {"an INT of the block", 1, fc(1, "A I 0.0;\nL #N;\nS C 1;", "VAR_INPUT\nN : INT;\nEND_VAR\n")},
       {"another case of an INT", 1, fc(1, "A I 0.0;\nL #n;\nS C 1;", "VAR_INPUT\nN : INT;\nEND_VAR\n")},
       {"an INT of a data block", 1, db(1, "i : INT;") + ob1("A I 0.0;\nL DB1.i;\nSD T 1;")},
       {"an INT of a structure", 1, db(1, "s : STRUCT\ni : INT;\nEND_STRUCT;") + ob1("A I 0.0;\nL DB1.s.i;\nS C 1;")},
       {"an S5TIME of a data block", 0, db(1, "i : S5TIME;") + ob1("A I 0.0;\nL DB1.i;\nSD T 1;")},
       {"a WORD of the block", 0, fc(1, "A I 0.0;\nL #N;\nS C 1;", "VAR_INPUT\nN : WORD;\nEND_VAR\n")},
       {"an S5TIME of the block", 0, fb(1, "A I 0.0;\nL #N;\nSD T 1;", "VAR_INPUT\nN : S5TIME := S5T#1S;\nEND_VAR\n")},
       {"BTI", 1, ob1("L W#16#0A00;\nBTI;\nT MW 0;")},
       {"S5T#", 0, ob1("A I 0.0;\nL S5T#2S500MS;\nSD T 1;")},
       {"W#16# with base and digits: 127 at 1 s", 0, ob1("A I 0.0;\nL W#16#2127;\nSD T 1;")},
       {"C#", 0, ob1("A I 0.0;\nL C#100;\nS C 1;")},
       {"one digit is the same number", 0, ob1("A I 0.0;\nL 5;\nS C 1;")},
       {"from memory", 0, ob1("A I 0.0;\nL MW 10;\nSD T 1;")},
       {"converted", 0, ob1("L MW 0;\nL 5;\n+I;\nITB;\nA I 0.0;\nS C 1;")},
       {"BTI of digits", 0, ob1("L W#16#0123;\nBTI;\nT MW 0;")}});
}

TEST(S5Rules, IecTimersAreCalledInEveryScan) {
  const std::string timer = instanceDb(1, "SFB 4"), call = "CALL SFB 4, DB 1 (IN := I 0.1, PT := T#1S);\n";
  const std::string box =
      fb(1, "A I 0.0;\nJCN m;\nCALL #T1 (IN := I 0.1, PT := T#1S);\nm: NOP 0;", "VAR\nT1 : SFB 5;\nEND_VAR\n");
  expectFindings(
      "S5T004",
      {{"behind JCN", 1, timer + ob1("A I 0.0;\nJCN m;\n" + call + "m: NOP 0;")},
       {"behind BEC", 1, timer + ob1("A I 0.0;\nBEC;\n" + call)},
       {"a box with EN", 1, timer + ob1("A I 0.0;\nJNB _001;\n" + call + "_001: NOP 0;")},
       {"in a block that is called by CC", 1, timer + fc(1, call) + ob1("A I 0.0;\nCC FC 1;")},
       {"in a block whose call is jumped over", 1, timer + fc(1, call) + ob1("A I 0.0;\nJC m;\nCALL FC 1;\nm: NOP 0;")},
       {"a multi-instance", 1, box + instanceDb(2, "FB 1") + ob1("CALL FB 1, DB 2;")},
       {"always", 0, timer + ob1(call)},
       {"in a block that is always called", 0, timer + fc(1, call) + ob1("CALL FC 1;")},
       {"behind a label where the ways meet", 0, timer + ob1("A I 0.0;\nJC m;\nL 1;\nT MW 0;\nm: NOP 0;\n" + call)},
       {"called on both ways", 0, timer + ob1("A I 0.0;\nJC m;\n" + call + "JU e;\nm: " + call + "e: NOP 0;")},
       {"in the start-up, to begin with", 0,
        timer + "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nA I 0.0;\nJC m;\n" + call +
            "m: NOP 0;\nEND_ORGANIZATION_BLOCK\n" + ob1("A I 0.0;\n= Q 0.0;")},
       {"a counter may be left out", 0,
        instanceDb(3, "SFB 0") + ob1("A I 0.0;\nJCN m;\nCALL SFB 0, DB 3 (CU := I 0.1, PV := 5);\nm: NOP 0;")}});
}

TEST(S5Rules, ElementsThatAreReadAreWorkedSomewhere) {
  expectFindings("TIM009", {{"a timer no one starts", 1, ob1("A T 2;\n= Q 0.0;\nA I 0.0;\nL S5T#1S;\nSD T 1;")},
                            {"a counter no one counts", 1, ob1("L C 2;\nT MW 0;")},
                            {"reset only", 1, ob1("A I 0.0;\nR T 1;\nA T 1;\n= Q 0.0;")},
                            {"started", 0, ob1("A I 0.0;\nL S5T#1S;\nSD T 1;\nA T 1;\n= Q 0.0;")},
                            {"set", 0, ob1("A I 0.0;\nL C#5;\nS C 1;\nA C 1;\n= Q 0.0;")},
                            {"handed to a block", 0,
                             fc(1, "A I 0.0;\nL S5T#1S;\nSD #T;", "VAR_INPUT\nT : TIMER;\nEND_VAR\n") +
                                 ob1("CALL FC 1 (T := T 1);\nA T 1;\n= Q 0.0;")}});
}

TEST(S5Rules, EdgesThatMayBeSkipped) {
  expectFindings("TIM014",
                 {{"behind JCN", 1, ob1("A I 0.0;\nJCN m;\nA I 0.1;\nFP M 1.0;\nS Q 0.0;\nm: NOP 0;")},
                  {"behind BEC", 1, ob1("A I 0.0;\nBEC;\nA I 0.1;\nFN M 1.0;\nS Q 0.0;")},
                  {"in every scan", 0, ob1("A I 0.1;\nFP M 1.0;\nS Q 0.0;")},
                  {"behind the label", 0, ob1("A I 0.0;\nJC m;\nL 1;\nT MW 4;\nm: A I 0.1;\nFP M 1.0;\n= Q 0.0;")}});
}

/// TIM008 where MB100 is the clock memory: M100.5 has a period of 1 s, M100.7 one of 2 s.
std::size_t neverFires7(const std::string& text) {
  Linted linted(text, {*cpuNamed("319-3"), usualEdition(*cpuNamed("319-3"))});
  linted.program.clockMemory = 100;
  const Facts facts(linted.program);
  const RuleSettings settings;
  FindingSink sink(linted.program, settings);
  sink.begin(*ruleNamed("TIM008"));
  ruleNamed("TIM008")->check(facts, sink);
  return sink.take().size();
}

TEST(S5Rules, AClockBitIsShorterThanTheTimer) {
  const std::string read = "A T 1;\n= Q 0.0;";
  for (const char* const start :
       {"A M 100.5;\nL S5T#2S;\nSD T 1;\n", "AN M 100.5;\nL S5T#2S;\nSD T 1;\n",
        "A I 0.0;\nA M 100.5;\nA I 0.1;\nL S5T#2S;\nSD T 1;\n", "A M 100.7;\nL S5T#1M;\nSD T 1;\n",
        "A M 100.0;\nL W#16#0100;\nSD T 1;\n", "A I 0.0;\nFP M 1.0;\nL S5T#2S;\nSD T 1;\n"})
    EXPECT_EQ(neverFires7(ob1(std::string(start) + read)), 1U) << start;
  for (const char* const start :
       {"A M 100.5;\nL S5T#900MS;\nSD T 1;\n", "A M 100.5;\nL S5T#2S;\nSS T 1;\n",  // SS keeps running
        "A M 100.5;\nL S5T#2S;\nSE T 1;\n",                                         // SE runs on, too
        "A M 100.5;\nO I 0.0;\nL S5T#2S;\nSD T 1;\n", "A M 101.5;\nL S5T#2S;\nSD T 1;\n",
        "A M 100.5;\nL MW 10;\nSD T 1;\n", "A(;\nO M 100.5;\nO I 0.0;\n);\nL S5T#2S;\nSD T 1;\n",
        "A M 100.5;\nL S5T#2S;\nSD T 1;\nA I 0.0;\nL S5T#1S;\nSD T 1;\n"})  // two starts
    EXPECT_EQ(neverFires7(ob1(std::string(start) + read)), 0U) << start;
  Linted unknown(ob1("A M 100.5;\nL S5T#2S;\nSD T 1;\n" + read),
                 {*cpuNamed("319-3"), usualEdition(*cpuNamed("319-3"))});
  EXPECT_TRUE(unknown.of("TIM008").empty()) << "no clock memory is chosen";
}

}  // namespace
}  // namespace rungproof::testing
