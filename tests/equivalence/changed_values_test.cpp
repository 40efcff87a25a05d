// What diff says of values with which programs begin, and of networks of an S7-300/400: the access of a function block
// to its own instance is no pointer of the program.
#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

class ChangedValues : public testing::Test {
 protected:
  test::ProgramRun diffOf(const std::string& before, const std::string& after, const std::string& ending = ".awl") {
    folder_.file("old" + ending, before);
    folder_.file("new" + ending, after);
    return test::run({"diff", folder_.path("old" + ending), folder_.path("new" + ending), "--isolated"});
  }
  test::TemporaryFolder folder_;
};

std::string counter(const std::string& first) {
  return "FUNCTION_BLOCK FB 1\nVAR_INPUT\n a : BOOL;\nEND_VAR\nVAR_OUTPUT\n q : BOOL;\nEND_VAR\nVAR\n n : INT" + first +
         ";\nEND_VAR\nBEGIN\nNETWORK\n A #a;\n = #q;\nNETWORK\n L #n;\n L 1;\n +I;\n T #n;\nEND_FUNCTION_BLOCK\n"
         "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n"
         "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n CALL FB 1, DB 1 (a := I 0.0, q := Q 0.0);\nNETWORK\n A M 5.0;\n = "
         "Q 0.1;\n"
         "NETWORK\n L DB1.n;\n T QW 4;\nEND_ORGANIZATION_BLOCK\n";
}

// Only the coil differs: it has no part in Q 0.0 or in the instance.
TEST_F(ChangedValues, AFunctionBlockElsewhereIsNotInfluenced) {
  std::string after = counter("");
  after.replace(after.find(" A M 5.0"), 8, " AN M 5.0");
  const test::ProgramRun run = diffOf(counter(""), after);
  EXPECT_TRUE(run.says("OB1, Network 2: changed")) << run.out;
  EXPECT_TRUE(run.says("= can differ: Q0.1\n")) << run.out;
  EXPECT_FALSE(run.says("may influence any memory")) << run.out;
  EXPECT_FALSE(run.says("proved equal")) << run.out;  // nothing else is in its reach
}

// A network of the function block reaches its instance, and what reads it.
TEST_F(ChangedValues, AFunctionBlockInfluencesItsInstance) {
  std::string after = counter("");
  after.replace(after.find(" L 1;"), 5, " L 2;");
  const test::ProgramRun run = diffOf(counter(""), after);
  EXPECT_TRUE(run.says("FB1, Network 2: changed")) << run.out;
  EXPECT_TRUE(run.says("influences: DB1.DBW4")) << run.out;
  EXPECT_FALSE(run.says("Q0.1")) << run.out;
}

// n begins with 5: the output word shows it, and no network has changed.
TEST_F(ChangedValues, StartValuesOfDataBlocks) {
  const test::ProgramRun run = diffOf(counter(""), counter(" := 5"));
  EXPECT_TRUE(run.says("value: DB1.n begins with 5 in place of 0\n")) << run.out;
  EXPECT_TRUE(run.says("0 networks changed, 1 first value changed, ")) << run.out;
  EXPECT_EQ(run.exit, 1);
}

/// One program reads a bit of a block that the other has not.
TEST_F(ChangedValues, DataBlocksThatOneProgramHas) {
  std::string more = "DATA_BLOCK DB 2\nSTRUCT\n x : BOOL;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n" + counter("");
  more.replace(more.find(" A M 5.0"), 8, " A DB2.DBX0.0");
  EXPECT_TRUE(diffOf(counter(""), more).says("value: DB2 is new\n"));
  EXPECT_TRUE(diffOf(more, counter("")).says("value: DB2 is gone\n"));
}

TEST_F(ChangedValues, Variables) {
  const auto program = [](const std::string& first) {
    return "PROGRAM Main\nVAR\n n : INT := " + first +
           ";\nEND_VAR\nVAR_OUTPUT\n q : INT;\nEND_VAR\nq := n;\nEND_PROGRAM\n";
  };
  const test::ProgramRun run = diffOf(program("1"), program("2"), ".st");
  EXPECT_TRUE(run.says("begins with 16#0002 in place of 16#0001")) << run.out << run.err;
}

}  // namespace
}  // namespace rungproof
