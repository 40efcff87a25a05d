// Rules on what stands in the accumulators of an S7-300/400: numbers below 0, constants that do not fit, pointers,
// counts of loops, and logic results that nothing asks. Each case gives its reason.
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

TEST(NumberRules7, RootsOfNegativeNumbers) {
  expectFindings("ARI009", {{"a difference", 1, ob1("L MD 0;\nL MD 4;\n-R;\nSQRT;\nT MD 8;")},
                            {"its logarithm", 1, ob1("L MD 0;\nL MD 4;\n-R;\nLN;\nT MD 8;")},
                            {"the other sign", 1, ob1("L MD 0;\nNEGR;\nSQRT;\nT MD 8;")},
                            {"a sine", 1, ob1("L MD 0;\nSIN;\nSQRT;\nT MD 8;")},
                            {"a cosine", 1, ob1("L MD 0;\nCOS;\nT MD 4;\nSQRT;\nT MD 8;")},
                            {"a constant", 1, ob1("L -2.0;\nSQRT;\nT MD 8;")},
                            {"ABS between", 0, ob1("L MD 0;\nL MD 4;\n-R;\nABS;\nSQRT;\nT MD 8;")},
                            {"a square", 0, ob1("L MD 0;\nSQR;\nSQRT;\nT MD 8;")},
                            {"a sum", 0, ob1("L MD 0;\nL MD 4;\n+R;\nSQRT;\nT MD 8;")},
                            {"a positive constant", 0, ob1("L 2.0;\nSQRT;\nT MD 8;")},
                            {"OV is asked", 0, ob1("L MD 0;\nL MD 4;\n-R;\nSQRT;\nJO m;\nT MD 8;\nm: NOP 0;")},
                            {"loaded anew", 0, ob1("L MD 0;\nL MD 4;\n-R;\nT MD 8;\nL MD 12;\nSQRT;\nT MD 8;")},
                            {"no root", 0, ob1("L MD 0;\nL MD 4;\n-R;\nSQR;\nT MD 8;")}});
}

TEST(NumberRules7, ConstantsThatDoNotFit) {
  expectFindings("ARI010", {{"a sum of words, 40000", 1, ob1("L 30000;\nL 10000;\n+I;\nT MW 0;")},
                            {"a difference, -40000", 1, ob1("L -30000;\nL 10000;\n-I;\nT MW 0;")},
                            {"a product, 90000", 1, ob1("L 300;\nL 300;\n*I;\nT MW 0;")},
                            {"of double words, 2^32", 1, ob1("L L#65536;\nL L#65536;\n*D;\nT MD 0;")},
                            {"a sum of double words", 1, ob1("L L#2000000000;\nL L#2000000000;\n+D;\nT MD 0;")},
                            {"a product in a double word", 0, ob1("L 200;\nL 200;\n*I;\nT MD 0;")},
                            {"of double words in one", 1, ob1("L L#65536;\nL L#65536;\n*D;\nT MD 0;")},
                            {"a step, 32768", 1, ob1("L 32767;\n+ 1;\nT MW 0;")},
                            {"the last that fits", 0, ob1("L 32766;\n+ 1;\nT MW 0;")},
                            {"the lowest that fits", 0, ob1("L -32767;\nL 1;\n-I;\nT MW 0;")},
                            {"32 bits", 0, ob1("L L#30000;\nL L#10000;\n+D;\nT MD 0;")},
                            {"a step of 32 bits", 0, ob1("L L#32767;\n+ L#1;\nT MD 0;")},
                            {"memory", 0, ob1("L MW 2;\nL 30000;\n+I;\nT MW 0;")},
                            {"a quotient", 0, ob1("L 30000;\nL 10000;\n/I;\nT MW 0;")},
                            {"REAL", 0, ob1("L 3.0e30;\nL 1.0e4;\n*R;\nT MD 0;")}});
}

TEST(NumberRules7, BytesTakenAsPointers) {
  const std::string local = "VAR_TEMP\n  i : INT;\n  d : DINT;\n  p : DWORD;\nEND_VAR\n";
  const auto inFc = [&](const std::string& statements) { return fc(1, statements, local) + ob1("CALL FC 1;"); };
  expectFindings("PTR006", {{"a word", 1, ob1("L MW 10;\nT MD 20;\nL MW [MD 20];\nT QW 0;")},
                            {"a byte", 1, ob1("L MB 10;\nT MD 20;\nL MB [MD 20];\nT QB 0;")},
                            {"a word into AR1", 1, ob1("L MW 10;\nLAR1;\nL W [AR1,P#0.0];\nT QW 0;")},
                            {"a number in the midst of a byte", 1, ob1("L 10;\nT MD 20;\nL MW [MD 20];\nT QW 0;")},
                            {"an INT of the block", 1, inFc("L #i;\nT #p;\nL MW [#p];\nT QW 0;")},
                            {"for a store", 1, ob1("L MW 10;\nT MD 20;\nL IW 0;\nT MW [MD 20];")},
                            {"into AR2", 1, ob1("L IW 10;\nLAR2;\nL W [AR2,P#0.0];\nT QW 0;")},
                            {"shifted", 0, ob1("L MW 10;\nSLD 3;\nT MD 20;\nL MW [MD 20];\nT QW 0;")},
                            {"multiplied", 0, ob1("L MW 10;\nL 8;\n*I;\nT MD 20;\nL MW [MD 20];\nT QW 0;")},
                            {"a pointer", 0, ob1("L P#10.0;\nT MD 20;\nL MW [MD 20];\nT QW 0;")},
                            {"a double word", 0, ob1("L MD 10;\nT MD 20;\nL MW [MD 20];\nT QW 0;")},
                            {"a whole byte", 0, ob1("L 80;\nT MD 20;\nL MW [MD 20];\nT QW 0;")},
                            {"a bit", 0, ob1("L 10;\nT MD 20;\nA M [MD 20];\n= Q 0.0;")},
                            {"a DINT of the block", 0, inFc("L #d;\nT #p;\nL MW [#p];\nT QW 0;")},
                            {"the number of a timer", 0, ob1("L MW 10;\nT MW 20;\nA T [MW 20];\n= Q 0.0;")},
                            {"stored anew", 0, ob1("L MW 10;\nT MD 20;\nL P#4.0;\nT MD 20;\nL MW [MD 20];\nT QW 0;")}});
}

