// "did you mean": signs of other languages, look-alike letters, misspelt symbols; and no advice where nothing is near.
#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

class Meant : public testing::Test {
 protected:
  Meant() {
    program_ = folder_.file("p.awl", "SYMBOL_TABLE\nStart,I0.0,\nMotor,Q0.0,\nEND_SYMBOL_TABLE\n" +
                                         mainBlock("Network 1\nLD Start\nAN I0.1\n= Motor\n"));
  }
  ProgramRun prove(const std::string& statement) {
    return run({"prove", program_, "--props", folder_.file("p.prop", "prove x: " + statement + "\n")});
  }
  TemporaryFolder folder_;
  std::string program_;
};

TEST_F(Meant, SignsOfOtherLanguages) {
  const std::vector<std::pair<std::string, std::string>> statements = {
      {"never Motor && I0.1", "and"},           {"never Motor & I0.1", "and"},    {"Start || not Motor", "or"},
      {"Motor -> not I0.1", "implies"},         {"Motor=>not I0.1", "implies"},   {"!Motor or Start", "not"},
      {"Motor implies !I0.1", "not"},           {"Motor != I0.1 or Start", "<>"}, {"never (Motor || Start)", "or"},
      {"always Start or (Motor ^ I0.1)", "xor"}};
  for (const auto& [statement, word] : statements) {
    const ProgramRun result = prove(statement);
    EXPECT_EQ(result.exit, 2) << statement;
    EXPECT_TRUE(result.says("did you mean '" + word + "'?")) << statement << result.out;
  }
}

TEST_F(Meant, NamesThatAreNear) {
  EXPECT_TRUE(prove("never QO.0").says("did you mean 'Q0.0'?"));  // a letter for the digit
  EXPECT_TRUE(prove("never Motr").says("did you mean 'Motor'?"));
  EXPECT_TRUE(prove("never Strat and Motor").says("did you mean 'Start'?"));
  EXPECT_TRUE(prove("never Conveyor").says("give the symbol table with --symbols"));
  EXPECT_TRUE(prove("never Q 0.0").says("write Q0.0, without a blank"));
}

/// A name in quotation marks is a symbol, as a statement list of the S7-200 has it too, and never an address.
TEST_F(Meant, QuotedNamesAreSymbols) {
  EXPECT_EQ(prove("\"Motor\" implies \"Start\"").exit, 0);
  EXPECT_TRUE(prove("never \"Motr\"").says("did you mean '\"Motor\"'?"));
  EXPECT_TRUE(prove("never \"Q0.0\"").says("'\"Q0.0\"' is no address and no known symbol"));
  // Letters that look like Latin ones make no name of the program.
  const ProgramRun cyrillic = prove("never \"\u041D\u0430\u0441\u043E\u0441\"");
  EXPECT_EQ(cyrillic.exit, 2);
  EXPECT_FALSE(cyrillic.says("did you mean")) << cyrillic.out;
  EXPECT_TRUE(cyrillic.says("give the symbol table with --symbols")) << cyrillic.out;
  const std::string named = folder_.file("n.awl",
                                         "SYMBOL_TABLE\n\u041D\u0430\u0441\u043E\u0441,Q0.0,\nEND_SYMBOL_TABLE\n"
                                         "//@ prove x: \"\u041D\u0430\u0441\u043E\u0441\" implies I0.0\n" +
                                             mainBlock("Network 1\nLD I0.0\n= Q0.0\n"));
  const ProgramRun found = run({"prove", "--isolated", named});
  EXPECT_EQ(found.exit, 0) << found.out << found.err;
  const std::string iec = folder_.file(
      "i.st", "PROGRAM Main\nVAR Motor AT %QX0.0, Start AT %IX0.0 : BOOL; END_VAR\nMotor := Start;\nEND_PROGRAM\n");
  const std::string statement = folder_.file("i.prop", "prove x: \"Motor\" implies \"Start\"\n");
  EXPECT_EQ(run({"prove", "--isolated", iec, "--props", statement}).exit, 0);
}

