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

}  // namespace
}  // namespace rungproof::test