TEST(NumberRules7, LoopsCountTheirRounds) {
  const std::string body = "L MW 14;\n+ 1;\nT MW 14;\n";
  expectFindings(
      "CTL011",
      {{"the count is kept and not loaded", 1, ob1("L 5;\nm: T MW 12;\n" + body + "LOOP m;")},
       {"another word", 1, ob1("L 5;\nm: T MW 12;\n" + body + "L MW 16;\nLOOP m;")},
       {"a constant", 1, ob1("L 5;\nm: T MW 12;\n" + body + "L 5;\nLOOP m;")},
       {"the preset again", 1, ob1("L MW 10;\nm: T MW 12;\n" + body + "L MW 10;\nLOOP m;")},
       {"a result on top", 1, ob1("L 5;\nm: T MW 12;\nL MW 14;\n+ 1;\nLOOP m;")},
       {"nothing is stored", 1, ob1("L 5;\nm: L MW 14;\nT QW 0;\nL MW 16;\nLOOP m;")},
       {"as it should be", 0, ob1("L 5;\nm: T MW 12;\n" + body + "L MW 12;\nLOOP m;")},
       {"only bits in the loop", 0, ob1("L 5;\nm: NOP 0;\nA I 0.0;\n= Q 0.0;\nLOOP m;")},
       {"stored at the end", 0, ob1("L 5;\nm: NOP 0;\nT MW 12;\n" + body + "L MW 12;\nLOOP m;")},
       {"stored elsewhere in the loop", 0,
        ob1("L 5;\nm: T MW 12;\n" + body + "L MW 12;\n+ -1;\nT MW 16;\nL MW 16;\nLOOP m;")},
       {"a call may store it", 0, fc(1, "NOP 0;") + ob1("L 5;\nm: NOP 0;\nCALL FC 1;\nL MW 12;\nLOOP m;")},
       {"a register keeps it", 0, ob1("L 5;\nm: T MW 12;\n" + body + "L MW 12;\nA I 0.0;\n= Q 0.1;\nLOOP m;")}});
}

TEST(NumberRules7, LogicResultsAreAsked) {
  const std::string block = fc(1, "SET;\nS Q 4.0;");
  expectFindings("NST007", {{"a call", 1, block + ob1("A I 0.0;\nCALL FC 1;")},
                            {"UC", 1, block + ob1("A I 0.0;\nAN I 0.1;\nUC FC 1;")},
                            {"a load and a call", 1, block + ob1("A I 0.0;\nL MW 0;\nT MW 2;\nCALL FC 1;")},
                            {"SET", 1, ob1("A I 0.0;\nSET;\n= Q 0.0;")},
                            {"CLR", 1, ob1("O I 0.0;\nCLR;\n= Q 0.0;")},
                            {"the end of OB1", 1, ob1("A I 0.1;\n= Q 0.0;\nA I 0.0;\nL MW 0;\nT MW 2;")},
                            {"parentheses", 1, block + ob1("A(;\nO I 0.0;\nO I 0.1;\n);\nCALL FC 1;")},
                            {"CC", 0, block + ob1("A I 0.0;\nCC FC 1;")},
                            {"a jump", 0, block + ob1("A I 0.0;\nJCN m;\nCALL FC 1;\nm: NOP 0;")},
                            {"an assignment", 0, block + ob1("A I 0.0;\n= Q 0.0;\nCALL FC 1;")},
                            {"a timer behind a load", 0, ob1("A I 0.0;\nL S5T#1S;\nSD T 1;")},
                            {"a drawn call", 0, block + ob1("A I 0.0;\nJNB _001;\nCALL FC 1;\n_001: A BR;\n= Q 0.0;")},
                            {"the end of an FC", 0, fc(1, "A I 0.0;") + ob1("UC FC 1;\n= Q 0.0;")},
                            {"another path asks it", 0, block + ob1("A I 0.0;\nJC m;\nCALL FC 1;\nm: NOP 0;")},
                            {"SAVE", 0, block + ob1("A I 0.0;\nSAVE;\nCALL FC 1;\nA BR;\n= Q 0.0;")}});
}

}  // namespace
}  // namespace rungproof::testing
