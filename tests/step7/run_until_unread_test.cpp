// What no run comes to spoils nothing: sim runs, and ends in the scan that comes to what was not read; equiv, diff and
// test tell their verdicts beside the errors. Exit code 2 says that not everything could be read.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::Output, test7::run;

/// FC 9 needs a name that no table has, FC 8 a type, DB 9 another; `calls` stands in OB 1.
std::string programOf(const std::string& calls, const std::string& output = "Q 0.0") {
  return "FUNCTION FC 9 : VOID\nBEGIN\nNETWORK\n A \"nope\";\n = M 1.0;\nEND_FUNCTION\n"
         "FUNCTION FC 8 : VOID\nVAR_TEMP\n u : UDT 77;\nEND_VAR\nBEGIN\nNETWORK\n A M 0.0;\n = M 1.1;\nEND_FUNCTION\n"
         "FUNCTION FC 7 : VOID\nBEGIN\nNETWORK\n FROB I 0.0;\nEND_FUNCTION\n"
         "DATA_BLOCK DB 9\nUDT 88\nBEGIN\nEND_DATA_BLOCK\n"
         "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n A I 0.0;\n = " +
         output + ";\nNETWORK\n" + calls + "\nNETWORK\n A M 1.0;\n = Q 0.1;\nEND_ORGANIZATION_BLOCK\n";
}

