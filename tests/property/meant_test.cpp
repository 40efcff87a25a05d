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
