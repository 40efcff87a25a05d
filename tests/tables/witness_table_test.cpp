// Runs that prove and equiv have found, as tables: the faulty program does not pass them, the mended one does.
#include "test_command.hpp"

namespace rungproof::test {
namespace {

class WitnessTable : public TestCommand {
 protected:
  const std::string faulty_ = write("faulty.awl", "Network 1\nLD I0.0\n= Q0.0\n");
  const std::string mended_ = write("mended.awl", "Network 1\nLD I0.0\nAN I0.1\n= Q0.0\n");
};

// With the stop pressed the motor must not run: Q0.0 is the one output that the property reads.
TEST_F(WitnessTable, OfAViolatedPropertyExpectsTheOpposite) {
  const std::string properties = write("p.prop", "prove stop: I0.1 implies not Q0.0\n");
  EXPECT_EQ(test::run({"prove", faulty_, "--props", properties, "--tables", path("tables"), "--isolated"}).exit, 1);
  const std::string table = path("tables/stop.test.csv");
  EXPECT_NE(contentOf(table).find("'stop' was violated here"), std::string::npos) << contentOf(table);
  EXPECT_EQ(run({faulty_, "--table", table}), 1) << out_;
  EXPECT_EQ(run({mended_, "--table", table}), 0) << out_ << contentOf(table);
}

// Which of the two has to go off nobody knows: neither is expected, and the note says so.
TEST_F(WitnessTable, OfTwoOutputsLeavesTheAnswerOpen) {
  const std::string program = write("both.awl", "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n");
  const std::string properties = write("p.prop", "prove both: never Q0.0 and Q0.1\n");
  EXPECT_EQ(test::run({"prove", program, "--props", properties, "--tables", path("tables"), "--isolated"}).exit, 1);
  const std::string table = contentOf(path("tables/both.test.csv"));
  EXPECT_NE(table.find("write what must be seen"), std::string::npos) << table;
}

// A division by 0 asks about a statement: a program that is mended shows whatever is right there.
TEST_F(WitnessTable, OfABuiltInCheckLeavesTheAnswerOpen) {
  const std::string program = write("divides.awl", "Network 1\nLD I0.0\nMOVW 5, VW2\n/I IW4, VW2\n");
  const test::ProgramRun proof = test::run({"prove", program, "--builtin", "--tables", path("tables"), "--isolated"});
  EXPECT_EQ(proof.exit, 1) << proof.out;
  const std::size_t named = proof.out.find("test table: ");
  ASSERT_NE(named, std::string::npos) << proof.out;
  const std::size_t begin = named + std::string_view("test table: ").size();
  const std::string table = contentOf(proof.out.substr(begin, proof.out.find('\n', begin) - begin));
  EXPECT_NE(table.find("write what must be seen"), std::string::npos) << table;
}

TEST_F(WitnessTable, OfADifferenceExpectsTheOldProgram) {
  const std::string table = path("difference.test.csv");
  EXPECT_EQ(test::run({"equiv", mended_, faulty_, "--table", table, "--isolated"}).exit, 1);
  EXPECT_EQ(run({mended_, "--table", table}), 0) << out_ << contentOf(table);
  EXPECT_EQ(run({faulty_, "--table", table}), 1) << out_;
  // No difference, no table.
  EXPECT_EQ(test::run({"equiv", mended_, mended_, "--table", path("none.csv"), "--isolated"}).exit, 0);
  EXPECT_TRUE(contentOf(path("none.csv")).empty());
}

// 3 s between the input and the output: the run has scans of any length, and the table waits as long.
TEST_F(WitnessTable, WaitsAsLongAsTheRun) {
  const std::string before = write("a.awl", "Network 1\nLD I0.0\nTON T37, 30\nNetwork 2\nLD T37\n= Q0.0\n");
  const std::string after = write("b.awl", "Network 1\nLD I0.0\nTON T37, 60\nNetwork 2\nLD T37\n= Q0.0\n");
  const std::string table = path("t.csv");
  EXPECT_EQ(test::run({"equiv", before, after, "--table", table, "--isolated"}).exit, 1);
  EXPECT_EQ(run({before, "--table", table}), 0) << out_ << contentOf(table);
  EXPECT_EQ(run({after, "--table", table}), 1) << out_ << contentOf(table);
}

/// The table of property `w` in the program, which is violated.
class MendedTable : public TestCommand {
 protected:
  std::string tableOf(const std::string& program, const std::string& property) {
    const std::string properties = write("p.prop", "prove w: " + property + "\n");
    const ProgramRun proof =
        test::run({"prove", program, "--props", properties, "--tables", path("tables"), "--isolated"});
    EXPECT_EQ(proof.exit, 1) << proof.out << proof.err;
    return path("tables/w.test.csv");
  }
  void expectExits(const std::string& faulty, const std::string& mended, const std::string& table) {
    for (const char* scans : {"10ms", "1ms", "100ms", "10ms..322ms"}) {
      EXPECT_EQ(run({faulty, "--table", table, "--scan-time", scans}), 1) << scans << out_ << contentOf(table);
      EXPECT_EQ(run({mended, "--table", table, "--scan-time", scans}), 0) << scans << out_ << contentOf(table);
    }
  }
};

// The pump runs on for a scan when I0.0 goes off. When it has come, 3 s after I0.0 with whatever scans, is nobody's
// business: the mended program starts it too.
TEST_F(MendedTable, ExpectsNothingInFrontOfTheViolation) {
  const std::string timer = "Network 2\nLD I0.0\nTON T37, 30\n";
  const std::string faulty = write("faulty.awl", "Network 1\nLD T37\n= Q0.1\n" + timer);
  const std::string mended = write("mended.awl", "Network 1\nLD T37\nA I0.0\n= Q0.1\n" + timer);
  expectExits(faulty, mended, tableOf(faulty, "Q0.1 implies I0.0"));
}

// 3 s of I0.0 may be one long scan after another with other inputs between: their time counts, not their number.
TEST_F(MendedTable, KeepsTheTimeOfLongScans) {
  const std::string timer = "Network 1\nLD I0.0\nTON T37, 30\n";
  const std::string faulty = write("faulty.awl", timer + "Network 2\nLD T37\n= Q0.1\n");
  const std::string mended = write("mended.awl", timer + "Network 2\nLD T37\nA I0.1\n= Q0.1\n");
  expectExits(faulty, mended, tableOf(faulty, "Q0.1 implies I0.1"));
}

// Without I0.0 both have to be off, whichever of them was on.
TEST_F(MendedTable, ExpectsAllThatThePropertyAsks) {
  const std::string faulty = write("faulty.awl", "Network 1\nLD I0.1\n= Q0.0\nNetwork 2\nLD I0.0\n= Q0.1\n");
  const std::string other = write("other.awl", "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n");
  const std::string mended = write("mended.awl", "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.0\n= Q0.1\n");
  const std::string table = tableOf(faulty, "(Q0.0 or Q0.1) implies I0.0");
  expectExits(faulty, mended, table);
  EXPECT_EQ(run({other, "--table", table}), 1) << out_ << contentOf(table);
}

// Programs that are right too: one makes Q0.0 true and false again in time, one never lets M0.0 come.
TEST_F(MendedTable, LeavesOpenWhatMayBeMendedElsewhere) {
  const std::string faulty = write("faulty.awl", "Network 1\nLD I0.0\n= M0.0\nNetwork 2\nLD I0.1\n= Q0.0\n");
  for (const char* property : {"I0.0 leads to Q0.0 within 3 scans", "M0.0 implies Q0.0", "rises(M0.0) implies Q0.0"}) {
    const std::string table = tableOf(faulty, property);
    EXPECT_NE(contentOf(table).find("write what must be seen"), std::string::npos) << property << contentOf(table);
    EXPECT_EQ(run({faulty, "--table", table}), 3) << property << contentOf(table);  // nothing is expected
  }
}

// The lamp comes 3 s after I0.0. The run has scans of some length; its program passes the table with any.
TEST_F(MendedTable, OfAGoalHoldsForItsProgram) {
  const std::string program = write("lamp.awl", "Network 1\nLD I0.0\nTON T37, 30\nNetwork 2\nLD T37\n= Q0.1\n");
  const std::string properties = write("p.prop", "reach w: Q0.1 and I0.1\n");
  EXPECT_EQ(test::run({"prove", program, "--props", properties, "--tables", path("tables"), "--isolated"}).exit, 0);
  const std::string table = path("tables/w.test.csv");
  EXPECT_EQ(run({program, "--table", table}), 0) << out_ << contentOf(table);
  EXPECT_NE(contentOf(table).find(",1,"), std::string::npos) << contentOf(table);
}

// x is no number, and so is its double: what is recorded is passed.
TEST_F(WitnessTable, NoNumberIsExpectedWhereThereIsNone) {
  const std::string program = write("n.st",
                                    "PROGRAM P VAR_INPUT x : REAL; END_VAR VAR_OUTPUT y : REAL; END_VAR\n"
                                    "y := x * 2.0;\nEND_PROGRAM\n");
  EXPECT_EQ(run({program, "--table", write("n.csv", "test,wait,set x,expect y\nT,1 scan,nan,nan\n")}), 0) << out_;
  EXPECT_EQ(run({program, "--table", write("w.csv", "test,wait,set x,expect y\nT,1 scan,1.0,nan\n")}), 1) << out_;
  EXPECT_NE(out_.find("expected nan, actual 2"), std::string::npos) << out_;
}

}  // namespace
}  // namespace rungproof::test