class RunUntilUnreadTest : public ::testing::Test {
 protected:
  Output simOf(const std::string& calls, const std::string& stimulus, const std::vector<std::string>& more = {}) {
    folder_.file("main.awl", programOf(calls));
    folder_.file("in.csv", stimulus);
    std::vector<std::string> arguments = {"sim", folder_.path("main.awl"), "--stimulus", folder_.path("in.csv")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  test::TemporaryFolder folder_;
};

// I5.0 stays 0: FC 9 is never called, and M1.0, which only FC 9 would write, is 0 as it began.
TEST_F(RunUntilUnreadTest, RunsThatDoNotComeToItAreRun) {
  const Output output = simOf("A I 5.0;\n CC FC 9;", "scan,I0.0,I5.0\n1,1,0\n2,0,0\n");
  EXPECT_TRUE(output.has("scan,time_ms,scan_ms,I0.0,I5.0,Q0.0,Q0.1,M1.0\n1,10,10,1,0,1,0,0\n2,20,10,0,0,0,0,0\n"))
      << output.text;
  EXPECT_FALSE(output.has("the run ends")) << output.text;
  EXPECT_EQ(output.exit, 2);
}

// In scan 2 it is called: scan 1 is the last one of which something is known.
TEST_F(RunUntilUnreadTest, RunsThatComeToItEndThere) {
  const Output output = simOf("A I 5.0;\n CC FC 9;", "scan,I0.0,I5.0\n1,1,0\n2,1,1\n3,1,0\n");
  EXPECT_TRUE(output.has("\n1,10,10,1,0,1,0,0\n")) << output.text;
  EXPECT_FALSE(output.has("\n2,20")) << output.text;
  EXPECT_TRUE(
      output.has("the run ends in scan 2, in FC9, network 1: it comes to what was not read: "
                 "nothing defines \"nope\""))
      << output.text;
  EXPECT_EQ(output.exit, 2);
}

// Nothing at all of that network could be read.
TEST_F(RunUntilUnreadTest, EmptyNetworksEndItToo) {
  const Output output = simOf("A I 5.0;\n CC FC 7;", "scan,I0.0,I5.0\n1,1,0\n2,1,1\n3,1,0\n");
  EXPECT_TRUE(output.has("\n1,10,10,1,0,1,")) << output.text;
  EXPECT_FALSE(output.has("\n2,20")) << output.text;
  EXPECT_TRUE(output.has("the run ends in scan 2, in FC7, network 1: ")) << output.text;
}

// A block that the files do not have ends the run where it is called, and an expected trace is compared up to there.
TEST_F(RunUntilUnreadTest, MissingBlocksEndIt) {
  const Output output = simOf("A I 5.0;\n JCN over;\n CALL FC 99;\nover: NOP 0;", "scan,I0.0,I5.0\n1,1,0\n2,1,1\n",
                              {"--trace", folder_.path("run.csv")});
  EXPECT_TRUE(output.has("the run ends in scan 1, in OB1, network 2: ")) << output.text;  // its whole network
  EXPECT_EQ(output.exit, 2);
}

// What DB 9 holds is not known: a run ends where it is used.
TEST_F(RunUntilUnreadTest, DataThatNobodyKnowsEndsIt) {
  const Output output = simOf("A I 5.0;\n JCN over;\nNETWORK\n L DB9.DBW 0;\n T MW 20;\nNETWORK\nover: NOP 0;",
                              "scan,I0.0,I5.0\n1,1,0\n2,1,1\n3,1,0\n");
  EXPECT_TRUE(output.has("the run ends in scan 2, in OB1, network 3: ")) << output.text;
  EXPECT_TRUE(output.has("\n1,10,10,1,0,1")) << output.text;
  EXPECT_FALSE(output.has("\n2,20")) << output.text;
}

// What stands behind the end would be another run: that it stops the CPU is not told.
TEST_F(RunUntilUnreadTest, NothingBehindTheEndIsTold) {
  const Output output = simOf("A I 5.0;\n CC FC 9;\nNETWORK\n A I 5.0;\n CC SFC 46;", "scan,I0.0,I5.0\n1,1,0\n2,1,1\n");
  EXPECT_TRUE(output.has("the run ends in scan 2, in FC9, network 1")) << output.text;
  EXPECT_FALSE(output.has("STOP")) << output.text;
}

// Nobody calls FC 9: both programs are wholly known as far as they run.
TEST_F(RunUntilUnreadTest, VerdictsStandBesideWhatNeverRuns) {
  folder_.file("old.awl", programOf("NOP 0;"));
  folder_.file("same.awl", programOf("NOP 1;"));
  folder_.file("new.awl", programOf("NOP 0;", "Q 0.2"));
  const Output equal = run({"equiv", folder_.path("old.awl"), folder_.path("same.awl")});
  EXPECT_TRUE(equal.has("EQUAL")) << equal.text;
  EXPECT_TRUE(equal.has("nothing defines \"nope\"")) << equal.text;
  EXPECT_EQ(equal.exit, 2);
  const Output different = run({"equiv", folder_.path("old.awl"), folder_.path("new.awl")});
  EXPECT_TRUE(different.has("DIFFERENT")) << different.text;
  EXPECT_EQ(different.exit, 2);
  const Output changed = run({"diff", folder_.path("old.awl"), folder_.path("new.awl")});
  EXPECT_TRUE(changed.has("OB1, Network 1: changed")) << changed.text;
  EXPECT_TRUE(changed.has("can differ: Q0.0, Q0.2")) << changed.text;
  EXPECT_EQ(changed.exit, 2);
}

// FC 9 may be called: whether the CPU goes on there nobody knows.
TEST_F(RunUntilUnreadTest, NoVerdictBesideWhatMayRun) {
  folder_.file("old.awl", programOf("A I 5.0;\n CC FC 9;"));
  const Output output = run({"equiv", folder_.path("old.awl"), folder_.path("old.awl")});
  EXPECT_FALSE(output.has("EQUAL")) << output.text;
  EXPECT_EQ(output.exit, 2);
}

TEST_F(RunUntilUnreadTest, TestsRunBesideWhatNeverRuns) {
  folder_.file("main.awl", programOf("NOP 0;"));
  folder_.file("table.csv", "test,set I0.0,expect Q0.0\nfollows,1,1\n,0,0\n");
  const Output output = run({"test", folder_.path("main.awl"), "--table", folder_.path("table.csv")});
  EXPECT_FALSE(output.has("the program is not tested")) << output.text;
  EXPECT_TRUE(output.has("passed")) << output.text;
  EXPECT_TRUE(output.has("nothing defines \"nope\"")) << output.text;
  EXPECT_EQ(output.exit, 2);
}

}  // namespace
}  // namespace rungproof
