// Purposes in words, of tables written by hand.
#include "frontend/testing/test_purpose.hpp"

#include <gtest/gtest.h>

#include "frontend/input/project.hpp"
#include "frontend/testing/table_reader.hpp"

namespace rungproof {
namespace {

/// A motor with start and guard, and a lamp that follows it after some time.
std::vector<std::string> purposes(const std::string& rows) {
  const Program program = readText("p.awl",
                                   "Network 1\nLD I0.0\nO Q0.0\nA I0.1\n= Q0.0\nNetwork 2\nLD Q0.0\nTON T37, 20\n"
                                   "Network 3\nLD T37\n= Q0.1\n");
  std::vector<Failure> failures;
  const TestTable table =
      readTestTable("t.csv", "test,wait,set I0.0,set I0.1,expect Q0.0,expect Q0.1\n" + rows, program, 0, failures);
  EXPECT_TRUE(failures.empty());
  return purposesOf(table);
}
using Texts = std::vector<std::string>;

TEST(Purpose, NamesWhatComesAndByWhat) {
  EXPECT_EQ(purposes("a,1 scan,0,1,0,0\na,1 scan,1,,1,0\na,3s,,,1,1\na,1 scan,,0,0,0\n"),
            Texts({"Q0.0 comes when I0.0 is switched on; Q0.1 comes by time; Q0.0 goes and Q0.1 goes when I0.1 is "
                   "switched off"}));
}

// The start works in the first test and does nothing in the second, in which the guard is open.
TEST(Purpose, NamesWhatRefusesAStart) {
  EXPECT_EQ(purposes("a,1 scan,0,1,0,0\na,1 scan,1,,1,0\nb,1 scan,0,0,0,0\nb,1 scan,1,,0,0\n"),
            Texts({"Q0.0 comes when I0.0 is switched on", "I0.0 is refused while I0.1 is off"}));
}

// What is not compared may have changed: nothing is said of it. What was said before is said again if there is no more.
TEST(Purpose, SaysNothingOfWhatIsNotCompared) {
  EXPECT_EQ(purposes("a,1 scan,0,1,0,0\na,1 scan,1,,1,0\nb,1 scan,0,1,0,\nb,1 scan,1,,1,\nc,1 scan,0,0,0,x\n"),
            Texts({"Q0.0 comes when I0.0 is switched on", "Q0.0 comes when I0.0 is switched on", "no output changes"}));
}

}  // namespace
}  // namespace rungproof
