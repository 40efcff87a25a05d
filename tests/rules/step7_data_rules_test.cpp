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

}  // namespace
}  // namespace rungproof::testing
