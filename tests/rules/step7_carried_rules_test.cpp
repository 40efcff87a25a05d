// Rules of both families on programs of the S7-300/400: found and not found. Each case gives its reason.
#include "ir/s7200/cpu.hpp"
#include "tests/rules/step7_cases.hpp"

namespace rungproof::testing {
namespace {

const std::string startUp = "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nSET;\nR Q 0.0;\nEND_ORGANIZATION_BLOCK\n";

TEST(CarriedRules, CoilsAndLatches) {
  expectFindings(
      "OUT001",
      {{"two coils", 1, ob1("A I 0.0;\n= Q 0.0;\nA I 0.1;\n= Q 0.0;")},
       {"in two blocks", 1, fc(1, "A I 0.1;\n= Q 0.0;") + ob1("A I 0.0;\n= Q 0.0;\nCALL FC 1;")},
       {"a bit of a data block", 1, db(1, "X : BOOL;") + ob1("A I 0.0;\n= DB1.DBX 0.0;\nA I 0.1;\n= DB1.DBX 0.0;")},
       {"one coil", 0, ob1("A I 0.0;\nO I 0.1;\n= Q 0.0;")},
       {"either here or there", 0, ob1("A I 0.0;\nJC m;\nA I 0.1;\n= Q 0.0;\nBEU;\nm: A I 0.2;\n= Q 0.0;")},
       {"given a first value in the start-up", 0,
        "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nCLR;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n" +
            ob1("A I 0.0;\n= Q 0.0;")},
       {"two outputs of one string", 0, ob1("A I 0.0;\n= Q 0.0;\n= Q 0.1;")},
       {"the compiler's bits of parameters", 0, ob1("A I 0.0;\n= L 20.0;\nA L 20.0;\n= Q 0.0;\nA I 0.1;\n= L 20.0;")}});
  expectFindings("OUT002", {{"= and S", 1, ob1("A I 0.0;\n= Q 0.0;\nA I 0.1;\nS Q 0.0;")},
                            {"= and R", 1, ob1("A I 0.0;\n= Q 0.0;\nA I 0.1;\nR Q 0.0;")},
                            {"S and R", 0, ob1("A I 0.0;\nS Q 0.0;\nA I 0.1;\nR Q 0.0;")},
                            {"R in the start-up", 0, startUp + ob1("A I 0.0;\n= Q 0.0;")},
                            {"a first value in the start-up", 0,
                             "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nCLR;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n" +
                                 ob1("A I 0.0;\nS Q 0.0;\nA I 0.1;\nR Q 0.0;")}});
  expectFindings("OUT004", {{"S alone", 1, ob1("A I 0.0;\nS Q 0.0;")},
                            {"R alone", 1, ob1("A I 0.0;\nR Q 0.0;")},
                            {"S and R", 0, ob1("A I 0.0;\nS Q 0.0;\nA I 0.1;\nR Q 0.0;")},
                            {"cleared by a byte", 0, ob1("A I 0.0;\nS Q 0.0;\nL 0;\nT QB 0;")}});
  expectFindings("OUT006", {{"an OB and an interrupt", 1,
                             "ORGANIZATION_BLOCK OB 35\nBEGIN\nNETWORK\nA I 0.0;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n" +
                                 ob1("A I 0.1;\n= Q 0.0;")},
                            {"one block", 0, ob1("A I 0.0;\n= Q 0.0;")},
                            {"the start-up and a scan", 0, startUp + ob1("A I 0.0;\nS Q 0.0;\nA I 0.1;\nR Q 0.0;")}});
}

TEST(CarriedRules, NumbersAndNames) {
  expectFindings("ARI004", {{"==R", 1, ob1("L MD 0;\nL 1.5;\n==R;\n= Q 0.0;")},
                            {"<>R", 1, ob1("L MD 0;\nL 1.5;\n<>R;\n= Q 0.0;")},
                            {">R", 0, ob1("L MD 0;\nL 1.5;\n>R;\n= Q 0.0;")},
                            {"==D", 0, ob1("L MD 0;\nL L#5;\n==D;\n= Q 0.0;")}});
}

TEST(CarriedRules, ResultsThatTwoLoadsPushOut) {
  expectFindings(
      "ARI007",
      {{"the program of 002:1454-1476", 1, ob1("L MD 0;\nL MD 4;\n+D;\nL MD 8;\nL MD 12;\n-D;\n*D;\nT MD 16;")},
       {"reals", 1, ob1("L MD 0;\nL 2.0;\n/R;\nL MD 8;\nL MD 12;\n-R;\n*R;\nT MD 16;")},
       {"NOP between", 1, ob1("L MD 0;\nL MD 4;\n+D;\nL MD 8;\nL MD 12;\n-D;\nNOP 0;\n*D;\nT MD 16;")},
       {"one value after the other", 0, ob1("L MD 0;\nL MD 4;\n+D;\nL MD 8;\n-D;\nL MD 12;\n*D;\nT MD 16;")},
       {"stored in between", 0,
        ob1("L MD 0;\nL MD 4;\n+D;\nT MD 20;\nL MD 8;\nL MD 12;\n-D;\nL MD 20;\n*D;\nT MD 16;")},
       {"with ENT", 0, ob1("L MD 0;\nL MD 4;\n+D;\nL MD 8;\nENT;\nL MD 12;\n-D;\n*D;\nT MD 16;")},
       {"the same operand twice, with no earlier result: 2 a - b is meant", 0,
        ob1("L MD 8;\nL MD 12;\n-D;\n+D;\nT MD 16;")}});
}

TEST(CarriedRules, CommentsOfNetworks) {
  expectFindings("STY001", {{"none", 1, ob1("A I 0.0;\n= Q 0.0;")},
                            {"a title", 0, ob1("TITLE = motor\nA I 0.0;\n= Q 0.0;")},
                            {"a comment", 0, ob1("// motor\nA I 0.0;\n= Q 0.0;")}});
}

/// Names of a table next to the text of OB1.
std::vector<std::string> named(const char* rule, std::string_view symbols, const std::string& text) {
  const Cpu cpu = *cpuNamed("319-3");
  std::vector<std::string> addresses;
  for (const Finding& finding : Linted(text, {cpu, usualEdition(cpu)}, symbols).of(rule))
    addresses.push_back(finding.address);
  return addresses;
}

TEST(CarriedRules, SymbolTables) {
  const std::string text = ob1("A \"Start\";\n= \"Motor\";");
  const std::string table = "Start;I 0.0;BOOL;button\nMotor;Q 0.0;BOOL;contactor\n";
  EXPECT_EQ(named("SYM002", table, text), std::vector<std::string>());
  EXPECT_EQ(named("SYM002", table + "Pump;Q 0.0;BOOL;again\n", text), std::vector<std::string>{"Q0.0"});
  EXPECT_EQ(named("SYM003", table, text), std::vector<std::string>());
  EXPECT_EQ(named("SYM003", table + "Lamp;Q 0.5;BOOL;\n", text), std::vector<std::string>{"Q0.5"});
}

TEST(CarriedRules, OfTheOtherFamilyNoneSpeaks) {
  const Cpu cpu = *cpuNamed("319-3");
  const Linted linted(ob1("A I 0.0;\nL S5T#1S;\nSD T 1;\nA T 1;\n= Q 0.0;"), {cpu, usualEdition(cpu)});
  EXPECT_EQ(linted.all(), std::vector<std::string>());
}

}  // namespace
}  // namespace rungproof::testing