TEST_F(Meant, MisspeltWordsOfTheLanguage) {
  const std::vector<std::pair<std::string, std::string>> statements = {
      {"Start adn Motor", "and"},
      {"Motor impiles Start", "implies"},
      {"nevr Motor and I0.1", "never"},
      {"Motor leads to Start wihtin 3 scans", "within"},
      {"Motor only aftr Start", "after"},
      {"rise(Motor) implies Start", "rises"},
      {"T37.valeu > 5 or Motor", "T37.value"},
      {"VW10 => 5", ">="},
      {"VW10 =< 5", "<="},
      {"Q0,0 or Motor", "Q0.0"}};
  for (const auto& [statement, word] : statements) {
    const ProgramRun result = prove(statement);
    EXPECT_EQ(result.exit, 2) << statement;
    EXPECT_TRUE(result.says("did you mean '" + word + "'?")) << statement << result.out;
  }
  EXPECT_TRUE(run({"prove", program_, "--props", folder_.file("h.prop", "prov x: never Motor\n")})
                  .says("did you mean 'prove'?"));
  // A word of the language in a wrong place is not misspelt.
  EXPECT_FALSE(prove("never Motor within I0.1").says("did you mean"));
}

/// Addresses and names of the other families.
TEST_F(Meant, NamesOfEachFamily) {
  const std::string step7 = folder_.file("m.awl",
                                         "DATA_BLOCK DB 1\nSTRUCT\n Speed : INT;\n Run : BOOL;\nEND_STRUCT\nBEGIN\n"
                                         "END_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
                                         "U E 0.0;\n= A 4.0;\n= DB1.DBX2.0;\nEND_ORGANIZATION_BLOCK\n");
  const std::string iec =
      folder_.file("i.st", "PROGRAM Main\nVAR Motor, Start : BOOL; T1 : TON; END_VAR\nMotor := Start;\nEND_PROGRAM\n");
  struct Case {
    std::string program, statement, meant;
  };
  const std::vector<Case> cases = {{step7, "never AO.0", "A0.0"},          {step7, "A4.O implies E0.0", "A4.0"},
                                   {step7, "A4,0 implies E0.0", "A4.0"},   {step7, "DB1.Sped > 5", "DB1.Speed"},
                                   {step7, "never DB1.Rnu", "DB1.Run"},    {iec, "never Motr", "Motor"},
                                   {iec, "never Main.Moter", "Main.Motor"}};
  for (const Case& c : cases) {
    const ProgramRun result = run({"prove", c.program, "--props", folder_.file("f.prop", "prove x: " + c.statement)});
    EXPECT_EQ(result.exit, 2) << c.statement;
    EXPECT_TRUE(result.says("did you mean '" + c.meant + "'?")) << c.statement << result.out;
  }
}

/// A property file that cannot be read comes before the verdicts.
TEST_F(Meant, IsTheFirstThingSaid) {
  const ProgramRun result = run(
      {"prove", program_, "--props", folder_.file("b.prop", "prove a: Motor implies Start\nprove b: never Motr\n")});
  ASSERT_TRUE(result.says("PROVED  a") && result.says("PRP002")) << result.out;
  EXPECT_LT(result.out.find("PRP002"), result.out.find("PROVED  a")) << result.out;
}

/// The fix replaces the sign alone, with blanks where it touches its neighbours.
TEST_F(Meant, TheFixCanBeRead) {
  const std::string file =
      folder_.file("q.awl", "//@ prove x: never Motor&&I0.1\nSYMBOL_TABLE\nMotor,Q0.0,\nEND_SYMBOL_TABLE\n" +
                                mainBlock("Network 1\nLD I0.0\nAN I0.1\n= Motor\n"));
  EXPECT_EQ(run({"lint", file, "--fix", "--unsafe-fixes"}).exit, 0);
  EXPECT_NE(contentOf(file).find("never Motor and I0.1\n"), std::string::npos) << contentOf(file);
}

}  // namespace
}  // namespace rungproof::test
